#include "gradation/sieve_spelling.hpp"
#include "support.hpp"

namespace sieve_spelling_test {

using namespace mdm;
using namespace mdm::test;

namespace {

std::string opening(const std::string &name) {
  INFO(name);
  return to_decimal(spelled_sieve_opening(name, '.'));
}

std::string refused(const std::string &name) {
  INFO(name);
  return message_of([&name] { spelled_sieve_opening(name, '.'); });
}

} // namespace

TEST_CASE("Spellings of sieves: inches with dashes, decimals, fraction signs and quotes") {
  for (const std::string name :
       {"3/4-in.", "3/4 in", "3/4\"", "¾\"", "¾ in.", "0.75 in", ".75\"", "3/4-inch", "3⁄4″"})
    CHECK(opening(name) == "19");
  for (const std::string name :
       {"1.5\"", "1 1/2\"", "1½\"", "1 ½ in", "1-1/2-in.", "1-1/2\"", "1.50 in.", "1 1/2''", "1 1/2”"})
    CHECK(opening(name) == "37.5");
  CHECK(opening("1-in.") == "25");
  CHECK(opening("⅜\"") == "9.5");
  CHECK(opening("3 in") == "75");
}

TEST_CASE("Spellings of sieves: numbers of ASTM, and metric ones in words") {
  for (const std::string name : {"No.10", "No 10", "N° 10", "Nº10", "Nr. 10", "U.S. No. 10", "US No. 10",
                                 "ASTM #10", "#10 sieve", "No. 10 sieve"})
    CHECK(opening(name) == "2");
  for (const std::string name : {"75 microns", "75 micron", "75 µm", "75 micrometres", "0.075 millimetres"})
    CHECK(opening(name) == "0.075");
  CHECK(opening("pan") == "0");
  CHECK(to_decimal(spelled_sieve_opening("0,063 mm", ',')) == "0.063");
}

TEST_CASE("Spellings of sieves: two names of one sieve, of which the metric one is taken") {
  CHECK(opening("No. 4 (4.75mm)") == "4.75");
  CHECK(opening("4.75 mm (No. 4)") == "4.75");
  CHECK(opening("#200 (75 µm)") == "0.075");
  for (const std::string name : {"No. 200 (0.075)", "No. 200 (75)", "0.075 (#200)", "75 (No. 200)"})
    CHECK(opening(name) == "0.075");
  CHECK(contains(refused("No. 200 (0.75)"), "are of two sieves"));
  CHECK(opening("No. 4 (4.76 mm)") == "4.76");
  CHECK(opening("1 in. (25.4 mm)") == "25.4");
  CHECK(opening("3/8\" (9.5 mm)") == "9.5");
  CHECK(opening("4.75 mm / No. 4") == "4.75");
  CHECK(contains(refused("No. 4 (2 mm)"),
                 "the names in 'No. 4 (2 mm)' are of two sieves, 4.75 mm and 2 mm: correct one of them"));
  CHECK(contains(refused("No. 40 (0.75 mm)"), "are of two sieves"));
  CHECK(contains(refused("#200 (wet)"), "'wet' is no sieve"));
}

TEST_CASE("Spellings of sieves: what may mean two things is refused") {
  for (const std::string name : {"10", "10 mesh", "3/4", "1.6 in", "No. 11", "#200 wet", "1/0 in", "B.S. 7",
                                 "Tyler No. 10", "", "-", "½", "4.75 (4.75)", "1//2 in", "Mesh 10"})
    CHECK(contains(refused(name), "is no sieve"));
}

} // namespace sieve_spelling_test

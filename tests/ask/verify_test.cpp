// Samples judged by the library's public verifier.

#include "catch.hpp"

#include <mdm/ask/verify.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <sstream>

namespace verify_test {

using namespace mdm;

namespace {

/// One sphere of size 2 and eight of size 1 have the same mass.
Gradation halves() {
  return gradation_of({"0.5", "1", "2"}, {"1", "1", "0"});
}

std::optional<bool> is_match(std::initializer_list<std::pair<const char *, int>> particles,
                             const char *tolerance = nullptr) {
  Question asked;
  if (tolerance != nullptr)
    asked.tolerances = {parse_tolerance(tolerance)};
  SampleVerifier verifier(halves(), asked);
  for (const auto &[size, quantity] : particles)
    verifier.add(parse_decimal(size), quantity);
  return verifier.verdict().is_match;
}

} // namespace

TEST_CASE("a sample with the gradation's shares matches, another does not") {
  CHECK(is_match({{"1", 8}, {"2", 1}}) == true);
  CHECK(is_match({{"1", 9}, {"2", 1}}) == false);
  CHECK(is_match({{"1", 8}, {"2", 1}, {"2.1", 1}}) == false);
}

TEST_CASE("a sample is judged within the tolerance that was asked for") {
  // 9/17 of the mass instead of 1/2: 2.94 points too many.
  CHECK(is_match({{"1", 9}, {"2", 1}}, "retained:2.95%") == true);
  CHECK(is_match({{"1", 9}, {"2", 1}}, "retained:2.94%") == false);
  CHECK(is_match({{"1", 9}, {"2", 1}}, "total:5.89%") == true);
}

TEST_CASE("a verdict has the classes, what is outside, and the report") {
  SampleVerifier verifier(halves());
  verifier.add(1, 8);
  verifier.add(2, 1);
  verifier.add(3, 4);
  const SampleVerdict verdict = verifier.verdict("grains");
  CHECK(verdict.particles == 13);
  CHECK(verdict.outside == 4);
  REQUIRE(verdict.classes.size() == 2);
  CHECK(verdict.classes[0].quantity == 8);
  CHECK(verdict.classes[1].upper.text() == "2");
  CHECK(verdict.classes[1].target == ratio(1, 2));
  CHECK(verdict.text.find("grains") != std::string::npos);
  CHECK(verdict.json.find("mdm-verify-1") != std::string::npos);
}

TEST_CASE("a sample is read from a file of particles, in its unit") {
  std::istringstream csv("size_um,quantity\n1000,8\n2000,1\n");
  SampleVerifier verifier(halves());
  verifier.read(csv, "grains.csv");
  CHECK(verifier.verdict().is_match == true);
  std::istringstream list("0.001\n0.002\n");
  SampleVerifier in_metres(halves());
  in_metres.read(list, "grains.txt", SizeUnit::m);
  CHECK(in_metres.verdict().classes[1].quantity == 1);
}

TEST_CASE("the verifier refuses sizes and files that are none") {
  SampleVerifier verifier(halves());
  CHECK_THROWS_AS(verifier.add(0), InputError);
  CHECK_THROWS_AS(verifier.add(1, 0), InputError);
  std::istringstream bad("size_mm,quantity\n1,x\n");
  CHECK_THROWS_WITH(verifier.read(bad, "bad.csv"), Catch::Contains("bad.csv:2"));
  Question asked;
  asked.cut_below = 7;
  CHECK_THROWS_AS(SampleVerifier(halves(), asked), InputError);
}

} // namespace verify_test

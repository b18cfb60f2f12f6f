#include "gradation/sieve_name.hpp"
#include "support.hpp"

namespace sieve_name_test {

using namespace mdm;
using namespace mdm::test;

namespace {

std::string opening(const std::string &name) {
  return to_decimal(sieve_opening(name));
}

} // namespace

TEST_CASE("Sieve names: ASTM E11 numbers") {
  for (const std::string name : {"No. 200", "no.200", "NO 200", "#200", "# 200", " No.\t200 "})
    CHECK(opening(name) == "0.075");
  CHECK(opening("No. 3-1/2") == "5.6");
  CHECK(opening("No. 3 1/2") == "5.6");
  CHECK(opening("#4") == "4.75");
  CHECK(opening("#635") == "0.02");
}

TEST_CASE("Sieve names: ASTM E11 inches are table openings, not conversions") {
  for (const std::string name : {"3/8 in", "3/8in.", "3/8\"", "3/8 inch", "3/8 INCHES", "3 / 8 in"})
    CHECK(opening(name) == "9.5");
  CHECK(opening("1 1/2\"") == "37.5");
  CHECK(opening("1-1/2 in.") == "37.5");
  CHECK(opening("5 in") == "125");
  CHECK(opening("0.530 in") == "13.2");
  CHECK(opening("1.06in") == "26.5");
}

TEST_CASE("Sieve names: Tyler numbers need their prefix") {
  CHECK(opening("Tyler 65 mesh") == "0.212");
  CHECK(opening("tyler65") == "0.212");
  CHECK(opening("TYLER 2-1/2 Mesh") == "8");
  CHECK(opening("Tyler 9") == "2");
  CHECK(contains(message_of([] { sieve_opening("65 mesh"); }), "'65 mesh' is no sieve"));
}

TEST_CASE("Sieve names: metric openings and the pan") {
  CHECK(opening("1.18 mm") == "1.18");
  CHECK(opening("75um") == "0.075");
  CHECK(opening("75 \xC2\xB5m") == "0.075");
  CHECK(opening("75 \xCE\xBCm") == "0.075");
  CHECK(opening("0.002 M") == "2");
  CHECK(opening("1E3 UM") == "1");
  CHECK(opening("PAN") == "0");
  CHECK(opening("0 mm") == "0");
  CHECK(to_decimal(sieve_opening("1,18 mm", ',')) == "1.18");
}

TEST_CASE("Sieve names: anything else is refused") {
  for (const std::string name :
       {"",        " ",        "200",       "No. 201",  "No. 0200", "No. #200", "3/8",
        "0.53 in", "3/8 inin", "3/8''",     "p a n",    "-1 mm",    "1 000 um", "1,18 mm",
        "mm",      "Tyler",    "Tyler 7/8", "No. 10.0", "nan mm",   "in",       "\xFF mm"})
    CHECK(contains(message_of([&name] { sieve_opening(name); }),
                   in_quotes(name) + " is no sieve: write a name such as"));
}

TEST_CASE("Sieve names: the tables are complete and descend") {
  const std::vector<std::string> inches = {"5",     "4.24",  "4",     "3-1/2", "3",    "2-1/2", "2.12", "2",
                                           "1-3/4", "1-1/2", "1-1/4", "1.06",  "1",    "7/8",   "3/4",  "5/8",
                                           "0.530", "1/2",   "7/16",  "3/8",   "5/16", "0.265", "1/4"};
  const std::vector<std::string> numbers = {"3-1/2", "4",   "5",   "6",   "7",   "8",   "10",  "12",  "14",
                                            "16",    "18",  "20",  "25",  "30",  "35",  "40",  "45",  "50",
                                            "60",    "70",  "80",  "100", "120", "140", "170", "200", "230",
                                            "270",   "325", "400", "450", "500", "635"};
  const std::vector<std::string> tyler = {"2-1/2", "3",   "3-1/2", "4",   "5",   "6",   "7",   "8",
                                          "9",     "10",  "12",    "14",  "16",  "20",  "24",  "28",
                                          "32",    "35",  "42",    "48",  "60",  "65",  "80",  "100",
                                          "115",   "150", "170",   "200", "250", "270", "325", "400"};
  const auto openings = [](const std::vector<std::string> &names, const std::string &before,
                           const std::string &behind) {
    std::vector<Rational> all;
    for (const std::string &name : names)
      all.push_back(sieve_opening(before + name + behind));
    return text(all);
  };
  CHECK(openings(inches, "", " in") ==
        "125 106 100 90 75 63 53 50 45 37.5 31.5 26.5 25 22.4 19 16 13.2 12.5 11.2 9.5 8 6.7 6.3");
  CHECK(openings(numbers, "No. ", "") ==
        "5.6 4.75 4 3.35 2.8 2.36 2 1.7 1.4 1.18 1 0.85 0.71 0.6 0.5 0.425 0.355 0.3 0.25 0.212 0.18 0.15 "
        "0.125 0.106 0.09 0.075 0.063 0.053 0.045 0.038 0.032 0.025 0.02");
  CHECK(openings(tyler, "Tyler ", " mesh") ==
        "8 6.7 5.6 4.75 4 3.35 2.8 2.36 2 1.7 1.4 1.18 1 0.85 0.71 0.6 0.5 0.425 0.355 0.3 0.25 0.212 0.18 "
        "0.15 0.125 0.106 0.09 0.075 0.063 0.053 0.045 0.038");
}

} // namespace sieve_name_test

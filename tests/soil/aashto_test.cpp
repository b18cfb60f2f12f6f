// The groups of AASHTO M 145, beside the standard's table read column by column.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/aashto.hpp"

#include <array>
#include <random>

namespace aashto_test {

using namespace mdm;
using grading_test::curve;

namespace {

using Points = std::vector<std::pair<std::string, std::string>>;

/// What passes 0.075, 0.425 and 2 mm, in percent; all passes 4.75 mm.
GradingCurve soil_of(const std::string &fines, const std::string &p425, const std::string &p2) {
  return curve({{"0.001", "0"}, {"0.075", fines}, {"0.425", p425}, {"2", p2}, {"4.75", "100"}});
}

std::optional<AtterbergLimits> limits(const char *liquid, const char *plastic) {
  return AtterbergLimits{parse_decimal(liquid), parse_decimal(plastic)};
}

std::string group(const GradingCurve &soil, const std::optional<AtterbergLimits> &of_fines = std::nullopt) {
  const Available<AashtoGroup> found = classify_aashto(soil, of_fines);
  if (!found)
    return "none";
  return found->symbol + (found->index ? "(" + to_string(*found->index) + ")" : "");
}

/// A column of the table; limits that it leaves out are beyond all numbers.
struct Column {
  const char *symbol;
  int most_2, most_425, least_425, most_fines, least_fines, most_liquid, least_liquid, most_plastic,
      least_plastic;
};

constexpr int all = 1000;
constexpr std::array<Column, 11> table = {{{"A-1-a", 50, 30, 0, 15, 0, all, 0, 6, 0},
                                           {"A-1-b", all, 50, 0, 25, 0, all, 0, 6, 0},
                                           {"A-3", all, all, 51, 10, 0, all, 0, 0, 0},
                                           {"A-2-4", all, all, 0, 35, 0, 40, 0, 10, 0},
                                           {"A-2-5", all, all, 0, 35, 0, all, 41, 10, 0},
                                           {"A-2-6", all, all, 0, 35, 0, 40, 0, all, 11},
                                           {"A-2-7", all, all, 0, 35, 0, all, 41, all, 11},
                                           {"A-4", all, all, 0, all, 36, 40, 0, 10, 0},
                                           {"A-5", all, all, 0, all, 36, all, 41, 10, 0},
                                           {"A-6", all, all, 0, all, 36, 40, 0, all, 11},
                                           {"A-7", all, all, 0, all, 36, all, 41, all, 11}}};

std::string by_table(int fines, int p425, int p2, int liquid, int plasticity) {
  for (const Column &c : table)
    if (p2 <= c.most_2 && p425 <= c.most_425 && p425 >= c.least_425 && fines <= c.most_fines &&
        fines >= c.least_fines && liquid <= c.most_liquid && liquid >= c.least_liquid &&
        plasticity <= c.most_plastic && plasticity >= c.least_plastic)
      return std::string(c.symbol) == "A-7" ? (plasticity <= liquid - 30 ? "A-7-5" : "A-7-6") : c.symbol;
  return "none";
}

} // namespace

TEST_CASE("AASHTO groups are those of the first column that holds", "[aashto]") {
  std::mt19937 random(7);
  const auto up_to = [&random](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  for (int i = 0; i < 3000; ++i) {
    const int fines = up_to(0, 60), p425 = up_to(fines, 100), p2 = up_to(p425, 100);
    const int liquid = up_to(0, 80), plasticity = up_to(0, std::min(liquid, 30));
    const Available<AashtoGroup> found =
        classify_aashto(soil_of(std::to_string(fines), std::to_string(p425), std::to_string(p2)),
                        AtterbergLimits{liquid, liquid - plasticity});
    CAPTURE(fines, p425, p2, liquid, plasticity);
    REQUIRE(found);
    CHECK(found->symbol == by_table(fines, p425, p2, liquid, plasticity));
    REQUIRE(found->index);
    CHECK(*found->index >= 0);
  }
}

TEST_CASE("the group index has both of its parts, or that of plasticity alone", "[aashto]") {
  // (90 - 35) (0.2 + 0.005 (53 - 40)) + 0.01 (90 - 15) (30 - 10) = 14.575 + 15.
  CHECK(group(soil_of("90", "95", "100"), limits("53", "23")) == "A-7-6(30)");
  // (60 - 35) (0.2 + 0.005 (35 - 40)) + 0.01 (60 - 15) (12 - 10) = 4.375 + 0.9.
  CHECK(group(soil_of("60", "90", "100"), limits("35", "23")) == "A-6(5)");
  // 0.01 (30 - 15) (20 - 10) = 1.5, to the even whole number.
  CHECK(group(soil_of("30", "60", "100"), limits("38", "18")) == "A-2-6(2)");
  CHECK(group(soil_of("40", "60", "100"), limits("20", "20")) == "A-4(0)"); // below 0
}

TEST_CASE("percents and limits are rounded to whole numbers, halves to the even one", "[aashto]") {
  CHECK(group(soil_of("5", "50.5", "100")) == "A-1-b(0)");
  CHECK(group(soil_of("5", "50.51", "100")) == "A-3(0)");
  CHECK(group(soil_of("35.5", "60", "100")) == "A-4");
  CHECK(group(soil_of("35.49", "60", "100")) == "A-2-4(0)");
  CHECK(group(soil_of("20", "60", "100"), limits("40.5", "35")) == "A-2-4(0)");
  CHECK(group(soil_of("20", "60", "100"), limits("40.51", "35")) == "A-2-5(0)");
  CHECK(group(soil_of("5", "60", "100"), limits("20", "19.5")) == "A-3(0)");
  // 11 is the difference of 41 and 30, 10 that of 40.6 and 30.4 rounded.
  CHECK(group(soil_of("20", "60", "100"), limits("40.6", "30.4")) == "A-2-7(0)");
  CHECK(group(soil_of("20", "60", "100"), limits("40.4", "29.6")) == "A-2-4(0)");
}

TEST_CASE("without limits the fines are nonplastic, and an index of the liquid limit is not known",
          "[aashto]") {
  CHECK(group(soil_of("50", "60", "100")) == "A-4");
  CHECK(group(soil_of("20", "60", "100")) == "A-2-4(0)");
  CHECK(group(soil_of("8", "60", "100")) == "A-3(0)");
  CHECK(group(soil_of("10", "25", "45")) == "A-1-a(0)");
}

TEST_CASE("a pan that hides 0.075 mm hides a group only where that changes it", "[aashto]") {
  CHECK(group(curve({{"0", "0"}, {"0.15", "8"}, {"0.425", "60"}, {"2", "100"}})) == "A-3(0)");
  const Available<AashtoGroup> open =
      classify_aashto(curve({{"0", "0"}, {"0.15", "20"}, {"0.425", "60"}, {"2", "100"}}), std::nullopt);
  REQUIRE_FALSE(open);
  CHECK(open.why().reason == "0.075 mm lies below 0.15 mm, the finest sieve: it is between A-3 and A-2-4");
  CHECK(group(curve({{"0", "0"}, {"0.15", "60"}, {"0.425", "70"}, {"2", "100"}}), limits("53", "23")) ==
        "none");
  CHECK(group(curve({{"0", "0"}, {"1", "60"}, {"2", "100"}})) == "none");
  CHECK(group(curve({{"0.001", "0"}, {"0.075", "5"}, {"0.425", "60"}, {"2", "70"}, {"100", "100"}})) ==
        "none");
}

TEST_CASE("the AASHTO group is that of what passes 75 mm", "[aashto]") {
  // 40 of 80 percent pass 0.425 mm.
  CHECK(group(curve(
            {{"0.001", "0"}, {"0.075", "4"}, {"0.425", "40"}, {"2", "60"}, {"75", "80"}, {"150", "100"}})) ==
        "A-1-b(0)");
}

} // namespace aashto_test

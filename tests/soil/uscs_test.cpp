// The flow charts of ASTM D2487: every leaf, and both sides of every bound.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/uscs.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <map>

namespace uscs_test {

using namespace mdm;
using namespace grading_test;

namespace {

using Points = std::vector<std::pair<std::string, std::string>>;

UscsGroup group(const Points &points, Fines fines = Fines::ML) {
  return *classify_uscs(curve(points), fines);
}

std::string symbol(const Points &points, Fines fines = Fines::ML) {
  return group(points, fines).symbol;
}

std::string name(const Points &points, Fines fines = Fines::ML) {
  return group(points, fines).name;
}

/// A sand with D10, D30, D60 of 0.1 (0.05 with 10 % fines or more), 0.3 and `d60` mm.
Points sand(const std::string &fines, const std::string &passing_4_75, const std::string &d60) {
  const std::string d10 = parse_decimal(fines) < 10 ? "0.1" : "0.05";
  Points points = {{"0.001", "0"}, {"0.075", fines},       {d10, "10"},  {"0.3", "30"},
                   {d60, "60"},    {"4.75", passing_4_75}, {"75", "100"}};
  if (d10 == "0.05")
    std::swap(points[1], points[2]);
  return points;
}

/// A gravel with D10, D30, D60 of 1, 6 and `d60` mm, and one of 5, 10 and `d60` mm with little sand.
Points gravel(const std::string &fines, const std::string &passing_4_75, const std::string &d60) {
  return {{"0.001", "0"}, {"0.075", fines}, {"1", "10"},  {"4.75", passing_4_75},
          {"6", "30"},    {d60, "60"},      {"75", "100"}};
}
Points clean_gravel(const std::string &fines, const std::string &d60) {
  return {{"0.001", "0"}, {"0.075", fines}, {"4.75", "9.5"}, {"5", "10"},
          {"10", "30"},   {d60, "60"},      {"75", "100"}};
}

const std::string well_d60 = "0.9", poor_d60 = "0.5"; // of sand: C_u 9 and 5, C_c 1 and 1.8

} // namespace

TEST_CASE("sands and gravels with less than 5 % fines", "[uscs]") {
  CHECK(group(sand("4", "100", well_d60)) == UscsGroup{"SW", "well-graded sand"});
  CHECK(group(sand("4", "80", well_d60)) == UscsGroup{"SW", "well-graded sand with gravel"});
  CHECK(group(sand("4", "100", poor_d60)) == UscsGroup{"SP", "poorly graded sand"});
  CHECK(group(sand("4", "80", poor_d60)) == UscsGroup{"SP", "poorly graded sand with gravel"});
  CHECK(group(clean_gravel("4", "20")) == UscsGroup{"GW", "well-graded gravel"});
  CHECK(group(gravel("4", "25", "20")) == UscsGroup{"GW", "well-graded gravel with sand"});
  CHECK(group(clean_gravel("4", "15")) == UscsGroup{"GP", "poorly graded gravel"});
  CHECK(group(gravel("4", "25", "7")) == UscsGroup{"GP", "poorly graded gravel with sand"});
}

TEST_CASE("sands and gravels with 5 to 12 % fines", "[uscs]") {
  const std::map<Fines, std::pair<std::string, std::string>> kinds = {{Fines::ML, {"M", "silt"}},
                                                                      {Fines::MH, {"M", "silt"}},
                                                                      {Fines::CL, {"C", "clay"}},
                                                                      {Fines::CH, {"C", "clay"}},
                                                                      {Fines::CL_ML, {"C", "silty clay"}}};
  for (const auto &[fines, kind] : kinds) {
    const auto &[letter, noun] = kind;
    CHECK(group(sand("8", "100", well_d60), fines) ==
          UscsGroup{"SW-S" + letter, "well-graded sand with " + noun});
    CHECK(group(sand("8", "80", well_d60), fines) ==
          UscsGroup{"SW-S" + letter, "well-graded sand with " + noun + " and gravel"});
    CHECK(group(sand("8", "100", poor_d60), fines) ==
          UscsGroup{"SP-S" + letter, "poorly graded sand with " + noun});
    CHECK(group(sand("8", "80", poor_d60), fines) ==
          UscsGroup{"SP-S" + letter, "poorly graded sand with " + noun + " and gravel"});
    CHECK(group(clean_gravel("8", "20"), fines) ==
          UscsGroup{"GW-G" + letter, "well-graded gravel with " + noun});
    CHECK(group(gravel("8", "25", "20"), fines) ==
          UscsGroup{"GW-G" + letter, "well-graded gravel with " + noun + " and sand"});
    CHECK(group(clean_gravel("8", "15"), fines) ==
          UscsGroup{"GP-G" + letter, "poorly graded gravel with " + noun});
    CHECK(group(gravel("8", "25", "7"), fines) ==
          UscsGroup{"GP-G" + letter, "poorly graded gravel with " + noun + " and sand"});
  }
}

TEST_CASE("sands and gravels with more than 12 % fines", "[uscs]") {
  const std::map<Fines, std::pair<std::string, std::string>> kinds = {
      {Fines::ML, {"XM", "silty"}},
      {Fines::MH, {"XM", "silty"}},
      {Fines::CL, {"XC", "clayey"}},
      {Fines::CH, {"XC", "clayey"}},
      {Fines::CL_ML, {"XC-XM", "silty, clayey"}}};
  const auto points = [](const char *passing_4_75) {
    return Points{{"0", "0"}, {"0.075", "20"}, {"4.75", passing_4_75}, {"75", "100"}};
  };
  for (const auto &[fines, kind] : kinds) {
    std::string of_sand = kind.first, of_gravel = kind.first;
    std::replace(of_sand.begin(), of_sand.end(), 'X', 'S');
    std::replace(of_gravel.begin(), of_gravel.end(), 'X', 'G');
    CHECK(group(points("95"), fines) == UscsGroup{of_sand, kind.second + " sand"});
    CHECK(group(points("70"), fines) == UscsGroup{of_sand, kind.second + " sand with gravel"});
    CHECK(group(points("30"), fines) == UscsGroup{of_gravel, kind.second + " gravel"});
    CHECK(group(points("40"), fines) == UscsGroup{of_gravel, kind.second + " gravel with sand"});
  }
}

TEST_CASE("fine-grained soils", "[uscs]") {
  const std::map<Fines, UscsGroup> kinds = {{Fines::ML, {"ML", "silt"}},
                                            {Fines::MH, {"MH", "elastic silt"}},
                                            {Fines::CL, {"CL", "lean clay"}},
                                            {Fines::CH, {"CH", "fat clay"}},
                                            {Fines::CL_ML, {"CL-ML", "silty clay"}}};
  const auto points = [](const char *fines, const char *passing_4_75) {
    return Points{{"0", "0"}, {"0.075", fines}, {"4.75", passing_4_75}, {"75", "100"}};
  };
  for (const auto &[fines, kind] : kinds) {
    const std::string &soil = kind.name;
    CHECK(group(points("90", "98"), fines) == kind);
    CHECK(name(points("85.1", "86"), fines) == soil);
    CHECK(name(points("80", "90"), fines) == soil + " with sand");
    CHECK(name(points("80", "89.9"), fines) == soil + " with gravel");
    CHECK(name(points("85", "100"), fines) == soil + " with sand");
    CHECK(name(points("70.1", "71"), fines) == soil + " with gravel");
    CHECK(name(points("70", "90"), fines) == "sandy " + soil);
    CHECK(name(points("60", "85.1"), fines) == "sandy " + soil);
    CHECK(name(points("60", "85"), fines) == "sandy " + soil + " with gravel");
    CHECK(name(points("60", "80"), fines) == "sandy " + soil + " with gravel");
    CHECK(name(points("60", "74.9"), fines) == "gravelly " + soil);
    CHECK(name(points("60", "75"), fines) == "gravelly " + soil + " with sand");
    CHECK(name(points("60", "79.9"), fines) == "gravelly " + soil + " with sand");
    CHECK(symbol(points("50", "79.9"), fines) == kind.symbol);
  }
}

TEST_CASE("the bounds of the share of fines", "[uscs]") {
  CHECK(symbol(sand("4.999999999", "100", well_d60)) == "SW");
  CHECK(symbol(sand("5", "100", well_d60)) == "SW-SM");
  CHECK(symbol(sand("12", "100", well_d60)) == "SW-SM");
  CHECK(symbol(sand("12.000000001", "100", well_d60)) == "SM");
  const auto points = [](const char *fines) { return Points{{"0", "0"}, {"0.075", fines}, {"4.75", "100"}}; };
  CHECK(symbol(points("49.999999999")) == "SM");
  CHECK(symbol(points("50")) == "ML");
}

TEST_CASE("a gravel has more than half of the coarse part above 4.75 mm", "[uscs]") {
  const auto points = [](const char *passing_4_75) {
    return Points{{"0", "0"}, {"0.075", "20"}, {"4.75", passing_4_75}, {"75", "100"}};
  };
  CHECK(symbol(points("60")) == "SM");
  CHECK(symbol(points("59.999999999")) == "GM");
}

TEST_CASE("`with gravel` and `with sand` start at 15 % of the whole", "[uscs]") {
  CHECK(name(sand("4", "85", well_d60)) == "well-graded sand with gravel");
  CHECK(name(sand("4", "85.000000001", well_d60)) == "well-graded sand");
  CHECK(name(gravel("4", "19", "20")) == "well-graded gravel with sand");
  CHECK(name(gravel("4", "18.999999999", "20")) == "well-graded gravel");
}

TEST_CASE("a well-graded sand has C_u of 6 or more, a gravel 4", "[uscs]") {
  CHECK(symbol(sand("4", "100", "0.6")) == "SW"); // C_c 1.5
  CHECK(symbol(sand("4", "100", "0.599999999")) == "SP");
  CHECK(symbol(clean_gravel("4", "20")) == "GW"); // C_c 1
  CHECK(symbol(clean_gravel("4", "19.999999999")) == "GP");
}

TEST_CASE("C_u is exactly 6 although D10 and D60 are irrational", "[uscs]") {
  const auto points = [](const char *middle) {
    return Points{{"0.1", "0"}, {"0.2", "20"}, {"0.4", "30"}, {middle, "50"}, {"1.2", "70"}, {"4.75", "100"}};
  };
  CHECK(symbol(points("0.6")) == "SW");
  CHECK(symbol(points("0.59999999999999999999999999999999999999")) == "SP");
}

TEST_CASE("a well-graded soil has C_c from 1 to 3", "[uscs]") {
  CHECK(symbol(sand("4", "100", "0.9")) == "SW"); // C_c 1
  CHECK(symbol(sand("4", "100", "0.900000001")) == "SP");
  const auto points = [](const char *d30) {
    return Points{{"0.075", "0"}, {"0.1", "10"}, {d30, "30"}, {"1.2", "60"}, {"4.75", "100"}};
  };
  CHECK(symbol(points("0.6")) == "SW"); // C_c 3
  CHECK(symbol(points("0.600000001")) == "SP");
}

TEST_CASE("the plasticity chart", "[uscs]") {
  const auto fines = [](const char *liquid, const char *plastic) {
    return classify_fines({decimal(liquid), decimal(plastic)});
  };
  // The A-line: PI 14.6 at LL 40, 21.9 at LL 50.
  CHECK(fines("40", "25.4") == Fines::CL);
  CHECK(fines("40", "25.400000001") == Fines::ML);
  CHECK(fines("50", "28.1") == Fines::CH);
  CHECK(fines("50", "28.100000001") == Fines::MH);
  CHECK(fines("49.999999999", "28") == Fines::CL);
  CHECK(fines("49.999999999", "29") == Fines::ML);
  CHECK(fines("90", "30") == Fines::CH);
  CHECK(fines("90", "60") == Fines::MH);
  // The hatched zone: PI 4 to 7 on and above the A-line.
  CHECK(fines("25", "21") == Fines::CL_ML);
  CHECK(fines("25", "21.000000001") == Fines::ML);
  CHECK(fines("25", "18") == Fines::CL_ML);
  CHECK(fines("25", "17.999999999") == Fines::CL);
  CHECK(fines("30", "25") == Fines::ML); // PI 5 below the A-line
  CHECK(fines("15", "13") == Fines::ML); // PI 2 above it
  CHECK(fines("20", "20") == Fines::ML);
  CHECK_THROWS_AS(fines("20", "20.1"), InputError);
  CHECK_THROWS_WITH(fines("20", "-1"), "the plastic limit is negative: give 0 or more, in percent");
  CHECK_THROWS_WITH(fines("-1", "2"), "the liquid limit is negative: give 0 or more, in percent");
  CHECK_THROWS_WITH(fines("-1", "-2"), "the liquid limit is negative: give 0 or more, in percent");
}

TEST_CASE("what is coarser than 0.075 mm is decided at its limits, without a sieve of 4.75 mm", "[uscs]") {
  const auto points = [](const char *fines) {
    return Points{{"0.001", "0"}, {"0.075", fines}, {"25", "100"}};
  };
  CHECK(name(points("85.000000001")) == "silt");
  CHECK(name(points("85")) == "silt with sand");
  CHECK(name(points("70.000000001")) == "silt with sand");
  CHECK(name(points("70")) == "sandy silt");
}

TEST_CASE("the group is that of what passes 75 mm", "[uscs]") {
  // Of the whole 4 % are fines, of the part below 75 mm 8 %; so with C_u and the share of gravel.
  const Points part = sand("8", "80", well_d60);
  Points whole;
  for (const auto &[size, percent] : part)
    whole.emplace_back(size, to_decimal(parse_decimal(percent) / 2));
  whole.emplace_back("300", "100");
  CHECK(group(whole) == UscsGroup{"SW-SM", "well-graded sand with silt, gravel and cobbles"});
  whole.back() = {"300", "50"};
  whole.emplace_back("500", "100");
  CHECK(name(whole) == "well-graded sand with silt, gravel and boulders");
  whole[whole.size() - 2].second = "70";
  CHECK(name(whole) == "well-graded sand with silt, gravel, cobbles and boulders");
}

TEST_CASE("without a sieve of 75 mm in coarser soils there is no group", "[uscs]") {
  const Available<UscsGroup> none =
      classify_uscs(curve({{"0", "0"}, {"0.075", "20"}, {"4.75", "50"}, {"63", "90"}, {"100", "100"}}));
  CHECK_FALSE(none);
  CHECK(none.why().reason.find("no sieve of 75 mm") != std::string::npos);
  CHECK_FALSE(none.why().limited);
  CHECK_FALSE(classify_uscs(curve({{"75", "0"}, {"100", "100"}})));
}

TEST_CASE("bounds that are no sieve are interpolated", "[uscs]") {
  // 0.075 is the geometric middle of 0.05 and 0.1125: 12 % of fines, exactly.
  const auto points = [](const char *above) {
    return Points{{"0.001", "0"}, {"0.05", "10"}, {"0.1125", above}, {"0.2", "30"},
                  {"0.6", "60"},  {"4", "90"},    {"8", "100"}};
  };
  CHECK(symbol(points("14")) == "SW-SM");
  CHECK(symbol(points("14.000000001")) == "SM");
}

TEST_CASE("what is in a pan at size 0 may be fines or not", "[uscs]") {
  const auto points = [](const char *in_pan) {
    return Points{{"0", "0"}, {"0.15", in_pan}, {"0.2", "10"}, {"0.6", "30"}, {"1.8", "60"}, {"4.75", "100"}};
  };
  CHECK(symbol(points("4.9")) == "SW");
  const Available<UscsGroup> open = classify_uscs(curve(points("5")));
  CHECK_FALSE(open);
  CHECK(open.why().reason.find("between SW and SW-SM") != std::string::npos);
}

TEST_CASE("few fines need D10", "[uscs]") {
  const GradingCurve c = curve({{"0", "0"}, {"0.075", "11"}, {"0.2", "20"}, {"0.6", "60"}, {"4.75", "100"}});
  CHECK_FALSE(classify_uscs(c));
  CHECK(classify_uscs(c).why().reason.find("D10 is below 0.075 mm") != std::string::npos);
  CHECK(classify_uscs(c, Fines::ML, true)->symbol == "SW-SM");
}

TEST_CASE("what all bits leave open is told as a limit", "[uscs]") {
  // Gravel and sand have equal shares; both are interpolated at irrational logarithms, with the same ratio.
  const Available<UscsGroup> open = classify_uscs(
      curve({{"0.06", "0"}, {"0.12", "20"}, {"3.8", "50"}, {"7.6", "60"}, {"20", "100"}}), Fines::ML);
  CHECK_FALSE(open);
  CHECK(open.why().limited);
  CHECK(open.why().reason.find("gravel against sand") != std::string::npos);
}

} // namespace uscs_test

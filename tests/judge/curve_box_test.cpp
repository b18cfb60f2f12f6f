// The curves that round to a report.

#include "catch.hpp"
#include "judge/curve_box.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

namespace curve_box_test {

using namespace mdm;

namespace {

CurveBox box(const std::string &csv, const std::optional<Rational> &unit = std::nullopt) {
  return curves_of(understand_gradation(csv, "sand.csv"), unit);
}

void check_range(const Interval &range, const char *lo, const char *hi) {
  CHECK(to_string(range.lo) == lo);
  CHECK(to_string(range.hi) == hi);
}

} // namespace

TEST_CASE("a percent stands for what rounds to its last digit", "[box]") {
  const CurveBox b = box("size_mm,passing_percent\n4,100\n2,71.20\n1,30.5\n0.5,7\n");
  REQUIRE(b.openings.size() == 5);
  CHECK_FALSE(b.is_exact);
  check_range(b.passing[0], "0", "0");
  check_range(b.passing[1], "13/2", "15/2");
  check_range(b.passing[2], "609/20", "611/20");
  check_range(b.passing[3], "14239/200", "14241/200");
  check_range(b.passing[4], "100", "100");
}

TEST_CASE("what rounds to 0 or 100 is no more and no less, and no curve falls", "[box]") {
  const CurveBox b = box("size_mm,passing_percent\n8,100\n4,100\n2,50\n1,50\n0.5,0\n");
  check_range(b.passing[1], "0", "1/2");
  check_range(b.passing[2], "99/2", "101/2");
  check_range(b.passing[3], "99/2", "101/2");
  check_range(b.passing[4], "199/2", "100");
}

TEST_CASE("percents retained together give what may pass", "[box]") {
  // Each is 0.05 of itself uncertain, and they add up to 100: 20.0 + 30.1 + 50.0 = 100.1.
  const CurveBox b = box("size_mm,retained_percent\n4,0\n2,20.0\n1,30.1\npan,50.0\n");
  REQUIRE(b.openings.size() == 4);
  // At 1 mm: at least 49.95, and at most 100 - 19.95 - 30.05.
  check_range(b.passing[1], "999/20", "50");
  // At 2 mm: 100 - [19.95, 20.05], and at least 49.95 + 30.05.
  check_range(b.passing[2], "80", "1601/20");
  check_range(b.retained[1], "601/20", "603/20");
}

TEST_CASE("fractions retained are parts of 1", "[box]") {
  const CurveBox b = box("size_mm,retained_fraction\n4,0\n2,0.25\npan,0.75\n");
  check_range(b.passing[1], "149/2", "151/2");
}

TEST_CASE("masses are exact, unless the user says how percents were rounded", "[box]") {
  const std::string masses = "size_mm,mass\n4,0\n2,1\n1,2\n";
  const CurveBox exact = box(masses), rounded = box(masses, ratio(1, 10));
  CHECK(exact.is_exact);
  check_range(exact.passing[2], "200/3", "200/3");
  CHECK_FALSE(rounded.is_exact);
  check_range(rounded.passing[2], "3997/60", "4003/60");
  // Nothing passes 1 mm, to the rounding.
  check_range(rounded.passing[1], "0", "1/20");
}

TEST_CASE("percents are exact where the user says so", "[box]") {
  const CurveBox b = box("size_mm,passing_percent\n4,100\n2,71\n1,30\n", Rational(0));
  CHECK(b.is_exact);
  check_range(b.passing[2], "71", "71");
  CHECK(box("size_mm,retained_percent\n4,0\n2,20.0\n1,30.1\npan,50.0\n", Rational(0)).is_exact);
}

TEST_CASE("percents retained that are far from 100 are refused", "[box]") {
  const std::string short_of = "size_mm,retained_percent\n4,0\n2,20.0\n1,30.0\npan,49.8\n";
  CHECK_THROWS_WITH(box(short_of), Catch::Contains("do not add up to 100"));
  CHECK_NOTHROW(box(short_of, Rational(0)));
  CHECK_NOTHROW(box(short_of, Rational(1)));
  CHECK_THROWS_WITH(box("size_mm,retained_percent\n4,0\n2,101\npan,0\n"),
                    Catch::Contains("do not add up to 100"));
}

} // namespace curve_box_test

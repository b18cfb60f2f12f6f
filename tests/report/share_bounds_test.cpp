#include "catch.hpp"
#include "report/share_bounds.hpp"

namespace share_bounds_test {

using namespace mdm;

namespace {

Gradation gradation() {
  return Gradation({0, 1, 2, 4}, {1, 2, 1, 0});
}

/// The errors of a sample with these masses in the classes.
MatchError found(const std::vector<Interval> &shares) {
  MatchError e;
  e.shares = shares;
  for (const Interval &s : shares)
    e.total = e.total + absolute(Interval(ratio(1, 4)) - s);
  return e;
}

} // namespace

TEST_CASE("Shares are compared with closed bounds, of classes, of what passes and of the sum of errors") {
  const Gradation g = gradation();
  const MatchError e = found({ratio(1, 4), ratio(1, 2), ratio(1, 4)});
  Tolerance t;
  CHECK(check_bounds(t, e, g, 6).holds == true);
  t.retained = {{0, 1}, {ratio(1, 2), ratio(1, 2)}, {0, ratio(1, 4)}};
  CHECK(check_bounds(t, e, g, 6).holds == true);
  t.retained[2].hi = ratio(24, 100);
  CHECK(check_bounds(t, e, g, 6).holds == false);
  CHECK(check_bounds(t, e, g, 6).reason == "the share of class 3 is 25 %, and the limits are 0 and 24 %");

  t = {};
  t.passing = {{0, ratio(1, 4)}, {ratio(3, 4), 1}, {1, 1}};
  CHECK(check_bounds(t, e, g, 6).holds == true);
  t.passing[1].lo = ratio(76, 100);
  CHECK(check_bounds(t, e, g, 6).holds == false);
  CHECK(check_bounds(t, e, g, 6).reason == "what passes 2 mm is 75 %, and the limits are 76 and 100 %");

  t = {};
  t.total = ratio(1, 4);
  CHECK(check_bounds(t, e, g, 6).holds == true);
  t.total = ratio(24, 100);
  CHECK(check_bounds(t, e, g, 6).holds == false);
}

TEST_CASE("Enclosures of shares around a bound leave it open") {
  const Gradation g = gradation();
  const MatchError e = found({Interval(ratio(24, 100), ratio(26, 100)), ratio(1, 2), ratio(1, 4)});
  Tolerance t;
  t.retained = {{ratio(1, 4), 1}, {0, 1}, {0, 1}};
  CHECK_FALSE(check_bounds(t, e, g, 6).holds.has_value());
  t.retained[0].lo = ratio(24, 100);
  CHECK(check_bounds(t, e, g, 6).holds == true);
  // What is broken counts more than what is open before it.
  t.retained = {{ratio(1, 4), 1}, {0, ratio(4, 10)}, {0, 1}};
  CHECK(check_bounds(t, e, g, 6).holds == false);
  CHECK(check_bounds(t, e, g, 6).reason.find("class 2") != std::string::npos);
}

TEST_CASE("A share and the limit that it misses have digits that tell them apart") {
  const Gradation g = gradation();
  const Rational little = ratio(1, Integer("1000000000000"));
  const MatchError e = found({Rational(ratio(1, 4) + little), ratio(1, 2), ratio(1, 4)});
  Tolerance t;
  t.retained = {{0, ratio(1, 4)}, {0, 1}, {0, 1}};
  CHECK(check_bounds(t, e, g, 6).reason ==
        "the share of class 1 is 25.0000000001 %, and the limits are 0 and 25 %");
  t = {};
  t.total = ratio(1, 4);
  CHECK(check_bounds(t, e, g, 6).reason ==
        "the errors of all shares sum to 25.0000000001 %, and the limit is 25 %");
}

} // namespace share_bounds_test

// Relative breakage against areas by hand, and against sums of thin strips.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/breakage.hpp"

#include <cmath>

namespace breakage_test {

using namespace mdm;
using grading_test::curve;

namespace {

double value(const Real &y) {
  const Ball b = y.ball(100);
  return (b.lower().convert_to<double>() + b.upper().convert_to<double>()) / 2;
}

std::vector<Interval> shares(const std::vector<Rational> &passing) {
  return {passing.begin(), passing.end()};
}

struct Both {
  double lo, hi;
};

Both both(const Available<RealRange> &y) {
  REQUIRE(y);
  return {value(y->lo), value(y->hi)};
}

/// Share that passes x of points (size, share), linear in log size.
double passes(const std::vector<double> &sizes, const std::vector<double> &p, double x) {
  if (x <= sizes.front())
    return p.front();
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
    if (x <= sizes[i + 1])
      return p[i] + (p[i + 1] - p[i]) * std::log(x / sizes[i]) / std::log(sizes[i + 1] / sizes[i]);
  return 1;
}

} // namespace

TEST_CASE("breakage of Hardin: decades by hand", "[breakage]") {
  // All of it in (7.4, 74] mm: two decades and half of one can pass.
  const GradingCurve known = curve({{"0.74", "0"}, {"7.4", "0"}, {"74", "100"}});
  const Both broken = both(breakage(known, shares({0, ratio(1, 2), 1})).hardin);
  CHECK(broken.lo == Approx(0.2)); // half of it passes 7.4 mm: two triangles of a decade and half a share
  CHECK(broken.hi == Approx(0.2));
  const Both none = both(breakage(known, shares({0, 0, 1})).hardin);
  CHECK(none.lo == 0);
  CHECK(none.hi == 0);
  // Without a sieve below: what passes 7.4 mm may be just below it, or dust.
  const GradingCurve open = curve({{"7.4", "0"}, {"74", "100"}});
  const Both range = both(breakage(open, shares({ratio(1, 2), 1})).hardin);
  CHECK(range.lo == Approx(0.1));
  CHECK(range.hi == Approx(0.5));
}

TEST_CASE("breakage of Hardin counts from 0.074 mm", "[breakage]") {
  // A class from a tenth to ten times of it, in which half had passed it.
  const GradingCurve before = curve({{"0.0074", "0"}, {"0.74", "100"}});
  const Both broken = both(breakage(before, shares({ratio(1, 2), 1})).hardin);
  CHECK(broken.lo == Approx(0.5)); // (1/4 / 2) / (1/2 / 2)
  CHECK(broken.hi == Approx(0.5));
  const GradingCurve at = curve({{"0.074", "0"}, {"0.74", "100"}});
  CHECK(both(breakage(at, shares({ratio(1, 10), 1})).hardin).hi == Approx(0.1));
  const GradingCurve silt = curve({{"0.002", "0"}, {"0.074", "100"}});
  CHECK(breakage(silt, shares({0, 1})).hardin.why().reason ==
        "nothing was coarser than 0.074 mm at the beginning");
}

TEST_CASE("breakage of Einav: two classes by hand", "[breakage]") {
  // All of it in (16, 32]; the fractal of 1 to 32 mm has the area 5/2 - log 32 / 3, since 32^0.4 = 4.
  const GradingCurve before = curve({{"1", "0"}, {"16", "0"}, {"32", "100"}});
  const double possible = 2.5 - std::log(32.0) / 3 - std::log(2.0) / 2;
  const Both broken = both(breakage(before, shares({0, ratio(1, 2), 1})).einav);
  CHECK(broken.lo == Approx(std::log(32.0) / 4 / possible));
  CHECK(broken.hi == Approx(broken.lo));
  CHECK(both(breakage(before, shares({0, 0, 1})).einav).hi == 0);
  CHECK(!breakage(curve({{"1", "0"}, {"32", "100"}}), shares({0, 1})).einav); // finer than the fractal
}

TEST_CASE("breakage with a pan, and sieves that nothing stays on", "[breakage]") {
  const GradingCurve pan = curve({{"0", "0"}, {"0.15", "10"}, {"0.6", "60"}, {"1.2", "100"}});
  CHECK(breakage(pan, shares({0, ratio(1, 5), ratio(4, 5), 1})).hardin.why().reason ==
        "what passed the finest sieve at the beginning is not known down to 0.074 mm");
  const GradingCurve dust = curve({{"0", "0"}, {"2", "100"}});
  CHECK(breakage(dust, shares({0, 1})).einav.why().reason == "all passed the finest sieve at the beginning");
  // The empty classes above the largest grain change nothing.
  const GradingCurve narrow = curve({{"1", "0"}, {"2", "10"}, {"8", "100"}});
  const GradingCurve wide = curve({{"1", "0"}, {"2", "10"}, {"8", "100"}, {"80", "100"}});
  const Breakage a = breakage(narrow, shares({0, ratio(1, 4), 1}));
  const Breakage b = breakage(wide, shares({0, ratio(1, 4), 1, 1}));
  CHECK(both(a.einav).lo == Approx(both(b.einav).lo));
  CHECK(both(a.hardin).lo == Approx(both(b.hardin).lo));
}

TEST_CASE("breakage against sums of thin strips", "[breakage]") {
  const std::vector<double> sizes = {0.05, 0.1, 0.3, 1, 2.5, 6};
  const std::vector<double> was = {0, 0.01, 0.05, 0.2, 0.6, 1}, is = {0, 0.03, 0.15, 0.4, 0.85, 1};
  const GradingCurve before =
      curve({{"0.05", "0"}, {"0.1", "1"}, {"0.3", "5"}, {"1", "20"}, {"2.5", "60"}, {"6", "100"}});
  const Breakage b =
      breakage(before, shares({0, ratio(3, 100), ratio(15, 100), ratio(40, 100), ratio(85, 100), 1}));
  const auto quotient = [&](double from, auto possible) {
    constexpr int strips = 200000;
    const double step = std::log(6 / from) / strips;
    double broken = 0, most = 0;
    for (int i = 0; i < strips; ++i) {
      const double x = from * std::exp((i + 0.5) * step);
      broken += passes(sizes, is, x) - passes(sizes, was, x);
      most += possible(x) - passes(sizes, was, x);
    }
    return broken / most;
  };
  CHECK(both(b.hardin).lo == Approx(quotient(0.074, [](double) { return 1.0; })).epsilon(1e-6));
  CHECK(both(b.einav).hi == Approx(quotient(0.05, [](double x) {
                              const double m = std::pow(0.05, 0.4);
                              return (std::pow(x, 0.4) - m) / (std::pow(6, 0.4) - m);
                            })).epsilon(1e-6));
}

} // namespace breakage_test

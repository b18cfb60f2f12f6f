// Shapes with a C_u and a C_c: against shapes that were chosen first, closed forms, and an independent
// computation.

#include "all_cases.hpp"
#include "catch.hpp"
#include "sets/beta_curve.hpp"
#include "sets/inverse_model.hpp"

#include <utility>
#include <vector>

namespace inverse_model_test {

using namespace mdm;

namespace {

InverseShapes shapes(const Interval &c_u, const Interval &c_c, const Rational &span,
                     const Rational &from = ratio(1, 10), const Rational &to = 20) {
  return inverse_shapes({c_u, c_c, span, {from, to}});
}

Interval enclosed(const Real &y) {
  const Enclosure e = enclose(y, 30);
  return {e.lower(), e.upper()};
}

bool holds(const Interval &y, const Rational &value) {
  return y.lo <= value && value <= y.hi;
}

/// The size of the share p, by bisection of the sum of binomial terms: whole a and b.
Rational share_below(unsigned a, unsigned b, const Rational &x) {
  Rational sum = 0;
  const unsigned n = a + b - 1;
  for (unsigned j = a; j <= n; ++j) {
    Integer ways = 1;
    for (unsigned i = 0; i < j; ++i)
      ways = ways * (n - i) / (i + 1);
    sum += Rational(ways) * power(x, j) * power(Rational(1 - x), n - j);
  }
  return sum;
}

Rational size_of_share(unsigned a, unsigned b, const Rational &span, const Rational &p) {
  Rational lo = 0, hi = 1;
  for (int i = 0; i < 90; ++i) {
    const Rational m = (lo + hi) / 2;
    (share_below(a, b, m) < p ? lo : hi) = m;
  }
  return 1 + 2 * span / (1 - span) * lo;
}

} // namespace

TEST_CASE("the shape that a C_u and a C_c were taken from is found, and proved to be there", "[inverse]") {
  std::vector<std::pair<unsigned, unsigned>> taken = {{1, 3}};
  if (takes_all_cases())
    taken.emplace_back(2, 1);
  for (const auto &[a, b] : taken) {
    const Rational span = ratio(9, 10);
    const auto size = [&, a = a, b = b](int percent) {
      return size_of_share(a, b, span, ratio(percent, 100));
    };
    const Rational d10 = size(10), d30 = size(30), d60 = size(60), tiny = ratio(1, power_of_ten(20));
    const Rational c_u = d60 / d10, c_c = d30 * d30 / (d60 * d10);
    const InverseShapes found = shapes({Rational(c_u - tiny), Rational(c_u + tiny)},
                                       {Rational(c_c - tiny), Rational(c_c + tiny)}, span);
    INFO(a << ", " << b);
    CHECK(found.complete);
    bool is_there = false;
    for (const ShapeBox &box : found.boxes)
      if (holds(box.a, Rational(a)) && holds(box.b, Rational(b))) {
        is_there = true;
        CHECK(box.holds_one);
        CHECK(box.a.hi - box.a.lo < ratio(1, 50));
      }
    CHECK(is_there);
  }
}

TEST_CASE("boxes have the shapes of an independent computation", "[inverse]") {
  // By scipy.special.betaincinv and a search of boxes in doubles.
  const InverseShapes found = shapes(Rational(6), ratio(6, 5), ratio(95, 100));
  REQUIRE(found.boxes.size() == 1);
  CHECK(holds(found.boxes[0].a, ratio(862450, 1000000)));
  CHECK(holds(found.boxes[0].b, ratio(161349, 100000)));
  CHECK(found.is_certain());
}

TEST_CASE("the C_u and C_c of every proved box are those that were asked for", "[inverse]") {
  const Rational span = ratio(95, 100);
  const InverseShapes found = shapes(Rational(4), Rational(2), span);
  REQUIRE_FALSE(found.boxes.empty());
  for (const ShapeBox &box : found.boxes) {
    const BetaCurve curve(Rational((box.a.lo + box.a.hi) / 2), Rational((box.b.lo + box.b.hi) / 2), 1,
                          (1 + span) / (1 - span));
    CHECK(abs(Rational(enclosed(uniformity(curve)).lo - 4)) < ratio(1, 100));
    CHECK(abs(Rational(enclosed(curvature(curve)).lo - 2)) < ratio(1, 100));
  }
}

TEST_CASE("where no shape can have them there is none, and that is certain", "[inverse]") {
  // d_60 / d_10 is below R = 3.
  const InverseShapes wide = shapes(Rational(6), Rational(1), ratio(1, 2));
  CHECK(wide.boxes.empty());
  CHECK(wide.is_certain());
  // d_30 / d_10 = sqrt(C_u C_c) would be above d_60 / d_10, or below 1.
  for (const Rational &c_c : {Rational(7), ratio(1, 10)}) {
    const InverseShapes none = shapes(Rational(6), c_c, ratio(95, 100));
    CHECK(none.boxes.empty());
    CHECK(none.examined == 0);
  }
  // The shape of the first test, (1, 3), is not in this range.
  CHECK(shapes(Rational(6), ratio(6, 5), ratio(95, 100), 2, 20).boxes.empty());
}

TEST_CASE("a shape at the edge of the range is not proved to be inside", "[inverse]") {
  const Rational span = ratio(95, 100);
  const BetaCurve curve(1, 3, 1, (1 + span) / (1 - span));
  const InverseShapes found = shapes(enclosed(uniformity(curve)), enclosed(curvature(curve)), span, 1, 20);
  REQUIRE(found.boxes.size() == 1);
  CHECK(holds(found.boxes[0].a, 1));
  CHECK_FALSE(found.boxes[0].holds_one);
  CHECK_FALSE(found.is_certain());
}

} // namespace inverse_model_test

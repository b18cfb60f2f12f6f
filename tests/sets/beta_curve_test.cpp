// The cumulative beta curve against finite sums, symmetry and closed forms.

#include "catch.hpp"
#include "sets/beta_curve.hpp"

#include <mdm/text/error.hpp>

namespace beta_curve_test {

using namespace mdm;

namespace {

bool holds(const Ball &ball, const Rational &r) {
  return ball.is_finite() && ball.lower() <= r && r <= ball.upper();
}

/// I_x(a, b) for integers: the chance of at least a successes in a + b - 1 trials.
Rational binomial_tail(const Rational &x, unsigned a, unsigned b) {
  const unsigned n = a + b - 1;
  Rational sum = 0;
  for (unsigned j = a; j <= n; ++j) {
    Rational choose = 1;
    for (unsigned i = 1; i <= j; ++i)
      choose *= ratio(n - j + i, i);
    sum += choose * power(x, j) * power(Rational(1 - x), n - j);
  }
  return sum;
}

/// sqrt r within 2^-200.
Ball root(const Rational &r) {
  return pow(Ball(r, 200), ratio(1, 2));
}

/// I_x(n + 1/2, b), b an integer, step by step from I_x(1/2, 1) = sqrt x: I_x(a, b + 1) = I_x(a, b) + x^a
/// (1-x)^b / (b B(a, b)) and I_x(a + 1, b) = I_x(a, b) - x^a (1-x)^b / (a B(a, b)).
Ball half_integer(const Rational &x, unsigned n, unsigned b) {
  Rational a = ratio(1, 2);
  Rational beta = 2; // B(a, c)
  Ball value = root(x);
  Rational x_power = 1; // x^(a - 1/2)
  unsigned c = 1;
  for (; c < b; ++c) {
    value = value + root(x) * Ball(Rational(x_power * power(Rational(1 - x), c) / (c * beta)), 200);
    beta *= c / (a + c);
  }
  for (unsigned i = 0; i < n; ++i) {
    value = value - root(x) * Ball(Rational(x_power * power(Rational(1 - x), c) / (a * beta)), 200);
    beta *= a / (a + c);
    x_power *= x;
    a += 1;
  }
  return value;
}

BetaCurve curve(const Rational &a, const Rational &b) {
  return BetaCurve(a, b, 1, 101);
}

} // namespace

TEST_CASE("integer parameters give the binomial sum, exactly and in the enclosure") {
  for (unsigned a = 1; a <= 6; ++a)
    for (unsigned b = 1; b <= 6; ++b)
      for (int i = 0; i <= 7; ++i) {
        const Rational x = ratio(i, 7);
        const Rational expected = binomial_tail(x, a, b);
        CHECK(exact_incomplete_beta(x, a, b) == expected);
        CHECK(curve(a, b).passing(Surd(Rational(1 + 100 * x))).fraction() == expected);
        CHECK(holds(incomplete_beta(Ball(x, 200), a, b), expected));
      }
}

TEST_CASE("half-integer parameters give the finite sum of the recurrences") {
  for (unsigned n = 0; n < 4; ++n)
    for (unsigned b = 1; b < 5; ++b)
      for (const Rational &x : {ratio(1, 9), ratio(1, 3), ratio(6, 7)}) {
        const Rational a = n + ratio(1, 2);
        const Ball expected = half_integer(x, n, b);
        CHECK(compare(incomplete_beta(Ball(x, 200), a, b), expected) == Order::undecided);
        CHECK(expected.upper() - expected.lower() < ratio(1, power_of_ten(40)));
        if (const std::optional<Rational> exact = exact_incomplete_beta(x, a, b))
          CHECK(holds(expected, *exact));
        CHECK(exact_incomplete_beta(x, a, b).has_value() == (x == ratio(1, 9)));
      }
}

TEST_CASE("I_x(a, b) = 1 - I_{1-x}(b, a)") {
  for (const auto &[a, b] : {std::pair(ratio(7, 10), ratio(13, 10)), std::pair(ratio(1, 100), Rational(30)),
                             std::pair(ratio(355, 113), ratio(22, 7))})
    for (int i = 1; i < 10; ++i) {
      const Rational x = ratio(i, 10);
      const Ball left = incomplete_beta(Ball(x, 200), a, b);
      const Ball right = Ball(1, 200) - incomplete_beta(Ball(Rational(1 - x), 200), b, a);
      CHECK(compare(left, right) == Order::undecided);
      CHECK(left.upper() - left.lower() < ratio(1, power_of_ten(30)));
    }
}

TEST_CASE("closed forms are found where they are fractions") {
  const Rational half = ratio(1, 2);
  CHECK(exact_incomplete_beta(ratio(1, 4), half, half) == ratio(1, 3));
  CHECK(exact_incomplete_beta(ratio(3, 4), half, half) == ratio(2, 3));
  CHECK(exact_incomplete_beta(half, ratio(17, 10), ratio(17, 10)) == half);
  CHECK(exact_incomplete_beta(ratio(4, 9), ratio(3, 2), 1) == ratio(8, 27));
  CHECK(exact_incomplete_beta(ratio(5, 9), 1, ratio(3, 2)) == Rational(1 - ratio(8, 27)));
  CHECK_FALSE(exact_incomplete_beta(half, ratio(3, 2), 1));
  CHECK_FALSE(exact_incomplete_beta(ratio(1, 3), half, half));
  for (const auto &[x, y] : {std::pair(ratio(1, 4), ratio(1, 3)), std::pair(ratio(3, 4), ratio(2, 3))})
    CHECK(holds(incomplete_beta(Ball(x, 100), half, half), y));
}

TEST_CASE("the inverse holds what it inverts") {
  const Rational half = ratio(1, 2);
  for (const unsigned bits : {60U, 300U, 2000U}) {
    const Ball quarter = inverse_incomplete_beta(ratio(1, 3), half, half, bits);
    CHECK(holds(quarter, ratio(1, 4)));
    CHECK(quarter.upper() - quarter.lower() < ratio(1, Integer(1) << (bits - 10)));
  }
  for (const auto &[a, b] : {std::pair(Rational(3), Rational(3)), std::pair(ratio(1, 10), ratio(1, 5)),
                             std::pair(Rational(900), half)})
    for (const Rational &x : {ratio(1, 100), ratio(1, 3), ratio(99, 100)}) {
      const Ball y = incomplete_beta(Ball(x, 300), a, b);
      if (y.lower() < ratio(1, 100) || y.upper() > ratio(99, 100))
        continue;
      CHECK(inverse_incomplete_beta(y.lower(), a, b, 100).lower() <= x);
      CHECK(inverse_incomplete_beta(y.upper(), a, b, 100).upper() >= x);
    }
}

TEST_CASE("inverses nearer to an end than 2^-500 are found, from either end") {
  constexpr unsigned bits = 2000;
  const Rational a = ratio(333, 1000), b = ratio(1, 1000);
  for (const Rational &y : {ratio(1, 3), ratio(1, 2), ratio(2, 3)}) {
    const Ball x = inverse_incomplete_beta(y, a, b, bits), rest = inverse_incomplete_beta(1 - y, b, a, bits);
    CHECK(x.upper() - x.lower() <= ratio(1, Integer(1) << (bits - 1)));
    CHECK(rest.upper() - rest.lower() <= ratio(1, Integer(1) << (bits - 1)));
    CHECK(x.lower() <= 1 - rest.lower());
    CHECK(1 - rest.upper() <= x.upper());
    CHECK(rest.lower() < ratio(1, Integer(1) << 500));
    CHECK(compare(incomplete_beta(Ball(rest.lower(), 2 * bits), b, a), Ball(1 - y, 2 * bits)) !=
          Order::greater);
    CHECK(compare(incomplete_beta(Ball(rest.upper(), 2 * bits), b, a), Ball(1 - y, 2 * bits)) != Order::less);
  }
}

TEST_CASE("diameters and coefficients of the curve") {
  CHECK(curve(1, 1).diameter(ratio(1, 4)).fraction() == Rational(26));
  CHECK(curve(2, 1).diameter(ratio(1, 4)).fraction() == Rational(51));
  CHECK(curve(ratio(7, 3), ratio(7, 3)).diameter(ratio(1, 2)).fraction() == Rational(51));
  CHECK(uniformity(curve(1, 1)).fraction() == ratio(61, 11));
  CHECK(curvature(curve(1, 1)).fraction() == ratio(31 * 31, 61 * 11));
  // 1 + 100 x with 3 x^2 - 2 x^3 = 6/10 and 1/10
  CHECK(rounded(uniformity(curve(2, 2)), 8) == "2.8040264");
}

TEST_CASE("shapes are those of the paper's table") {
  const Rational half = ratio(1, 2);
  CHECK(curve(half, half).shape() == "U-shaped, symmetric");
  CHECK(curve(half, ratio(1, 3)).shape() == "U-shaped");
  CHECK(curve(half, 1).shape() == "strictly decreasing, a power law");
  CHECK(curve(half, 3).shape() == "strictly decreasing");
  CHECK(curve(1, half).shape() == "strictly increasing, a power law");
  CHECK(curve(2, 1).shape() == "strictly increasing, a straight line");
  CHECK(curve(ratio(3, 2), 1).shape() == "strictly increasing, strictly concave, a power law");
  CHECK(curve(3, 3).shape() == "unimodal, symmetric");
  CHECK(curve(1, 3).shape() == "strictly decreasing, strictly convex, a power law");
  CHECK(curve(1, 2).shape() == "strictly decreasing, a straight line");
  CHECK(curve(1, ratio(3, 2)).shape() == "strictly decreasing, strictly concave, a power law");
  CHECK(curve(1, 1).shape() == "uniform");
  CHECK(curve(2, half).shape() == "strictly increasing");
  CHECK(curve(3, 1).shape() == "strictly increasing, strictly convex, a power law");
  CHECK(curve(3, 4).shape() == "unimodal");
  CHECK(curve(half, half).course() == "concave, then convex");
  CHECK(curve(half, 3).course() == "strictly concave");
  CHECK(curve(1, 3).course() == "strictly concave");
  CHECK(curve(1, half).course() == "strictly convex");
  CHECK(curve(1, 1).course() == "a straight line");
  CHECK(curve(ratio(3, 2), 1).course() == "strictly convex");
  CHECK(curve(2, half).course() == "strictly convex");
  CHECK(curve(2, 4).course() == "double curved: convex, then concave");
}

TEST_CASE("a curve without sizes, without width or without shape is refused") {
  CHECK_THROWS_AS(BetaCurve(0, 1, 1, 2), InputError);
  CHECK_THROWS_AS(BetaCurve(1, -1, 1, 2), InputError);
  CHECK_THROWS_AS(BetaCurve(1000000, 1, 1, 2), InputError);
  CHECK_THROWS_AS(BetaCurve(1, 1, 0, 2), InputError);
  CHECK_THROWS_AS(BetaCurve(1, 1, 2, 2), InputError);
  CHECK_THROWS_AS(BetaCurve(1, 1, 3, 2), InputError);
}

} // namespace beta_curve_test

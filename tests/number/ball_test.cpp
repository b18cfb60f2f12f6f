// Balls hold the exact results, and say only what is certain.

#include "catch.hpp"
#include "number/ball.hpp"

#include <random>
#include <thread>
#include <vector>

namespace ball_test {

using namespace mdm;

namespace {

bool holds(const Ball &ball, const Rational &r) {
  return ball.is_finite() && ball.lower() <= r && r <= ball.upper();
}

bool is_narrow(const Ball &ball, const Rational &width) {
  return ball.upper() - ball.lower() <= width;
}

/// A fraction with a numerator up to 10^9 and a denominator up to 10^6, biased to short ones.
Rational any(std::mt19937_64 &random, int least) {
  const auto number = [&random](int lo, int hi) {
    return std::uniform_int_distribution<int>(lo, hi)(random);
  };
  return random() % 4 == 0 ? Rational(number(std::max(least, -3), 3))
                           : ratio(number(least, 1000000000), number(1, 1000000));
}

/// r with 300 binary places, rounded down.
Rational cut(const Rational &r) {
  const Integer unit = power(Integer(2), 300);
  return ratio(floor(Rational(r * unit)), unit);
}

/// e^x by the exponential series: fractions around it. \pre |x| <= 64
std::pair<Rational, Rational> exp_by_series(const Rational &x) {
  const Rational part = abs(x) / 64, ulp = ratio(1, power(Integer(2), 300));
  Rational term = 1, sum = 1;
  int n = 0;
  while (term > 0) {
    term = cut(term * part / ++n);
    sum += term;
  }
  Rational lo = sum,
           hi = sum + 4 * n * ulp; // of the terms, each is too small by less than 2 ulp; less is left out
  for (int i = 0; i < 6; ++i) {
    lo = cut(lo * lo);
    hi = cut(hi * hi) + ulp;
  }
  return x < 0 ? std::pair<Rational, Rational>(1 / hi, 1 / lo) : std::pair(lo, hi);
}

} // namespace

TEST_CASE("the four operations hold the exact result", "[ball]") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const unsigned bits = i % 2 == 0 ? 53 : 200;
    const Rational a = any(random, -1000000000), b = any(random, -1000000000);
    const Ball x(a, bits), y(b, bits);
    CHECK(holds(x, a));
    CHECK(holds(x + y, a + b));
    CHECK(holds(x - y, a - b));
    CHECK(holds(x * y, a * b));
    if (b != 0)
      CHECK(holds(x / y, a / b));
  }
}

TEST_CASE("log and exp agree with the exponential series", "[ball]") {
  std::mt19937_64 random(2);
  const Rational narrow = ratio(1, power(Integer(2), 180));
  for (int i = 0; i < 300; ++i) {
    const Rational a = any(random, 1);
    const Ball y = log(Ball(a, 200));
    CHECK(exp_by_series(y.lower()).first <= a);
    CHECK(a <= exp_by_series(y.upper()).second);
    CHECK(is_narrow(y, narrow));
    CHECK(holds(exp(y), a));
    const Rational small = a / 1000000000;
    const Ball e = exp(Ball(small, 200));
    const auto [from, to] = exp_by_series(small);
    CHECK(e.lower() <= to);
    CHECK(from <= e.upper());
    CHECK(is_narrow(e, narrow));
  }
}

TEST_CASE("a power that is a number of so many digits is a point", "[ball]") {
  for (const auto &[base, exponent, value] : {std::tuple(Rational(8), ratio(1, 3), Rational(2)),
                                              {4, ratio(3, 2), 8},
                                              {ratio(1, 4), ratio(-1, 2), 2},
                                              {0, ratio(1, 3), 0},
                                              {3, 0, 1},
                                              {ratio(3, 2), 2, ratio(9, 4)}})
    CHECK(compare(pow(Ball(base, 64), exponent), Ball(value, 64)) == Order::equal);
  CHECK_FALSE(pow(Ball(0, 64), -1).is_finite());
  CHECK_FALSE(pow(Ball(-1, 64), ratio(1, 3)).is_finite());
  // Exponents of many digits are taken by logarithms.
  const Ball by_log = pow(Ball(2, 100), ratio(100001, 100000)), near = pow(Ball(2, 100), ratio(1001, 1000));
  CHECK(compare(by_log, near) == Order::less);
  CHECK(compare(by_log, Ball(2, 100)) == Order::greater);
}

TEST_CASE("rational powers hold exact roots", "[ball]") {
  std::mt19937_64 random(3);
  for (unsigned i = 0; i < 300; ++i) {
    const Rational root = any(random, 1);
    const unsigned degree = 1 + i % 7;
    CHECK(holds(pow(Ball(power(root, degree), 100), ratio(1, degree)), root));
    CHECK(holds(pow(Ball(root, 100), ratio(-2, 1)), 1 / (root * root)));
  }
}

TEST_CASE("comparisons are certain or undecided", "[ball]") {
  const Ball third(ratio(1, 3), 64), two(2, 64), half(ratio(1, 2), 64);
  CHECK(compare(third, half) == Order::less);
  CHECK(compare(half, third) == Order::greater);
  CHECK(compare(half, half) == Order::equal);
  CHECK(compare(third, third) == Order::undecided); // 1/3 is no point of 64 bits
  CHECK(compare(third, Ball(ratio(1, 3) + ratio(1, power(Integer(10), 30)), 64)) == Order::undecided);
  CHECK(compare(third, Ball(ratio(1, 3) + ratio(1, power(Integer(10), 30)), 128)) == Order::undecided);
  CHECK(compare(Ball(ratio(1, 3), 128), Ball(ratio(1, 3) + ratio(1, power(Integer(10), 30)), 128)) ==
        Order::less);
  CHECK(compare(log(two), half) == Order::greater);
}

TEST_CASE("what has no value is not finite, and nothing is certain of it", "[ball]") {
  const Ball zero(0, 64), minus(-1, 64), two(2, 64);
  for (const Ball &none : {log(zero), log(minus), two / zero}) {
    CHECK_FALSE(none.is_finite());
    CHECK(compare(none, two) == Order::undecided);
    CHECK(compare(two, none) == Order::undecided);
    CHECK_FALSE((none + two).is_finite());
  }
}

TEST_CASE("balls are values", "[ball]") {
  Ball a(ratio(1, 3), 64), b = a;
  a = Ball(5, 64);
  CHECK(holds(b, ratio(1, 3)));
  CHECK(holds(a, 5));
  b = std::move(a);
  CHECK(holds(b, 5));
  const Ball &same = b;
  b = same;
  CHECK(holds(b, 5));
}

TEST_CASE("the error function has its known digits", "[ball]") {
  CHECK(holds(erf(Ball(0, 100)), 0));
  // erf(1) = 0.84270079294971486934122063508..., and it is odd.
  const Rational cut = ratio(Integer("84270079294971486934"), power_of_ten(20));
  const Ball at_one = erf(Ball(1, 100));
  CHECK(at_one.lower() > cut);
  CHECK(at_one.upper() < cut + ratio(1, power_of_ten(20)));
  CHECK(holds(at_one + erf(Ball(-1, 100)), 0));
}

TEST_CASE("threads compute with balls of their own", "[ball]") {
  // MPFR keeps logarithms and pi for each thread; a leak checker sees what is left at its end.
  std::vector<std::optional<Ball>> results(4);
  std::vector<std::thread> threads;
  for (std::optional<Ball> &result : results)
    threads.emplace_back([&result] { result = exp(log(Ball(3, 5000))); });
  for (std::thread &thread : threads)
    thread.join();
  for (const std::optional<Ball> &result : results)
    CHECK(holds(*result, 3));
}

} // namespace ball_test

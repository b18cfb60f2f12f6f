// Products of rational powers: whether they are fractions is known exactly.

#include "catch.hpp"
#include "number/power_product.hpp"

#include <random>

namespace power_product_test {

using namespace mdm;

namespace {

PowerProduct product(const std::vector<std::pair<Rational, Rational>> &powers) {
  PowerProduct result;
  for (const auto &[base, exponent] : powers)
    result *= PowerProduct(base, exponent);
  return result;
}

const std::optional<Rational> irrational;

} // namespace

TEST_CASE("fractions are told from irrational numbers", "[power_product]") {
  const auto exact = [](const std::vector<std::pair<Rational, Rational>> &powers) {
    return product(powers).exact();
  };
  CHECK(exact({}) == Rational(1));
  CHECK(exact({{ratio(3, 40), 1}}) == ratio(3, 40));
  CHECK(exact({{2, ratio(1, 2)}}) == irrational);
  CHECK(exact({{ratio(8, 27), ratio(-2, 3)}}) == ratio(9, 4));
  CHECK(exact({{36, ratio(1, 2)}}) == Rational(6));
  CHECK(exact({{2, ratio(1, 2)}, {8, ratio(1, 2)}}) == Rational(4));
  CHECK(exact({{2, ratio(1, 2)}, {3, ratio(1, 2)}}) == irrational);
  CHECK(exact({{2, ratio(1, 2)}, {3, ratio(1, 2)}, {6, ratio(1, 2)}}) == Rational(6));
  CHECK(exact({{6, ratio(1, 3)}, {10, ratio(1, 3)}, {15, ratio(1, 3)}}) == irrational);
  CHECK(exact({{6, ratio(1, 2)}, {10, ratio(1, 2)}, {15, ratio(1, 2)}}) == Rational(30));
  // Exponents as masses make them: no power of that degree is ever formed.
  const Rational odd = ratio(123457, 10000019);
  CHECK(exact({{4, odd}, {2, -2 * odd}, {5, 1}}) == Rational(5));
  CHECK(exact({{ratio(3, 4), odd}, {ratio(9, 16), -odd / 2}}) == Rational(1));
  CHECK(exact({{4, odd}}) == irrational);
}

TEST_CASE("the exact value lies in the enclosure", "[power_product]") {
  std::mt19937_64 random(6);
  int fractions = 0;
  for (int i = 0; i < 1000; ++i) {
    PowerProduct p;
    for (int factors = 0; factors < 4; ++factors)
      p *= PowerProduct(ratio(1 + random() % 12, 1 + random() % 12),
                        ratio(static_cast<long>(random() % 9) - 4, 1 + random() % 2));
    const Ball y = p.real().ball(200);
    if (const std::optional<Rational> value = p.exact()) {
      ++fractions;
      CHECK(y.lower() <= *value);
      CHECK(*value <= y.upper());
    } else { // all exponents are halves: the square is a fraction, and no square of one
      const Rational square = pow(p, 2).exact().value();
      CHECK(exact_root(square, 2) == irrational);
    }
  }
  CHECK(fractions >= 420);
  CHECK(fractions < 900);
}

TEST_CASE("products, quotients and powers", "[power_product]") {
  const PowerProduct a(2, ratio(1, 3)), b(5, ratio(1, 3));
  CHECK(pow(a * b, 3).exact() == Rational(10));
  CHECK((a / a).exact() == Rational(1));
  CHECK(pow(a / b, -3).exact() == ratio(5, 2));
  CHECK(pow(a, 0).exact() == Rational(1));
}

TEST_CASE("ratios of logarithms are told to be fractions", "[power_product]") {
  const auto exact = [](const PowerProduct &a, const PowerProduct &b) { return log_ratio(a, b).exact(); };
  CHECK(exact(PowerProduct(8), PowerProduct(2)) == Rational(3));
  CHECK(exact(PowerProduct(8), PowerProduct(4)) == ratio(3, 2));
  CHECK(exact(PowerProduct(ratio(1, 4)), PowerProduct(8)) == ratio(-2, 3));
  CHECK(exact(PowerProduct(1), PowerProduct(8)) == Rational(0));
  CHECK(exact(PowerProduct(3), PowerProduct(2)) == irrational);
  CHECK(exact(PowerProduct(6), PowerProduct(12)) == irrational);
  CHECK(exact(PowerProduct(36), PowerProduct(6)) == Rational(2));
  CHECK(exact(PowerProduct(5, ratio(1, 7)) * PowerProduct(2, ratio(1, 7)), PowerProduct(10)) == ratio(1, 7));
  CHECK(rounded(log_ratio(PowerProduct(3), PowerProduct(2)), 12) == "1.58496250072");
}

TEST_CASE("what is too long for an exact value has an enclosure still", "[power_product]") {
  const PowerProduct huge(3, Rational(power_of_ten(6)));
  CHECK_FALSE(huge.exact());
  CHECK(huge.real().ball(100).is_finite());
}

} // namespace power_product_test

// Sizes are drawn uniform by volume, the same on every machine, inside their classes.

#include "catch.hpp"

#include <mdm/grading/beta_curve.hpp>
#include <mdm/grading/set_sizes.hpp>

using namespace mdm;

namespace {

std::vector<SizeClass> classes(Classing classing) {
  return size_classes(BetaCurve(1, 1, 1, 10), classing, 4);
}

} // namespace

TEST_CASE("the partition function and its inverse belong together") {
  const UniformByVolume discs(2, 6, 2), spheres(2, 6, 3);
  CHECK(discs.powered_size(ratio(1, 2)) == Rational(3)); // 2 a b / (a + b)
  CHECK(discs.partition(3) == ratio(1, 2));
  CHECK(discs.powered_size(0) == Rational(2));
  CHECK(discs.powered_size(1) == Rational(6));
  CHECK(spheres.powered_size(ratio(1, 2)) == ratio(36, 5)); // 2 a^2 b^2 / (a^2 + b^2)
  for (int i = 1; i < 20; ++i) {
    const Rational y = ratio(i, 20);
    CHECK(discs.partition(discs.powered_size(y)) == y);
    CHECK(discs.size(y, 20).lower() <= discs.powered_size(y));
    const Enclosure d = spheres.size(y, 20);
    CHECK(spheres.partition(d.lower()) <= y);
    CHECK(spheres.partition(d.upper()) >= y);
  }
}

TEST_CASE("sizes lie inside their class, however near to its bounds") {
  const Rational tiny = ratio(1, Integer(1) << 65);
  for (const Classing classing : {Classing::regular, Classing::geometric})
    for (const unsigned dimension : {2U, 3U})
      for (const SizeClass &c : classes(classing)) {
        const ClassSizes sizes(c, dimension, 15);
        for (const Rational &y : {tiny, ratio(1, 3), Rational(1 - tiny)}) {
          const Enclosure d = sizes.at(y);
          CHECK(compare(c.lower.real, Real(d.lower())) != Order::greater);
          CHECK(compare(Real(d.upper()), c.upper.real) != Order::greater);
          CHECK(d.upper() - d.lower() <= ratio(2, power_of_ten(14)));
          if (const std::optional<Rational> exact = sizes.exact(y)) {
            CHECK(d.lower() <= *exact);
            CHECK(*exact <= d.upper());
          }
          CHECK(sizes.exact(y).has_value() == (dimension == 2 && c.lower.real.fraction().has_value() &&
                                               c.upper.real.fraction().has_value()));
        }
      }
}

TEST_CASE("few digits do not touch the open end of a class") {
  // Bounds 1, 2, 3 and 4 are decimals of one digit.
  const Draws draws = Draws::quantiles();
  for (const SizeClass &c : size_classes(BetaCurve(2, 3, 1, 4), Classing::regular, 3))
    for (const unsigned dimension : {2U, 3U})
      for (const unsigned digits : {1U, 2U, 3U}) {
        const ClassSizes sizes(c, dimension, digits);
        for (std::uint64_t i = 0; i < 500; ++i) {
          const Enclosure d = sizes.at(draws(0, i, 500));
          CHECK(d.lower() > *c.lower.real.fraction());
          CHECK(d.upper() <= *c.upper.real.fraction());
          if (const std::optional<ShortSize> quick = sizes.quick(draws.bits(0, i, 500)))
            CHECK(ratio(Integer(quick->lo), power_of_ten(quick->places)) > *c.lower.real.fraction());
        }
      }
  // Nor where the class is too narrow for sixty digits.
  const SizeClass narrow{Surd(Rational(1)), Surd(Rational(1 + ratio(1, power_of_ten(90)))), Rational(1)};
  const Enclosure d = ClassSizes(narrow, 3, 3).at(ratio(1, 2));
  CHECK(d.lower() > 1);
  CHECK(d.upper() <= *narrow.upper.real.fraction());
}

TEST_CASE("irrational bounds give the enclosure of the size between them") {
  const SizeClass c = size_classes(BetaCurve(1, 1, 1, 2), Classing::geometric, 2)[0]; // 1 to sqrt 2
  // 2 sqrt 2 / (1 + sqrt 2) = 4 - 2 sqrt 2
  const Enclosure d = ClassSizes(c, 2, 15).at(ratio(1, 2));
  CHECK(d.lower_text() == "1.1715728752538");
  CHECK(d.upper_text() == "1.17157287525381");
}

TEST_CASE("draws are reproducible and in the open interval") {
  CHECK(Draws::quantiles()(5, 0, 2) == ratio(1, 4));
  CHECK(Draws::quantiles()(7, 1, 2) == ratio(3, 4));
  // The first number of stream 0 with key 0 is e169c58d6627e8d5 (hexadecimal).
  CHECK(Draws::random(0)(0, 0, 1) == ratio(2 * Integer(0xe169c58d6627e8d5ULL) + 1, Integer(1) << 65));
  CHECK(Draws::random(1)(0, 0, 1) != Draws::random(2)(0, 0, 1));
  CHECK(Draws::random(1)(0, 1, 1) != Draws::random(1)(1, 0, 1));
}

TEST_CASE("a drawn class has the distribution") {
  // Kolmogorov: sqrt(n) sup |F_n - F| is above 2.2 with chance 2 exp(-2 * 2.2^2) < 2e-4; the seed is fixed.
  constexpr std::uint64_t n = 4000;
  const Draws draws = Draws::random(42);
  std::vector<Rational> y;
  for (std::uint64_t i = 0; i < n; ++i)
    y.push_back(draws(3, i, n));
  std::sort(y.begin(), y.end());
  Rational worst = 0;
  for (std::uint64_t i = 0; i < n; ++i)
    worst = std::max({worst, Rational(ratio(i + 1, n) - y[i]), Rational(y[i] - ratio(i, n))});
  CHECK(worst * worst * n < ratio(484, 100));
}

// Sizes in 64-bit fixed point are those of exact arithmetic, or nothing.

#include "catch.hpp"
#include "sets/beta_curve.hpp"
#include "sets/set_sizes.hpp"

namespace quick_sizes_test {

using namespace mdm;

namespace {

struct Tally {
  unsigned quick = 0, all = 0;
};

/// Compares quick sizes with exact ones at random places and near both ends.
Tally compared(const SizeClass &c, unsigned dimension, unsigned digits, unsigned n) {
  const ClassSizes sizes(c, dimension, digits);
  const Draws draws = Draws::random(99);
  Tally tally;
  for (unsigned i = 0; i < n; ++i) {
    const std::uint64_t random = draws.bits(0, i, n);
    for (const std::uint64_t y : {random, random >> (i % 64), ~(random >> (i % 64))}) {
      ++tally.all;
      const std::optional<ShortSize> quick = sizes.quick(y);
      if (!quick)
        continue;
      ++tally.quick;
      // Both ends of [Y, Y + 1] / 2^64, and thus all between them.
      const Rational unit = ratio(1, power_of_ten(quick->places));
      const Rational lo = Rational(quick->lo) * unit, hi = lo + unit;
      for (const std::uint64_t step : {0U, 1U}) {
        const Rational at = ratio(Integer(y) + step, Integer(1) << 64);
        if (at == 0 || at == 1)
          continue;
        const Enclosure exact = sizes.at(at);
        REQUIRE(lo <= exact.lower());
        REQUIRE(exact.upper() <= hi);
      }
      CHECK(compare(c.lower.real, Real(lo)) != Order::greater);
      CHECK(compare(Real(hi), c.upper.real) != Order::greater);
      const std::size_t length = std::to_string(quick->lo).size();
      CHECK((length == digits || (quick->places == 0 && length < digits)));
    }
  }
  return tally;
}

} // namespace

TEST_CASE("quick sizes enclose the exact ones, in their class and with the digits asked for") {
  for (const unsigned dimension : {2U, 3U})
    for (const Classing classing : {Classing::regular, Classing::geometric})
      for (const SizeClass &c : size_classes(BetaCurve(1, 1, ratio(2, 100), ratio(198, 100)), classing, 3)) {
        const Tally tally = compared(c, dimension, 15, 60);
        CHECK(tally.quick * 3 > tally.all);
        compared(c, dimension, 3, 20);
        compared(c, dimension, 18, 20);
      }
}

TEST_CASE("classes of any place and width have the right sizes, quick or not") {
  const Rational tiny = ratio(1, power_of_ten(390));
  for (const auto &[a, b] :
       {std::pair(tiny, Rational(2 * tiny)), std::pair(Rational(123456), Rational(9876543)),
        std::pair(ratio(999, 1000), ratio(1001, 1000)),
        std::pair(Rational(1), Rational(1 + ratio(1, power_of_ten(15)))),
        std::pair(ratio(1, 1000), Rational(power_of_ten(30)))})
    for (const unsigned dimension : {2U, 3U})
      compared(size_classes(BetaCurve(1, 1, a, b), Classing::regular, 1)[0], dimension, 6, 40);
}

TEST_CASE("too many digits are left to exact arithmetic") {
  const ClassSizes sizes(size_classes(BetaCurve(1, 1, 1, 2), Classing::regular, 1)[0], 3, 19);
  CHECK_FALSE(sizes.quick(std::uint64_t{1} << 63));
}

TEST_CASE("the bits of a draw are those of its number") {
  for (const Draws &draws : {Draws::quantiles(), Draws::random(5)})
    for (const std::uint64_t q : {std::uint64_t{1}, std::uint64_t{7}, std::uint64_t{1} << 40})
      for (const std::uint64_t i : {std::uint64_t{0}, q / 2, q - 1})
        CHECK(draws.bits(3, i, q) == floor(Rational(draws(3, i, q) * Rational(Integer(1) << 64))));
}

} // namespace quick_sizes_test

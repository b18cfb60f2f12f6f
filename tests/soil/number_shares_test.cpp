// Shares by mass and by number against all corners of the classes.

#include "catch.hpp"
#include "soil/number_shares.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>

#include <random>

namespace number_shares_test {

using namespace mdm;

namespace {

/// sizes[i] and masses[i] as gradation_of takes them: masses of the classes, then 0.
GradingCurve curve_of(const std::vector<Rational> &sizes, const std::vector<Rational> &shares) {
  std::vector<std::string> s, m;
  for (const Rational &size : sizes)
    s.push_back(to_decimal(size));
  for (const Rational &share : shares)
    m.push_back(to_decimal(share));
  m.emplace_back("0");
  return GradingCurve(gradation_of(s, m));
}

/// The least and the greatest share of class j over all choices of lower and upper sieves. Sizes above 0.
std::pair<Rational, Rational> by_corners(const std::vector<Rational> &sizes,
                                         const std::vector<Rational> &shares, std::size_t j, ShareOf given) {
  Rational least = 1, greatest = 0;
  for (std::size_t corner = 0; corner < (std::size_t{1} << shares.size()); ++corner) {
    Rational own = 0, sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const Rational x = sizes[i + ((corner >> i) & 1)];
      const Rational weight =
          given == ShareOf::number ? Rational(shares[i] * x * x * x) : Rational(shares[i] / (x * x * x));
      sum += weight;
      if (i == j)
        own = weight;
    }
    least = std::min<Rational>(least, own / sum);
    greatest = std::max<Rational>(greatest, own / sum);
  }
  return {least, greatest};
}

void check_exactly(const Real &real, const Rational &value) {
  REQUIRE(real.fraction());
  CHECK(*real.fraction() == value);
}

} // namespace

TEST_CASE("The shares of the other kind lie between those of the corners") {
  std::mt19937 random(5);
  const auto between = [&random](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    std::vector<Rational> sizes = {between(1, 5)}, shares;
    for (int k = between(1, 5); k > 0; --k) {
      sizes.push_back(sizes.back() + between(1, 5));
      shares.push_back(between(0, 3) == 0 ? 0 : between(1, 9));
    }
    shares.back() = between(1, 9);
    const ShareOf given = i % 2 == 0 ? ShareOf::mass : ShareOf::number;
    const std::vector<RealRange> ranges = other_shares(curve_of(sizes, shares), given);
    REQUIRE(ranges.size() == shares.size());
    for (std::size_t j = 0; j < shares.size(); ++j) {
      const auto [least, greatest] = by_corners(sizes, shares, j, given);
      check_exactly(ranges[j].lo, least);
      check_exactly(ranges[j].hi, greatest);
    }
  }
}

TEST_CASE("Of a pan the shares may be none or all") {
  const std::vector<RealRange> numbers = other_shares(curve_of({0, 1, 2}, {1, 3}), ShareOf::mass);
  check_exactly(numbers[0].lo, ratio(1, 4)); // all others as small as they can be: 1 to 3
  check_exactly(numbers[0].hi, 1);
  check_exactly(numbers[1].lo, 0);
  check_exactly(numbers[1].hi, ratio(3, 4));
  const std::vector<RealRange> masses = other_shares(curve_of({0, 1, 2}, {1, 3}), ShareOf::number);
  check_exactly(masses[0].lo, 0);
  check_exactly(masses[0].hi, ratio(1, 4));
  check_exactly(masses[1].lo, ratio(3, 4));
  check_exactly(masses[1].hi, 1);
}

TEST_CASE("A single class has all, by mass and by number") {
  for (const ShareOf given : {ShareOf::mass, ShareOf::number})
    for (const Rational &finest : {Rational(0), Rational(1)}) {
      const std::vector<RealRange> ranges = other_shares(curve_of({finest, 2, 3}, {5, 0}), given);
      check_exactly(ranges[0].lo, 1);
      check_exactly(ranges[0].hi, 1);
      check_exactly(ranges[1].hi, 0);
    }
}

} // namespace number_shares_test

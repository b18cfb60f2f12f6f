// f, F, V and h of one set convert into each other.

#include "catch.hpp"
#include "sets/size_distribution.hpp"
#include "sets/uniform_by_volume.hpp"

namespace size_distribution_test {

using namespace mdm;

namespace {

const std::vector<Real> bounds = {Rational(1), Rational(2), Rational(5)};
const std::vector<Real> shares = {ratio(1, 4), ratio(3, 4)};

Rational value(const Real &y) {
  REQUIRE(y.fraction());
  return *y.fraction();
}

} // namespace

TEST_CASE("one class is the distribution uniform by volume, Eq. 2 and 3") {
  const SizeDistribution discs = SizeDistribution::by_volume({Rational(2), Rational(6)}, {Rational(1)}, 2);
  const UniformByVolume same(2, 6, 2);
  for (int d = 2; d <= 6; ++d) {
    CHECK(value(discs.number_density(d)) == ratio(12, 4 * d * d)); // d_max d_min / (d_max - d_min) / d^2
    CHECK(value(discs.partition(d)) == same.partition(d));
    CHECK(value(discs.grading(d)) == ratio(d - 2, 4));
    CHECK(value(discs.volume_density(d)) == ratio(1, 4));
  }
}

TEST_CASE("volumes give numbers and numbers give the volumes back") {
  for (const unsigned dimension : {2U, 3U}) {
    const SizeDistribution by_volume = SizeDistribution::by_volume(bounds, shares, dimension);
    const SizeDistribution by_number = SizeDistribution::by_number(
        bounds, {by_volume.number_share(0), by_volume.number_share(1)}, dimension);
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(value(by_number.volume_share(i)) == value(shares[i]));
    for (const Rational &d : {Rational(1), ratio(3, 2), Rational(2), Rational(3), Rational(5)}) {
      CHECK(value(by_number.grading(d)) == value(by_volume.grading(d)));
      CHECK(value(by_number.partition(d)) == value(by_volume.partition(d)));
    }
    CHECK(value(by_volume.grading(2)) == ratio(1, 4));
    CHECK(value(by_volume.grading(5)) == 1);
    CHECK(value(by_volume.partition(5)) == 1);
  }
}

TEST_CASE("V is d^D f over its integral, and f the slope of F") {
  for (const unsigned dimension : {2U, 3U}) {
    const SizeDistribution set = SizeDistribution::by_volume(bounds, shares, dimension);
    // The integral of x^D f(x): V is constant in a class, so any place tells.
    const auto quotient = [&](const Rational &d) {
      return Rational(value(set.number_density(d)) * power(d, dimension) / value(set.volume_density(d)));
    };
    CHECK(quotient(1) == quotient(ratio(7, 4)));
    CHECK(quotient(1) == quotient(4));
    const Rational d = 3, step = ratio(1, power_of_ten(9));
    const Rational slope = (value(set.partition(Rational(d + step))) - value(set.partition(d))) / step;
    CHECK(abs(Rational(slope / value(set.number_density(d)) - 1)) < ratio(1, power_of_ten(8)));
  }
}

TEST_CASE("irrational bounds give enclosures of the same") {
  const Real two = pow(pow(Real(2), ratio(1, 2)), 2); // 2, known as a computation
  const SizeDistribution near = SizeDistribution::by_volume({Rational(1), two, Rational(5)}, shares, 3);
  const SizeDistribution exact = SizeDistribution::by_volume(bounds, shares, 3);
  CHECK(rounded(near.partition(Rational(3)), 12) == rounded(exact.partition(Rational(3)), 12));
  CHECK(rounded(near.number_density(Rational(3)), 12) == rounded(exact.number_density(Rational(3)), 12));
}

} // namespace size_distribution_test

#include "sets/uniform_by_volume.hpp"

#include <cassert>

namespace mdm {

UniformByVolume::UniformByVolume(Rational a, Rational b, unsigned dimension)
    : a_power_(mdm::power(a, dimension - 1)), b_power_(mdm::power(b, dimension - 1)), power_(dimension - 1) {
  assert(a > 0 && a < b && (dimension == 2 || dimension == 3));
}

Rational UniformByVolume::partition(const Rational &d) const {
  return (1 - a_power_ / mdm::power(d, power_)) / (1 - a_power_ / b_power_);
}

Rational UniformByVolume::powered_size(const Rational &y) const {
  return a_power_ * b_power_ / (b_power_ - y * (b_power_ - a_power_));
}

Enclosure UniformByVolume::size(const Rational &y, unsigned digits) const {
  const Rational powered = powered_size(y);
  return enclose_root(numerator(powered), denominator(powered), power_, digits);
}

} // namespace mdm

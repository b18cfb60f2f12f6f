#pragma once
/// \file
/// Sizes of which equal intervals hold equal volumes.

#include "number/real.hpp"

namespace mdm {

/// The distribution uniform by volume fraction on [a, b], 0 < a < b (Voivret, Delenne, Radjai, Eq. 2-4, for
/// discs), for particles of volume proportional to d^D, D = 2 or 3: the number density is proportional to
/// d^-D, and with p = D - 1 its partition function is F(d) = (1 - (a/d)^p) / (1 - (a/b)^p).
class UniformByVolume {
public:
  /// \pre 0 < a < b; dimension is 2 or 3
  UniformByVolume(Rational a, Rational b, unsigned dimension);

  /// F(d), the share by number of what is not larger than d, a <= d <= b.
  Rational partition(const Rational &d) const;
  /// F^-1(y)^p = (a b)^p / (b^p - y (b^p - a^p)), 0 <= y <= 1: in dimension 2 the size itself.
  Rational powered_size(const Rational &y) const;
  /// F^-1(y) in decimals, as enclose_root.
  Enclosure size(const Rational &y, unsigned digits) const;

  /// D - 1.
  unsigned power() const { return power_; }

private:
  Rational a_power_, b_power_;
  unsigned power_;
};

} // namespace mdm

#pragma once
/// \file
/// The size of a fraction in powers of ten.

#include <mdm/number/rational.hpp>

namespace mdm {

/// 10^exponent.
Rational ten_to(long exponent);

/// The e with 10^e <= |r| < 10^(e + 1).
/// \pre r != 0
long decimal_exponent(const Rational &r);

} // namespace mdm

#pragma once
/// \file
/// Rational bounds of pi.

#include <mdm/number/enclosure.hpp>

namespace mdm {

/// Decimals lo < pi < hi with `places` digits after the point, one unit apart. From MPFR.
Enclosure enclose_pi(unsigned places);

} // namespace mdm

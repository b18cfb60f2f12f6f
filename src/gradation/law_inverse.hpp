#pragma once
/// \file
/// The size of a particle of given mass: f^-1.

#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/enclosure.hpp>

namespace mdm {

/// Encloses x > 0 with x^degree = n / d under a law that is a power, and with f(x) = n / d under another, by
/// decimals of `digits` significant digits as enclose_root does. Under a sum of several powers x that is a
/// decimal is a point if it has no more than these digits.
/// \pre n / d > 0 is at most the mass of the last node of a table
Enclosure enclose_inverse(const MassLaw &law, const Integer &n, const Integer &d, unsigned degree,
                          unsigned digits);

} // namespace mdm

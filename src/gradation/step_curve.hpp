#pragma once
/// \file
/// Curves of particles, which rise at their sizes alone.

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// Adds the mass of particles from `least` to `most` in size to a curve that ascends: it is behind all that
/// is there, and what passes is the same up to 10^-12 of `least` below it.
/// \pre data.sizes begins at 0; most is above the last of them
void add_step(Gradation::Data &data, const Rational &least, const Rational &most, const Rational &mass);

} // namespace mdm

#pragma once
/// \file
/// The scale that is chosen in the window of a match.

#include <mdm/match/solve.hpp>

namespace mdm {

/// Robust: the simplest rational within 1/127 of the window's width above s* = max(sqrt(above * up_to), s_0)
/// (of the rest of the window, at s_0); half the upper end where the window starts at 0 and there is no s_0.
/// Automatic at an irrational s_0: a rational above it by at most 10^-digits of it.
Rational choose_scale(const Window &window, ScaleChoice choice, unsigned digits);

} // namespace mdm

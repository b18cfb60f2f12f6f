#pragma once
/// \file
/// The packing fraction.

#include "number/real.hpp"
#include "packing/packing.hpp"

namespace mdm {

/// The share of a window that is covered by discs which do not overlap: pi times an integer for those that
/// lie in it, and segments of circles, by Arb, for those that its sides cut.
/// \pre the window is not empty; in a periodic packing it is as wide as the box
Real packing_fraction(const Packing &packing, const PackingWindow &window);

} // namespace mdm

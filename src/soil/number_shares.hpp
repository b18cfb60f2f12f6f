#pragma once
/// \file
/// From shares of the mass to shares of the number of particles, and back.

#include "soil/mean_sizes.hpp"

#include <vector>

namespace mdm {

/// What the shares of a gradation are of.
enum class ShareOf { mass, number };

/// The shares of the other kind, one a class: of the number where those of the curve are of the mass, of the
/// mass where they are of the number. Spheres of one density; a class (x_j, x_{j+1}] holds sizes of any kind,
/// so each share is only known to lie in a range, from that with the particles of its class as light (as
/// many) and those of the others as heavy (as few) as their sieves allow to the opposite; from 0 to 1, and to
/// 1 where the sizes in a pan at 0 decide. The whole of the shares is one: the ends of all ranges are not met
/// at once.
std::vector<RealRange> other_shares(const GradingCurve &curve, ShareOf given);

} // namespace mdm

#pragma once
/// \file
/// Mean sizes of a gradation of particles of one density.

#include "soil/grading_curve.hpp"

namespace mdm {

/// A real number of which bounds alone are known, lo <= y <= hi.
struct RealRange {
  Real lo, hi;
};

/// D[3,2] = 1 / sum of w / x, the mean over the surface, and D[4,3] = sum of w x, that over the volume, in
/// mm; w the shares of the mass. A class (x_j, x_{j+1}] holds sizes of any kind, so both lie between their
/// values with all particles at the lower and at the upper sieves. Not available where a pan at size 0 holds
/// mass. Source: ISO 9276-2.
Available<RealRange> surface_mean(const GradingCurve &curve);
Available<RealRange> volume_mean(const GradingCurve &curve);

} // namespace mdm

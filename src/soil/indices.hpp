#pragma once
/// \file
/// Index numbers of a grading curve.

#include "soil/grading_curve.hpp"

namespace mdm {

/// C_u = D60 / D10, the coefficient of uniformity.
Available<PowerProduct> uniformity(const GradingCurve &curve, bool extrapolate = false);

/// C_c = D30^2 / (D60 D10), the coefficient of curvature.
Available<PowerProduct> curvature(const GradingCurve &curve, bool extrapolate = false);

/// (D90 - D10) / D50, the span.
Available<Real> span(const GradingCurve &curve, bool extrapolate = false);

/// I_GS of Erguler (2016): the integral of the share passing over log size from 0.001 to 75 mm, divided by
/// log 75 - log 0.001. Not available where a pan at size 0 holds mass.
Available<Real> grain_size_index(const GradingCurve &curve);

/// I_C of Arnold: the area between the curve and the level P(x_2), over log size from x_2, the finest sieve
/// above the pan, to x_n, divided by that of the triangle, (1 - P(x_2)) (log x_n - log x_2) / 2.
Available<Real> curvature_index(const GradingCurve &curve);

/// phi_1 (Arnold, Eq. 15): the mass of the finest class with particles over that of the coarsest.
Rational finest_mass_ratio(const GradingCurve &curve);

/// zeta_1 (Arnold, Eq. 16) at the upper bounds of the coarsest and the finest class with particles: the ratio
/// of their cubes.
PowerProduct coarsest_volume_ratio(const GradingCurve &curve);

} // namespace mdm

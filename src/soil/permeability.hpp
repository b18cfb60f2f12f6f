#pragma once
/// \file
/// Estimates of the hydraulic conductivity of water at 20 degrees Celsius.

#include "soil/mean_sizes.hpp"

namespace mdm {

/// Hazen (1911): k = C D10^2 with C = 100 / (cm s), so 0.01 m/s for D10 = 1 mm. For loose sand of D10 from
/// 0.1 to 3 mm and C_u below 5.
Available<PowerProduct> hazen_conductivity(const GradingCurve &curve, bool extrapolate);

/// True if D10 and C_u are those that Hazen's formula is for; decided exactly. \pre D10 is available
bool is_hazen_soil(const GradingCurve &curve, bool extrapolate);

/// Kozeny and Carman as Carrier (2003) has it, for spheres: k = (gamma / mu) / (5 S^2) e^3 / (1 + e), with
/// gamma / mu = 99,300 / (cm s) and S = 6 / D[3,2], in m/s, between its values at the bounds of D[3,2].
/// \param void_ratio  e > 0
Available<RealRange> kozeny_carman_conductivity(const GradingCurve &curve, const Rational &void_ratio);

} // namespace mdm

#pragma once
/// \file
/// Names of sediments and soils by the shares of their fractions, decided exactly. Not available where a pan
/// at size 0 hides a share, or (limited) where no precision decides.

#include "soil/grading_curve.hpp"

#include <string>

namespace mdm {

/// Folk (1954): gravel above 2 mm, sand, and mud up to 1/16 mm, by the share of gravel (0.01, 5, 30, 80 %)
/// and by sand over mud (1/9, 1, 9); what is at a limit is above it.
Available<std::string> folk_texture(const GradingCurve &curve);

/// Shepard (1954): sand up to 2 mm, silt up to 1/16 mm and clay up to 1/256 mm, without what is coarser. One
/// of them from 75 % on; sand-silt-clay where each has 20 %; else the greatest with the second as adjective,
/// of equal ones the coarser.
Available<std::string> shepard_texture(const GradingCurve &curve);

/// The triangle of the USDA (Soil Survey Manual, 2017): sand up to 2 mm, silt up to 0.05 mm and clay up to
/// 0.002 mm, without what is coarser.
Available<std::string> usda_texture(const GradingCurve &curve);

} // namespace mdm

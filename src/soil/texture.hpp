#pragma once
/// \file
/// Names of sediments and soils by the shares of their fractions, decided exactly. Not available where a pan
/// at size 0 hides a share, or (limited) where no precision decides.

#include "soil/grading_curve.hpp"

#include <array>
#include <string>

namespace mdm {

/// Who names by three parts of the mass.
enum class TextureSystem {
  /// Folk (1954): mud up to 1/16 mm, sand up to 2 mm, gravel, by the share of gravel (0.01, 5, 30, 80 %) and
  /// by
  /// sand over mud (1/9, 1, 9); what is at a limit is above it.
  folk,
  /// Shepard (1954): sand up to 2 mm, silt up to 1/16 mm and clay up to 1/256 mm, without what is coarser.
  /// One
  /// of them from 75 % on; sand-silt-clay where each has 20 %; else the greatest with the second as
  /// adjective,
  /// of equal ones the coarser.
  shepard,
  /// The triangle of the USDA (Soil Survey Manual, 2017): sand up to 2 mm, silt up to 0.05 mm and clay up to
  /// 0.002 mm, without what is coarser.
  usda
};

/// The parts of the mass in the system's order, mud, sand, gravel or sand, silt, clay, as shares of their
/// sum, which is above 0.
Available<std::array<Real, 3>> texture_parts(TextureSystem system, const GradingCurve &curve);

/// The system's name of what has these parts.
Available<std::string> texture(TextureSystem system, const GradingCurve &curve);

} // namespace mdm

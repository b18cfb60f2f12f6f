#pragma once
/// \file
/// The Unified Soil Classification System, ASTM D2487, for inorganic soils.

#include "soil/grading_curve.hpp"

namespace mdm {

/// Atterberg limits in percent water content, liquid >= plastic >= 0.
struct AtterbergLimits {
  Rational liquid, plastic;
};

/// The group of the fines by themselves.
enum class Fines { ML, MH, CL, CH, CL_ML };

/// The place in the plasticity chart, with PI = liquid - plastic and the A-line PI = 0.73 (LL - 20): from LL
/// 50 on CH on or above it, else MH; below, CL on or above it with PI > 7, CL-ML there with 4 <= PI <= 7,
/// else ML.
/// \throws InputError if a limit is negative or the plastic one above the liquid one
Fines classify_fines(const AtterbergLimits &limits);

/// A group symbol and group name, for example `SW-SM` and `well-graded sand with silt and gravel`.
struct UscsGroup {
  std::string symbol, name;
  bool operator==(const UscsGroup &) const = default;
};

/// The group of the part that passes 75 mm (which must be a sieve if anything is coarser; it then adds `with
/// cobbles` and `boulders`). Bounds as in the standard: fines below 5 %, to 12 %, below 50 %; gravel if it is
/// more than half of the coarse part; well-graded with C_u >= 4 (gravel), 6 (sand) and 1 <= C_c <= 3; `with`
/// from 15 % on. All are decided exactly, and percents are not rounded first. Where 0.075 mm lies in a pan
/// at size 0 there is a group only if all its mass may be fines or none without a change.
Available<UscsGroup> classify_uscs(const GradingCurve &curve, Fines fines = Fines::ML,
                                   bool extrapolate = false);

} // namespace mdm

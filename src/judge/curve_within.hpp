#pragma once
/// \file
/// Whether one of many curves keeps all limits.

#include "judge/interpolation.hpp"
#include "soil/available.hpp"

#include <mdm/judge/specification.hpp>

namespace mdm {

/// Limits with their place on the curves of a box.
struct PlacedLimits {
  CurvePlace place;
  Rational least, most;
};

/// The percents of a curve, one a sieve of its box.
using CurvePercents = std::vector<Rational>;

/// Whether there is a curve, and one where it can be written.
struct CurveWithin {
  bool exists = false;
  std::optional<CurvePercents> curve; ///< as near to the reported one as it was easy; nothing also where no
                                      ///< decimals of 40 places are such a curve
};

/// Decides whether a curve of the box keeps all limits together. What may pass x_{i+1} on a curve that keeps
/// those up to there is an interval, of which that of the next sieve is made: the projection of a polygon
/// (Fourier and Motzkin). Not available where precision does not decide a comparison.
/// \pre box.narrow() was called
Available<CurveWithin> curve_within(const CurveBox &box, const std::vector<PlacedLimits> &limits);

} // namespace mdm

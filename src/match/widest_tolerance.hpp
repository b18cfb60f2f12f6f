#pragma once
/// \file
/// The tolerance that every sample is within.

#include <mdm/match/tolerance.hpp>

namespace mdm {

/// In percentage points: shares that sum to 1 differ by at most 2 in all, and by at most 1 in a class or
/// below a sieve.
inline Rational widest_tolerance(AskedTolerance::Kind kind) {
  return kind == AskedTolerance::Kind::total ? 200 : 100;
}

} // namespace mdm

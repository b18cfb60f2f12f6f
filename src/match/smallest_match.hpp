#pragma once
/// \file
/// The smallest exact match beside something else, in bounded time.

#include "number/real.hpp"

#include <mdm/gradation/gradation.hpp>
#include <mdm/gradation/mass_law.hpp>

#include <cstdint>
#include <string>

namespace mdm {

/// Steps after which a smallest match that is only shown beside something else is left with bounds: some
/// seconds.
inline constexpr std::uint64_t most_steps_beside = 10'000'000;

/// Bounds of the number of particles of the smallest exact match; a point but where finding it would take
/// more than most_steps_beside.
struct SmallestMatch : IntegerBounds {
  /// N, or `[lo, hi]`.
  std::string text() const;
  /// n over N, or `[lo, hi]`, cut to four digits.
  std::string ratio_text(const Integer &n) const;
};

/// Searches for the smallest exact match, for at most most_steps_beside steps.
SmallestMatch smallest_match(const Gradation &g, const MassLaw &law);

} // namespace mdm

#pragma once
/// \file
/// The finest classes of a match, where they cost most particles for little mass.

#include <mdm/match/match.hpp>

#include <optional>

namespace mdm {

/// The finest classes of a match, as shares of it.
struct CostlyFines {
  RootSize below; ///< the upper opening of the largest of them
  Rational particles, mass;
};

/// The fewest finest classes that have 90 % of the particles or more, if they hold 5 % of the mass or less;
/// else nothing. Both bounds are closed and decided exactly.
std::optional<CostlyFines> costly_fines(const Match &m);

} // namespace mdm

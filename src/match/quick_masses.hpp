#pragma once
/// \file
/// Masses of the classes for given counts, found in double precision.

#include "match/tolerant_problem.hpp"

namespace mdm {

/// What double precision finds.
struct QuickMasses {
  std::optional<std::vector<Rational>>
      t;                 ///< a match with the counts, verified, near the middle of all bounds
  bool are_close = true; ///< that there is no match is not clear: only exact numbers can tell
};

/// Looks for masses that make the counts q a match.
QuickMasses quick_masses(const TolerantProblem &problem, const std::vector<Integer> &q);

} // namespace mdm

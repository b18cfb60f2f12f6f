#pragma once
/// \file
/// Given numbers of particles as a match within a tolerance.

#include "match/tolerant_problem.hpp"

#include <optional>
#include <vector>

namespace mdm {

/// Bounds on the mass of one particle of a class, in the units of the problem's t; closed.
struct MassBounds {
  Rational lo, hi;
};

/// The reasons why counts are no match: conditions that together contradict the counts. Those of `stated` are
/// the bounds that were given for a class.
struct CountConflict {
  std::vector<Multiple> conditions;
  std::vector<std::size_t> stated;
};

/// Whether there are masses with which q_1, ..., q_k are a match (Theorem 12), by an exact linear program.
/// \param stated  bounds on the masses of classes, where there are some
/// \return nothing if there are; else conditions that contradict each other
/// \pre q has an entry for each class
std::optional<CountConflict> conflict_of_counts(const TolerantProblem &problem, const std::vector<Integer> &q,
                                                const std::vector<std::optional<MassBounds>> &stated);

} // namespace mdm

#pragma once
/// \file
/// The least match (theory: proofs/README.md, Theorems 2 to 5).

#include "match/sweep_problem.hpp"
#include "match/watch.hpp"

#include <mdm/match/evidence.hpp>
#include <mdm/match/limits.hpp>

#include <cstdint>
#include <vector>

namespace mdm {

/// The steps of a sweep: positions in Problem::classes(). From L = 0, each step j replaces the lower bound L
/// on the scale by count_j(L)^b f_j / m_j, where count_j(L) is the least count that class j needs above L.
using Steps = std::vector<std::uint32_t>;

/// The result of a sweep.
template <class Int>
struct Swept {
  /// Where complete: the least match, least in every class. Else counts that every match reaches: their sum
  /// is a lower bound of N.
  std::vector<Int> q;
  Steps chain;             ///< empty where it was not to be kept
  std::uint64_t steps = 0; ///< that were taken
  bool complete = false;
};

/// The result of least_match().
using LeastMatch = Swept<Integer>;

/// Starts from the floors, raises the lower bound on the scale over the classes that can still move until
/// nothing does. Every raise is forced, so the result is the least match, class by class (Theorem 3). Cost:
/// at most 1 + sum max(0, settled - r) steps whatever the masses, settled = ceil(f / (F - f)) for b = 1; one
/// step where F >= 2^b f everywhere. Memory: 4 bytes a step where the chain is kept. Int is Int128 or
/// Integer.
/// \throws Int128Overflow if Int is Int128 and too short
template <class Int>
Swept<Int> sweep(const SweepProblem<Int> &problem, const Limits &limits, const Watch &watch);
/// With the deadline of the limits as its watch.
template <class Int>
Swept<Int> sweep(const SweepProblem<Int> &problem, const Limits &limits = {}) {
  return sweep(problem, limits, Watch(limits.deadline));
}

/// In 128 bits.
extern template Swept<Int128> sweep(const SweepProblem<Int128> &, const Limits &, const Watch &);
/// In integers of any length.
extern template Swept<Integer> sweep(const SweepProblem<Integer> &, const Limits &, const Watch &);

/// The least match: a sweep in 128 bits, repeated with Integer where they overflow.
LeastMatch least_match(const Problem &problem, const Limits &limits, const Watch &watch);
/// With the deadline of the limits as its watch.
LeastMatch least_match(const Problem &problem, const Limits &limits = {});

/// The steps of a sweep at scales above `above`, which is 0 where it is of all, in terms of the gradation.
Chain chain_of(Steps steps, const Rational &above, const Problem &problem);

/// A match found without sweeping (Theorem 4): every class at a scale from which on it cannot move. An upper
/// bound.
std::vector<Integer> some_match(const Problem &problem);

} // namespace mdm

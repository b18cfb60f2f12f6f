#pragma once
/// \file
/// The least match (theory: proofs/README.md, Theorems 2 to 5).

#include <mdm/match/sweep_problem.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace mdm {

/// When to stop before the end. A step is a raise of the lower bound on the scale.
struct Limits {
  std::optional<std::uint64_t> max_steps;
  std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// The steps that prove minimality: positions in Problem::classes(). From L = 0, each step j replaces the lower bound L
/// on the scale by count_j(L)^b f_j / m_j, where count_j(L) is the least count that class j needs above L.
using Chain = std::vector<std::uint32_t>;

/// What a sweep leaves.
struct LeastMatch {
  /// Where complete: the least match, least in every class. Else counts that every match reaches: their sum is a lower
  /// bound of N.
  std::vector<Integer> q;
  Chain chain;
  bool complete = false;
};

/// Starts from the floors, raises the lower bound on the scale over the classes that can still move until nothing does.
/// Every raise is forced, so the result is the least match, class by class.
/// Cost: at most 1 + sum max(0, ceil(f / (F - f)) - r) steps whatever the masses; one step where F >= 2 f everywhere.
/// The first form tries 128 bits and repeats with Integer on overflow.
LeastMatch least_match(const Problem &problem, const Limits &limits = {});
template <class Int>
LeastMatch least_match(const SweepProblem<Int> &problem, const Limits &limits = {});

extern template LeastMatch least_match(const SweepProblem<Int128> &, const Limits &);
extern template LeastMatch least_match(const SweepProblem<Integer> &, const Limits &);

/// A match found without sweeping (Theorem 4): every class at a scale from which on it cannot move. An upper bound.
std::vector<Integer> some_match(const Problem &problem);

} // namespace mdm

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
  std::optional<std::uint64_t> max_steps = std::nullopt; ///< of a sweep
  std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt;
  std::optional<std::uint64_t> node_limit = std::nullopt; ///< of a search tree
  std::optional<Integer> at_most = std::nullopt;          ///< more particles than this need no exact number
};

/// The steps that prove minimality: positions in Problem::classes(). From L = 0, each step j replaces the
/// lower bound L on the scale by count_j(L)^b f_j / m_j, where count_j(L) is the least count that class j
/// needs above L.
using Chain = std::vector<std::uint32_t>;

/// What a sweep leaves.
template <class Int>
struct Swept {
  /// Where complete: the least match, least in every class. Else counts that every match reaches: their sum
  /// is a lower bound of N.
  std::vector<Int> q;
  Chain chain;
  bool complete = false;
};

using LeastMatch = Swept<Integer>;

/// Starts from the floors, raises the lower bound on the scale over the classes that can still move until
/// nothing does. Every raise is forced, so the result is the least match, class by class (Theorem 3). Cost:
/// at most 1 + sum max(0, settled - r) steps whatever the masses, settled = ceil(f / (F - f)) for b = 1; one
/// step where F >= 2^b f everywhere. Int is Int128 or Integer.
/// \throws Int128Overflow if Int is Int128 and too short
template <class Int>
Swept<Int> sweep(const SweepProblem<Int> &problem, const Limits &limits = {});

extern template Swept<Int128> sweep(const SweepProblem<Int128> &, const Limits &);
extern template Swept<Integer> sweep(const SweepProblem<Integer> &, const Limits &);

/// The least match: a sweep in 128 bits, repeated with Integer where they overflow.
LeastMatch least_match(const Problem &problem, const Limits &limits = {});

/// A match found without sweeping (Theorem 4): every class at a scale from which on it cannot move. An upper
/// bound.
std::vector<Integer> some_match(const Problem &problem);

} // namespace mdm

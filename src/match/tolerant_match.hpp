#pragma once
/// \file
/// The smallest match within a tolerance: branch and bound with exact bounds.

#include "match/tolerant_problem.hpp"
#include "match/watch.hpp"

#include <mdm/match/limits.hpp>

namespace mdm {

/// Particles and class masses that are a match, masses in the problem's units.
struct TolerantMatch {
  std::vector<Integer> q;
  std::vector<Rational> t;
};

/// A table of more numbers, some 1 GB and growing with their length, is not searched: retained:1% of more
/// than 1023 classes.
constexpr std::size_t largest_table = std::size_t{1} << 23;

/// For given counts masses are looked for by an exact program only up to so many numbers, some 60 classes:
/// beyond, it takes longer than a search.
constexpr std::size_t largest_exact_masses = std::size_t{1} << 15;

/// The result of a search.
struct TolerantResult {
  std::optional<TolerantMatch> best; ///< smallest that was found
  Integer lower_bound = 1;           ///< no match has fewer particles
  bool complete = false;             ///< the best is the smallest; or there is none at all
  bool too_large = false;            ///< there was no search: its table would not fit into memory
  Tree tree; ///< refutes fewer particles than `proved`, any number where there is no match; empty if it was
             ///< not to be kept, or is longer than longest_tree
  Integer proved = 1;      ///< of a complete search the best's particles; else at most lower_bound
  std::uint64_t nodes = 0; ///< that were looked at
};

/// The least number of particles. There is no search where a chain shows the first match, or the one with the
/// differences of its bounds, to be the smallest; nor where the program's table has more than largest_table
/// numbers. Else by branch and bound (TolerantSearch). Cost: depends on the tree.
/// \param first  a match to improve upon, if it is one: what there is when a limit ends the search early
TolerantResult tolerant_match(const TolerantProblem &problem, const Limits &limits,
                              const std::optional<TolerantMatch> &first, const Watch &watch);
/// With the deadline of the limits as its watch.
TolerantResult tolerant_match(const TolerantProblem &problem, const Limits &limits = {},
                              const std::optional<TolerantMatch> &first = std::nullopt);

} // namespace mdm

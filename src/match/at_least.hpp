#pragma once
/// \file
/// The smallest match with at least so many particles.

#include "match/least_match.hpp"

namespace mdm {

/// Largest count of each class at scales just above `scale` (`open`), or at `scale` itself: the largest q >=
/// 0 with q^p f / m <= scale, or < scale. Nothing for a class with f = 0, which can hold any number.
std::vector<std::optional<Integer>> largest_counts(const Problem &problem, const Rational &scale, bool open);

/// The scale, to the power p, up to which n particles do not fit, and above which they do, empty classes
/// aside: the n-th smallest of all q^p f / m. 0 if some f = 0. Cost: O(k log k) comparisons for k classes,
/// whatever n is.
/// \pre n >= 1
Rational crowded_scale(const Problem &problem, const Integer &n);

/// A match with at least n particles: the smallest if `least.complete`, else any.
struct AtLeastMatch {
  std::vector<Integer> q; ///< the match
  Rational above;   ///< z: no match with n particles has a scale up to z; 0 where the sweep is of all scales
  LeastMatch least; ///< the least match at scales above z; its sum is at most that of the smallest match
};

/// The least N' >= n with an exact match (Theorem 7), at the least feasible scale: lower ends of the counts,
/// then particles added from the finest class up. `start` is a closed lower end of the scales that the floors
/// of the problem come from, or 0.
AtLeastMatch at_least_match(const Problem &problem, const Integer &n, const Rational &start,
                            const Limits &limits, const Watch &watch);
/// With the deadline of the limits as its watch.
AtLeastMatch at_least_match(const Problem &problem, const Integer &n, const Rational &start,
                            const Limits &limits = {});

} // namespace mdm

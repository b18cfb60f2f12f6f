#pragma once
/// \file
/// Counts with which the mean particle of every class is nearly that of sizes uniform by volume.

#include "match/problem.hpp"

#include <mdm/match/match.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// A match of a problem: a count for each of its classes, and the gradation's scale s.
struct UniformCounts {
  std::vector<Integer> q;
  Rational scale;
  Window window;
};

/// The mean volume of sizes uniform by volume from l to u: l u for discs and 2 l^2 u^2 / (l + u) for spheres;
/// where l = 0, it is 0 and u^D / 2 is taken, from which a spread has no need to move far.
Rational uniform_mean(const Rational &l, const Rational &u, unsigned dimension);

/// The largest |s m / (q mu) - 1| over the classes, mu = uniform_mean: how far the mean particle is from it.
Rational farthest_mean(const Gradation &g, const Problem &problem, const std::vector<Integer> &q,
                       const Rational &scale);

/// n particles shared out so that every class has s m / mu of them, rounded to a neighbouring integer, or
/// its floor where that is more. Nothing if the mean of a class would lie outside it. Cost: k log k for k
/// classes, and at most k rounds over those that come to their floors.
/// \pre the law is x^D; n is at least the sum of the floors
std::optional<UniformCounts> uniform_counts(const Gradation &g, const Problem &problem, const Integer &n);

} // namespace mdm

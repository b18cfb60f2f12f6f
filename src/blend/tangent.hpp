#pragma once
/// \file
/// Tangents of the sum of squared deviations.

#include <mdm/blend/blend_problem.hpp>

namespace mdm {

/// A tangent as a cost that no blend's sum of squares is below: d^2 >= slope d - slope^2 / 4 for each
/// deviation d (Theorem 22).
struct Tangent {
  BlendProblem problem; ///< that has the cost as its aim, with the limits and stockpiles of the first
  Rational raised;      ///< the cost is so much above the tangent, as no cost is negative
};

/// The slopes of the tangent that touches where so much passes, one a sieve; 0 of those without a target.
std::vector<Rational> slopes_at(const BlendProblem &problem, const std::vector<Rational> &passing);

/// The tangent with these slopes.
/// \pre the problem's aim is squares
Tangent tangent_with(const BlendProblem &problem, const std::vector<Rational> &slopes);

} // namespace mdm

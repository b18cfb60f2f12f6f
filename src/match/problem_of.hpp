#pragma once
/// \file
/// The integer problem that a match solves, made again: a proof is written in its terms.

#include "match/problem.hpp"
#include "match/tolerant_problem.hpp"

#include <mdm/match/match.hpp>

namespace mdm {

/// With the floors of a demanded volume.
/// \pre m.sample, and no tolerance was asked for
Problem problem_of(const Match &m);

/// \pre m.tolerance
TolerantProblem tolerant_problem_of(const Match &m);

/// The mass of each class of the sample in units of c x^(a/b), to the scale power.
/// \pre m.sample
std::vector<Rational> powered_masses(const Match &m);

/// The masses themselves.
/// \pre m.sample, and m.tolerance, for which they are fractions
std::vector<Rational> class_masses(const Match &m);

} // namespace mdm

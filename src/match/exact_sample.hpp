#pragma once
/// \file
/// The sample of an exact match.

#include "match/problem.hpp"

#include <mdm/match/match.hpp>

namespace mdm {

/// The sample with the quantities q, one for each class of the problem, at the chosen scale: with its margin,
/// sizes and mass. `window` is that of q.
/// \throws InputError if a size is an opening that is no decimal
MatchSample exact_sample(const Gradation &g, const Problem &problem, std::vector<Integer> q, Window window,
                         const Rational &chosen, unsigned digits);

} // namespace mdm

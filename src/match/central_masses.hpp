#pragma once
/// \file
/// Masses of the classes for given counts.

#include "match/tolerant_problem.hpp"
#include "match/watch.hpp"

namespace mdm {

/// Masses that make the counts q a match, if they are one. Cost: a linear program in double precision, whose
/// result is verified; where that does not decide, an exact one.
/// \throws Simplex::Interrupted soon after the watch's end
std::optional<std::vector<Rational>> masses_of(const TolerantProblem &problem, const std::vector<Integer> &q,
                                               const Watch &watch = {});

/// Masses of the classes that make q a match, as far from all bounds on sizes and shares as can be: the least
/// distance, relative to the width between two bounds, is greatest, as far as double precision sees it. The
/// weight, where one is demanded, is `weight` or more by at most a part `excess` of it, if that can be.
/// Nothing if q is no match at that weight.
/// \throws Simplex::Interrupted soon after the watch's end
std::optional<std::vector<Rational>> central_masses(const TolerantProblem &problem,
                                                    const std::vector<Integer> &q,
                                                    const std::optional<Rational> &weight,
                                                    const Rational &excess, const Watch &watch = {});

} // namespace mdm

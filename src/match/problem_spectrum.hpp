#pragma once
/// \file
/// All numbers of particles that solve an integer problem.

#include "match/problem.hpp"
#include "match/spectrum.hpp"
#include "match/watch.hpp"

namespace mdm {

/// Walks up the feasible scales (Theorem 8): vector of lower ends by vector at first, then, where gaps come
/// only from scales that are not feasible, from one feasible stretch to the next, until every class is
/// feasible for good. Cost: a least match a step; `limits.max_steps` counts these.
Spectrum spectrum(const Problem &problem, const Limits &limits, const Watch &watch);
/// With the deadline of the limits as its watch.
Spectrum spectrum(const Problem &problem, const Limits &limits = {});

} // namespace mdm

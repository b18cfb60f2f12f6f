#pragma once
/// \file
/// All numbers of particles that have an exact match.

#include <mdm/match/least_match.hpp>

#include <utility>
#include <vector>

namespace mdm {

/// The reachable N: the closed intervals, ascending and with gaps between them, and every integer from
/// `all_from` on. Where a limit was reached (not complete), nothing is known from `all_from` on.
struct Spectrum {
  std::vector<std::pair<Integer, Integer>> intervals;
  Integer all_from;
  bool complete = false;
};

/// Walks up the feasible scales (Theorem 8): vector of lower ends by vector at first, then, where gaps come
/// only from scales that are not feasible, from one feasible stretch to the next, until every class is
/// feasible for good. Cost: a least match a step; `limits.max_steps` counts these.
Spectrum spectrum(const Problem &problem, const Limits &limits = {});

} // namespace mdm

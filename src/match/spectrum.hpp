#pragma once
/// \file
/// All numbers of particles that have an exact match.

#include <mdm/match/limits.hpp>
#include <mdm/match/solve.hpp>

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

/// All numbers of particles, from the least on, with which the gradation of a match without a tolerance can
/// be matched as its question demands: its law, floors and volume. Cost: a least match a step;
/// `limits.max_steps` counts these.
/// \param progress  as SolveOptions::progress
/// \pre m.sample, and no tolerance was asked for
Spectrum spectrum(const Match &m, const Limits &limits = {}, const ProgressCall &progress = {});

} // namespace mdm

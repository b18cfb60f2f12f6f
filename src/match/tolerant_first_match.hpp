#pragma once
/// \file
/// Matches to begin a search with.

#include "match/tolerant_chain.hpp"
#include "match/tolerant_match.hpp"

namespace mdm {

/// A match whose counts differ from those of the chain by one particle in the next class, or else by one more
/// particle; nothing if there is none. Most matches that are not the chain's are such ones.
std::optional<TolerantMatch> neighbouring_match(const TolerantChain &chain, const Watch &watch);

/// A match with few particles, fewer than `most`, but for certain not the smallest one: with masses from a
/// little above `mass` on, without whole numbers at first. Nothing if none is found, or the watch ends.
std::optional<TolerantMatch> rounded_match(const TolerantProblem &problem, const Rational &mass,
                                           const std::optional<Integer> &most, const Watch &watch);

} // namespace mdm

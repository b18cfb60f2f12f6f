#pragma once
/// \file
/// A match near the chain's bound.

#include "match/tolerant_chain.hpp"
#include "match/tolerant_match.hpp"

namespace mdm {

/// A match whose counts differ from those of the chain by one particle in the next class, or else by one more
/// particle; nothing if there is none. Most matches that are not the chain's are such ones.
std::optional<TolerantMatch> neighbouring_match(const TolerantChain &chain, const Watch &watch);

/// A match with few particles, but for certain not the smallest one: the differences of the chain's bounds
/// are taken at greater and greater masses, from that of `chain` on, until they are a match. Nothing if none
/// has fewer particles than `most`, or the watch ends.
std::optional<TolerantMatch> climbed_match(const TolerantChain &chain, const std::optional<Integer> &most,
                                           const Watch &watch);

} // namespace mdm

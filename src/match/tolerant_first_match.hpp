#pragma once
/// \file
/// A match to begin a search with.

#include "match/tolerant_match.hpp"

namespace mdm {

/// A match with few particles, fewer than `most`, mostly the smallest where no smaller ones than `least` are
/// to be had: with masses from a little above `mass` on. Nothing if none is found, or the watch ends.
/// \param least  no match has fewer particles
/// \param rounds  how long to look: masses, each up to 4 times as far above `mass` as the last; where counts
/// are walked over, so many times 16 windows of it
std::optional<TolerantMatch> first_match(const TolerantProblem &problem, const Rational &mass,
                                         const Integer &least, const std::optional<Integer> &most, int rounds,
                                         const Watch &watch);

} // namespace mdm

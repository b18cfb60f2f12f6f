#pragma once
/// \file
/// Why stockpiles cannot meet a specification.

#include "match/watch.hpp"

#include <mdm/blend/blend.hpp>

namespace mdm {

/// The limits that contradict each other, as few as can be: each is left out that is not needed, first those
/// of shares, then upper ones from the finest sieve to the coarsest, then lower ones from the coarsest to the
/// finest. What is left speaks of the sieves that are farthest apart.
/// \pre no real shares keep all limits
/// \throws Simplex::Interrupted soon after the watch's end
BlendContradiction contradiction_of(const BlendProblem &problem, const Watch &watch);

} // namespace mdm

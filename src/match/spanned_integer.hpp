#pragma once
/// \file
/// The spanned integer algorithm as published.

#include "match/published.hpp"

namespace mdm {

/// The settings of the spanned integer algorithm.
struct SpannedIntegerOptions {
  Rational start = ratio(1, 1000); ///< position of the first x_nS in its class, in (0, 1]
  std::uint64_t increments = 100; ///< >= 1 sizes x_nS, evenly from the first to the upper sieve; 1: the first
  std::uint64_t max_iterations = 999; ///< >= 1
};

/// The spanned integer algorithm (SI, steps 1-6), to the letter. With i particles of size x_nS in the
/// reference class, every other class needs between a_j (all at the upper sieve) and b_j (all at the lower
/// one). If ceil(a_j) <= floor(b_j) for each, q_j = ceil(a_j) and the sizes follow from Eq. 19. Else x_nS
/// grows; after the last x_nS, i does. The printed test takes b_j itself for reachable, though the lower
/// sieve is no size of the class: PublishedTry::error judges the sample that comes out.
///
/// An iteration that finds nothing leaves the sample of its last x_nS, with ceil(a_j) in every class; where
/// that is not spanned, Eq. 19 gives sizes that lie below the class. Cost: a division a class for each x_nS.
///
/// The paper's code tries one x_nS. With start 1/2 and one size this gives its answers to all of the paper's
/// 2,750 gradations, with start 1/1000 to all but four: there b_j < 1 in a class, and the code takes one
/// particle all the same.
/// \throws InputError if the law is not rational
Published spanned_integer(const Gradation &g, const MassLaw &law, const SpannedIntegerOptions &options = {});

} // namespace mdm

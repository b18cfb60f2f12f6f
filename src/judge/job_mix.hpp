#pragma once
/// \file
/// Limits about a job mix: what passes each of its sieves, within so many points.

#include <mdm/gradation/gradation.hpp>
#include <mdm/judge/specification.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The limits of a job mix's sieves: what passes in the mix less and more the points, from 0 to 100 %.
/// \param within  texts with points of sieves, `4.75mm=7,0.075mm=2`; at most one with those of all others, `5`.
///     A size without a unit is in that of the mix
/// \throws InputError naming the option where a text is none of these, the mix has no such sieve, a sieve is
///     there twice, or points are negative; and if openings of the mix are irrational
Specification job_mix_limits(const Gradation &mix, const std::vector<std::string> &within);

} // namespace mdm

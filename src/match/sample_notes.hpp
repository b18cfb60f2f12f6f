#pragma once
/// \file
/// What a modeller should know of a sample before using it.

#include <mdm/match/match.hpp>

namespace mdm {

/// Notes on a match's sample: of a specimen the figures of a representative volume, which are its height over
/// the largest size, against the 15 to 20 of Cantor and Ovalle (2025), the particles of the coarsest class,
/// and the largest size over D50 (Arnold, "Introduction"); of any sample the classes whose sizes crowd a
/// sieve, within 1e-6 of themselves
/// ("Discussion"). \pre there is a sample
std::vector<std::string> sample_notes(const Match &match);

} // namespace mdm

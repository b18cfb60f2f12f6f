#pragma once
/// \file
/// The proof of a match for VIPR checkers.

#include <mdm/match/match.hpp>

namespace mdm {

/// The most classes of a VIPR export: it has a constraint for each pair of them.
inline constexpr std::size_t most_vipr_classes = 200;

/// The problem without its scale, the match and the proof of minimality in the VIPR format, version 1.0
/// (Cheung, Gleixner, Steffy, "Verifying integer programming results", 2017; proofs/README.md, Theorem 10).
/// Within a tolerance: the problem of fewer particles than the match has, and the proof that it has no
/// solution, in slack form (Theorem 15).
/// \pre m.complete, and m was solved with Limits::keep_proof
/// \throws InputError if m has too many classes, or if the mass law makes ratios of masses at openings
/// irrational
std::string vipr(const Match &m);

} // namespace mdm

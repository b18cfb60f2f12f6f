#pragma once
/// \file
/// The proof of a match within a tolerance for VIPR checkers.

#include <mdm/match/match.hpp>

namespace mdm {

/// The problem of a sample of fewer than N particles (of any number, where there is none) in slack form: d is
/// at most every excess of a class's mass over its lower bound, and the proof is that d <= 0
/// (proofs/README.md, Theorem 15). The strict lower bounds of a match have no other form in VIPR, so the
/// match itself is not part of it.
/// \pre m.complete, m.tolerance, m.evidence()
std::string tolerant_vipr(const Match &m);

} // namespace mdm

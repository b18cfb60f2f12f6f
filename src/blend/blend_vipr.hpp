#pragma once
/// \file
/// The proof of a blend for VIPR checkers.

#include <mdm/blend/blend.hpp>

namespace mdm {

/// The problem, its first blend and the proof that none has a lower value, or the proof that there is none,
/// in the VIPR format, version 1.0 (Cheung, Gleixner, Steffy, "Verifying integer programming results", 2017;
/// proofs/README.md, Theorem 22). Its variables are the steps n_i, and the deviations where they are the aim.
/// \pre the answer is one to the problem, its status is optimal or none, and the aim is no widening
/// \throws InputError for squares and at_most, which are no linear conditions
std::string blend_vipr(const BlendProblem &problem, const BlendAnswer &answer);

} // namespace mdm

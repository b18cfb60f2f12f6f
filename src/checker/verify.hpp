#pragma once

#include "certificate.hpp"
#include "problem.hpp"

namespace mdm_check {

/// Verifies the claim (section 3): pi, witness, chain, at least M. Throws Refused at the first thing that
/// fails.
void verify(const Problem &problem, const Certificate &certificate);

} // namespace mdm_check

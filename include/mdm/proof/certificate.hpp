#pragma once
/// \file
/// The certificate of a match.

#include <mdm/match/solve.hpp>

namespace mdm {

/// The text of the certificate that m.particles() is the least number the question allows, or that no sample
/// is within its tolerance, in the format of proofs/certificate-format.md. `mdm-check` accepts it with the
/// gradation file that m came from.
/// \pre m.complete
/// \throws InputError if its numbers are beyond the limits of the format
std::string certificate(const Match &m);

} // namespace mdm

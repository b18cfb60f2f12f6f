#pragma once
/// \file
/// The certificate of a match.

#include <mdm/match/match.hpp>

namespace mdm {

/// The text of the certificate that m.particles() is the least number the question allows, or that no sample
/// is within its tolerance; of a search within a tolerance that a limit ended, that the least number is
/// m.proof.bound at least. In the format of proofs/certificate-format.md. `mdm-check` accepts it with the
/// gradation file that m came from.
/// \pre has_certificate(m), and m was solved with Limits::keep_proof
/// \throws InputError if its numbers are beyond the limits of the format, or its evidence was too long to be
/// kept
std::string certificate(const Match &m);

/// True if there is something to certify: the search came to its end, or has a bound.
inline bool has_certificate(const Match &m) {
  return m.complete || m.proof.bound;
}

/// Says before solving that no certificate can be within the limits of the format, whatever the answer.
/// \param asked  the gradation with the question's changes
/// \throws InputError if so
void check_certifiable(const Gradation &asked, const Question &question);

} // namespace mdm

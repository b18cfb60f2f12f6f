#pragma once
/// \file
/// The certificate of a match.

#include <mdm/match/match.hpp>

namespace mdm {

/// A certificate, in the format of proofs/certificate-format.md.
struct Certified {
  std::string text;
  /// No match has fewer particles: all that is proved of a search that a limit ended. It is m.proof.bound,
  /// or less where its proof would be longer than the format allows.
  std::optional<Integer> bound;
};

/// The certificate that m.particles() is the least number the question allows, or that no sample is within
/// its tolerance; of a search that a limit ended, that the least number is not below a bound. `mdm-check`
/// accepts it with the gradation file that m came from.
/// \pre has_certificate(m), and m was solved with Limits::keep_proof
/// Within a tolerance, where its evidence would be too long, less is proved.
/// \throws InputError if its numbers are beyond the limits of the format
Certified certified(const Match &m);

/// Its text.
inline std::string certificate(const Match &m) {
  return certified(m).text;
}

/// True if there is something to certify: the search came to its end, or has a bound.
inline bool has_certificate(const Match &m) {
  return m.complete || m.proof.bound;
}

/// Says before solving that no certificate can be within the limits of the format, whatever the answer.
/// \param asked  the gradation with the question's changes
/// \throws InputError if so
void check_certifiable(const Gradation &asked, const Question &question);

} // namespace mdm

#pragma once
/// \file
/// The certificate of a sample's shares and errors (proofs/certificate-format.md, section 12).

#include "proof/sample_tally.hpp"

#include <mdm/match/question.hpp>

#include <optional>
#include <string>

namespace mdm {

/// What is certified of a sample.
struct CertifiedSample {
  std::string text;
  bool matches;
};

/// The certificate that the sample of the tally matches what is asked, or that it does not; nothing where
/// ranges of sizes or an irrational law leave that open.
/// \param g  with the question's changes; that of the tally
/// \throws InputError if the question does not fit g, or a limit of the format is passed
std::optional<CertifiedSample> certified_sample(const Gradation &g, const Question &question,
                                                const SampleTally &tally);

} // namespace mdm

#pragma once
/// \file
/// The certificates of the answers that a cross-check judges, as files.

#include "ask/crosscheck_options.hpp"
#include "crosscheck/answer_proof.hpp"
#include "files/suite_lines.hpp"

#include <atomic>

namespace mdm {

/// Writes the certificates of answers to a folder, by several threads: NUMBER.proof, NUMBER.sample.csv and
/// NUMBER.gradation.json for the line NUMBER of the suite, NUMBER-2 and so on for more answers to it.
class AnswerProofs {
public:
  /// \throws InputError if the folder cannot be made
  AnswerProofs(std::string folder, const CrosscheckQuestion &question, Rational size_tolerance);

  /// \param number  of the answers to the gradation, from 1
  /// \throws InputError if a file cannot be written
  void add(const SuiteLine &entry, const Gradation &asked, const OtherAnswer &answer, unsigned number);

  /// How many there are, and how one is checked.
  std::string note() const;

private:
  /// Nothing also where numbers are beyond the limits of the format.
  std::optional<AnswerProof> made(const Gradation &asked, const OtherAnswer &answer) const;

  std::string folder_;
  const CrosscheckQuestion &question_;
  Rational size_tolerance_;
  std::atomic<std::uint64_t> answers_ = 0, proofs_ = 0;
};

} // namespace mdm

#pragma once
/// \file
/// The certificates of the answers that a cross-check judges, as files.

#include "ask/crosscheck_options.hpp"
#include "files/answer_stream.hpp"
#include "files/suite_lines.hpp"

#include <atomic>
#include <vector>

namespace mdm {

/// Makes the certificates of answers and writes them: to a folder as NUMBER.proof, NUMBER.sample.csv and
/// NUMBER.gradation.json for the line NUMBER of the suite, NUMBER-2 and so on for more answers to it; or as
/// one stream with an index, where the name is that of a stream.
class AnswerProofs {
public:
  /// \throws InputError if the folder or the stream cannot be made
  AnswerProofs(std::string path, const CrosscheckQuestion &question, Rational size_tolerance);

  /// The certificates of the answers to a gradation, in their order. One that failed has none, one that may
  /// match or not has none, and where numbers are beyond the limits of the format there is none.
  using OfGradation = std::vector<std::optional<AnswerProof>>;

  /// The certificate of an answer. Several threads may call it.
  std::optional<AnswerProof> made(const Gradation &asked, const OtherAnswer &answer);
  /// Writes those of the answers to the gradation of a line. Lines ascend.
  /// \throws InputError if that cannot be
  void write(const SuiteLine &entry, const OfGradation &proofs);
  /// Makes what was written final. \throws InputError if that fails
  void commit();

  /// How many there are, and how they are checked.
  /// \param suite  its path
  std::string note(const std::string &suite) const;

private:
  void write_files(const SuiteLine &entry, std::size_t number, const AnswerProof &proof) const;

  std::string path_;
  const CrosscheckQuestion &question_;
  Rational size_tolerance_;
  std::optional<AnswerStream> stream_; ///< none: a folder
  std::atomic<std::uint64_t> answers_ = 0;
  std::uint64_t proofs_ = 0;
};

} // namespace mdm

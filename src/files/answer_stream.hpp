#pragma once
/// \file
/// The certificates of answers to a suite as one file, with an index beside it.

#include "crosscheck/answer_proof.hpp"
#include "files/output.hpp"

#include <cstdint>

namespace mdm {

/// Samples, each with its certificate behind it, and their index (proofs/certificate-format.md, section 10).
/// Both files are written beside and take their names in commit().
class AnswerStream {
public:
  /// \throws InputError if one of the files cannot be written
  explicit AnswerStream(const std::string &path);

  /// \param line    of the suite
  /// \param number  of the answers to the gradation, from 1; both ascend
  /// \throws InputError if it cannot be written
  void add(std::uint64_t line, std::size_t number, const AnswerProof &proof);
  /// \throws InputError if that fails
  void commit();

private:
  Output stream_, index_;
  std::uint64_t offset_ = 0;
};

} // namespace mdm

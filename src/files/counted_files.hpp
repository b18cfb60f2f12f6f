#pragma once
/// \file
/// Answers and proofs with their totals beside them.

#include "answer/totals.hpp"
#include "files/file_lock.hpp"
#include "files/proof_stream.hpp"

namespace mdm {

/// The totals of a file of answers.
std::string totals_path(const std::string &answers);

/// The totals beside a file of answers. \throws InputError if there are none
Totals read_totals_of(const std::string &answers);

/// A file beside the totals of `answers` as messages and commands name it.
std::string path_beside(const std::string &answers, const NamedFileTotals &file);

/// The files of a shard or of a set of shards: answers, the stream of proofs with its index where it is asked
/// for, and totals. One run at a time writes them. What an earlier run wrote stays until all is written anew;
/// the totals are removed before the first file takes its name, and written last: where they are, all is.
class CountedFiles {
public:
  /// Takes the files for this run. \throws InputError if they cannot be written, or another run has them
  CountedFiles(std::string answers, std::optional<std::string> proofs);

  /// The totals of an earlier run, if its files are there with these names and as it left them.
  std::optional<Totals> complete() const;

  /// Begins to write. \throws InputError if that cannot be
  void open();
  Output &answers() { return *answers_; }
  /// Null where no proofs are asked for.
  ProofStream *proofs() { return proofs_ ? &*proofs_ : nullptr; }
  /// Makes all final. \param totals all but the files \throws InputError if that fails
  void commit(Totals totals);

private:
  std::string answers_path_;
  std::optional<std::string> proofs_path_;
  FileLock lock_;
  std::optional<Output> answers_;
  std::optional<ProofStream> proofs_;
};

} // namespace mdm

#pragma once
/// \file
/// What a batch is asked.

#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"
#include "files/proof_stream.hpp"

namespace mdm::cli {

/// The options of mdm batch.
struct BatchCommand {
  std::vector<std::string> files;
  SolveFlags flags;
  ReadingFlags reading;
  std::optional<std::string> proofs, shard;
  bool alone = false; ///< the suite has the lines of the shard alone
  unsigned threads = 1;
  OutputFlags output;

  /// Certificates are written as one stream ...
  bool has_proof_stream() const { return proofs && (shard || names_proof_stream(*proofs)); }
  /// ... or each as a file of its own.
  bool has_proof_folder() const { return proofs && !has_proof_stream(); }
};

} // namespace mdm::cli

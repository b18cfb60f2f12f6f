#pragma once
/// \file
/// The answers of a batch, one by one.

#include "ask/asked_search.hpp"
#include "cli/batch_command.hpp"
#include "cli/exit_code.hpp"
#include "files/batch_sources.hpp"

namespace mdm::cli {

/// The answer to one gradation, with the exit code that it would have alone.
struct BatchAnswer {
  std::string text;
  int exit = Exit::done;
  std::string told = {};        ///< on standard error
  std::string id = {};          ///< of a table's rows
  std::string unit = {};        ///< the same; empty: no rows
  std::string certificate = {}; ///< for the stream of proofs; empty: none
};

/// Solves the gradations of a batch as the command says. Several threads may call it.
class BatchSolver {
public:
  /// \param command must outlive it
  /// \throws InputError naming the option where its value does not serve
  explicit BatchSolver(const BatchCommand &command);

  /// What is wrong with the gradation is the answer. In a folder of proofs its certificate is written.
  /// \throws InputError if that cannot be
  BatchAnswer answer(const BatchItem &item) const;

private:
  BatchAnswer error(const std::string &id, const std::string &message) const;
  BatchAnswer solved(Gradation g, const BatchItem &item) const;
  std::string write_proofs(const std::string &certificate, Found &found, const BatchItem &item,
                           const std::string &checked) const;

  const BatchCommand &command_;
  AskedSearch search_;
};

} // namespace mdm::cli

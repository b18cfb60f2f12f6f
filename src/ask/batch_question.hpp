#pragma once
/// \file
/// One question to many gradations.

#include "ask/outcome.hpp"
#include "ask/solve_options.hpp"

namespace mdm {

/// A match and how its search ended.
struct BatchMatch {
  Match match;
  Outcome outcome;
  Limits limits;
};

/// What a batch asks of each gradation. Several threads may ask at once.
class BatchQuestion {
public:
  /// \param keep_proof  keep what proofs are written from
  /// \throws InputError naming the option where its value does not serve
  BatchQuestion(const SolveTexts &asked, const ReadBand &read_band, bool keep_proof);

  /// The answer; a time limit is one of this gradation's own. \throws InputError where the question does not
  /// fit it
  BatchMatch ask(Gradation g, const ProgressCall &progress = {}) const;

private:
  SolveTexts texts_;
  bool keep_proof_;
  AskedQuestion question_;
  SolveOptions options_;
};

} // namespace mdm

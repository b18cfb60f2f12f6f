#pragma once
/// \file
/// A search as the options of solving ask for it, for one gradation or for many.

#include "ask/outcome.hpp"
#include "ask/solve_options.hpp"

namespace mdm {

/// A match and how its search ended.
struct Found {
  Match match;
  std::optional<Match> finer; ///< of a budget, see BudgetMatch
  Outcome outcome;
  Limits limits;
};

/// True if the search left open whether the match is the smallest, or which step of a budget is the first.
bool is_open(const Match &found);
/// Says in the notes of what is open that the caller ended the search.
void note_stopped(Match &found);

/// The question, its budget of particles if it has one, and the limits. Several threads may ask at once.
class AskedSearch {
public:
  /// \param keep_proof  keep what proofs are written from
  /// \throws InputError naming the option where its value does not serve
  AskedSearch(SolveTexts asked, const BudgetTexts &budget, const ReadBand &read_band, bool keep_proof);

  const AskedQuestion &question() const { return question_; }

  /// The answer; a time limit is one of this gradation's own. \throws InputError where the question does not
  /// fit it
  Found ask(Gradation g, const ProgressCall &progress = {}) const;
  /// The same of a question that was made for the gradation.
  Found ask(Gradation g, const Question &question, const ProgressCall &progress) const;

private:
  SolveTexts texts_;
  bool keep_proof_;
  std::optional<Budget> budget_;
  AskedQuestion question_;
  SolveOptions options_;
};

} // namespace mdm

#include "ask/asked_search.hpp"

namespace mdm {
namespace {

std::optional<Budget> budget_of(const BudgetTexts &budget, const SolveTexts &others) {
  budget.check();
  return budget.particles ? std::optional(budget.budget(others)) : std::nullopt;
}

} // namespace

bool is_open(const Match &found) {
  return !found.complete || (found.budget && !found.budget->is_decided);
}

void note_stopped(Match &found) {
  if (is_open(found))
    found.notes.push_back("the search was interrupted");
}

AskedSearch::AskedSearch(SolveTexts asked, const BudgetTexts &budget, const ReadBand &read_band,
                         bool keep_proof)
    : texts_(std::move(asked)), keep_proof_(keep_proof), budget_(budget_of(budget, texts_)),
      question_(budget_ ? budget.question(texts_, read_band) : texts_.question(read_band)),
      options_(texts_.options(keep_proof)) {}

Found AskedSearch::ask(Gradation g, const ProgressCall &progress) const {
  const Question question = question_.of(g);
  return ask(std::move(g), question, progress);
}

Found AskedSearch::ask(Gradation g, const Question &question, const ProgressCall &progress) const {
  SolveOptions options = texts_.time_limit ? texts_.options(keep_proof_) : options_;
  options.progress = progress;
  BudgetMatch found = budget_ ? solve_within_budget(g, question, *budget_, options)
                              : BudgetMatch{solve(std::move(g), question, options), std::nullopt};
  const Outcome outcome = outcome_of(found.match, options.limits);
  return {std::move(found.match), std::move(found.finer), outcome, options.limits};
}

} // namespace mdm

#include "ask/batch_question.hpp"

namespace mdm {

BatchQuestion::BatchQuestion(const SolveTexts &asked, const ReadBand &read_band, bool keep_proof)
    : texts_(asked), keep_proof_(keep_proof), question_(asked.question(read_band)),
      options_(asked.options(keep_proof)) {}

BatchMatch BatchQuestion::ask(Gradation g, const ProgressCall &progress) const {
  SolveOptions options = texts_.time_limit ? texts_.options(keep_proof_) : options_;
  options.progress = progress;
  const Question question = question_.of(g);
  Match m = solve(std::move(g), question, options);
  const Outcome outcome = outcome_of(m, options.limits);
  return {std::move(m), outcome, options.limits};
}

} // namespace mdm

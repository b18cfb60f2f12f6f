#include "python/question.hpp"

#include <mdm/text/error.hpp>

namespace mdm::python {

OptionText Words::find(const std::string &keyword) const {
  const auto found = values.find(keyword);
  return found == values.end() ? std::nullopt : OptionText(found->second);
}

SolveTexts solve_texts(const Words &words) {
  SolveTexts texts;
  take_words(words, SolveTexts::tolerance_options, texts);
  for_each_option(texts, [&words](const char *name, OptionText &text) { text = words.find(option(name)); });
  return texts;
}

BudgetTexts budget_texts(const Words &words) {
  BudgetTexts texts;
  take_words(words, BudgetTexts::options, texts);
  return texts;
}

ReadBand band_of(const Words &words) {
  return
      [&words](const std::string &content) { return read_envelope(content, words.values.at("band_name")); };
}

std::optional<Envelope> envelope_of(const Words &words) {
  const OptionText band = words.find("band");
  return band ? std::optional(band_of(words)(*band)) : std::nullopt;
}

SolveOptions options_of(const Words &words, bool keep_proof) {
  SolveOptions o = solve_texts(words).options(keep_proof);
  // More steps than a proof can have: they are for the answer alone.
  o.limits.keep_proof = keep_proof && o.limits.max_steps.value_or(0) <= most_steps;
  return o;
}

} // namespace mdm::python

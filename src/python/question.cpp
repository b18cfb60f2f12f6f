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
  take_words(words, SolveTexts::band_options, texts);
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

bool keeps_proof(const Words &words, bool keep_proof) {
  return keep_proof && solve_texts(words).options().limits.max_steps.value_or(0) <= most_steps;
}

SolveOptions options_of(const Words &words, bool keep_proof) {
  return solve_texts(words).options(keeps_proof(words, keep_proof));
}

} // namespace mdm::python

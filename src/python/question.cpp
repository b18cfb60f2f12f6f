#include "python/question.hpp"

#include "cli/solve_texts.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm::python {
namespace {

/// `--at-least` as the keyword `at_least`.
std::string keyword(std::string_view option) {
  std::string word(option.substr(2));
  std::replace(word.begin(), word.end(), '-', '_');
  return word;
}

void replace_option(std::string &text, const std::string &option) {
  for (std::size_t at = 0; (at = text.find(option, at)) != std::string::npos; ++at) {
    const char next = at + option.size() < text.size() ? text[at + option.size()] : ' ';
    if (next != '-' && (next < 'a' || next > 'z')) // else a longer one
      text.replace(at, option.size(), keyword(option));
  }
}

/// Calls action(), whose errors name options of the command line, and names keywords in them.
template <class Action>
auto in_keywords(Action action) {
  try {
    return action();
  } catch (const InputError &e) {
    std::string text = e.what();
    for (const char *const option : {"--tolerance", "--band", "--particles", "--grid"})
      replace_option(text, option);
    for (const cli::SolveTexts::Named &named : cli::SolveTexts::all)
      replace_option(text, named.option);
    throw InputError(text);
  }
}

cli::SolveTexts texts_of(const Words &words) {
  cli::SolveTexts texts;
  texts.tolerances = words.tolerances;
  if (const std::string *const band = words.find("band"))
    texts.band = *band;
  for (const auto &[option, text] : cli::SolveTexts::all)
    if (const std::string *const value = words.find(keyword(option)))
      texts.*text = *value;
  return texts;
}

cli::BudgetTexts budget_texts_of(const Words &words) {
  cli::BudgetTexts texts{words.values.at("particles"), {}};
  if (const std::string *const grid = words.find("grid"))
    texts.grid = *grid;
  return texts;
}

cli::ReadBand band_of(const Words &words) {
  return
      [&words](const std::string &content) { return read_envelope(content, words.values.at("band_name")); };
}

} // namespace

const std::string *Words::find(const std::string &name) const {
  const auto found = values.find(name);
  return found == values.end() ? nullptr : &found->second;
}

cli::AskedQuestion question_of_gradation(const Words &words) {
  return in_keywords([&] { return texts_of(words).GradationTexts::question(); });
}

cli::AskedQuestion question_of(const Words &words) {
  return in_keywords([&] { return texts_of(words).question(band_of(words)); });
}

cli::AskedQuestion question_of_both(const Words &words) {
  return in_keywords([&] { return texts_of(words).question_of_both(band_of(words)); });
}

Question question_in(const cli::AskedQuestion &asked, SizeUnit unit) {
  return in_keywords([&] { return asked.in(unit); });
}

SolveOptions options_of(const Words &words, bool keep_proof) {
  SolveOptions o = in_keywords([&] { return texts_of(words).options(keep_proof); });
  // More steps than a proof can have: they are for the answer alone.
  o.limits.keep_proof = keep_proof && o.limits.max_steps.value_or(0) <= most_steps;
  return o;
}

Budget budget_of(const Words &words) {
  return in_keywords([&] { return budget_texts_of(words).budget(texts_of(words)); });
}

cli::AskedQuestion question_beside_budget(const Words &words) {
  return in_keywords([&] { return budget_texts_of(words).question(texts_of(words), band_of(words)); });
}

} // namespace mdm::python

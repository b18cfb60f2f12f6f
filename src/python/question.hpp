#pragma once
/// \file
/// A question and its limits in the words of the command line.

#include "cli/asked_question.hpp"

#include <mdm/match/budget.hpp>
#include <mdm/match/solve.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mdm::python {

/// The options of `mdm solve` by their names, with `_` for `-` and numbers as texts. `band` is the content of
/// the file, `band_name` its name.
struct Words {
  std::map<std::string, std::string> values;
  std::vector<std::string> tolerances;

  /// The value of an option, or nothing.
  const std::string *find(const std::string &name) const;
  bool has(const std::string &name) const { return find(name) != nullptr; }
  bool is_tolerant() const { return !tolerances.empty() || has("band"); }
};

/// How a gradation is taken: law, pan_size, cut_below and size_factor. Errors name the option.
cli::AskedQuestion question_of_gradation(const Words &words);

/// What a gradation is asked. Errors name the option.
/// \throws InputError where a value does not serve, or options do not go together
cli::AskedQuestion question_of(const Words &words);
/// The same for a trade-off, which looks for matches of both kinds: limits of either serve.
cli::AskedQuestion question_of_both(const Words &words);

/// The question with its lengths in the gradation's unit.
Question question_in(const cli::AskedQuestion &asked, SizeUnit unit);

/// The limits, and how sizes are shown. The deadline counts from this call. With a limit of more steps than a
/// proof can have none is kept.
SolveOptions options_of(const Words &words, bool keep_proof);

/// A budget of particles, and the question beside it. \pre words.has("particles")
Budget budget_of(const Words &words);
cli::AskedQuestion question_beside_budget(const Words &words);

} // namespace mdm::python

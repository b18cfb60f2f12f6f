#pragma once
/// \file
/// A question and its limits in the keywords of the package.

#include "ask/solve_options.hpp"
#include "text/option_name.hpp"

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace mdm::python {

/// Options by their keywords, with numbers as texts. `band` is the content of the file, `band_name` its name.
struct Words {
  std::map<std::string, std::string> values;
  std::vector<std::string> tolerances;

  /// The value of an option, or nothing.
  OptionText find(const std::string &keyword) const;
  bool has(const std::string &keyword) const { return find(keyword).has_value(); }
  bool is_tolerant() const { return !tolerances.empty() || has("band"); }
};

/// Fills the texts of a table with the values of its keywords.
template <class Row, class Texts>
void take_words(const Words &words, const std::vector<Row> &rows, Texts &texts) {
  for (const Row &row : rows) {
    const auto take = [&](auto place) {
      using Value = std::remove_reference_t<decltype(texts.*place)>;
      if constexpr (std::is_same_v<Value, bool>)
        texts.*place = words.has(option(row.name));
      else if constexpr (std::is_same_v<Value, OptionText>)
        texts.*place = words.find(option(row.name));
      else
        texts.*place = words.tolerances;
    };
    std::visit(take, row.place);
  }
}

/// All options of solving.
SolveTexts solve_texts(const Words &words);
/// A budget of particles, if there is one.
BudgetTexts budget_texts(const Words &words);
/// How the band is read; `words` must outlive it.
ReadBand band_of(const Words &words);
/// The envelope of the band, if there is one.
std::optional<Envelope> envelope_of(const Words &words);

/// False with a limit of more steps than a proof can have: they are for the answer alone.
bool keeps_proof(const Words &words, bool keep_proof);
/// The limits, and how sizes are shown. The deadline counts from this call. With a limit of more steps than a
/// proof can have none is kept.
SolveOptions options_of(const Words &words, bool keep_proof);

} // namespace mdm::python

#include "gradation/number_shares.hpp"

#include "gradation/plain_words.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {

bool speaks_of_number_shares(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  const auto have = [&words](std::string_view list) { return has_any_word(list, words); };
  const auto have_two = [&words](std::string_view first, std::string_view second) {
    return has_two_words(first, second, words);
  };
  constexpr std::string_view kinds = "number count population intensity anzahl nombre numero area";
  if (have("anzahlverteilung anzahlsummenverteilung q0") || have_two("pebble", "count counts") ||
      have_two("by", kinds) || have_two(kinds, "distribution distributions percent weighted"))
    return true;
  return have("number anzahl nombre numero") &&
         have("distribution distributions distribucion distribuzione weighted weighting basis base "
              "verteilung");
}

bool states_other_shares(std::string_view label, std::string_view value) {
  constexpr std::string_view labels =
      "distribution distributions distribucion distribuzione verteilung verteilungsart "
      "result results resultat ergebnis basis base weighted weighting mode mengenart";
  constexpr std::string_view kinds =
      "number numbers anzahl nombre numero count counts surface surfaces oberflaeche "
      "superficie length lengths laenge longueur longitud lunghezza";
  constexpr std::string_view beside = "area percent weighted based basis distribution by";
  const std::vector<std::string> of_label = words_of(label), of_value = words_of(value);
  const auto is_label = [labels](const std::string &w) { return has_word(labels, w); };
  const auto is_kind = [kinds](const std::string &w) { return has_word(kinds, w); };
  const bool is_report = of_label == std::vector<std::string>{"report", "by"};
  return (is_report || std::any_of(of_label.begin(), of_label.end(), is_label)) &&
         std::any_of(of_value.begin(), of_value.end(), is_kind) &&
         std::all_of(of_value.begin(), of_value.end(),
                     [&](const std::string &w) { return is_kind(w) || has_word(beside, w); });
}

namespace {

/// What a cell, or one with the next where the row has no more, says that shares are of; else nothing.
std::string other_shares_in(const CellRow &row, std::size_t column) {
  const std::string_view cell = row.cell(column), next = row.cell(column + 1);
  const std::size_t sign = cell.find_last_of(":=");
  if (sign != std::string_view::npos && states_other_shares(cell.substr(0, sign), cell.substr(sign + 1)))
    return in_quotes(cell);
  return row.filled() == 2 && states_other_shares(cell, next) ? in_quotes(cell) + " " + in_quotes(next) : "";
}

} // namespace

void refuse_number_shares(const Cells &cells, std::size_t above, const Source &source) {
  for (std::size_t i = 0; i < above; ++i) {
    const CellRow &row = cells.rows[i];
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      for (const std::string &text : {row.cells[c], row.cells[c] + " " + std::string(row.cell(c + 1))})
        if (speaks_of_number_shares(text))
          source.refuse(row.line, fmt::format("{} says that the shares are by number: {}", in_quotes(text),
                                              number_shares_remedy));
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      if (const std::string stated = other_shares_in(row, c); !stated.empty())
        source.refuse(row.line, fmt::format("{} says that the shares are not by mass or volume: {}", stated,
                                            number_shares_remedy));
  }
}

} // namespace mdm

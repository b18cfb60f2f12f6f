#include "gradation/header_words.hpp"

#include "gradation/column_words.hpp"
#include "gradation/plain_words.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace mdm {
namespace {

struct UnitWords {
  std::string_view words; ///< with spaces between them
  ColumnUnit unit;
};
constexpr std::string_view kilograms = "kg kgs kilogram kilograms kilogramm kilogramme kilogrammes";
constexpr std::array units = {
    UnitWords{"mm millimeter millimeters millimetre millimetres milimetro milimetros millimetri",
              ColumnUnit::mm},
    UnitWords{"um u micron microns micrometer micrometers micrometre micrometres mikrometer micras",
              ColumnUnit::um},
    UnitWords{"m", ColumnUnit::m},
    UnitWords{"in inch inches zoll", ColumnUnit::inch},
    UnitWords{"phi", ColumnUnit::phi},
    UnitWords{
        "percent percents percentage percentages pct prozent prozente pourcentage pourcentages porcentaje "
        "porcentajes percentuale percentuali",
        ColumnUnit::percent},
    UnitWords{"fraction", ColumnUnit::fraction},
    UnitWords{"g gr gm gms gram grams gramm gramme grammes gramos grammi", ColumnUnit::mass},
    UnitWords{kilograms, ColumnUnit::mass},
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

using UnitsOfWords = std::unordered_map<std::string_view, ColumnUnit>;

UnitsOfWords units_of_words() {
  UnitsOfWords all;
  for (const UnitWords &u : units)
    for (const std::string_view word : listed_words(u.words))
      all.emplace(word, u.unit);
  return all;
}

ColumnUnit unit_of_word(std::string_view word) {
  static const UnitsOfWords all = units_of_words();
  const auto found = all.find(word);
  return found == all.end() ? ColumnUnit::none : found->second;
}

bool is_percent(std::string_view word) {
  return unit_of_word(word) == ColumnUnit::percent;
}

/// Short forms of what the percent are of: `M.-%`, `wt%`.
bool is_share_abbreviation(std::string_view word) {
  return is_one_of(word, {"m", "ma", "wt", "w", "gew", "vol", "v"});
}

/// Words of which the percent are, beside the percent: `M.-%`, `wt%`, `percent by mass`.
bool is_share_word(std::string_view word) {
  return is_share_abbreviation(word) || is_one_of(word, {"mass", "masse", "weight", "volume", "by"});
}

ColumnUnit unit_of(const std::vector<std::string> &words) {
  if (words.size() > 1 && std::count_if(words.begin(), words.end(), is_percent) == 1 &&
      std::all_of(words.begin(), words.end(),
                  [](const std::string &w) { return is_percent(w) || is_share_word(w); }))
    return ColumnUnit::percent;
  return words.size() == 1 ? unit_of_word(words[0]) : ColumnUnit::none;
}

/// `?m`, `_m`, ` m`: what is left of micrometres where the first letter was lost.
bool may_lack_micro(std::string_view unit) {
  return unit.size() > 1 && unit.back() == 'm' && words_of(unit) == std::vector<std::string>{"m"};
}

/// The header without what stands in the last brackets, if that is a unit.
ColumnUnit take_bracketed_unit(std::string &header) {
  constexpr std::array<std::string_view, 3> brackets = {"()", "[]", "{}"};
  for (const std::string_view pair : brackets) {
    const std::size_t open = header.rfind(pair[0]);
    const std::size_t close = open == std::string::npos ? open : header.find(pair[1], open);
    if (close == std::string::npos)
      continue;
    const std::string_view content = std::string_view(header).substr(open + 1, close - open - 1);
    const ColumnUnit unit = unit_of_words(content);
    if (unit == ColumnUnit::none)
      continue;
    const bool is_cut = may_lack_micro(content);
    header.erase(open, close + 1 - open);
    return is_cut ? ColumnUnit::none : unit;
  }
  return ColumnUnit::none;
}

/// Takes `by mass` and the like away.
void drop_share(std::vector<std::string> &words) {
  for (std::size_t i = 1; i + 1 < words.size();)
    if (words[i] == "by" && is_share_word(words[i + 1]))
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                  words.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    else
      ++i;
}

/// Takes percent away wherever it stands, with short forms of what it is of: `cumulative % passing`,
/// `Siebdurchgang in M.-%`.
ColumnUnit take_percent(std::vector<std::string> &words) {
  const bool is_last = is_percent(words.back());
  words.erase(std::remove_if(words.begin(), words.end(),
                             [&words](const std::string &w) {
                               return is_percent(w) || (words.size() > 2 && is_share_abbreviation(w));
                             }),
              words.end());
  if (is_last && words.size() > 1 && is_one_of(words.back(), {"in", "en"}))
    words.pop_back();
  return ColumnUnit::percent;
}

/// Takes the unit from words without brackets: `siebweite in mm`, `grams retained`, `wt percent passing`.
ColumnUnit take_unit(std::vector<std::string> &words) {
  drop_share(words);
  if (words.size() > 1 && std::any_of(words.begin(), words.end(), is_percent))
    return take_percent(words);
  if (words.size() < 2)
    return ColumnUnit::none;
  if (const ColumnUnit first = unit_of_word(words.front());
      first == ColumnUnit::mass || first == ColumnUnit::fraction) {
    words.erase(words.begin());
    return first;
  }
  const bool is_word = words.back() == "in" && meaning_of_words(words, false); // of `volume in`
  const ColumnUnit last = is_word ? ColumnUnit::none : unit_of_word(words.back());
  if (last == ColumnUnit::none)
    return last;
  words.pop_back();
  if (words.size() > 1 && words.back() == "in")
    words.pop_back();
  return last;
}

/// `mm`, `[µm]` or `phi` and nothing else; other units may be symbols, as `m` of a mass.
std::optional<ColumnUnit> unit_alone(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
  if (words.size() != 1 || words[0] == "u")
    return std::nullopt;
  const ColumnUnit unit = unit_of_word(words[0]);
  return unit == ColumnUnit::mm || unit == ColumnUnit::um || unit == ColumnUnit::phi ? std::optional(unit)
                                                                                     : std::nullopt;
}

} // namespace

std::optional<SizeUnit> length_of(ColumnUnit unit) {
  switch (unit) {
  case ColumnUnit::mm:
    return SizeUnit::mm;
  case ColumnUnit::um:
    return SizeUnit::um;
  case ColumnUnit::m:
    return SizeUnit::m;
  case ColumnUnit::inch:
    return SizeUnit::in;
  default:
    return std::nullopt;
  }
}

bool is_of_sizes(ColumnUnit unit) {
  return length_of(unit) || unit == ColumnUnit::phi;
}

ColumnUnit unit_of_words(std::string_view words) {
  return unit_of(words_of(words));
}

ColumnUnit unit_in_header(std::string_view header) {
  std::string rest(header);
  const ColumnUnit unit = take_bracketed_unit(rest);
  std::vector<std::string> words = words_of(rest);
  return unit == ColumnUnit::none ? take_unit(words) : unit;
}

std::vector<std::string> words_in(std::string_view header, ColumnUnit unit) {
  std::string rest(header);
  const ColumnUnit bracketed = take_bracketed_unit(rest);
  std::vector<std::string> words = words_of(rest);
  for (const ColumnUnit found : {bracketed, take_unit(words)})
    if (found != ColumnUnit::none && found != unit)
      return {};
  return words;
}

std::optional<HeaderMeaning> header_meaning(std::string_view header) {
  if (const std::optional<ColumnUnit> unit = unit_alone(header))
    return HeaderMeaning{ColumnMeaning::size, *unit};
  std::string rest(header);
  ColumnUnit unit = take_bracketed_unit(rest);
  std::vector<std::string> words = words_of(rest);
  // Percent may be named beside a unit in brackets, as in `Percent passing (%)`; anything else would be a
  // second unit.
  const ColumnUnit other = take_unit(words);
  if (unit == ColumnUnit::none)
    unit = other;
  else if (other != ColumnUnit::none && other != unit)
    return std::nullopt;
  const bool is_symbol = joined(words) == "ri" || joined(words) == "r i";
  if (is_symbol && unit != ColumnUnit::mass)
    return std::nullopt;
  const std::optional<WordsMeaning> said = is_symbol ? std::optional(WordsMeaning{ColumnMeaning::retained})
                                                     : meaning_of_words(std::move(words), is_of_sizes(unit));
  if (!said)
    return std::nullopt;
  const HeaderMeaning meaning{said->meaning, unit, said->is_individual, is_symbol, said->is_unclear};
  if (unit != ColumnUnit::none && is_of_sizes(unit) != holds_sizes(meaning))
    return std::nullopt;
  return meaning;
}

bool holds_sizes(const HeaderMeaning &meaning) {
  return meaning.meaning == ColumnMeaning::size || meaning.meaning == ColumnMeaning::sieve;
}

bool names_kilograms(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  return std::any_of(words.begin(), words.end(), [](const std::string_view word) {
    return has_word(kilograms, word.substr(std::min(word.find_first_not_of("0123456789"), word.size())));
  });
}

bool names_other_mass(std::string_view text) {
  return has_any_word("lb lbs pound pounds oz ounce ounces mg milligram milligrams tonne tonnes",
                      words_of(text));
}

} // namespace mdm

#include "gradation/header_words.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace mdm {
namespace {

struct Words {
  std::string_view words; ///< as plain_words gives them
  ColumnMeaning meaning;
};

constexpr auto size_column = ColumnMeaning::size;
constexpr auto sieve_column = ColumnMeaning::sieve;
constexpr auto retained_column = ColumnMeaning::retained;
constexpr auto cumulative_column = ColumnMeaning::cumulative;
constexpr auto passing_column = ColumnMeaning::passing;

// Only names that mean one thing. `Refus` in French, for example, is what a sieve retains or all coarser ones
// too.
constexpr std::array english = {
    Words{"size", size_column},
    Words{"sieve size", size_column},
    Words{"sieve opening", size_column},
    Words{"sieve aperture", size_column},
    Words{"sieve opening size", size_column},
    Words{"test sieve size", size_column},
    Words{"opening", size_column},
    Words{"opening size", size_column},
    Words{"aperture", size_column},
    Words{"aperture size", size_column},
    Words{"mesh size", size_column},
    Words{"mesh opening", size_column},
    Words{"particle size", size_column},
    Words{"particle diameter", size_column},
    Words{"equivalent diameter", size_column},
    Words{"equivalent particle diameter", size_column},
    Words{"grain size", size_column},
    Words{"grain diameter", size_column},
    Words{"diameter", size_column},
    Words{"channel diameter lower", size_column},
    Words{"sieve", sieve_column},
    Words{"sieve no", sieve_column},
    Words{"sieve number", sieve_column},
    Words{"sieve name", sieve_column},
    Words{"sieve designation", sieve_column},
    Words{"us sieve", sieve_column},
    Words{"us sieve no", sieve_column},
    Words{"us standard sieve", sieve_column},
    Words{"us standard sieve no", sieve_column},
    Words{"test sieve", sieve_column},
    Words{"mass", retained_column},
    Words{"weight", retained_column},
    Words{"retained", retained_column},
    Words{"mass retained", retained_column},
    Words{"weight retained", retained_column},
    Words{"retained mass", retained_column},
    Words{"retained weight", retained_column},
    Words{"mass of soil retained", retained_column},
    Words{"weight of soil retained", retained_column},
    Words{"mass retained on sieve", retained_column},
    Words{"weight retained on sieve", retained_column},
    Words{"retained on sieve", retained_column},
    Words{"individual retained", retained_column},
    Words{"individual mass retained", retained_column},
    Words{"individual weight retained", retained_column},
    Words{"volume in", retained_column},
    Words{"differential volume", retained_column},
    Words{"diff volume", retained_column},
    Words{"p3", retained_column},
    Words{"cumulative retained", cumulative_column},
    Words{"cum retained", cumulative_column},
    Words{"cumulative mass retained", cumulative_column},
    Words{"cumulative weight retained", cumulative_column},
    Words{"cumulative oversize", cumulative_column},
    Words{"oversize", cumulative_column},
    Words{"passing", passing_column},
    Words{"mass passing", passing_column},
    Words{"weight passing", passing_column},
    Words{"cumulative passing", passing_column},
    Words{"cum passing", passing_column},
    Words{"cumulative mass passing", passing_column},
    Words{"total passing", passing_column},
    Words{"finer", passing_column},
    Words{"finer than", passing_column},
    Words{"cumulative finer", passing_column},
    Words{"mass finer", passing_column},
    Words{"undersize", passing_column},
    Words{"cumulative undersize", passing_column},
    Words{"volume under", passing_column},
    Words{"q3", passing_column},
};
constexpr std::array german = {
    Words{"siebweite", size_column},
    Words{"maschenweite", size_column},
    Words{"siebmaschenweite", size_column},
    Words{"siebgroesse", size_column},
    Words{"sieboeffnung", size_column},
    Words{"oeffnungsweite", size_column},
    Words{"nennoeffnungsweite", size_column},
    Words{"lochweite", size_column},
    Words{"korngroesse", size_column},
    Words{"korndurchmesser", size_column},
    Words{"partikelgroesse", size_column},
    Words{"partikeldurchmesser", size_column},
    Words{"durchmesser", size_column},
    Words{"sieb", sieve_column},
    Words{"pruefsieb", sieve_column},
    Words{"analysensieb", sieve_column},
    Words{"masse", retained_column},
    Words{"gewicht", retained_column},
    Words{"rueckstand", retained_column},
    Words{"siebrueckstand", retained_column},
    Words{"einzelrueckstand", retained_column},
    Words{"teilrueckstand", retained_column},
    Words{"rueckstand masse", retained_column},
    Words{"masse rueckstand", retained_column},
    Words{"rueckstandssumme", cumulative_column},
    Words{"summenrueckstand", cumulative_column},
    Words{"rueckstand kumuliert", cumulative_column},
    Words{"kumulierter rueckstand", cumulative_column},
    Words{"siebrueckstand kumuliert", cumulative_column},
    Words{"summe rueckstand", cumulative_column},
    Words{"summe der rueckstaende", cumulative_column},
    Words{"durchgang", passing_column},
    Words{"siebdurchgang", passing_column},
    Words{"durchgangssumme", passing_column},
    Words{"summendurchgang", passing_column},
    Words{"durchgang kumuliert", passing_column},
    Words{"kumulierter durchgang", passing_column},
};
constexpr std::array french = {
    Words{"ouverture", size_column},
    Words{"ouverture de maille", size_column},
    Words{"ouverture des mailles", size_column},
    Words{"ouverture du tamis", size_column},
    Words{"maille", size_column},
    Words{"diametre", size_column},
    Words{"diametre des grains", size_column},
    Words{"tamis", sieve_column},
    Words{"masse retenue", retained_column},
    Words{"refus partiel", retained_column},
    Words{"refus partiels", retained_column},
    Words{"refus cumule", cumulative_column},
    Words{"refus cumules", cumulative_column},
    Words{"passant", passing_column},
    Words{"passants", passing_column},
    Words{"passant cumule", passing_column},
    Words{"passants cumules", passing_column},
    Words{"tamisat", passing_column},
    Words{"tamisats", passing_column},
    Words{"tamisat cumule", passing_column},
    Words{"tamisats cumules", passing_column},
};
constexpr std::array spanish = {
    Words{"abertura", size_column},
    Words{"abertura de malla", size_column},
    Words{"abertura del tamiz", size_column},
    Words{"diametro", size_column},
    Words{"tamiz", sieve_column},
    Words{"masa retenida", retained_column},
    Words{"peso retenido", retained_column},
    Words{"retenido parcial", retained_column},
    Words{"retenido acumulado", cumulative_column},
    Words{"pasa", passing_column},
    Words{"que pasa", passing_column},
    Words{"pasante", passing_column},
    Words{"pasante acumulado", passing_column},
};
constexpr std::array italian = {
    Words{"apertura", size_column},
    Words{"apertura maglia", size_column},
    Words{"apertura delle maglie", size_column},
    Words{"setaccio", sieve_column},
    Words{"crivello", sieve_column},
    Words{"massa trattenuta", retained_column},
    Words{"peso trattenuto", retained_column},
    Words{"trattenuto parziale", retained_column},
    Words{"trattenuto cumulato", cumulative_column},
    Words{"trattenuto cumulativo", cumulative_column},
    Words{"passante", passing_column},
    Words{"passante cumulato", passing_column},
    Words{"passante cumulativo", passing_column},
};

// Rows at the foot of a table, in the same languages.
constexpr std::array<std::string_view, 9> pan_words = {
    "pan", "schale", "bodenschale", "auffangschale", "siebboden", "boden", "fond", "fondo", "in pan"};
constexpr std::array<std::string_view, 12> total_words = {"total",        "totals", "sum",    "total mass",
                                                          "total weight", "summe",  "gesamt", "gesamtmasse",
                                                          "somme",        "suma",   "totale", "somma"};

struct UnitWords {
  std::string_view words;
  ColumnUnit unit;
};
constexpr std::array units = {
    UnitWords{"mm", ColumnUnit::mm},           UnitWords{"millimeter", ColumnUnit::mm},
    UnitWords{"millimeters", ColumnUnit::mm},  UnitWords{"millimetre", ColumnUnit::mm},
    UnitWords{"um", ColumnUnit::um},           UnitWords{"micron", ColumnUnit::um},
    UnitWords{"microns", ColumnUnit::um},      UnitWords{"micrometer", ColumnUnit::um},
    UnitWords{"micrometre", ColumnUnit::um},   UnitWords{"m", ColumnUnit::m},
    UnitWords{"in", ColumnUnit::inch},         UnitWords{"inch", ColumnUnit::inch},
    UnitWords{"inches", ColumnUnit::inch},     UnitWords{"phi", ColumnUnit::phi},
    UnitWords{"percent", ColumnUnit::percent}, UnitWords{"prozent", ColumnUnit::percent},
    UnitWords{"pct", ColumnUnit::percent},     UnitWords{"fraction", ColumnUnit::fraction},
    UnitWords{"g", ColumnUnit::mass},          UnitWords{"gr", ColumnUnit::mass},
    UnitWords{"gram", ColumnUnit::mass},       UnitWords{"grams", ColumnUnit::mass},
    UnitWords{"gramm", ColumnUnit::mass},      UnitWords{"kg", ColumnUnit::mass},
};

/// Letters beyond ASCII, each with its spelling: two characters of UTF-8 that begin with the same byte, but
/// for the Greek ones.
struct Letter {
  std::string_view letter, spelling;
};
constexpr std::array letters = {
    Letter{"ä", "ae"},     Letter{"Ä", "ae"},       Letter{"ö", "oe"},       Letter{"Ö", "oe"},
    Letter{"ü", "ue"},     Letter{"Ü", "ue"},       Letter{"ß", "ss"},       Letter{"é", "e"},
    Letter{"É", "e"},      Letter{"è", "e"},        Letter{"È", "e"},        Letter{"ê", "e"},
    Letter{"à", "a"},      Letter{"á", "a"},        Letter{"Á", "a"},        Letter{"í", "i"},
    Letter{"ì", "i"},      Letter{"ó", "o"},        Letter{"ò", "o"},        Letter{"ú", "u"},
    Letter{"ù", "u"},      Letter{"ñ", "n"},        Letter{"ç", "c"},        Letter{"\u00B5", "u"},
    Letter{"\u03BC", "u"}, Letter{"\u03C6", "phi"}, Letter{"\u03A6", "phi"},
};

/// Moves the first character of `rest` to `plain`; `%` becomes a word, what is no letter or digit a space.
void take_character(std::string_view &rest, std::string &plain) {
  for (const Letter &l : letters)
    if (rest.starts_with(l.letter)) {
      plain += l.spelling;
      rest.remove_prefix(l.letter.size());
      return;
    }
  const char c = lower(rest.front());
  if (c == '%')
    plain += " percent ";
  else
    plain += (c >= 'a' && c <= 'z') || is_digit(c) || static_cast<unsigned char>(c) >= 0x80 ? c : ' ';
  rest.remove_prefix(1);
}

std::vector<std::string> words_of(std::string_view text) {
  std::string plain;
  while (!text.empty())
    take_character(text, plain);
  std::vector<std::string> words;
  for (std::size_t from = 0; (from = plain.find_first_not_of(' ', from)) < plain.size();) {
    const std::size_t to = std::min(plain.find(' ', from), plain.size());
    words.push_back(plain.substr(from, to - from));
    from = to;
  }
  return words;
}

std::string joined(const std::vector<std::string> &words) {
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Words of which the percent are, beside the percent: `M.-%`, `wt%`, `percent by mass`.
bool is_share_word(std::string_view word) {
  return is_one_of(word,
                   {"m", "ma", "wt", "w", "gew", "vol", "v", "mass", "masse", "weight", "volume", "by"});
}

ColumnUnit unit_of(const std::vector<std::string> &words) {
  if (words.size() > 1 && std::count(words.begin(), words.end(), "percent") == 1 &&
      std::all_of(words.begin(), words.end(),
                  [](const std::string &w) { return w == "percent" || is_share_word(w); }))
    return ColumnUnit::percent;
  if (words.size() != 1)
    return ColumnUnit::none;
  const auto found =
      std::find_if(units.begin(), units.end(), [&words](const UnitWords &u) { return u.words == words[0]; });
  return found == units.end() ? ColumnUnit::none : found->unit;
}

std::optional<ColumnMeaning> meaning_of(const std::string &words) {
  const auto find = [&words](const auto &language) -> std::optional<ColumnMeaning> {
    const auto found =
        std::find_if(language.begin(), language.end(), [&words](const Words &w) { return w.words == words; });
    return found == language.end() ? std::nullopt : std::optional(found->meaning);
  };
  std::optional<ColumnMeaning> meaning = find(english);
  for (const auto &other : {find(german), find(french), find(spanish), find(italian)})
    if (!meaning)
      meaning = other;
  return meaning;
}

/// The header without what stands in the last brackets, if that is a unit.
ColumnUnit take_bracketed_unit(std::string &header) {
  constexpr std::array<std::string_view, 3> brackets = {"()", "[]", "{}"};
  for (const std::string_view pair : brackets) {
    const std::size_t open = header.rfind(pair[0]);
    const std::size_t close = open == std::string::npos ? open : header.find(pair[1], open);
    if (close == std::string::npos)
      continue;
    const ColumnUnit unit = unit_of_words(std::string_view(header).substr(open + 1, close - open - 1));
    if (unit == ColumnUnit::none)
      continue;
    header.erase(open, close + 1 - open);
    return unit;
  }
  return ColumnUnit::none;
}

/// Takes `by mass` and the like from the end of what is more than that.
void drop_share(std::vector<std::string> &words) {
  while (words.size() > 2 && words[words.size() - 2] == "by" && is_share_word(words.back()))
    words.resize(words.size() - 2);
}

/// Takes the unit at the end or beginning of words without brackets: `siebweite in mm`, `wt percent passing`.
ColumnUnit take_unit(std::vector<std::string> &words) {
  ColumnUnit unit = ColumnUnit::none;
  drop_share(words);
  if (words.size() > 2 && words[1] == "percent" && is_share_word(words[0]))
    words.erase(words.begin());
  if (words.size() > 1 && words.front() == "percent") {
    words.erase(words.begin());
    return ColumnUnit::percent;
  }
  if (words.size() > 1 && words.back() != "in")
    unit = unit_of({words.back()});
  if (unit == ColumnUnit::none)
    return unit;
  words.pop_back();
  while (unit == ColumnUnit::percent && words.size() > 1 && is_share_word(words.back()) &&
         meaning_of(joined(words)) == std::nullopt)
    words.pop_back();
  if (words.size() > 1 && words.back() == "in")
    words.pop_back();
  return unit;
}

} // namespace

bool is_of_sizes(ColumnUnit unit) {
  return unit == ColumnUnit::mm || unit == ColumnUnit::um || unit == ColumnUnit::m ||
         unit == ColumnUnit::inch || unit == ColumnUnit::phi;
}

std::string plain_words(std::string_view text) {
  return joined(words_of(text));
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

std::optional<HeaderMeaning> header_meaning(std::string_view header) {
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
  const std::optional<ColumnMeaning> meaning = meaning_of(joined(words));
  if (!meaning)
    return std::nullopt;
  const bool holds_sizes = *meaning == ColumnMeaning::size || *meaning == ColumnMeaning::sieve;
  if (unit != ColumnUnit::none && is_of_sizes(unit) != holds_sizes)
    return std::nullopt;
  return HeaderMeaning{*meaning, unit};
}

bool is_pan_word(std::string_view cell) {
  return std::find(pan_words.begin(), pan_words.end(), plain_words(cell)) != pan_words.end();
}

bool is_total_word(std::string_view cell) {
  return std::find(total_words.begin(), total_words.end(), plain_words(cell)) != total_words.end();
}

} // namespace mdm

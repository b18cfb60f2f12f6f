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

constexpr auto size = ColumnMeaning::size;
constexpr auto sieve = ColumnMeaning::sieve;
constexpr auto retained = ColumnMeaning::retained;
constexpr auto cumulative = ColumnMeaning::cumulative;
constexpr auto passing = ColumnMeaning::passing;

// Only names that mean one thing. `Refus` in French, for example, is what a sieve retains or all coarser ones
// too.
constexpr std::array english = {
    Words{"size", size},
    Words{"sieve size", size},
    Words{"sieve opening", size},
    Words{"sieve aperture", size},
    Words{"sieve opening size", size},
    Words{"test sieve size", size},
    Words{"opening", size},
    Words{"opening size", size},
    Words{"aperture", size},
    Words{"aperture size", size},
    Words{"mesh size", size},
    Words{"mesh opening", size},
    Words{"particle size", size},
    Words{"particle diameter", size},
    Words{"equivalent diameter", size},
    Words{"equivalent particle diameter", size},
    Words{"grain size", size},
    Words{"grain diameter", size},
    Words{"diameter", size},
    Words{"channel diameter lower", size},
    Words{"sieve", sieve},
    Words{"sieve no", sieve},
    Words{"sieve number", sieve},
    Words{"sieve name", sieve},
    Words{"sieve designation", sieve},
    Words{"us sieve", sieve},
    Words{"us sieve no", sieve},
    Words{"us standard sieve", sieve},
    Words{"us standard sieve no", sieve},
    Words{"test sieve", sieve},
    Words{"mass", retained},
    Words{"weight", retained},
    Words{"retained", retained},
    Words{"mass retained", retained},
    Words{"weight retained", retained},
    Words{"retained mass", retained},
    Words{"retained weight", retained},
    Words{"mass of soil retained", retained},
    Words{"weight of soil retained", retained},
    Words{"mass retained on sieve", retained},
    Words{"weight retained on sieve", retained},
    Words{"retained on sieve", retained},
    Words{"individual retained", retained},
    Words{"individual mass retained", retained},
    Words{"individual weight retained", retained},
    Words{"volume in", retained},
    Words{"differential volume", retained},
    Words{"diff volume", retained},
    Words{"p3", retained},
    Words{"cumulative retained", cumulative},
    Words{"cum retained", cumulative},
    Words{"cumulative mass retained", cumulative},
    Words{"cumulative weight retained", cumulative},
    Words{"cumulative oversize", cumulative},
    Words{"oversize", cumulative},
    Words{"passing", passing},
    Words{"mass passing", passing},
    Words{"weight passing", passing},
    Words{"cumulative passing", passing},
    Words{"cum passing", passing},
    Words{"cumulative mass passing", passing},
    Words{"total passing", passing},
    Words{"finer", passing},
    Words{"finer than", passing},
    Words{"cumulative finer", passing},
    Words{"mass finer", passing},
    Words{"undersize", passing},
    Words{"cumulative undersize", passing},
    Words{"volume under", passing},
    Words{"q3", passing},
};
constexpr std::array german = {
    Words{"siebweite", size},
    Words{"maschenweite", size},
    Words{"siebmaschenweite", size},
    Words{"siebgroesse", size},
    Words{"sieboeffnung", size},
    Words{"oeffnungsweite", size},
    Words{"nennoeffnungsweite", size},
    Words{"lochweite", size},
    Words{"korngroesse", size},
    Words{"korndurchmesser", size},
    Words{"partikelgroesse", size},
    Words{"partikeldurchmesser", size},
    Words{"durchmesser", size},
    Words{"sieb", sieve},
    Words{"pruefsieb", sieve},
    Words{"analysensieb", sieve},
    Words{"masse", retained},
    Words{"gewicht", retained},
    Words{"rueckstand", retained},
    Words{"siebrueckstand", retained},
    Words{"einzelrueckstand", retained},
    Words{"teilrueckstand", retained},
    Words{"rueckstand masse", retained},
    Words{"masse rueckstand", retained},
    Words{"rueckstandssumme", cumulative},
    Words{"summenrueckstand", cumulative},
    Words{"rueckstand kumuliert", cumulative},
    Words{"kumulierter rueckstand", cumulative},
    Words{"siebrueckstand kumuliert", cumulative},
    Words{"summe rueckstand", cumulative},
    Words{"summe der rueckstaende", cumulative},
    Words{"durchgang", passing},
    Words{"siebdurchgang", passing},
    Words{"durchgangssumme", passing},
    Words{"summendurchgang", passing},
    Words{"durchgang kumuliert", passing},
    Words{"kumulierter durchgang", passing},
};
constexpr std::array french = {
    Words{"ouverture", size},
    Words{"ouverture de maille", size},
    Words{"ouverture des mailles", size},
    Words{"ouverture du tamis", size},
    Words{"maille", size},
    Words{"diametre", size},
    Words{"diametre des grains", size},
    Words{"tamis", sieve},
    Words{"masse retenue", retained},
    Words{"refus partiel", retained},
    Words{"refus partiels", retained},
    Words{"refus cumule", cumulative},
    Words{"refus cumules", cumulative},
    Words{"passant", passing},
    Words{"passants", passing},
    Words{"passant cumule", passing},
    Words{"passants cumules", passing},
    Words{"tamisat", passing},
    Words{"tamisats", passing},
    Words{"tamisat cumule", passing},
    Words{"tamisats cumules", passing},
};
constexpr std::array spanish = {
    Words{"abertura", size},
    Words{"abertura de malla", size},
    Words{"abertura del tamiz", size},
    Words{"diametro", size},
    Words{"tamiz", sieve},
    Words{"masa retenida", retained},
    Words{"peso retenido", retained},
    Words{"retenido parcial", retained},
    Words{"retenido acumulado", cumulative},
    Words{"pasa", passing},
    Words{"que pasa", passing},
    Words{"pasante", passing},
    Words{"pasante acumulado", passing},
};
constexpr std::array italian = {
    Words{"apertura", size},
    Words{"apertura maglia", size},
    Words{"apertura delle maglie", size},
    Words{"setaccio", sieve},
    Words{"crivello", sieve},
    Words{"massa trattenuta", retained},
    Words{"peso trattenuto", retained},
    Words{"trattenuto parziale", retained},
    Words{"trattenuto cumulato", cumulative},
    Words{"trattenuto cumulativo", cumulative},
    Words{"passante", passing},
    Words{"passante cumulato", passing},
    Words{"passante cumulativo", passing},
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

std::string plain_words(std::string_view text) {
  return joined(words_of(text));
}

ColumnUnit unit_of_words(std::string_view words) {
  return unit_of(words_of(words));
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
  const bool is_length = unit == ColumnUnit::mm || unit == ColumnUnit::um || unit == ColumnUnit::m ||
                         unit == ColumnUnit::inch || unit == ColumnUnit::phi;
  const bool holds_sizes = *meaning == ColumnMeaning::size || *meaning == ColumnMeaning::sieve;
  if (unit != ColumnUnit::none && is_length != holds_sizes)
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

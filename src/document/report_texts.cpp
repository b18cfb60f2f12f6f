#include "document/report_texts.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mdm {
namespace {

constexpr ReportTexts english_report = {
    .code = "en",
    .title = "Grain size report",
    .client = "Client",
    .curves = "Grading curves",
    .analysis = "Sieve analysis",
    .specification = "Specification",
    .description = "Description",
    .notes = "Notes",
    .footer = "Worked out exactly by mdm {}. Numbers are rounded to {} digits on this page alone.",
    .sieve = "sieve, mm",
    .pan = "pan",
    .mass_retained = "mass retained",
    .retained = "retained, %",
    .passing = "passing, %",
    .percent_passing = "percent passing",
    .least = "least, %",
    .most = "most, %",
    .interpolated = "interpolated, linear in percent over log size, where the sample has no sieve",
    .indices = "index numbers and groups",
    .fractions = "percent of the mass",
    .not_available = "not available",
    .holds = "pass",
    .fails = "fail",
    .hangs = "hangs",
    .undecided = "undecided"};

constexpr ReportTexts german_report = {
    .code = "de",
    .title = "Bericht zur Korngrößenverteilung",
    .client = "Auftraggeber",
    .curves = "Körnungslinien",
    .analysis = "Siebanalyse",
    .specification = "Anforderung",
    .description = "Beschreibung",
    .notes = "Hinweise",
    .footer = "Exakt berechnet von mdm {}. Nur auf dieser Seite sind Zahlen gerundet, auf {} Stellen.",
    .sieve = "Sieb, mm",
    .pan = "Schale",
    .mass_retained = "Rückstand, Masse",
    .retained = "Rückstand, %",
    .passing = "Durchgang, %",
    .percent_passing = "Durchgang in Prozent",
    .least = "mindestens, %",
    .most = "höchstens, %",
    .interpolated =
        "interpoliert, linear in Prozent über dem Logarithmus der Größe, wo die Probe kein Sieb hat",
    .indices = "Kennzahlen und Bodengruppen",
    .fractions = "Prozent der Masse",
    .not_available = "nicht bestimmbar",
    .holds = "erfüllt",
    .fails = "nicht erfüllt",
    .hangs = "hängt an der Rundung",
    .undecided = "unentschieden"};

using Word = std::pair<std::string_view, std::string_view>;

/// Of a symbol of ISO 14688; the nouns are masculine, and so are the adjectives.
constexpr std::array<Word, 8> german_words = {{{"gr", "kiesiger"},
                                               {"sa", "sandiger"},
                                               {"si", "schluffiger"},
                                               {"cl", "toniger"},
                                               {"Gr", "Kies"},
                                               {"Sa", "Sand"},
                                               {"Si", "Schluff"},
                                               {"Cl", "Ton"}}};

} // namespace

std::string_view ReportTexts::verdict(Compliance verdict) const {
  switch (verdict) {
  case Compliance::holds:
    return holds;
  case Compliance::fails:
    return fails;
  case Compliance::hangs:
    return hangs;
  case Compliance::undecided:
    break;
  }
  return undecided;
}

const ReportTexts &report_texts(Language language) {
  return language == Language::german ? german_report : english_report;
}

std::string local_number(std::string number, Language language) {
  if (language == Language::english)
    return number;
  std::replace(number.begin(), number.end(), '.', ',');
  const std::string to = " to ";
  if (const std::size_t at = number.find(to); at != std::string::npos)
    number.replace(at, to.size(), " bis ");
  return number;
}

std::string local_soil_name(const std::string &symbol, const std::string &words, Language language) {
  if (language == Language::english)
    return words;
  std::string name;
  for (std::size_t i = 0; i < symbol.size(); i += 2) {
    const std::string_view part = std::string_view(symbol).substr(i, 2);
    const auto *const found = std::find_if(german_words.begin(), german_words.end(),
                                           [&](const Word &w) { return w.first == part; });
    name += (name.empty() ? "" : " ");
    name += found == german_words.end() ? "Boden" : found->second; // of the symbol S
  }
  return name;
}

} // namespace mdm

#pragma once
/// \file
/// A laboratory report's own words in each language.

#include "text/language.hpp"

#include <mdm/judge/specification.hpp>

#include <string>
#include <string_view>

namespace mdm {

/// Names, and groups of ASTM and AASHTO, are not a report's own: they are in English. Notes are in
/// text/german.hpp.
struct ReportTexts {
  std::string_view code; ///< of the language in HTML
  std::string_view title, client, curves, analysis, specification, description, notes, footer;
  std::string_view sieve, pan, mass_retained, retained, passing, percent_passing, least, most, interpolated;
  std::string_view indices, fractions, not_available;
  std::string_view holds, fails, hangs, undecided;

  std::string_view verdict(Compliance verdict) const;
};

const ReportTexts &report_texts(Language language);

/// A number, or a range of two with ` to ` between them, as the language writes it: 1,6 bis 20,8.
std::string local_number(std::string number, Language language);

/// The name of ISO 14688-2 in words: that in English, or of its symbol in German (sandiger Kies).
std::string local_soil_name(const std::string &symbol, const std::string &words, Language language);

} // namespace mdm

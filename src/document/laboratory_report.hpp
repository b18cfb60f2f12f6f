#pragma once
/// \file
/// The report that a laboratory gives to its client: sieve analyses with their curves, index numbers, groups,
/// and verdicts on a specification.

#include "report/conformity_report.hpp"
#include "soil/describe.hpp"
#include "text/language.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// A sample with what is said of it.
struct ReportedSample {
  UnderstoodGradation sheet;
  SoilDescription description;
};

/// What a report says.
struct LaboratoryReport {
  std::string title;
  std::vector<std::pair<std::string, std::string>> fields; ///< of its head, name and value, in their order
  std::vector<ReportedSample> samples;                     ///< at least one
  std::optional<ConformityReport> conformity;              ///< of the same samples; nothing: no specification
  Language language = Language::english;                   ///< of the page's own words and numbers
};

/// A page of HTML in one file, which needs nothing else and prints on A4 and letter: head, curves, the table
/// of each sieve analysis, verdicts, index numbers, and every note.
std::string report_html(const LaboratoryReport &report);

/// One line of JSON, schema `mdm-report-1`, without a newline at its end: title, fields [{name, value}],
/// descriptions as `mdm-describe-1`, judgement as `mdm-judge-1` or null. `digits` >= 1 are significant
/// digits.
std::string report_json(const LaboratoryReport &report, unsigned digits);

} // namespace mdm

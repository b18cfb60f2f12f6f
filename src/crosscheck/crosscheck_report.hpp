#pragma once
/// \file
/// Rows and summary of a cross-check as text, CSV and JSON.

#include "text/json_writer.hpp"

#include <mdm/crosscheck/crosscheck.hpp>

namespace mdm {

/// The columns that rows have beside id,verdict,particles,minimum,ratio,max_error.
struct CrosscheckColumns {
  std::string setting; ///< name of the column of settings, or empty: none
  bool reasons = false;
};

/// The header of rows as CSV, with a newline. In rows ratio and max_error (in percentage points) are cut to 6
/// significant digits.
std::string crosscheck_csv_header(const CrosscheckColumns &columns);
/// The row of an answer, with a newline.
std::string crosscheck_csv(const CrosscheckRow &row, const CrosscheckColumns &columns);

/// What was asked, as the JSON says it before its rows.
struct CrosscheckAsked {
  std::string suite;
  std::optional<std::string> answers, solver, by;
  std::optional<std::string> question; ///< nothing for the exact one
  Rational size_tolerance;
};

class CrosscheckSummary;

/// The object of a cross-check up to the array of its rows.
void begin_crosscheck(JsonWriter &json, const CrosscheckAsked &asked);
/// A row as an object; `setting` only where answers have settings.
void write_row(JsonWriter &json, const CrosscheckRow &row, bool has_setting);
/// The object from the end of its rows on.
void end_crosscheck(JsonWriter &json, const CrosscheckSummary &summary, bool has_setting,
                    const std::vector<std::string> &notes);

/// The report as text: what was asked, the summary, notes. \param suite  its name as it is shown
std::string crosscheck_text(const std::string &suite, const std::optional<std::string> &question,
                            std::uint64_t gradations, const CrosscheckSummary &summary,
                            const CrosscheckColumns &columns, const std::vector<std::string> &notes);

/// The order statistics of n ratios at the places 0, n/4, n/2, 3n/4 (rounded down, from 0) and n - 1 of
/// their ascending order: each is the ratio of an answer.
using Quartiles = std::array<Rational, 5>;
/// The quartiles; nothing if there is no ratio.
std::optional<Quartiles> quartiles(std::vector<Rational> ratios);

/// Counts rows by setting and verdict. Memory: a ratio a match.
class CrosscheckSummary {
public:
  /// The counts of one setting.
  struct Setting {
    std::string name;
    std::array<std::uint64_t, answer_verdict_count> counts{};
    std::vector<Rational> ratios; ///< of matches
    std::uint64_t count(AnswerVerdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
    std::uint64_t rows() const;
  };

  void add(const CrosscheckRow &row);
  /// In the order in which they came.
  const std::vector<Setting> &settings() const { return settings_; }
  /// Rows of all settings with the verdict.
  std::uint64_t count(AnswerVerdict verdict) const;

  /// A table with a line a setting, and the first rows that are no match with their reasons.
  std::string text(const CrosscheckColumns &columns) const;
  /// An array with an object a setting.
  void write(JsonWriter &json, bool has_setting) const;

private:
  std::vector<Setting> settings_;
  std::vector<CrosscheckRow> first_bad_;
};

} // namespace mdm

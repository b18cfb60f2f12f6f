#pragma once
/// \file
/// Blends of other solvers, judged.

#include <mdm/blend/blend.hpp>
#include <mdm/crosscheck/answer_verdict.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A solver's answer to one problem of blending, not judged yet.
struct OtherBlend {
  std::string id;                       ///< of the problem; empty if it could not be read
  std::optional<AnswerVerdict> failure; ///< why there are no shares, if there are none
  std::string reason;
  std::vector<Rational> shares;             ///< from 0 to 1, of each stockpile
  std::vector<std::string> stockpiles = {}; ///< their names, if it states them
};

/// A blend from its JSON: {"id": "a", "shares": ["0.61", "0.11", ...]}, {"id": "a", "percents": [61, 11,
/// ...]}, the first blend of an mdm-blend-1, or a "status" of infeasible, none or gave up; "stockpiles" may
/// name them. Numbers are decimals or fractions p/q. What cannot be read is garbage: nothing is thrown.
OtherBlend json_blend(std::string_view text);

/// A row of a cross-check.
struct BlendRow {
  std::string id;
  /// minimal: the best; larger: within the limits, and not the best; not_a_match: no blend of the problem;
  /// infeasible: there is a blend, or, of an answer that says so rightly, minimal.
  AnswerVerdict verdict = AnswerVerdict::no_answer;
  std::optional<Rational> value, best; ///< of the aim
  std::string reason;
};

/// `best`, `worse`, `not-a-blend`, else the name of the verdict.
std::string_view name_of_blend(AnswerVerdict verdict);

/// Judges a blend exactly, by what solve_blend found.
/// \pre found is the answer to the problem
BlendRow judge_blend(const std::string &id, const BlendProblem &problem, const BlendAnswer &found,
                     const OtherBlend &answer);

/// Counts of verdicts, and the rows that are not the best, with their reasons.
class BlendSummary {
public:
  void add(const BlendRow &row);
  std::uint64_t count(AnswerVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t rows() const;
  std::string text() const;

private:
  std::array<std::uint64_t, answer_verdict_count> counts_{};
  std::vector<BlendRow> first_others_;
};

/// id,verdict,value,best,reason, with a newline; fractions are cut to 12 significant digits.
std::string blend_rows_header();
std::string blend_row_csv(const BlendRow &row);
/// One line, schema `mdm-crosscheck-blends-1`, without a newline at its end.
std::string blend_rows_json(const std::string &suite, const std::vector<BlendRow> &rows,
                            const BlendSummary &summary, const std::vector<std::string> &notes);

} // namespace mdm

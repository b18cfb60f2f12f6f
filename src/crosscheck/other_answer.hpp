#pragma once
/// \file
/// Answers of other solvers, as read.

#include <mdm/crosscheck/answer_verdict.hpp>
#include <mdm/number/rational.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mdm {

/// A size as an answer states it: lo <= x <= hi; a decimal has lo = hi.
struct StatedSize {
  Rational lo, hi;
};

/// A solver's answer to one gradation, not judged yet.
struct OtherAnswer {
  std::string id;                            ///< of the gradation
  bool has_id = false;                       ///< it could be read
  std::map<std::string, std::string> labels; ///< other columns or keys with a text or a number, by name
  /// Why there are no particles, if there are none, and the details; else nothing.
  std::optional<AnswerVerdict> failure;
  std::string reason;

  std::vector<Integer> quantities; ///< >= 0, one a class with mass or one a class
  /// Empty, or one for each quantity; nothing where the answer has none (an empty class).
  std::vector<std::optional<StatedSize>> sizes;
  /// Openings of the classes, in decimals; empty, or one for each quantity.
  std::vector<std::optional<std::pair<Rational, Rational>>> classes;
  Rational unit_mm = 1;      ///< the unit of the sizes in mm
  std::string contradiction; ///< what it says of its number of particles, where its quantities are others
};

/// An answer that is none, with its id where that is not empty.
OtherAnswer failed_answer(std::string id, AnswerVerdict failure, std::string reason);

/// An answer from its JSON: an mdm-answer-1 (what has "classes" is read as one), or {"id", "quantities":
/// [...], "sizes": [...], "unit": "mm"}, of which only quantities is needed. Numbers are JSON numbers or
/// strings and read from their text; a size is one number, [lo, hi] or null; unit is mm, um, m or in. Without
/// quantities, "status" and "reason" may name one of the failures, and any other status, or an "error", is no
/// answer. What cannot be read is garbage: nothing is thrown.
OtherAnswer json_answer(std::string_view text);

/// An answer as one line of JSON that json_answer reads, without a newline. `more` are further keys with
/// texts, written first.
std::string answer_line(const OtherAnswer &answer,
                        const std::vector<std::pair<std::string, std::string>> &more);

/// Reads a file of answers: CSV with a header, or JSON Lines (if it begins with `{`). The columns of CSV are
/// `id`, `quantities` (whole numbers separated by spaces), optionally one of `sizes_mm`, `sizes_um`,
/// `sizes_m`, `sizes_in` (decimals separated by spaces), and any others as labels. A line that cannot be read
/// is an answer that is garbage. A table of mdm batch is read too. Blank lines and, in CSV, those that begin
/// with # are skipped; one with a digit behind the # is garbage.
/// \throws InputError `file:line: ...` if the header is broken
std::vector<OtherAnswer> read_answers(std::string_view content, const std::string &file);

} // namespace mdm

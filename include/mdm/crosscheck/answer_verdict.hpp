#pragma once
/// \file
/// The verdict on an answer of another solver.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace mdm {

/// The kinds of verdicts.
enum class AnswerVerdict {
  minimal,     ///< a match with the least number of particles
  larger,      ///< a match with more particles than are needed
  not_a_match, ///< no particles of these quantities (and sizes) match the gradation
  undecided,   ///< a match; a limit came before the least number was known
  no_answer,   ///< nothing was answered
  garbage,     ///< the answer cannot be read
  crashed,     ///< the solver ended with a signal or an exit code other than 0
  timeout,     ///< the solver did not end in time
  infeasible,  ///< the answer is that there is no match, and there is one
  gave_up      ///< the solver says that it found nothing
};

/// The number of verdicts.
inline constexpr std::size_t answer_verdict_count = 10;

/// All of them, in the order of reports.
inline constexpr std::array<AnswerVerdict, answer_verdict_count> answer_verdicts = {
    AnswerVerdict::minimal,    AnswerVerdict::larger,  AnswerVerdict::not_a_match, AnswerVerdict::undecided,
    AnswerVerdict::no_answer,  AnswerVerdict::garbage, AnswerVerdict::crashed,     AnswerVerdict::timeout,
    AnswerVerdict::infeasible, AnswerVerdict::gave_up};

/// As reports write it, for example `not-a-match`.
std::string_view name(AnswerVerdict verdict);

/// The verdict of that name.
std::optional<AnswerVerdict> answer_verdict_named(std::string_view text);

} // namespace mdm

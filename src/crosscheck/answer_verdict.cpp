#include <mdm/crosscheck/answer_verdict.hpp>

#include <algorithm>

namespace mdm {

std::string_view name(AnswerVerdict verdict) {
  static constexpr std::array<std::string_view, answer_verdict_count> names = {
      "minimal", "larger",  "not-a-match", "undecided",  "no-answer",
      "garbage", "crashed", "timeout",     "infeasible", "gave-up"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::optional<AnswerVerdict> answer_verdict_named(std::string_view text) {
  const auto found = std::find_if(answer_verdicts.begin(), answer_verdicts.end(),
                                  [text](AnswerVerdict v) { return name(v) == text; });
  return found == answer_verdicts.end() ? std::nullopt : std::optional(*found);
}

} // namespace mdm

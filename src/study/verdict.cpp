#include <mdm/study/verdict.hpp>

#include <algorithm>

namespace mdm {

std::string_view name(Verdict verdict) {
  static constexpr std::array<std::string_view, verdict_count> names = {
      "minimal", "larger",  "not-a-match", "undecided",  "no-answer",
      "garbage", "crashed", "timeout",     "bad-problem"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::optional<Verdict> verdict_named(std::string_view text) {
  const auto found =
      std::find_if(verdicts.begin(), verdicts.end(), [text](Verdict v) { return name(v) == text; });
  return found == verdicts.end() ? std::nullopt : std::optional(*found);
}

} // namespace mdm

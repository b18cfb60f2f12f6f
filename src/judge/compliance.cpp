#include "judge/compliance.hpp"

#include <algorithm>
#include <array>

namespace mdm {

std::string_view name(Compliance verdict) {
  static constexpr std::array<std::string_view, 4> names = {"pass", "fail", "hangs", "undecided"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::string_view headline(Compliance verdict) {
  static constexpr std::array<std::string_view, 4> headlines = {
      "PASS", "FAIL", "HANGS on what the report does not tell",
      "UNDECIDED: a limit of precision was reached"};
  return headlines.at(static_cast<std::size_t>(verdict));
}

Compliance worst(const std::vector<Compliance> &verdicts) {
  for (const Compliance bad : {Compliance::undecided, Compliance::fails, Compliance::hangs})
    if (std::find(verdicts.begin(), verdicts.end(), bad) != verdicts.end())
      return bad;
  return Compliance::holds;
}

} // namespace mdm

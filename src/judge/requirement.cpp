#include "judge/requirement.hpp"

#include "text/option_name.hpp"

#include <fmt/format.h>

namespace mdm {

Compliance verdict_of(const std::vector<Requirement> &requirements) {
  std::vector<Compliance> verdicts;
  for (const Requirement &r : requirements) {
    if (r.verdict == Compliance::fails)
      return Compliance::fails;
    verdicts.push_back(r.verdict);
  }
  return worst(verdicts);
}

Compliance RuleReport::verdict() const {
  std::vector<Compliance> verdicts;
  for (const RuleJudgement &s : samples)
    verdicts.push_back(s.verdict);
  return worst(verdicts);
}

std::string rounding_note(bool is_exact) {
  const std::string rounding = option("rounding");
  return is_exact
             ? fmt::format("The report is taken as exact; {} 0.1 judges every curve that rounds to it.",
                           rounding)
             : fmt::format(
                   "Each percent stands for all numbers that round to it, within half a unit of its last "
                   "digit; 100 at the largest sieve is exact. {} none takes the report as exact.",
                   rounding);
}

} // namespace mdm

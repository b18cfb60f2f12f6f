#include "report/conformity_report.hpp"

#include <mdm/ask/judge.hpp>

namespace mdm {

JudgedGradation judge_gradation(const UnderstoodGradation &report, const Specification &specification,
                                const std::optional<Rational> &rounding) {
  constexpr unsigned digits = 15, digits_of_text = 6;
  const ConformityReport all{specification, {judge(report, specification, rounding)}};
  const Conformity &c = all.samples.front();
  JudgedGradation judged{
      c.id, c.verdict, {}, c.notes, conformity_json(all, digits), conformity_text(all, digits_of_text)};
  for (const SieveVerdict &s : c.sieves)
    judged.sieves.push_back({s.limits, s.passing ? std::optional(enclose(*s.passing, digits)) : std::nullopt,
                             enclose(s.least, digits), enclose(s.most, digits), s.verdict});
  return judged;
}

} // namespace mdm

// Whether counts, and sizes where they are stated, are a match for a question with a tolerance or other
// demands (Theorem 12). With counts alone an exact linear program asks whether there are masses for them;
// its contradiction is the reason of a refusal, put into words. With sizes each class's mass lies in an
// interval, of the sizes as stated, which is one more condition. A volume of solids is irrational through
// pi: the weight is tried at an upper and a lower bound of it, and what lies between is undecided.

#include "crosscheck/counts_judge.hpp"

#include "gradation/shown.hpp"
#include "match/fixed_counts.hpp"
#include "number/counted.hpp"
#include "number/pi.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// Digits of pi that a volume is decided with.
constexpr unsigned pi_places = 200;

/// Without a tolerance the shares are those of the gradation.
Tolerance asked_tolerance(const Gradation &g, const Question &question) {
  std::vector<AskedTolerance> asked = question.tolerances;
  if (!question.is_tolerant())
    asked.push_back(parse_tolerance("retained:0%"));
  return tolerance_of(g, asked, question.band, question.size_factor);
}

std::string percent(const Rational &share) {
  return shown(Rational(share * 100)) + " %";
}

} // namespace

CountsJudge::CountsJudge(Gradation g, const Question &question)
    : g_(std::move(g)), question_(question), tolerance_(asked_tolerance(g_, question_)) {
  static_cast<void>(problem(0)); // which refuses what is irrational
}

TolerantProblem CountsJudge::problem(const Rational &weight) const {
  TolerantDemands demands{question_.min_per_class, question_.at_least, std::nullopt};
  if (question_.solids)
    demands.weight = weight;
  return TolerantProblem(g_, question_.law, tolerance_, demands);
}

CountsJudge::Finding CountsJudge::find(const std::vector<Integer> &q,
                                       const std::vector<std::optional<StatedSize>> &sizes,
                                       const Rational &size_tolerance) const {
  const Interval weight = question_.solids ? start_scale(*question_.solids, 1, pi_places) : Interval(0, 0);
  std::string wrong = mismatch(problem(weight.lo), q, sizes, size_tolerance);
  if (!wrong.empty() || weight.is_point())
    return {std::move(wrong), false};
  wrong = mismatch(problem(weight.hi), q, sizes, size_tolerance);
  if (wrong.empty())
    return {};
  return {"the solids volume is so near to what is asked for that 200 digits of pi do not decide", true};
}

std::string CountsJudge::mismatch(const TolerantProblem &problem, const std::vector<Integer> &q,
                                  const std::vector<std::optional<StatedSize>> &sizes,
                                  const Rational &size_tolerance) const {
  std::vector<std::optional<MassBounds>> stated(q.size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (q[j] < problem.least(j))
      return fmt::format("class {} has {}, and at least {} are asked for", j + 1, counted(q[j]),
                         to_string(problem.least(j)));
    if (!sizes[j] || q[j] == 0)
      continue;
    const StatedSize wide{sizes[j]->lo * (1 - size_tolerance), sizes[j]->hi * (1 + size_tolerance)};
    if (wide.hi <= g_.lower(j) || wide.lo > g_.upper(j))
      return fmt::format("the size {} is outside its class {}",
                         shown(wide.hi <= g_.lower(j) ? sizes[j]->hi : sizes[j]->lo), j + 1);
    const Rational unit = problem.unit() * g_.factor(j);
    stated[j] = MassBounds{question_.law.powered(wide.lo) * unit, question_.law.powered(wide.hi) * unit};
  }
  const std::optional<CountConflict> conflict = conflict_of_counts(problem, q, stated);
  if (!conflict)
    return {};
  std::string text;
  for (const Multiple &condition : conflict->conditions)
    text += (text.empty() ? "" : ", ") + in_words(condition, problem, q);
  std::string classes;
  for (const std::size_t j : conflict->stated)
    classes += (classes.empty() ? "" : ", ") + std::to_string(j + 1);
  if (!classes.empty())
    text +=
        (text.empty() ? "" : ", ") + fmt::format("the {} stated of {} {}",
                                                 conflict->stated.size() == 1 ? "size is as" : "sizes are as",
                                                 conflict->stated.size() == 1 ? "class" : "classes", classes);
  return "not all of this can hold: " + text;
}

std::string CountsJudge::in_words(const Multiple &condition, const TolerantProblem &problem,
                                  const std::vector<Integer> &q) const {
  const std::size_t j = condition.j;
  const Tolerance &t = problem.tolerance();
  const std::string of_class = fmt::format("class {}", j + 1);
  switch (condition.condition) {
  case TolerantCondition::above_lower:
    return fmt::format("{} of {} {} {}", counted(q[j]), of_class,
                       q[j] == 1 ? "is larger than" : "are larger than", shown(g_.lower(j)));
  case TolerantCondition::up_to_upper:
    return fmt::format("{} of {} {} {}", counted(q[j]), of_class, q[j] == 1 ? "is at most" : "are at most",
                       shown(g_.upper(j)));
  case TolerantCondition::retained_lo:
    return fmt::format("{} holds at least {}", of_class, percent(t.retained[j].lo));
  case TolerantCondition::retained_hi:
    return fmt::format("{} holds at most {}", of_class, percent(t.retained[j].hi));
  case TolerantCondition::passing_lo:
    return fmt::format("at least {} pass {}", percent(t.passing[j].lo), shown(g_.upper(j)));
  case TolerantCondition::passing_hi:
    return fmt::format("at most {} pass {}", percent(t.passing[j].hi), shown(g_.upper(j)));
  case TolerantCondition::excess:
  case TolerantCondition::excess_sign:
    return fmt::format("{} counts with what it holds above its share", of_class);
  case TolerantCondition::excess_total:
    return fmt::format("all shares together are off by at most {}", percent(*t.total));
  case TolerantCondition::weight:
    return "the solids have the volume that is asked for";
  case TolerantCondition::at_least:
    return fmt::format("there are at least {}", counted(problem.at_least()));
  default:
    return "there are particles";
  }
}

} // namespace mdm

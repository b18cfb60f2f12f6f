#include "match/tradeoff.hpp"

#include "match/problem.hpp"
#include "match/tolerant_match.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

Limits limits_of_row(const TradeoffOptions &options) {
  Limits limits = options.limits;
  limits.keep_proof = false;
  if (options.time_limit)
    limits.deadline = std::chrono::steady_clock::now() + *options.time_limit;
  return limits;
}

/// The smallest sieves that can be kept; a sieve that retains nothing keeps what the next larger one does.
std::vector<TradeoffRow> exact_rows(const Gradation &g, const Question &question,
                                    const TradeoffOptions &options) {
  const Rational all = sum(g.masses());
  std::vector<TradeoffRow> rows;
  Rational lost = 0;
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0)
      continue;
    const Problem problem(g.from_class(j), question.law, question.min_per_class);
    const LeastMatch found = least_match(problem, limits_of_row(options));
    const Integer bound = total(found.q);
    rows.push_back(
        {0, g.opening(j), Rational(lost / all), found.complete ? bound : total(some_match(problem)), bound});
    lost += g.mass(j);
  }
  return rows;
}

TradeoffRow tolerant_row(const Gradation &g, const Question &question, const AskedTolerance &asked,
                         const TradeoffOptions &options, const TradeoffRow &exact) {
  TradeoffRow row = exact;
  row.tolerance = asked.percent;
  if (asked.percent == 0)
    return row;
  const TolerantProblem problem(g, question.law, tolerance_of(g, {asked}, std::nullopt, 1),
                                {question.min_per_class, 1, std::nullopt});
  const TolerantResult found = tolerant_match(problem, limits_of_row(options));
  row.lower_bound = found.lower_bound;
  if (found.best)
    row.particles = std::min(row.particles, total(found.best->q));
  return row;
}

/// The result of a row is an upper bound for the next ones and a lower bound for those before.
void share_bounds(std::vector<TradeoffRow> &rows) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    rows[i].particles = std::min(rows[i].particles, rows[i - 1].particles);
  for (std::size_t i = rows.size(); i-- > 1;)
    rows[i - 1].lower_bound = std::max(rows[i - 1].lower_bound, rows[i].lower_bound);
}

} // namespace

Tradeoff tradeoff(Gradation g, const Question &question, const TradeoffOptions &options) {
  Tradeoff result{question, asked_gradation(std::move(g), question), options.kind, {}, {}};
  result.by_sieve = exact_rows(result.gradation, question, options);
  share_bounds(result.by_sieve);
  std::vector<Rational> tolerances = options.tolerances;
  std::sort(tolerances.begin(), tolerances.end());
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  for (const Rational &percent : tolerances)
    result.by_tolerance.push_back(
        tolerant_row(result.gradation, question, {options.kind, percent}, options, result.exact()));
  share_bounds(result.by_tolerance);
  return result;
}

} // namespace mdm

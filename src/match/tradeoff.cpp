#include "match/tradeoff.hpp"

#include "match/problem.hpp"
#include "match/tolerant_match.hpp"
#include "match/watch.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// The limits of each row and the one watch of all.
class TradeoffRows {
public:
  explicit TradeoffRows(const TradeoffOptions &options)
      : limits_(options.limits), time_limit_(options.time_limit), watch_(std::nullopt, options.progress) {
    limits_.keep_proof = false;
  }

  const Limits &limits() const { return limits_; }
  /// Of a row that begins now.
  Watch watch() const {
    return time_limit_ ? watch_.until(std::chrono::steady_clock::now() + *time_limit_) : watch_;
  }

private:
  Limits limits_;
  std::optional<std::chrono::milliseconds> time_limit_;
  Watch watch_;
};

/// The smallest sieves that can be kept; a sieve that retains nothing keeps what the next larger one does.
std::vector<TradeoffRow> exact_rows(const Gradation &g, const Question &question, const TradeoffRows &of) {
  const Rational all = sum(g.masses());
  std::vector<TradeoffRow> rows;
  Rational lost = 0;
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0)
      continue;
    const Problem problem(g.from_class(j), question.law, question.min_per_class);
    const LeastMatch found = least_match(problem, of.limits(), of.watch());
    const Integer bound = total(found.q);
    rows.push_back(
        {0, g.opening(j), Rational(lost / all), found.complete ? bound : total(some_match(problem)), bound});
    lost += g.mass(j);
  }
  return rows;
}

TradeoffRow tolerant_row(const Gradation &g, const Question &question, const AskedTolerance &asked,
                         const TradeoffRows &of, const TradeoffRow &exact) {
  TradeoffRow row = exact;
  row.tolerance = asked.percent;
  if (asked.percent == 0)
    return row;
  const TolerantProblem problem(g, question.law, tolerance_of(g, {asked}, std::nullopt, 1),
                                {question.min_per_class, 1, std::nullopt});
  const TolerantResult found = tolerant_match(problem, of.limits(), std::nullopt, of.watch());
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
  const TradeoffRows of(options);
  result.by_sieve = exact_rows(result.gradation, question, of);
  share_bounds(result.by_sieve);
  std::vector<Rational> tolerances = options.tolerances;
  std::sort(tolerances.begin(), tolerances.end());
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  for (const Rational &percent : tolerances)
    result.by_tolerance.push_back(
        tolerant_row(result.gradation, question, {options.kind, percent}, of, result.exact()));
  share_bounds(result.by_tolerance);
  return result;
}

} // namespace mdm

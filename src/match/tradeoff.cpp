// N against the tolerance, against the smallest sieve that is kept, and against a size factor. Each row is a
// match of its own with its own bounds, and rows help each other: what matches within a tolerance matches
// within a wider one, so that an upper bound is one for all rows behind it and a lower bound one for all
// before. A number of particles that is given as a budget adds the row of the least tolerance that it
// suffices for (budget.cpp). Without its finest classes an exact match is still one of what is kept, which
// gives the other curve the same order.

#include "match/budget.hpp"
#include "number/common_denominator.hpp"

#include <mdm/match/tradeoff.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// Solves one row after the other, each within the limits; a caller who ends one ends all.
class TradeoffRows {
public:
  explicit TradeoffRows(const TradeoffOptions &options) : options_(options) {}

  /// The row with what is certain of the smallest match of its gradation.
  TradeoffRow solved(TradeoffRow row, Gradation g, const Question &question) {
    const Match m = solve(std::move(g), question, solve_options());
    set_match(row, m);
    row.has_none = m.status == Status::none;
    return row;
  }

  /// Adds a row at the least tolerance or factor with which the budget suffices, where one is known.
  void add_within(std::vector<TradeoffRow> &rows, const Integer &particles, BudgetBy by, TradeoffRow row,
                  const Gradation &g, const Question &question) {
    const Match m =
        solve_within_budget(g, question, {particles, by, options_.kind, options_.grid}, solve_options())
            .match;
    if (!m.budget->enough || !m.has_answer()) {
      missed_.push_back({particles, by, m.status == Status::none});
      return;
    }
    (by == BudgetBy::tolerance ? row.tolerance : row.size_factor) = *m.budget->enough;
    set_match(row, m);
    row.has_none = false;
    rows.push_back(std::move(row));
  }

  /// The budgets for which there was no row.
  std::vector<Tradeoff::MissedBudget> missed() && { return std::move(missed_); }

private:
  static void set_match(TradeoffRow &row, const Match &m) {
    row.particles = m.has_answer() ? m.particles() : std::nullopt;
    row.lower_bound = m.lower_bound;
    row.coarsest = 0;
    if (m.has_answer())
      for (std::size_t j = 0; j < m.gradation.classes(); ++j)
        if (m.gradation.mass(j) > 0)
          row.coarsest = m.sample->quantities[j];
  }

  SolveOptions solve_options() {
    SolveOptions o;
    o.limits = options_.limits;
    o.limits.keep_proof = false;
    o.at_most = options_.limits.at_most;
    const auto now = std::chrono::steady_clock::now();
    if (stopped_)
      o.limits.deadline = now;
    else if (options_.time_limit)
      o.limits.deadline = now + *options_.time_limit;
    if (options_.progress)
      o.progress = [this](const Progress &known) {
        stopped_ = stopped_ || !options_.progress(known);
        return !stopped_;
      };
    return o;
  }

  const TradeoffOptions &options_;
  bool stopped_ = false;
  std::vector<Tradeoff::MissedBudget> missed_;
};

/// True if something must pass a sieve of the band below which the gradation has no class: without its finest
/// classes there is no match.
bool needs_finer_classes(const Gradation &g, const Question &question) {
  if (!question.band)
    return false;
  const Envelope &band = *question.band;
  const Rational unit = in_mm(band.unit) / in_mm(g.unit());
  for (std::size_t i = 0; i < band.sizes.size(); ++i)
    if (band.passing_min[i] > 0 && power(Rational(band.sizes[i] * unit), g.root()) <= g.powers().front())
      return true;
  return false;
}

/// The smallest sieves that can be kept; a sieve that retains nothing keeps what the next larger one does.
/// \param g without the question's size factor
std::vector<TradeoffRow> sieve_rows(const Gradation &g, const Question &question, const Gradation &shown,
                                    TradeoffRows &of) {
  const Rational all = sum(g.masses());
  std::vector<TradeoffRow> rows;
  Rational lost = 0;
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0)
      continue;
    TradeoffRow row;
    row.smallest = shown.opening(j);
    row.lost = lost / all;
    Gradation kept = g.from_class(j);
    if (lost > 0 && needs_finer_classes(kept, question)) {
      row.lower_bound = 1;
      row.has_none = true;
      rows.push_back(std::move(row));
    } else {
      rows.push_back(of.solved(std::move(row), std::move(kept), question));
    }
    lost += g.mass(j);
  }
  return rows;
}

TradeoffRow tolerance_row(const Gradation &g, Question question, const AskedTolerance &asked,
                          TradeoffRows &of, const TradeoffRow &whole) {
  TradeoffRow row = whole;
  row.tolerance = asked.percent;
  if (asked.percent == 0 && !question.is_tolerant())
    return row;
  if (asked.percent == 0 && !question.band)
    question.tolerances.clear(); // the exact match is within all of them
  else
    question.tolerances.push_back(asked);
  return of.solved(std::move(row), g, question);
}

/// The budgets that are asked for, ascending. \param most  particles of the match without a tolerance
std::vector<Integer> budgets_of(const TradeoffOptions &options, const Integer &most) {
  std::vector<Integer> budgets = options.budgets;
  if (options.all_budgets)
    for (Integer decade = 1; decade < most; decade *= 10)
      for (const unsigned step : {1U, 2U, 5U})
        if (decade * step < most)
          budgets.emplace_back(decade * step);
  std::sort(budgets.begin(), budgets.end());
  return budgets;
}

/// Ascending tolerances or factors, each once.
void sort_rows(std::vector<TradeoffRow> &rows, Rational TradeoffRow::*by) {
  std::stable_sort(rows.begin(), rows.end(),
                   [by](const TradeoffRow &a, const TradeoffRow &b) { return a.*by < b.*by; });
  const auto same = [by](const TradeoffRow &a, const TradeoffRow &b) { return a.*by == b.*by; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
}

/// The result of a row is an upper bound for the next ones and a lower bound for those before.
void share_bounds(std::vector<TradeoffRow> &rows) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (const std::optional<Integer> &before = rows[i - 1].particles;
        before && (!rows[i].particles || *before < *rows[i].particles)) {
      rows[i].particles = before;
      rows[i].coarsest = rows[i - 1].coarsest;
    }
  for (std::size_t i = rows.size(); i-- > 1;)
    if (!rows[i].has_none)
      rows[i - 1].lower_bound = std::max(rows[i - 1].lower_bound, rows[i].lower_bound);
}

/// The least size factors with which the budgets suffice for the specimen; nothing without budgets.
std::vector<TradeoffRow> size_factor_rows(const std::vector<Integer> &budgets, const Gradation &g,
                                          const Question &question, TradeoffRows &of,
                                          const TradeoffRow &whole) {
  std::vector<TradeoffRow> rows;
  for (const Integer &particles : budgets)
    of.add_within(rows, particles, BudgetBy::size_factor, whole, g, question);
  if (!budgets.empty())
    rows.push_back(whole);
  sort_rows(rows, &TradeoffRow::size_factor);
  share_bounds(rows);
  return rows;
}

/// True where what is left of a match without its finest classes answers the question as well.
bool survives_cuts(const Question &q) {
  return q.at_least == 1 && !q.solids && !q.is_tolerant();
}

} // namespace

Tradeoff tradeoff(Gradation g, const Question &question, const TradeoffOptions &options) {
  assert(!question.is_tolerant() || (options.budgets.empty() && !options.all_budgets));
  Tradeoff result{question, asked_gradation(g, question), options.kind, {}, {}, {}};
  Question changes = question; // what is not changed in `base` yet
  changes.pan_size = changes.cut_below = std::nullopt;
  Question done = question;
  done.size_factor = 1;
  const Gradation base = asked_gradation(std::move(g), done);
  TradeoffRows of(options);
  result.by_sieve = sieve_rows(base, changes, result.gradation, of);
  if (survives_cuts(question))
    share_bounds(result.by_sieve);
  for (const Rational &percent : options.tolerances)
    result.by_tolerance.push_back(tolerance_row(base, changes, {options.kind, percent}, of, result.whole()));
  const std::vector<Integer> budgets = budgets_of(options, result.whole().lower_bound);
  for (const Integer &particles : budgets)
    of.add_within(result.by_tolerance, particles, BudgetBy::tolerance, result.whole(), base, changes);
  sort_rows(result.by_tolerance, &TradeoffRow::tolerance);
  share_bounds(result.by_tolerance);
  if (question.solids && question.size_factor == 1)
    result.by_size_factor = size_factor_rows(budgets, base, changes, of, result.whole());
  result.missed = std::move(of).missed();
  result.at_most = options.limits.at_most;
  return result;
}

} // namespace mdm

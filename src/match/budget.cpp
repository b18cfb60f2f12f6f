// The least tolerance or size factor on a grid with which a number of particles suffices (Theorem 21). The
// questions are a row of steps, each of which asks for no more than the one before: what matches within a
// tolerance matches within every greater one, and what fills a specimen fills it magnified. So there is a
// first step that suffices; it is found by halving.
//
// Invariant: with `above` particles suffice, with `below` they do not. Where a limit ends a search, what it
// was asked is open: then two boundaries are found by halving, that of what is known to suffice and that of
// what is known not to, and the answer is a bracket. In the end the two neighbours are solved with their
// proofs.

#include "match/budget.hpp"

#include "match/widest_tolerance.hpp"

#include <functional>
#include <map>

namespace mdm {
namespace {

/// The questions of a budget, none of which asks for more than the one before.
struct BudgetSteps {
  std::function<Rational(const Integer &)> value;        ///< of the step i >= 0
  std::function<void(Question &, const Rational &)> set; ///< puts it into the question
  Integer last = 0;                                      ///< the last step that is looked at
  bool is_weakest = true;                                ///< no step asks for less than the last
};

/// The same limits for a match that has no more particles than the budget: the first one that there is.
SolveOptions within(const Integer &particles, SolveOptions options) {
  options.at_most = particles;
  options.limits.enough = particles;
  if (const auto now = std::chrono::steady_clock::now();
      options.limits.deadline && *options.limits.deadline > now)
    options.limits.deadline = now + (*options.limits.deadline - now) / 4;
  return options;
}

/// Tolerances 0, grid, 2 grid, ... below the widest, and the widest.
BudgetSteps tolerance_steps(const Budget &budget) {
  const Rational widest = widest_tolerance(budget.kind);
  const Integer last = ceil(Rational(widest / budget.grid));
  return {[=, grid = budget.grid](const Integer &i) { return i == last ? widest : Rational(i * grid); },
          [kind = budget.kind](Question &q, const Rational &percent) {
            q.tolerances = {{kind, percent}};
          },
          last};
}

/// An upper bound for the volume of solids that is demanded, in the cube of its unit.
Rational most_demanded(const Solids &solids) {
  const Rational pi = ratio(22, 7);
  if (const auto *c = std::get_if<Cylinder>(&solids))
    return pi / 4 * c->diameter * c->diameter * c->height / (1 + c->void_ratio);
  if (const auto *b = std::get_if<Box>(&solids))
    return b->a * b->b * b->c / (1 + b->void_ratio);
  return std::get<SolidsVolume>(solids).volume;
}

/// Size factors 1, 1 + grid, 1 + 2 grid, ... up to one with which the smallest match that there is without a
/// specimen fills it.
BudgetSteps factor_steps(const Gradation &g, Question question, const Budget &budget,
                         const SolveOptions &options) {
  BudgetSteps steps{[grid = budget.grid](const Integer &i) { return Rational(1 + i * grid); },
                    [](Question &q, const Rational &factor) { q.size_factor = factor; }};
  const Rational demanded = most_demanded(question.solids.value());
  question.solids.reset();
  SolveOptions of_any = within(budget.particles, options);
  of_any.limits.keep_proof = false;
  const Match any = solve(g, question, of_any);
  steps.is_weakest = any.has_answer() || any.status == Status::none;
  const std::optional<Enclosure> volume = any.has_answer() ? any.solids_volume() : std::nullopt;
  if (!volume) // of other particles than spheres a specimen cannot be asked, as the first step will say
    return steps;
  const Rational there_is = volume->lower();
  const auto fills = [&](const Integer &i) { return power(steps.value(i), 3) * there_is >= demanded; };
  if (!fills(Integer(0)))
    for (steps.last = 1; !fills(steps.last);)
      steps.last *= 2;
  return steps;
}

BudgetSteps steps_of(const Gradation &g, const Question &question, const Budget &budget,
                     const SolveOptions &options) {
  return budget.by == BudgetBy::tolerance ? tolerance_steps(budget)
                                          : factor_steps(g, question, budget, options);
}

/// Looks for the first step that suffices, by halves.
class BudgetSearch {
public:
  BudgetSearch(const Gradation &g, const Question &question, const Budget &budget,
               const SolveOptions &options)
      : g_(g), question_(question), budget_(budget), options_(options),
        steps_(steps_of(g, question, budget, options)) {}

  BudgetMatch run() {
    if (suffices(steps_.last) != true)
      return without_step();
    if (suffices(Integer(0)) == true)
      return {with_budget(solved(Integer(0), options_), Integer(0), std::nullopt), std::nullopt};
    // Between what is known to suffice and what is not; what a limit left open is neither.
    const Integer enough = boundary([this](const Integer &i) { return suffices(i) == true; });
    const Integer open = boundary([this](const Integer &i) { return suffices(i) != false; });
    BudgetMatch result{solved(enough, options_), std::nullopt};
    std::optional<Integer> finer;
    if (suffices(Integer(open - 1)) == false)
      finer = Integer(open - 1);
    if (finer)
      result.finer = solved(*finer, within(budget_.particles, options_));
    result.match = with_budget(std::move(result.match), enough, finer);
    if (finer != enough - 1)
      result.match.notes.push_back(std::string("a limit left open which ") +
                                   (budget_.by == BudgetBy::tolerance ? "tolerance" : "size factor") +
                                   " is the least that suffices");
    return result;
  }

private:
  Match solved(const Integer &i, const SolveOptions &options) const {
    Question question = question_;
    steps_.set(question, steps_.value(i));
    return solve(g_, question, options);
  }

  /// Nothing: a limit left it open.
  std::optional<bool> suffices(const Integer &i) {
    const auto [known, is_new] = known_.try_emplace(i);
    if (is_new) {
      SolveOptions options = within(budget_.particles, options_);
      options.limits.keep_proof = false;
      const Match m = solved(i, options);
      if (m.has_answer())
        known->second = true;
      else if (m.status == Status::none)
        known->second = false;
    }
    return known->second;
  }

  /// The first step above 0 for which `holds` by halving, which is true of the last one.
  template <class Holds>
  Integer boundary(const Holds &holds) {
    Integer below = 0, above = steps_.last;
    while (above - below > 1) {
      const Integer middle = (below + above) / 2;
      (holds(middle) ? above : below) = middle;
    }
    return above;
  }

  /// No step is enough, or that is open.
  BudgetMatch without_step() {
    SolveOptions options = options_;
    options.at_most = budget_.particles;
    const bool is_proved = steps_.is_weakest && suffices(steps_.last) == false;
    Match m = solved(steps_.last, options);
    return {with_budget(std::move(m), std::nullopt,
                        is_proved ? std::optional<Integer>(steps_.last) : std::nullopt),
            std::nullopt};
  }

  Match with_budget(Match m, const std::optional<Integer> &enough,
                    const std::optional<Integer> &finer) const {
    MatchBudget budget{budget_.particles, budget_.by, std::nullopt, std::nullopt, false};
    if (enough)
      budget.enough = steps_.value(*enough);
    if (finer)
      budget.next_finer = steps_.value(*finer);
    budget.is_decided = enough ? (*enough == 0 || (finer && *finer + 1 == *enough)) : finer.has_value();
    m.budget = std::move(budget);
    return m;
  }

  const Gradation &g_;
  const Question &question_;
  const Budget &budget_;
  const SolveOptions &options_;
  BudgetSteps steps_;
  std::map<Integer, std::optional<bool>> known_;
};

} // namespace

BudgetMatch solve_within_budget(const Gradation &g, const Question &question, const Budget &budget,
                                const SolveOptions &options) {
  return BudgetSearch(g, question, budget, options).run();
}

} // namespace mdm

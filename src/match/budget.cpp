// The least tolerance or size factor on a grid with which a number of particles suffices (Theorem 21). The
// questions are a row of steps, each of which asks for no more than the one before: what matches within a
// tolerance matches within every greater one, and what fills a specimen fills it magnified. So there is a
// first step that suffices; it is found by halving.
//
// Where a limit ends a search, what it was asked is open: then two boundaries are found by halving, that of
// what is known to suffice and that of what is known not to, and the answer is a bracket. The matches at both
// are kept with their proofs.

#include "match/budget.hpp"

#include "match/watch.hpp"
#include "match/widest_tolerance.hpp"

#include <algorithm>
#include <functional>
#include <map>

namespace mdm {
namespace {

/// The questions of a budget, none of which asks for more than the one before.
struct BudgetSteps {
  std::function<Rational(const Integer &)> value;        ///< of the step i >= 0
  std::function<void(Question &, const Rational &)> set; ///< puts it into the question
  Integer last = 0;                                      ///< the last step that is looked at
};

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

/// Size factors 1, 1 + grid, 1 + 2 grid, ... up to one with which particles of that volume fill a specimen.
BudgetSteps factor_steps(const Budget &budget, const Solids &demanded, const Rational &there_is) {
  BudgetSteps steps{[grid = budget.grid](const Integer &i) { return Rational(1 + i * grid); },
                    [](Question &q, const Rational &factor) { q.size_factor = factor; }};
  const Rational volume = most_demanded(demanded);
  const auto fills = [&](const Integer &i) { return power(steps.value(i), 3) * there_is >= volume; };
  if (!fills(Integer(0)))
    for (steps.last = 1; !fills(steps.last);)
      steps.last *= 2;
  return steps;
}

/// Looks for the first step that suffices, by halves.
class BudgetSearch {
public:
  BudgetSearch(const Gradation &g, const Question &question, const Budget &budget,
               const SolveOptions &options)
      : g_(g), question_(question), budget_(budget), options_(options) {
    if (options.progress)
      options_.progress = [this, call = options.progress](const Progress &known) {
        is_stopped_ = is_stopped_ || !call(known);
        return !is_stopped_;
      };
    watch_ = Watch(options_.limits.deadline, options_.progress).telling([this](Progress &known) {
      known.lower_bound = question_.at_least;
      if (enough_)
        known.particles = enough_->match.particles();
    });
  }
  BudgetSearch(const BudgetSearch &) = delete;
  BudgetSearch &operator=(const BudgetSearch &) = delete;

  BudgetMatch run() {
    if (budget_.by == BudgetBy::tolerance) {
      steps_ = tolerance_steps(budget_);
    } else {
      // Magnified, the smallest match that there is without a specimen fills it.
      Match free = decided(without_solids());
      if (!free.has_answer())
        return without_step(std::move(free));
      steps_ = factor_steps(budget_, question_.solids.value(), free.solids_volume().value().lower());
    }
    Match last = decided(question_at(steps_.last));
    if (!last.has_answer())
      return without_step(std::move(last));
    known_[steps_.last] = true;
    keep(steps_.last, std::move(last));
    if (suffices(Integer(0)) != true) {
      // Between what is known to suffice and what is not; what a limit left open is neither.
      halve([this](const Integer &i) { return suffices(i) == true; });
      halve([this](const Integer &i) { return suffices(i) != false; });
    }
    return bracket();
  }

private:
  /// A match at a step, and which it is.
  struct Step {
    Integer i;
    Match match;
  };

  Question question_at(const Integer &i) const {
    Question question = question_;
    steps_.set(question, steps_.value(i));
    return question;
  }

  /// \throws InputError as for any question with a volume of solids, if this one has other particles
  Question without_solids() const {
    Question question = question_;
    if (question.law.is_sphere())
      question.solids.reset(); // else solve() refuses it
    return question;
  }

  /// The first match that there is with no more particles than the budget.
  Match within_budget(const Question &question, bool in_all_time) const {
    SolveOptions options = options_;
    options.at_most = budget_.particles;
    options.limits.enough = budget_.particles;
    options.limits.gap.reset(); // it says nothing of the budget
    if (const auto now = std::chrono::steady_clock::now();
        !in_all_time && options.limits.deadline && *options.limits.deadline > now)
      options.limits.deadline = now + (*options.limits.deadline - now) / 4;
    return solve(g_, question, options);
  }

  /// The same in all the time that is left, where a part of it leaves open whether there is one: without it
  /// there is nothing to look for.
  Match decided(const Question &question) const {
    Match m = within_budget(question, false);
    return verdict(m) || !options_.limits.deadline || is_over() ? std::move(m)
                                                                : within_budget(question, true);
  }

  /// Whether the budget suffices. Nothing: a limit left it open.
  static std::optional<bool> verdict(const Match &m) {
    return m.has_answer()             ? std::optional(true)
           : m.status == Status::none ? std::optional(false)
                                      : std::nullopt;
  }

  bool is_over() const { return is_stopped_ || watch_.ends(); }

  /// Keeps the match at the first step that is known to suffice, and the proof at the last that does not.
  void keep(const Integer &i, Match m) {
    std::optional<Step> &at = m.has_answer() ? enough_ : finer_;
    if (!at || (m.has_answer() ? i < at->i : i > at->i))
      at.emplace(Step{i, std::move(m)});
  }

  /// The verdict of a step; where the time is over, or the caller said so, no search begins.
  std::optional<bool> suffices(const Integer &i) {
    const auto [known, is_new] = known_.try_emplace(i);
    if (is_new && !is_over()) {
      Match m = within_budget(question_at(i), false);
      known->second = verdict(m);
      if (known->second)
        keep(i, std::move(m));
    }
    return known->second;
  }

  /// Comes to the first step above 0 for which `holds` by halving, which is true of the last one.
  template <class Holds>
  void halve(const Holds &holds) {
    Integer below = 0, above = steps_.last;
    while (above - below > 1) {
      const Integer middle = (below + above) / 2;
      (holds(middle) ? above : below) = middle;
    }
  }

  /// The smallest match at the first step that suffices; where a limit comes before its end, the smaller one
  /// of that search and of the one for the step.
  Match smallest() {
    Match &known = enough_->match;
    if (is_over())
      return std::move(known);
    SolveOptions options = options_;
    options.at_most = std::min(budget_.particles, options.at_most.value_or(budget_.particles));
    Match m = solve(g_, question_at(enough_->i), options);
    if (m.complete || m.status == Status::none || (m.has_answer() && *m.particles() <= *known.particles()))
      return m;
    known.lower_bound = std::max(known.lower_bound, std::min(m.lower_bound, *known.particles()));
    return std::move(known);
  }

  BudgetMatch bracket() {
    BudgetMatch result{smallest(), std::nullopt};
    MatchBudget budget{budget_.particles, budget_.by, steps_.value(enough_->i), std::nullopt,
                       enough_->i == 0 || (finer_ && finer_->i + 1 == enough_->i)};
    if (finer_) {
      budget.next_finer = steps_.value(finer_->i);
      result.finer = std::move(finer_->match);
    }
    if (!budget.is_decided)
      result.match.notes.push_back(std::string("a limit left open which ") +
                                   (budget_.by == BudgetBy::tolerance ? "tolerance" : "size factor") +
                                   " is the least that suffices");
    result.match.budget = std::move(budget);
    return result;
  }

  /// No step is enough, or that is open. \param weakest  it asks for less than any step, or as little
  BudgetMatch without_step(Match weakest) const {
    MatchBudget budget{budget_.particles, budget_.by, std::nullopt, std::nullopt,
                       weakest.status == Status::none};
    if (budget.is_decided)
      budget.next_finer = steps_.value ? steps_.value(steps_.last) : Rational(1);
    weakest.budget = std::move(budget);
    return {std::move(weakest), std::nullopt};
  }

  const Gradation &g_;
  const Question &question_;
  const Budget &budget_;
  SolveOptions options_;
  Watch watch_;
  bool is_stopped_ = false;
  BudgetSteps steps_;
  std::map<Integer, std::optional<bool>> known_;
  std::optional<Step> enough_, finer_;
};

} // namespace

BudgetMatch solve_within_budget(const Gradation &g, const Question &question, const Budget &budget,
                                const SolveOptions &options) {
  return BudgetSearch(g, question, budget, options).run();
}

} // namespace mdm

// The least tolerance on a grid with which a number of particles suffices (Theorem 21). Matches within a
// tolerance are matches within every greater one, so on the grid there is a first value that suffices; it
// is found by halving.
//
// Invariant: with `above` particles suffice, with `below` they do not. Where a limit ends a search, what it
// was asked is open: then two boundaries are found by halving, that of what is known to suffice and that of
// what is known not to, and the answer is a bracket. In the end the two neighbours are solved with their
// proofs.

#include "match/budget.hpp"

#include "match/widest_tolerance.hpp"

#include <map>

namespace mdm {
namespace {

/// Looks for the least tolerance among 0, grid, 2 grid, ... below the widest, and the widest, by halves.
class BudgetSearch {
public:
  BudgetSearch(const Gradation &g, const Question &question, const Budget &budget,
               const SolveOptions &options)
      : g_(g), question_(question), budget_(budget), options_(options),
        widest_(widest_tolerance(budget.kind)), last_(ceil(Rational(widest_ / budget.grid))) {}

  BudgetMatch run() {
    if (suffices(last_) != true)
      return without_tolerance();
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
      result.finer = solved(*finer, within_budget());
    result.match = with_budget(std::move(result.match), enough, finer);
    if (finer != enough - 1)
      result.match.notes.push_back("a limit left open which tolerance is the least that suffices");
    return result;
  }

private:
  Rational percent(const Integer &i) const { return i == last_ ? widest_ : Rational(i * budget_.grid); }

  Match solved(const Integer &i, const SolveOptions &options) const {
    Question question = question_;
    question.tolerances = {{budget_.kind, percent(i)}};
    return solve(g_, question, options);
  }

  /// With no more particles than the budget, the first match that there is.
  SolveOptions within_budget() const {
    SolveOptions options = options_;
    options.at_most = budget_.particles;
    options.limits.enough = budget_.particles;
    if (const auto now = std::chrono::steady_clock::now();
        options.limits.deadline && *options.limits.deadline > now)
      options.limits.deadline = now + (*options.limits.deadline - now) / 4;
    return options;
  }

  /// Nothing: a limit left it open.
  std::optional<bool> suffices(const Integer &i) {
    const auto [known, is_new] = known_.try_emplace(i);
    if (is_new) {
      SolveOptions options = within_budget();
      options.limits.keep_proof = false;
      const Match m = solved(i, options);
      if (m.has_answer())
        known->second = true;
      else if (m.status == Status::none)
        known->second = false;
    }
    return known->second;
  }

  /// The least tolerance above 0 for which `holds` by halving, which is true of the last one.
  template <class Holds>
  Integer boundary(const Holds &holds) {
    Integer below = 0, above = last_;
    while (above - below > 1) {
      const Integer middle = (below + above) / 2;
      (holds(middle) ? above : below) = middle;
    }
    return above;
  }

  /// No tolerance is enough, or that is open.
  BudgetMatch without_tolerance() {
    SolveOptions options = options_;
    options.at_most = budget_.particles;
    const bool is_proved = suffices(last_) == false;
    Match m = solved(last_, options);
    return {with_budget(std::move(m), std::nullopt, is_proved ? std::optional<Integer>(last_) : std::nullopt),
            std::nullopt};
  }

  Match with_budget(Match m, const std::optional<Integer> &enough,
                    const std::optional<Integer> &finer) const {
    MatchBudget budget{budget_.particles, std::nullopt, std::nullopt, false};
    if (enough)
      budget.tolerance = percent(*enough);
    if (finer)
      budget.next_finer = percent(*finer);
    budget.is_decided = enough ? (*enough == 0 || (finer && *finer + 1 == *enough)) : finer.has_value();
    m.budget = std::move(budget);
    return m;
  }

  const Gradation &g_;
  const Question &question_;
  const Budget &budget_;
  const SolveOptions &options_;
  Rational widest_;
  Integer last_; ///< number of the widest tolerance
  std::map<Integer, std::optional<bool>> known_;
};

} // namespace

BudgetMatch solve_within_budget(const Gradation &g, const Question &question, const Budget &budget,
                                const SolveOptions &options) {
  return BudgetSearch(g, question, budget, options).run();
}

} // namespace mdm

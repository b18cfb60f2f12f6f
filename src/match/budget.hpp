#pragma once
/// \file
/// The least tolerance, or the least size factor, that a number of particles suffices for.

#include <mdm/match/solve.hpp>

namespace mdm {

/// A number of particles that is not to be exceeded, and what is to be as small as it allows.
struct Budget {
  Integer particles; ///< >= 1
  BudgetBy by = BudgetBy::tolerance;
  AskedTolerance::Kind kind = AskedTolerance::Kind::retained; ///< of a tolerance: retained, passing or total
  /// Percentage points, or steps of the factor, > 0: tolerances are multiples of it, and the widest; size
  /// factors are 1 and multiples of it more.
  Rational grid = ratio(1, 1000);
};

/// The answer to a budget.
struct BudgetMatch {
  Match match; ///< the smallest at the tolerance or the factor; with its `budget`
  /// At the next finer tolerance, or the next smaller factor, every match has more particles than the budget.
  /// Nothing at the first step, where no step is enough (the match says so), and where a limit left it open.
  std::optional<Match> finer;
};

/// Looks for the first step on the grid with which the budget suffices. The smallest match within a tolerance
/// never has more particles than that within a finer one, and the smallest match of a specimen never more
/// with a greater size factor (Theorem 21). The least real tolerance need not exist. Searches that a limit
/// ends leave a bracket: the finest step that is known to suffice and the coarsest one that is known not to.
/// Cost: some 17 matches at the grid of 0.001; each takes a quarter of the time that is left before the
/// deadline.
/// \param question  by tolerance without tolerances and band; by size factor with solids and the factor 1
/// \throws InputError if the question does not fit g
BudgetMatch solve_within_budget(const Gradation &g, const Question &question, const Budget &budget,
                                const SolveOptions &options = {});

} // namespace mdm

#pragma once
/// \file
/// The least tolerance that a number of particles suffices for.

#include <mdm/match/solve.hpp>

namespace mdm {

/// A number of particles that is not to be exceeded, and the kind of tolerance that is to be as small as it
/// allows.
struct Budget {
  Integer particles;                                          ///< >= 1
  AskedTolerance::Kind kind = AskedTolerance::Kind::retained; ///< retained, passing or total
  Rational grid = ratio(1, 1000); ///< percentage points > 0: tolerances are multiples of it, and the widest
};

/// The answer to a budget.
struct BudgetMatch {
  Match match; ///< the smallest at the tolerance; with its `budget`
  /// At the next finer tolerance every match has more particles than the budget. Nothing at tolerance 0,
  /// where no tolerance is enough (the match says so), and where a limit left it open.
  std::optional<Match> finer;
};

/// Looks for the least tolerance on the grid with which the budget suffices: the smallest match within a
/// tolerance never has more particles than that within a finer one. The least real tolerance need not exist.
/// Searches that a limit ends leave a bracket: the finest tolerance that is known to suffice and the coarsest
/// one that is known not to. Cost: some 17 tolerant matches at the grid of 0.001; each takes a quarter of
/// the time that is left before the deadline.
/// \param question  without tolerances and band
/// \throws InputError if the question does not fit g
BudgetMatch solve_within_budget(const Gradation &g, const Question &question, const Budget &budget,
                                const SolveOptions &options = {});

} // namespace mdm

#pragma once
/// \file
/// The price of fewer particles: N against a tolerance, against the smallest sieve that is kept, and, of a
/// specimen, against a size factor.

#include <mdm/match/question.hpp>
#include <mdm/match/solve.hpp>

#include <chrono>

namespace mdm {

/// A sample that a modeller may choose, and its N.
struct TradeoffRow {
  Rational tolerance = 0;           ///< percentage points; 0: exact
  RootSize smallest;                ///< opening of the smallest sieve kept
  Rational lost = 0;                ///< share of the mass, in the classes below it
  Rational size_factor = 1;         ///< of the question's sizes
  std::optional<Integer> particles; ///< a match has so many; nothing: none is known
  Integer lower_bound;              ///< no match has fewer
  Integer coarsest = 0;             ///< particles of the coarsest class in the match; 0 where it is not known
  bool has_none = false;            ///< it is certain that there is no match

  bool is_optimal() const { return particles && *particles == lower_bound; }
  /// Whatever a search could still find is known.
  bool is_certain() const { return is_optimal() || has_none; }
};

/// The points of a trade-off that are asked for.
struct TradeoffOptions {
  AskedTolerance::Kind kind = AskedTolerance::Kind::retained; ///< retained, passing or total
  std::vector<Rational> tolerances;                           ///< percentage points
  std::vector<Integer> budgets;   ///< numbers of particles >= 1 that add the least tolerance they suffice for
  bool all_budgets = false;       ///< adds 1, 2, 5, 10, ... below the number of the whole gradation's match
  Rational grid = ratio(1, 1000); ///< percentage points > 0, of the tolerances that budgets add
  Limits limits;                  ///< of each row; its deadline is not used
  std::optional<std::chrono::milliseconds> time_limit; ///< of each row
  /// As SolveOptions::progress, of the row that is worked on; false ends all rows as a limit does.
  ProgressCall progress;
};

/// The curves. Along the first, neither `particles` nor `lower_bound` rises: what matches within a tolerance
/// does so within a wider one. Nor do they along the second, unless a number of particles, a volume or shares
/// are asked for: a match without its finest classes matches what is left.
struct Tradeoff {
  Question question;
  Gradation gradation; ///< with the question's pan, cut and size factor
  AskedTolerance::Kind kind;
  std::vector<TradeoffRow> by_tolerance; ///< ascending, each once; nothing left out
  std::vector<TradeoffRow> by_sieve;     ///< ascending, the sieves that retain something
  /// The least factors with which budgets suffice, ascending from 1 on; where a specimen or a volume and
  /// budgets are asked for and the question has no factor, else empty.
  std::vector<TradeoffRow> by_size_factor;

  /// A budget that no row tells of: no tolerance or factor suffices for it, or a limit left that open.
  struct MissedBudget {
    Integer particles;
    BudgetBy by = BudgetBy::tolerance;
    bool is_certain = false; ///< nothing suffices
  };
  std::vector<MissedBudget> missed = {};
  std::optional<Integer> at_most = {}; ///< matches of more particles count as none

  /// The match of the whole gradation as asked, without more tolerance.
  const TradeoffRow &whole() const { return by_sieve.front(); }
};

/// The trade-off of a gradation: every row is the answer to the whole question, the rows of `by_sieve` for
/// what is left of the gradation, those of `by_tolerance` with this tolerance besides the question's. Cost: a
/// match for each row, some 17 for each budget, twice so many of a specimen.
/// \pre with budgets the question has neither tolerances nor a band
/// \throws InputError if the question does not fit g
Tradeoff tradeoff(Gradation g, const Question &question, const TradeoffOptions &options);

} // namespace mdm

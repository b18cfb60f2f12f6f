#pragma once
/// \file
/// The price of fewer particles: N against a tolerance, and against the smallest sieve that is kept.

#include "match/least_match.hpp"

#include <mdm/match/question.hpp>
#include <mdm/match/solve.hpp>

#include <chrono>

namespace mdm {

/// A sample that a modeller may choose, and its N.
struct TradeoffRow {
  Rational tolerance = 0; ///< percentage points; 0: exact
  RootSize smallest;      ///< opening of the smallest sieve kept
  Rational lost = 0;      ///< share of the mass, in the classes below it
  Integer particles;      ///< a match has so many
  Integer lower_bound;    ///< no match has fewer

  bool is_optimal() const { return particles == lower_bound; }
};

/// The points of a trade-off that are asked for.
struct TradeoffOptions {
  AskedTolerance::Kind kind = AskedTolerance::Kind::retained; ///< retained, passing or total
  std::vector<Rational> tolerances;                           ///< percentage points
  Limits limits;                                              ///< of each row, but its deadline
  std::optional<std::chrono::milliseconds> time_limit;        ///< of each row
  /// As SolveOptions::progress, of the row that is worked on; false ends all rows as a limit does.
  ProgressCall progress;
};

/// Both curves. Along each, neither `particles` nor `lower_bound` rises: what matches within a tolerance does
/// so within a wider one, and a match without its finest classes matches what is left.
struct Tradeoff {
  Question question;
  Gradation gradation; ///< with the question's pan, cut and size factor
  AskedTolerance::Kind kind;
  std::vector<TradeoffRow> by_tolerance; ///< ascending, each once; nothing left out
  std::vector<TradeoffRow> by_sieve;     ///< ascending, the sieves that retain something; exact

  /// The exact match of the whole gradation.
  const TradeoffRow &exact() const { return by_sieve.front(); }
};

/// The trade-off of a gradation. Of the question, the law, the changes of the gradation and `min_per_class`
/// count. Cost: a least match for each sieve, a tolerant match for each tolerance.
/// \throws InputError if the question does not fit g
Tradeoff tradeoff(Gradation g, const Question &question, const TradeoffOptions &options);

} // namespace mdm

#pragma once
/// \file
/// The smallest match within a tolerance, with its sizes.

#include "match/sizes.hpp"
#include "match/tolerant_match.hpp"

#include <mdm/match/question.hpp>
#include <mdm/number/enclosure.hpp>

namespace mdm {

/// The answer to a question with a tolerance.
struct TolerantAnswer {
  Tolerance tolerance;
  TolerantProblem problem;
  TolerantResult found;                        ///< its best has central masses
  std::vector<std::optional<Enclosure>> sizes; ///< of each class's particles; nothing for an empty class
  std::vector<Rational> shares;                ///< t_j / M; empty where there is no match
  Rational mass;                               ///< M of the match, in units of c x^(a/b)
  std::optional<Enclosure> pi;                 ///< bounds that a demanded volume was decided with
};

/// Answers a question about g, whose pan, cut and size factor are made.
/// \param q, s  an exact match with its scale, which may be within the tolerance
/// \throws InputError if the question does not fit g
TolerantAnswer tolerant_answer(const Gradation &g, const Question &question, const std::vector<Integer> &q,
                               const Rational &s, const Limits &limits, unsigned digits, const Watch &watch);

} // namespace mdm

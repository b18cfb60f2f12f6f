#pragma once
/// \file
/// From a gradation and a question to the smallest match.

#include <mdm/match/at_least.hpp>
#include <mdm/match/scale.hpp>
#include <mdm/match/sizes.hpp>
#include <mdm/match/tolerant_answer.hpp>

#include <string>

namespace mdm {

/// How to solve and what to show; nothing here changes what is proved.
struct SolveOptions {
  Limits limits;
  std::optional<Integer> at_most; ///< more particles than this are no match
  ScaleChoice scale = ScaleChoice::automatic;
  unsigned digits = 15; ///< significant digits of sizes
};

enum class Status {
  optimal,  ///< the match is the smallest
  feasible, ///< a limit came first: the match is one, the smallest has at least `lower_bound` particles
  none,   ///< every match has more than `at_most` particles, at least `lower_bound`; or there is none at all
  unknown ///< a limit came first: the match has more than `at_most` particles, a smaller one was not excluded
};

/// The smallest set of particles that matches a gradation, or what is known of it.
struct Match {
  Match(Question asked, Gradation g, Problem p)
      : question(std::move(asked)), gradation(std::move(g)), problem(std::move(p)) {}

  Question question;
  Gradation gradation; ///< with the question's pan, cut and size factor
  Problem problem;     ///< with all floors
  Status status = Status::unknown;
  Integer lower_bound; ///< no match that the question allows has fewer particles

  /// A match, one entry for each class of the problem; the smallest if `complete`.
  std::vector<Integer> q;
  bool complete = false;
  Window window;
  Rational scale;               ///< chosen, to the power b
  std::vector<Enclosure> sizes; ///< of each class's particles at that scale
  Rational margin;              ///< least distance of a size to its sieves, relative

  /// Instead of q, window, scale, sizes and margin where the question has a tolerance.
  std::optional<TolerantAnswer> tolerant;

  /// The evidence of minimality, if `complete`: see certificate.hpp.
  Chain chain;
  Rational above;              ///< z of a question with at_least; 0: nothing
  std::optional<Enclosure> pi; ///< bounds that the start scale was decided with

  unsigned digits = 15; ///< significant digits that were asked for
  std::vector<std::string> notes;

  Integer particles() const { return tolerant ? total(tolerant->found.best->q) : total(q); }
  /// True if the match answers the question: it is within `at_most`.
  bool has_answer() const { return status == Status::optimal || status == Status::feasible; }
  /// Volume of the particles at the chosen scale, (pi/6) s sum m_j / c_j (for a tolerance (pi/6) sum t_j /
  /// c_j); for spheres only.
  Enclosure solids_volume() const;
};

/// Solves. Cost: the least match, one root a class, and nothing that depends on the size of N but its digits.
/// \throws InputError if the question does not fit the gradation
Match solve(Gradation g, const Question &question = {}, const SolveOptions &options = {});

} // namespace mdm

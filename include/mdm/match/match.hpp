#pragma once
/// \file
/// The answer: the smallest match, or what is known of it.

#include <mdm/gradation/root_size.hpp>
#include <mdm/match/evidence.hpp>
#include <mdm/match/question.hpp>
#include <mdm/number/enclosure.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The knowledge of the smallest match that a search ends with.
enum class Status {
  optimal,  ///< the match is the smallest
  feasible, ///< a limit came first: the match is one, the smallest has at least `lower_bound` particles
  none,   ///< every match has more than `at_most` particles, at least `lower_bound`; or there is none at all
  unknown ///< a limit came first: the match has more than `at_most` particles, a smaller one was not excluded
};

/// A class of the gradation with what a match has in it.
struct MatchClass {
  RootSize lower, upper; ///< of the sizes (lower, upper]
  Rational mass;         ///< of the gradation, in its unit
  Rational share;        ///< of the whole mass of the match; without a tolerance that of the gradation
  Integer quantity;      ///< of particles; 0 in an empty class
  std::optional<Enclosure> size; ///< of each of them; nothing in an empty class
};

/// All scales (to the scale power) that make given quantities a match: above < S <= up_to, and S >= s_0 where
/// a volume of solids is asked for; s_0 is below `up_to` or equal to it.
struct Window {
  Rational above;
  Rational up_to;
  std::optional<Interval> start;

  /// True if the scale of the asked volume is itself in the window: that volume can be had exactly. An
  /// irrational s_0 lies strictly between its bounds.
  bool start_is_feasible() const {
    return start && (start->is_point() ? start->lo > above : start->lo >= above);
  }
};

/// The scale of an exact match: the class masses of the sample over those of the gradation, in units of c
/// x^(a/b), to the scale power.
struct MatchScale {
  Window window;   ///< of the quantities
  Rational chosen; ///< in the window
  Rational margin; ///< least distance of a size to its sieves, relative
};

/// A sample that matches. Vectors have an entry for each class of the gradation.
struct MatchSample {
  std::vector<Integer> quantities;
  std::vector<std::optional<Enclosure>> sizes; ///< of a class's particles; nothing for an empty class
  /// The shares of the classes in the sample's mass, where a tolerance lets them differ from those of the
  /// gradation.
  std::optional<std::vector<Rational>> shares;
  Rational mass;                   ///< of all particles together, in units of c x^(a/b), to the scale power
  std::optional<MatchScale> scale; ///< nothing within a tolerance: there is no single one
};

/// The parts of a proof.
struct MatchProof {
  std::optional<Evidence> evidence;
  /// What the evidence of a search shows that a limit ended: no match has fewer particles. Nothing if the
  /// search came to its end, or there is nothing to show.
  std::optional<Integer> bound;
  std::optional<Enclosure> pi; ///< bounds that a demanded volume was decided with, if it needed any
};

/// What a budget of particles buys: the least tolerance or the least size factor with which it suffices.
enum class BudgetBy { tolerance, size_factor };

/// The tolerance in percentage points, or the size factor, of a match that a budget of particles chose
/// (match/budget.hpp).
struct MatchBudget {
  Integer particles; ///< the budget
  BudgetBy by = BudgetBy::tolerance;
  std::optional<Rational> enough;     ///< with which it suffices; nothing if there is none
  std::optional<Rational> next_finer; ///< with which it does not; nothing at the tolerance 0 or the factor 1
  bool is_decided = false;            ///< there is no step between the two
};

/// The smallest set of particles that matches a gradation, or what is known of it. Exact matches and those
/// within a tolerance have the same form.
struct Match {
  Match(Question asked, Gradation g) : question(std::move(asked)), gradation(std::move(g)) {}

  Question question;
  Gradation gradation; ///< with the question's pan, cut and size factor
  Status status = Status::unknown;
  bool complete = false; ///< the search came to its end: the sample is the smallest match, or there is none
  Integer lower_bound;   ///< no match that the question allows has fewer particles
  std::optional<MatchSample> sample;  ///< a match: it answers the question if has_answer()
  std::optional<Tolerance> tolerance; ///< the bounds on shares that the question comes to; nothing: exact
  std::optional<MatchBudget> budget;  ///< where a budget chose the tolerance
  MatchProof proof;
  unsigned digits = 15; ///< significant digits that were asked for
  std::vector<std::string> notes;

  /// True if the sample answers the question: it is within `at_most`.
  bool has_answer() const { return status == Status::optimal || status == Status::feasible; }
  /// Particles of the sample; nothing where no match is known.
  std::optional<Integer> particles() const;
  /// Every class of the gradation, ascending, with what the sample has in it; none where no match is known.
  /// Cost: made at each call, some fractions a class.
  std::vector<MatchClass> classes() const;
  /// Nothing if the evidence was not to be kept or is longer than a certificate can be, or there is nothing
  /// to show.
  const std::optional<Evidence> &evidence() const { return proof.evidence; }
  /// The power that scales and the sample's mass are given to, as they may be irrational themselves: b of the
  /// law times the root of the gradation.
  unsigned scale_power() const { return question.law.b * gradation.root(); }
  /// Volume of the particles, (pi/6) sum t_j / c_j over their masses t_j; of spheres, and where a match is
  /// known.
  std::optional<Enclosure> solids_volume() const;
};

} // namespace mdm

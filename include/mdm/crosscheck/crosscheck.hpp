#pragma once
/// \file
/// Answers of other solvers, judged.

#include <mdm/crosscheck/answer_verdict.hpp>
#include <mdm/match/solve.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mdm {

struct OtherAnswer;

/// The judgement of one answer to one gradation.
struct CrosscheckRow {
  std::string id;
  std::string setting; ///< the label that groups answers, or empty
  AnswerVerdict verdict = AnswerVerdict::no_answer;
  std::optional<Integer> particles; ///< N of the answer
  std::optional<Integer> minimum;   ///< the least N of any match
  std::optional<Rational> ratio;    ///< particles / minimum, of a match
  /// The largest |share of a class in the sample - share in the gradation|, of the sizes as stated (the upper
  /// one of two bounds), none moved to another class. Nothing where sizes are not stated.
  std::optional<Rational> max_error;
  std::string reason; ///< why it is no match, or cannot be judged
};

/// What is known of the least number of particles of a match.
struct KnownMinimum {
  Integer lower_bound;              ///< no match has fewer
  std::optional<Integer> particles; ///< a match has so many; nothing: none is known
  bool has_none = false;            ///< there is no match
};

/// A gradation with the least match for a question, to judge answers by.
class Crosscheck {
public:
  /// Of exact matches of spheres.
  /// \param limits of the search for the least match \param progress as SolveOptions::progress
  /// \throws InputError if numbers get out of hand
  explicit Crosscheck(Gradation g, const Limits &limits = {}, const ProgressCall &progress = {});
  /// Of any question.
  /// \throws InputError likewise, or if the law is irrational at an opening
  Crosscheck(Gradation g, const Question &question, const Limits &limits, const ProgressCall &progress = {});
  /// Of any question about whose least match so much is known: nothing is searched for.
  /// \throws InputError likewise
  static Crosscheck with_minimum(Gradation g, const Question &question, KnownMinimum known);

  /// With the pan, the cut and the size factor of the question made.
  const Gradation &gradation() const;

  /// Judges. A match is a vector of quantities for which one scale s gives every class its mass, and
  /// whose stated sizes x are right at one such scale: the size y = (s m / (q c))^(1/3) that a class needs
  /// then lies within x (1 - size_tolerance) <= y <= x (1 + size_tolerance), where x is stated by bounds,
  /// from the lower to the upper one. Decided exactly: for spheres each of these is an interval of s.
  /// \pre 0 <= size_tolerance < 1
  CrosscheckRow judge(const OtherAnswer &answer, const Rational &size_tolerance) const;
  /// The same of a line of JSON as `mdm crosscheck` takes it from a solver: {"quantities": ["15", "2"],
  /// "sizes": ["0.07", "0.14"], "unit": "mm"}, of which `quantities` is needed, or an mdm-answer-1. What
  /// cannot be read is garbage: nothing is thrown.
  CrosscheckRow judge(std::string_view answer, const Rational &size_tolerance = ratio(1, 1000000000)) const;

private:
  class State;
  explicit Crosscheck(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

} // namespace mdm

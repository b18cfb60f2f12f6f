#pragma once
/// \file
/// Answers of other solvers, judged.

#include "crosscheck/counts_judge.hpp"
#include "crosscheck/other_answer.hpp"
#include "match/least_match.hpp"

#include <mdm/match/solve.hpp>

#include <memory>

namespace mdm {

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

/// A gradation with the least match for a question, to judge answers by.
class Crosscheck {
public:
  /// Of exact matches of spheres.
  /// \param limits of the search for the least match
  /// \throws InputError if numbers get out of hand
  explicit Crosscheck(Gradation g, Limits limits = {});
  /// Of any question.
  /// \throws InputError likewise, or if the law is irrational at an opening
  Crosscheck(Gradation g, const Question &question, const Limits &limits);

  /// With the pan, the cut and the size factor of the question made.
  const Gradation &gradation() const { return g_; }

  /// Judges. A match is a vector of quantities for which one scale s gives every class its mass, and
  /// whose stated sizes x are right at one such scale: the size y = (s m / (q c))^(1/3) that a class needs
  /// then lies within x (1 - size_tolerance) <= y <= x (1 + size_tolerance), where x is stated by bounds,
  /// from the lower to the upper one. Decided exactly: for spheres each of these is an interval of s.
  /// \pre 0 <= size_tolerance < 1
  CrosscheckRow judge(const OtherAnswer &answer, const Rational &size_tolerance) const;

private:
  struct Particles;
  /// A question that is not the plain one, with what is known of its least match.
  struct Asked {
    CountsJudge judge;
    Match known;
  };
  CrosscheckRow judge_asked(const OtherAnswer &answer, const Rational &size_tolerance) const;
  std::string spread_over_classes(const OtherAnswer &answer, std::vector<Integer> &q,
                                  std::vector<std::optional<StatedSize>> &sizes) const;
  void compare_with_known(CrosscheckRow &row) const;
  std::string in_words(std::size_t j) const;
  std::string in_words(const Particles &particles, std::size_t i) const;
  std::string take(const OtherAnswer &answer, Particles &particles) const;
  Rational scale_at(const Particles &particles, std::size_t i, const Rational &size) const;
  std::string mismatch(const OtherAnswer &answer, const Rational &size_tolerance) const;
  std::string mismatch_of_sizes(const Particles &particles, const Rational &size_tolerance) const;
  std::optional<Rational> max_error(const OtherAnswer &answer) const;

  Gradation g_;
  std::vector<std::size_t> with_mass_; ///< classes with mass
  LeastMatch least_;
  std::shared_ptr<const Asked> asked_; ///< null: the plain question
};

} // namespace mdm

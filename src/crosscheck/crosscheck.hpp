#pragma once
/// \file
/// Answers of other solvers, judged.

#include "crosscheck/other_answer.hpp"
#include "match/least_match.hpp"

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

/// A gradation of spheres with its least match, to judge answers by.
class Crosscheck {
public:
  /// \param limits of the search for the least match
  /// \throws InputError if numbers get out of hand
  explicit Crosscheck(Gradation g, Limits limits = {});

  const Gradation &gradation() const { return g_; }

  /// Judges. A match is a vector of quantities for which one scale s gives every class its mass, and
  /// whose stated sizes x are right at one such scale: the size y = (s m / (q c))^(1/3) that a class needs
  /// then lies within x (1 - size_tolerance) <= y <= x (1 + size_tolerance), where x is stated by bounds,
  /// from the lower to the upper one. Decided exactly: for spheres each of these is an interval of s.
  /// \pre 0 <= size_tolerance < 1
  CrosscheckRow judge(const OtherAnswer &answer, const Rational &size_tolerance) const;

private:
  struct Particles;
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
};

} // namespace mdm

#pragma once
/// \file
/// The particles of an answer to a question with a tolerance or other demands, judged.

#include "crosscheck/other_answer.hpp"
#include "match/tolerant_problem.hpp"

#include <mdm/match/question.hpp>

#include <string>
#include <vector>

namespace mdm {

/// Decides whether numbers of particles, and their sizes where they are stated, are a match for a question.
class CountsJudge {
public:
  /// \param g  with the pan, the cut and the size factor of the question made
  /// \throws InputError if the law is irrational at an opening, or the question does not fit g
  CountsJudge(Gradation g, const Question &question);

  /// What is against the particles.
  struct Finding {
    std::string mismatch;      ///< empty: nothing
    bool is_undecided = false; ///< a volume that is asked for is too near to be told
  };
  /// \param q, sizes  one a class; sizes in the unit of g
  /// \param size_tolerance  see Crosscheck::judge
  Finding find(const std::vector<Integer> &q, const std::vector<std::optional<StatedSize>> &sizes,
               const Rational &size_tolerance) const;

private:
  TolerantProblem problem(const Rational &weight) const;
  std::string in_words(const Multiple &condition, const TolerantProblem &problem,
                       const std::vector<Integer> &q) const;
  std::string mismatch(const TolerantProblem &problem, const std::vector<Integer> &q,
                       const std::vector<std::optional<StatedSize>> &sizes,
                       const Rational &size_tolerance) const;

  Gradation g_;
  Question question_;
  Tolerance tolerance_;
};

} // namespace mdm

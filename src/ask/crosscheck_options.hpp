#pragma once
/// \file
/// What is asked about the answers of other solvers.

#include "ask/solve_options.hpp"

#include <mdm/crosscheck/crosscheck.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The question that the answers are to, and how they are judged, as texts. All members throw an InputError
/// that names the option where its value does not serve.
struct CrosscheckTexts : SolveTexts {
  OptionText size_tolerance;

  /// All but those of the question.
  static const std::vector<OptionRow<CrosscheckTexts>> options, limit_options;

  /// How far sizes may be off, as a part of the size as stated.
  Rational most_size_error() const;
  /// The options of the question as they were given; empty for the plain question.
  std::string question_words() const;
};

/// The question about each gradation of a suite.
class CrosscheckQuestion {
public:
  CrosscheckQuestion(const CrosscheckTexts &asked, const ReadBand &read_band);

  /// An exact match of spheres and nothing else.
  bool is_plain() const { return !asked_; }
  /// The gradation with its least match. \param progress as SolveOptions::progress
  /// \throws InputError where the question does not fit it
  Crosscheck problem(const Gradation &g, const ProgressCall &progress = {}) const;
  /// What is asked about a gradation in that unit.
  Question question(const Gradation &g) const { return asked_ ? asked_->of(g) : Question(); }

private:
  Limits limits_;
  std::optional<AskedQuestion> asked_;
};

} // namespace mdm

#pragma once
/// \file
/// The algorithms of Arnold's paper as published: what is asked, and the run.

#include "ask/outcome.hpp"
#include "ask/solve_options.hpp"
#include "particles/sample_certifier.hpp"
#include "report/published.hpp"

#include <vector>

namespace mdm {

/// An algorithm with its settings, as texts.
struct PublishedTexts {
  std::string algorithm; ///< rounded, fixed-size or spanned-integer
  GradationTexts gradation;
  OptionText sizes, size_at, rounding, tolerance, max_iterations, start, increments, digits;

  /// All but those of the gradation.
  static const std::vector<OptionRow<PublishedTexts>> options;
};

/// The algorithm that is asked for, ready to be run.
class PublishedRun {
public:
  /// \throws InputError naming the option where its value does not serve, or the algorithm has no use for it
  explicit PublishedRun(const PublishedTexts &asked);

  /// \throws InputError where the question does not fit the gradation
  PublishedReport report(const Gradation &g) const;

  /// The certificate of the report's sample: that it matches exactly, or within the total error that is
  /// enough for fixed-size, or that it does not; nothing where the sample is empty.
  /// \param begin  takes the canonical sample
  /// \throws InputError if it is beyond the limits of the format
  std::optional<CertifiedSample> certified(const PublishedReport &report,
                                           const SampleCertifier::Begin &begin) const;

private:
  PublishedAlgorithm kind_;
  std::string settings_; ///< in words
  std::function<Published(const Gradation &, const MassLaw &)> run_;
  AskedQuestion question_;
  std::optional<Rational> total_error_; ///< that is enough
  unsigned digits_;
};

Outcome outcome_of(const PublishedReport &report);

} // namespace mdm

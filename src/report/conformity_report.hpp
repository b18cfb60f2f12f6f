#pragma once
/// \file
/// Whether samples keep a specification, as text, JSON and CSV.

#include "judge/conformity.hpp"

namespace mdm {

/// The verdicts on some samples, at least one.
struct ConformityReport {
  Specification specification;
  std::vector<Conformity> samples;

  /// The worst of all: undecided, else fails, else hangs, else holds.
  Compliance verdict() const;
};

// `digits` >= 1 are significant digits.

/// A value with so many digits, or with more where fewer would not show that it is beyond one of its limits.
std::string shown_beside_limits(const Real &value, const std::optional<Rational> &least,
                                const std::optional<Rational> &most, unsigned digits);

/// One line of JSON, schema `mdm-judge-1`, without a newline at its end. Percents are enclosures ["lo","hi"],
/// those of witnesses are exact fractions.
std::string conformity_json(const ConformityReport &report, unsigned digits);

/// sample,size_mm,passing_min_percent,passing_max_percent,passing_lo,passing_hi,least,most,verdict: a row a
/// sieve, and one without a size for the sample. What may have been rounded lies between least and most.
std::string conformity_csv(const ConformityReport &report, unsigned digits);

/// For people: of one sample a row a sieve, of several a column a sample.
std::string conformity_text(const ConformityReport &report, unsigned digits);

} // namespace mdm

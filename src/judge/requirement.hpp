#pragma once
/// \file
/// A rule of practice as requirements on the numbers of a gradation.

#include "judge/compliance.hpp"
#include "number/real.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// A number that a rule works with, of the curve as reported.
struct RuleNumber {
  std::string name;
  std::optional<Real> value; ///< nothing where the report does not tell it
  std::string unit;          ///< mm, %, or nothing
};

/// value <= limit, or value >= limit.
struct Requirement {
  std::string name;
  RuleNumber value;
  bool at_most = true;
  std::optional<Real> limit; ///< in the unit of the value
  std::string limit_text;    ///< where the limit comes from, such as `4 x d85 of the base`
  Compliance verdict = Compliance::undecided;
};

/// What a rule says of one sample.
struct RuleJudgement {
  std::string id;
  Compliance verdict = Compliance::undecided;
  std::vector<Requirement> requirements;
  std::vector<RuleNumber> numbers; ///< that lead to them
  std::vector<std::string> notes;
};

/// A rule with what it says of some samples.
struct RuleReport {
  std::string rule;  ///< its name as an option
  std::string about; ///< in words, with its source
  std::vector<RuleNumber> numbers;
  std::vector<std::string> notes;
  std::vector<RuleJudgement> samples;

  /// The worst of all.
  Compliance verdict() const;
};

/// That of all requirements together: fails where one does, else the worst.
Compliance verdict_of(const std::vector<Requirement> &requirements);

/// What of the curve is taken as exact, or how it was rounded.
std::string rounding_note(bool is_exact);

} // namespace mdm

#pragma once
/// \file
/// Whether a gradation keeps a specification.

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/judge/specification.hpp>
#include <mdm/number/enclosure.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// The verdict at a sieve of the specification. Percents have 15 significant digits.
struct JudgedSieve {
  PassingLimits limits;
  std::optional<Enclosure>
      passing;           ///< percent that passes, of the reported curve; nothing below its finest sieve
  Enclosure least, most; ///< of the curves that round to the report
  Compliance verdict = Compliance::undecided;
};

/// The verdict on a gradation.
struct JudgedGradation {
  std::string id;
  Compliance verdict = Compliance::undecided; ///< of all sieves together
  std::vector<JudgedSieve> sieves;            ///< ascending
  std::vector<std::string> notes;
  std::string json; ///< one line, schema `mdm-judge-1`
  std::string text; ///< the report for people, as `mdm judge` prints it
};

/// Judges what was understood of a report. A percent in it stands for all numbers that round to it: the
/// verdict holds or fails for all curves that round to the report, or hangs on what it does not tell. At a
/// size where the gradation has no sieve, what passes is interpolated, linear in log size, and decided
/// exactly.
/// \param rounding  one unit of the last digit of all percents, 0 where nothing was rounded; open: as the report has them
/// \throws InputError if percents retained cannot be those of a whole
JudgedGradation judge_gradation(const UnderstoodGradation &report, const Specification &specification,
                                const std::optional<Rational> &rounding = std::nullopt);

} // namespace mdm

#pragma once
/// \file
/// Whether a sample keeps a specification, whatever was rounded in its report.

#include "judge/compliance.hpp"
#include "judge/further_limits.hpp"

namespace mdm {

/// The verdict at one sieve.
struct SieveVerdict {
  PassingLimits limits;
  std::optional<Real> passing;  ///< percent, of the reported curve; nothing below its finest sieve
  Real least, most;             ///< percent, of the curves that round to the report
  bool is_interpolated = false; ///< linear in log size
  Compliance verdict = Compliance::undecided;
  std::optional<Real>
      distance; ///< from `passing` to the nearest limit that can be missed, negative beyond it
};

/// The percents that pass the sieves of a curve.
struct WitnessCurve {
  std::vector<RootSize> sizes; ///< mm, ascending, above 0
  std::vector<Rational> passing;
};

/// The verdict on one sample.
struct Conformity {
  std::string id;
  Compliance verdict = Compliance::undecided;
  std::vector<SieveVerdict> sieves; ///< ascending
  std::vector<LimitVerdict> limits; ///< the further ones
  bool is_exact = true;             ///< nothing was rounded
  /// Of a verdict that hangs: a curve that rounds to the report and keeps all limits (nothing where no short
  /// decimals are such a curve), and one that does not.
  std::optional<WitnessCurve> within, outside;
  std::vector<std::string> notes;
};

/// The sieves at which a limit is missed whatever was rounded, in mm, ascending.
std::vector<Rational> missed_sizes(const Conformity &sample);

/// Judges by all sieves and all further limits together.
/// \param rounding  one unit of the last digit of all percents, 0 for none; nothing: as the report has them
/// \throws InputError as curves_of
Conformity judge(const UnderstoodGradation &report, const Specification &specification,
                 const std::optional<Rational> &rounding = std::nullopt,
                 const std::vector<FurtherLimit> &limits = {});

} // namespace mdm

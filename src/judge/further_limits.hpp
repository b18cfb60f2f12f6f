#pragma once
/// \file
/// What a specification may ask besides the percents that pass its sieves.

#include "judge/compliance.hpp"
#include "judge/curve_within.hpp"

#include <mdm/soil/fineness_modulus.hpp>

#include <string>
#include <vector>

namespace mdm {

/// A limit on a number of a curve, closed.
struct FurtherLimit {
  /// Nothing: on the percent that passes a sieve of the specification and stays on its next finer one.
  std::optional<FinenessModulus> modulus;
  std::optional<Rational> least, most; ///< one of them at least
};

/// The name and the ends of `NAME=2.3..3.1`, of which one may be missing.
struct NamedLimits {
  std::string name;
  std::optional<Rational> least, most;
};

/// Percent signs are taken where the name is none of a fineness modulus.
/// \param forms  what may be written, for a message
/// \throws InputError where it is none, has no end, or no number is from the first to the second
NamedLimits parse_named_limits(const std::string &text, const char *forms);

/// `FM=2.3..3.1`, `FM-EN=2.4..`, `retained=..45%`.
/// \throws InputError where it is none of them, or no number keeps it
FurtherLimit parse_further_limit(const std::string &text);

/// A number of a curve: constant + the sum of factor times the percent that passes.
struct CurveNumber {
  struct Term {
    Rational size; ///< mm
    CurvePlace place;
    Rational factor;
  };
  std::string name;
  Rational constant;
  std::vector<Term> terms;
};

/// The verdict on a number.
struct LimitVerdict {
  FurtherLimit limit;
  CurveNumber number;
  std::optional<Real>
      value;           ///< of the reported curve; nothing where it depends on what is below its finest sieve
  Real least, most;    ///< bounds of it for the curves that round to the report
  bool are_met = true; ///< there are curves with the bounds
  Compliance verdict = Compliance::undecided;
};

/// The sizes at which a limit needs what passes, in mm.
std::vector<Rational> sizes_of(const FurtherLimit &limit);

/// The verdicts on all numbers that the limits are about; `retained` is about each two sieves that follow
/// each other in the specification.
/// \param unmeasured  sieves of the box that the report does not have
/// \pre box.narrow() was called, and each size needed is a sieve of the box or between two above 0
std::vector<LimitVerdict> further_verdicts(const CurveBox &box, const Specification &specification,
                                           const std::vector<FurtherLimit> &limits,
                                           const std::vector<Rational> &unmeasured);

/// Whether a curve of the box keeps the limits at sieves and the further ones together, and one that does.
/// Limits at sieves of the box and on what stays between two of them tie what passes two sieves, so that
/// there are a least and a greatest curve; on the curves between these one fineness modulus takes all values
/// from one end to the other. Not available where a limit that is not kept by all curves is of another kind.
/// \param further  those that some curves keep and others do not
Available<CurveWithin> curve_within_all(CurveBox box, const std::vector<PlacedLimits> &limits,
                                        const std::vector<LimitVerdict> &further);

/// A curve of the box that does not keep a limit that hangs.
CurvePercents curve_outside(const CurveBox &box, const LimitVerdict &hanging);

} // namespace mdm

#pragma once
/// \file
/// Sizes and percents that the curves of a box may have.

#include "judge/curve_within.hpp"
#include "number/power_product.hpp"

namespace mdm {

/// A size (mm) between two; without `lo` between 0 and `hi`.
struct DiameterRange {
  std::optional<PowerProduct> lo;
  PowerProduct hi;
};

/// The curves that a narrow box lies between, and the reported one.
struct OuterCurves {
  explicit OuterCurves(CurveBox curves);

  CurveBox box;
  CurvePercents coarse, fine; ///< the least and the most that passes

  /// The finest sieve above 0 (mm): below it no curve is known.
  PowerProduct finest() const;
};

/// The least size that `percent` > 0 passes on the curve through `percents`; nothing where it lies below the
/// finest sieve.
std::optional<PowerProduct> diameter(const CurveBox &box, const CurvePercents &percents,
                                     const Rational &percent);
/// The greatest size that no more than `percent` passes: another one where the curve is flat there.
/// \pre percent < 100
std::optional<PowerProduct> upper_diameter(const CurveBox &box, const CurvePercents &percents,
                                           const Rational &percent);

/// D_p for all curves and all p in `percent`, in (0, 100].
DiameterRange diameters(const OuterCurves &curves, const Interval &percent);

/// D_p of the reported curve for a p in `percent`; nothing where it lies below the finest sieve.
std::optional<Real> reported_diameter(const OuterCurves &curves, const Interval &percent);

/// y between two numbers, known as well as they are near each other.
Real real_between(const Real &lo, const Real &hi);

/// A fraction that is y, or two around it that agree to more digits than are ever printed.
Interval fractions_around(const Real &y);

/// What passes `size`, at or above the finest sieve, on the curve through these percents.
/// \throws NotAvailable where no precision tells between which sieves it lies
Real passing(const CurveBox &box, const CurvePercents &percents, const PowerProduct &size);

/// What passes `size` (mm) on all curves, as fractions_around() it; below the finest sieve from 0 on.
/// \throws NotAvailable as above
Interval passing_range(const OuterCurves &curves, const Rational &size);

/// a <= b, decided. \throws NotAvailable where no precision tells
bool not_above(const PowerProduct &a, const PowerProduct &b);

} // namespace mdm

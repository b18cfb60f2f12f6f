#pragma once
/// \file
/// Size classes of a grading curve.

#include "sets/sieve_curve.hpp"

#include <memory>

namespace mdm {

/// One class of sizes, lower to upper.
struct SizeClass {
  CurveSize lower, upper;
  Real volume_fraction; ///< f_v (Eq. 6)

  /// True if f_v is 0, as between sieves that the same share passes.
  bool is_empty() const { return volume_fraction.fraction() == Rational(0); }
};

/// The rule that sets the bounds between classes.
enum class Classing {
  regular,   ///< equal widths
  geometric, ///< d_i = d_min (d_max / d_min)^(i / N_c) (Eq. 11)
  isochoric  ///< equal volume fractions
};

/// `regular`, `geometric` or `isochoric`.
const char *name(Classing classing);

/// The most classes.
inline constexpr unsigned max_size_classes = 10000;

/// N_c classes of a curve, ascending. Cost: some microseconds a class; isochoric ones of a beta curve some
/// milliseconds, and some 0.2 s where a or b is near 0.001 and bounds agree in a thousand bits.
/// \throws InputError if there are none or too many, or a stair has no such classes (isochoric)
std::vector<SizeClass> size_classes(const ModelCurve &curve, Classing classing, unsigned n);

/// The classes between the sieves of a measured curve.
std::vector<SizeClass> sieve_classes(const SieveCurve &curve);

} // namespace mdm

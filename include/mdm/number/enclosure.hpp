#pragma once
/// \file
/// Proved decimal enclosures of real numbers.

#include <mdm/number/rational.hpp>

namespace mdm {

/// The decimals lo * 10^-places <= y <= hi * 10^-places around a real y >= 0; lo = hi exactly when y is that
/// decimal.
struct Enclosure {
  Integer lo;
  Integer hi;
  unsigned places = 0;

  bool is_point() const { return lo == hi; }
  /// The bounds as fractions.
  Rational lower() const;
  Rational upper() const;
  /// The bounds in plain decimal notation.
  std::string lower_text() const;
  std::string upper_text() const;
  /// `[lo, hi]` with trailing zeros, or the value alone where lo = hi.
  std::string text() const;
};

/// Encloses (n/d)^(1/degree), for n, d > 0 with or without common factors and degree >= 1, to `digits` >= 1
/// significant digits (more if the root has more before its point): hi - lo is one unit of the last digit,
/// lo^degree <= n/d < hi^degree; or lo = hi with lo^degree = n/d where the root is a decimal, however long.
/// Decided in integers (Theorem 9). Cost: one integer root of about degree * digits digits.
Enclosure enclose_root(const Integer &n, const Integer &d, unsigned degree, unsigned digits);

/// Encloses every y in [lo/d, hi/d], 0 < lo <= hi, d > 0, by decimals of `digits` significant digits, rounded
/// outwards.
Enclosure enclose_interval(const Integer &lo, const Integer &hi, const Integer &d, unsigned digits);

} // namespace mdm

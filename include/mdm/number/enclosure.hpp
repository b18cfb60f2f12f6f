#pragma once
/// \file
/// Proved decimal enclosures of real numbers.

#include <mdm/number/rational.hpp>

namespace mdm {

/// The decimals lo * 10^-places <= y <= hi * 10^-places around a real y >= 0; lo = hi exactly when y is that decimal.
struct Enclosure {
  Integer lo;
  Integer hi;
  unsigned places = 0;

  /// The bounds as fractions.
  Rational lower() const;
  Rational upper() const;
  /// The bounds in plain decimal notation.
  std::string lower_text() const;
  std::string upper_text() const;
};

/// Encloses r^(1/degree), for r > 0, degree >= 1, to `digits` >= 1 significant digits: hi - lo is one unit of the last
/// digit, lo^degree <= r < hi^degree, or lo = hi with lo^degree = r where the root is a decimal, however long.
/// Decided in integers (Theorem 9). Cost: one integer root of about degree * digits digits.
Enclosure enclose_root(const Rational &r, unsigned degree, unsigned digits);

/// Encloses every y in [lo, hi], 0 < lo <= hi, by decimals of `digits` significant digits, rounded outwards.
Enclosure enclose_interval(const Rational &lo, const Rational &hi, unsigned digits);

} // namespace mdm

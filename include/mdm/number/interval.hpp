#pragma once
/// \file
/// Real numbers between fractions.

#include <mdm/number/rational.hpp>

#include <cassert>

namespace mdm {

/// A real number y with lo <= y <= hi; lo = hi where y is known to be that fraction.
struct Interval {
  Rational lo;
  Rational hi;

  Interval() = default;
  Interval(const Rational &exact) : lo(exact), hi(exact) {}
  /// \pre lo <= hi
  Interval(Rational lower, Rational upper) : lo(std::move(lower)), hi(std::move(upper)) { assert(lo <= hi); }

  /// True if y is known to be a fraction, lo.
  bool is_point() const { return lo == hi; }
};

/// Encloses y + z.
Interval operator+(const Interval &y, const Interval &z);
/// Encloses y - z.
Interval operator-(const Interval &y, const Interval &z);
/// Encloses y * z, for y, z >= 0.
Interval operator*(const Interval &y, const Interval &z);
/// Encloses y / z, for z > 0.
Interval operator/(const Interval &y, const Interval &z);
/// Encloses y^exponent, for y >= 0.
Interval power(const Interval &y, unsigned exponent);
/// Encloses |y|.
Interval absolute(const Interval &y);
/// Encloses the greater of y and z.
Interval greater(const Interval &y, const Interval &z);

/// Encloses r^(1/degree) for r >= 0: exactly where it is a fraction, else within 2^-bits.
Interval root(const Rational &r, unsigned degree, unsigned bits);

} // namespace mdm

#pragma once
/// \file
/// Numbers of a sheet with what their printing may have cut off.

#include <mdm/number/interval.hpp>

#include <algorithm>

namespace mdm {

/// A number that was rounded to its last digit. What it was lies within half a unit of that; below 0 are no
/// masses.
struct PrintedNumber {
  Rational value;
  Rational half;

  Interval range() const {
    return {std::max<Rational>(value - half, 0), std::max<Rational>(value + half, 0)};
  }
};

inline PrintedNumber operator+(const PrintedNumber &a, const PrintedNumber &b) {
  return {a.value + b.value, a.half + b.half};
}
inline PrintedNumber operator-(const PrintedNumber &a, const PrintedNumber &b) {
  return {a.value - b.value, a.half + b.half};
}
inline PrintedNumber operator*(const PrintedNumber &a, const Rational &factor) {
  return {a.value * factor, a.half * factor};
}

/// A part of a whole in percent. \pre the whole is above 0 whatever its rounding
inline PrintedNumber share_of(const PrintedNumber &part, const PrintedNumber &whole) {
  const Rational low = 100 * part.range().lo / (whole.value + whole.half),
                 high = 100 * part.range().hi / (whole.value - whole.half);
  return {(low + high) / 2, (high - low) / 2};
}

/// True where both may be one number.
inline bool agree(const PrintedNumber &a, const PrintedNumber &b) {
  return abs(Rational(a.value - b.value)) <= a.half + b.half;
}
/// True where the number may lie within the bounds.
inline bool agree(const PrintedNumber &a, const Interval &bounds) {
  const Interval range = a.range();
  return range.lo <= bounds.hi && bounds.lo <= range.hi;
}

} // namespace mdm

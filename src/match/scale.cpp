// The scale in a match's window (above, up_to]. The robust one keeps all sizes as far from the sieves as
// can be: their least relative distance is greatest at the geometric middle (proofs/README.md, Theorem 9,
// "Robust scale"). The middle is irrational in general and its digits are of no use to anybody, so the
// simplest rational in the next 1/128 of the width is taken: integer roots enclose the middle, and a walk
// down the continued fraction finds the simplest between two ends.

#include "match/scale.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// The simplest rational in a part of [m, m + width / 127], m = sqrt(above * up_to). Both ends of the part
/// are multiples of 2^-bits <= width / 2^14, the lower one less than two of them above m, so that their
/// numbers stay short.
Rational simplest_near_middle(const Rational &above, const Rational &up_to) {
  const Integer n = numerator(above), d = denominator(above), m = numerator(up_to), e = denominator(up_to);
  const Integer width = m * d - n * e; // over unit
  const Integer unit = d * e;
  const std::size_t small = bit_length(unit) + 15;
  const std::size_t large = bit_length(width);
  const std::size_t bits = small > large ? small - large : 0;
  const Integer lo = floor_root(floor_div(Integer(n * m) << (2 * bits), unit), 2) + 1;
  const Integer hi = lo + floor_div(width << bits, unit << 7);
  return simplest_between(lo, hi, Integer(1) << bits);
}

Rational robust_scale(const Window &w) {
  if (w.start_is_feasible() && w.start->hi * w.start->hi > w.above * w.up_to)
    return simplest_between(w.start->hi, Rational(w.start->hi + (w.up_to - w.start->hi) / 128));
  return w.above == 0 ? Rational(w.up_to / 2) : simplest_near_middle(w.above, w.up_to);
}

} // namespace

Rational choose_scale(const Window &w, ScaleChoice choice, unsigned digits) {
  if (choice == ScaleChoice::upper)
    return w.up_to;
  if (choice == ScaleChoice::robust || !w.start_is_feasible())
    return robust_scale(w);
  const Rational &start = w.start->hi;
  if (w.start->is_point())
    return start;
  const Rational room =
      std::min(Rational((w.up_to - start) / 2), Rational(start / Rational(power_of_ten(digits))));
  return simplest_between(start, Rational(start + room));
}

} // namespace mdm

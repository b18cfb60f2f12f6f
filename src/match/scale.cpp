#include <mdm/match/scale.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// The simplest rational in a part of [m, m + width / 127], m = sqrt(above * up_to). Both ends of the part
/// are multiples of 2^-bits <= width / 2^14, the lower one less than two of them above m, so that their
/// numbers stay short.
Rational simplest_near_middle(const Rational &above, const Rational &up_to) {
  const Rational width = up_to - above;
  const std::size_t small = bit_length(denominator(width)) + 15;
  const std::size_t large = bit_length(numerator(width));
  const std::size_t bits = small > large ? small - large : 0;
  const Rational square = above * up_to;
  const Integer lo = floor_root(floor_div(numerator(square) << (2 * bits), denominator(square)), 2) + 1;
  const Integer hi = lo + floor_div(numerator(width) << bits, denominator(width) << 7);
  const Integer unit = Integer(1) << bits;
  return simplest_between(ratio(lo, unit), ratio(hi, unit));
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
  if (w.start->exact())
    return start;
  const Rational room =
      std::min(Rational((w.up_to - start) / 2), Rational(start / Rational(power_of_ten(digits))));
  return simplest_between(start, Rational(start + room));
}

} // namespace mdm

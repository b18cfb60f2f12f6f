#include <mdm/match/scale.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// A rational in [sqrt(above * up_to), sqrt(above * up_to) + width / 2^14].
Rational middle_from_above(const Rational &above, const Rational &up_to) {
  const Rational width = up_to - above;
  const Rational square = above * up_to;
  const std::size_t small = bit_length(denominator(width)) + 16;
  const std::size_t large = bit_length(numerator(width));
  const std::size_t bits = small > large ? small - large : 0;
  const Integer scaled = floor_div(Integer(numerator(square) << (2 * bits)), denominator(square));
  return ratio(Integer(floor_root(scaled, 2) + 1), Integer(Integer(1) << bits));
}

Rational robust_scale(const Window &w) {
  if (w.above == 0 && !w.start)
    return w.up_to / 2;
  Rational lo = w.above == 0 ? Rational(0) : middle_from_above(w.above, w.up_to);
  Rational width = w.up_to - w.above;
  if (w.start_is_feasible() && w.start->hi > lo) {
    lo = w.start->hi;
    width = w.up_to - lo;
  }
  return simplest_between(lo, Rational(lo + width / 128));
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
  const Rational room = std::min(Rational((w.up_to - start) / 2), Rational(start / Rational(power_of_ten(digits))));
  return simplest_between(start, Rational(start + room));
}

} // namespace mdm

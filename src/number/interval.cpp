// Intervals with fractions at their ends. Sums, products and quotients are exact at both ends, so an
// interval grows by nothing but its arguments' widths; a root is a fraction where it is one, and else
// between two fractions 2^-bits apart, found by integers. Where the sign of an argument matters the ends
// are chosen by it. They are used where numbers are not refined on demand (real.hpp), as in sums over many
// particles.

#include <mdm/number/interval.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {

Interval operator+(const Interval &y, const Interval &z) {
  return {y.lo + z.lo, y.hi + z.hi};
}

Interval operator-(const Interval &y, const Interval &z) {
  return {y.lo - z.hi, y.hi - z.lo};
}

Interval operator*(const Interval &y, const Interval &z) {
  assert(y.lo >= 0 && z.lo >= 0);
  return {y.lo * z.lo, y.hi * z.hi};
}

Interval operator/(const Interval &y, const Interval &z) {
  assert(z.lo > 0);
  return {y.lo / (y.lo < 0 ? z.lo : z.hi), y.hi / (y.hi < 0 ? z.hi : z.lo)};
}

Interval power(const Interval &y, unsigned exponent) {
  assert(y.lo >= 0);
  return {power(y.lo, exponent), power(y.hi, exponent)};
}

Interval absolute(const Interval &y) {
  if (y.lo >= 0)
    return y;
  if (y.hi <= 0)
    return {Rational(-y.hi), Rational(-y.lo)};
  return {Rational(0), std::max(Rational(-y.lo), y.hi)};
}

Interval greater(const Interval &y, const Interval &z) {
  return {std::max(y.lo, z.lo), std::max(y.hi, z.hi)};
}

Interval root(const Rational &r, unsigned degree, unsigned bits) {
  assert(r >= 0 && degree >= 1);
  if (const std::optional<Rational> exact = exact_root(r, degree))
    return *exact;
  const Integer scaled = floor_div(numerator(r) << (bits * degree), denominator(r));
  const Integer lo = floor_root(scaled, degree);
  const Integer unit = Integer(1) << bits;
  return {ratio(lo, unit), ratio(lo + 1, unit)};
}

} // namespace mdm

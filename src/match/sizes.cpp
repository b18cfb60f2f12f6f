#include <mdm/match/sizes.hpp>

#include <algorithm>

namespace mdm {

namespace {

/// lower < x.lo and x.hi <= upper, in integers.
bool inside(const Enclosure &x, const Rational &lower, const Rational &upper) {
  const Integer unit = power_of_ten(x.places);
  return numerator(lower) * unit < x.lo * denominator(lower) && x.hi * denominator(upper) <= numerator(upper) * unit;
}

} // namespace

std::vector<Enclosure> enclose_sizes(const Gradation &g, const Problem &problem, const std::vector<Integer> &q,
                                     const Rational &scale, unsigned digits) {
  const MassLaw &law = problem.law();
  const Integer scale_numerator = numerator(scale);
  const Integer scale_denominator = denominator(scale);
  std::vector<Enclosure> sizes;
  sizes.reserve(q.size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    const std::size_t index = problem.classes()[j].index;
    const Rational mass = g.has_factors() ? Rational(g.mass(index) / g.factor(index)) : g.mass(index);
    const Integer n = scale_numerator * power(numerator(mass), law.b);
    const Integer d = scale_denominator * power(Integer(q[j] * denominator(mass)), law.b);
    Enclosure x = enclose_root(n, d, law.a, digits);
    for (unsigned more = 2 * digits; !inside(x, g.lower(index), g.upper(index)); more *= 2)
      x = enclose_root(n, d, law.a, more);
    sizes.push_back(std::move(x));
  }
  return sizes;
}

Rational size_margin(const MassLaw &law, const Rational &above, const Rational &up_to, const Rational &scale) {
  Rational closest = up_to / scale;
  if (above > 0)
    closest = std::min(closest, Rational(scale / above));
  if (closest == 1)
    return 0;
  for (unsigned digits = 6;; digits *= 2) {
    const Enclosure root = enclose_root(numerator(closest), denominator(closest), law.a, digits);
    const Integer excess = root.lo - power_of_ten(root.places);
    if (root.lo == root.hi || excess >= 1000)
      return ratio(excess, power_of_ten(root.places));
  }
}

} // namespace mdm

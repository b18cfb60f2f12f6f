#include "particles/cost.hpp"

#include "number/pi.hpp"

#include <mdm/number/enclosure.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {

Rational in_metres(const ParticleSet &set, const Rational &length) {
  return length * in_mm(set.unit) / 1000;
}

Rational rayleigh_time(const ParticleSet &set, const ParticleClass &c, const Elasticity &elasticity) {
  assert(elasticity.young > 0 && elasticity.poisson > -1 && elasticity.poisson <= ratio(1, 2));
  constexpr unsigned digits = 15;
  const Rational metre = in_metres(set, 1);
  const Rational r = metre * exact_value(c.sizes.front().radius.value);
  const Rational square =
      r * r * c.density / power(metre, 3) * 2 * (1 + elasticity.poisson) / elasticity.young;
  const Enclosure root = enclose_root(numerator(square), denominator(square), 2, digits);
  return enclose_pi(digits).lower() * root.lower() /
         (ratio(1631, 10000) * elasticity.poisson + ratio(8766, 10000));
}

Rational rayleigh_time(const ParticleSet &set, const Elasticity &elasticity) {
  Rational least = rayleigh_time(set, set.classes.front(), elasticity);
  for (const ParticleClass &c : set.classes)
    least = std::min(least, rayleigh_time(set, c, elasticity));
  return least;
}

Rational loose_side(const ParticleSet &set) {
  const Integer um = 1000000;
  return ratio(floor_root(floor(Rational(2 * set.cubes() * power(Rational(in_metres(set, 1) * um), 3))), 3),
               um);
}

} // namespace mdm

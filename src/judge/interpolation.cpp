// The place of a size between the sieves of a box. At a sieve it is that sieve; between two it is at the
// part (log size - log x_i) / (log x_{i+1} - log x_i) of the way, a quotient of logarithms of fractions,
// which is irrational in general and refined when it is compared. What passes there is linear in what
// passes the two sieves, with a part of exactly 0 left out, so that a curve which is flat there is exact.

#include "judge/interpolation.hpp"

#include "number/power_product.hpp"

namespace mdm {
namespace {

PowerProduct product(const RootSize &x) {
  return PowerProduct(x.power, ratio(1, x.degree));
}

} // namespace

CurvePlace place_of(const CurveBox &box, const Rational &size) {
  const RootSize x{size};
  std::size_t i = box.openings.size() - 1;
  while (i > 0 && compare(box.openings[i], x) > 0)
    --i;
  if (i + 1 == box.openings.size() || compare(box.openings[i], x) == 0)
    return {i, std::nullopt};
  const PowerProduct lower = product(box.openings[i]);
  return {i, log_ratio(PowerProduct(size) / lower, product(box.openings[i + 1]) / lower)};
}

CurvePlace place_on(const CurveBox &box, const Rational &size) {
  return compare(RootSize{size}, box.openings[1]) < 0 ? CurvePlace{0, std::nullopt} : place_of(box, size);
}

Real scaled(const Real &c, const Real &y) {
  return c.fraction() && *c.fraction() == 0 ? Real(0) : c * y;
}

Real passing_at(const CurvePlace &place, const std::vector<Rational> &percents) {
  const Rational &lower = percents[place.i];
  return place.way ? Real(lower) + scaled(Real(percents[place.i + 1] - lower), *place.way) : Real(lower);
}

} // namespace mdm

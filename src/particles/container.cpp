#include "particles/container.hpp"

#include "number/nearest_double.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mdm {

Container::Container(const SampleSpace &space) : space_(space) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = cut_double(space.box->low[axis]);
    high_[axis] = cut_double(space.box->high[axis]);
  }
}

bool Container::holds(const SphereSample::Place &place, const Rational &unit) const {
  if (is_well_inside(place, unit))
    return true;
  std::array<Rational, 3> centre;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string decimal(place[axis]);
    std::replace(decimal.begin(), decimal.end(), ',', '.');
    centre[axis] = parse_decimal(decimal) * unit;
  }
  return holds(centre);
}

bool Container::is_well_inside(const SphereSample::Place &place, const Rational &unit) const {
  // Far more than the few units of 2^-53 by which products and sums of doubles are off.
  constexpr double error = 1e-12;
  if (space_.is_cylinder)
    return false;
  const double length = cut_double(unit);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double> number = nearest_double(place[axis]);
    if (!number)
      return false;
    const double x = *number * length;
    const double margin = error * (std::abs(x) + std::abs(low_[axis]) + std::abs(high_[axis]));
    const bool has_top = axis < 2 || space_.has_top;
    if (!space_.periodic[axis] && !(x > low_[axis] + margin && (!has_top || x < high_[axis] - margin)))
      return false;
  }
  return true;
}

bool Container::holds(const std::array<Rational, 3> &centre) const {
  const SpaceBox &box = *space_.box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool has_top = axis < 2 || space_.has_top;
    if (!space_.periodic[axis] &&
        (centre[axis] < box.low[axis] || (has_top && centre[axis] > box.high[axis])))
      return false;
  }
  if (!space_.is_cylinder)
    return true;
  const Rational r = box.side(0) / 2;
  const Rational x = centre[0] - box.low[0] - r, y = centre[1] - box.low[1] - r;
  return Rational(x * x + y * y) <= Rational(r * r);
}

} // namespace mdm

#include "packing/sphere_space.hpp"

#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <limits>

namespace mdm::packing {
namespace {

/// The largest of n numbers of which doubles within an error are known.
template <class Value, class Exact>
Rational largest_of(std::size_t n, double error, const Value &value, const Exact &exact) {
  double most = value(std::size_t{0});
  for (std::size_t i = 1; i < n; ++i)
    most = std::max(most, value(i));
  std::optional<Rational> largest;
  for (std::size_t i = 0; i < n; ++i)
    if (value(i) >= most - 2 * error)
      largest = largest ? std::max(*largest, Rational(exact(i))) : Rational(exact(i));
  return *largest;
}

/// More than the error of a sum of a few doubles of the sample.
double error_of_sum(const SphereSample &sample) {
  return sample.greatest() * 16 * std::numeric_limits<double>::epsilon();
}

/// The end of the spheres along an axis: the highest for a sign of 1; -1 times the lowest for -1.
Rational end_of(const SphereSample &sample, std::size_t axis, int sign) {
  return largest_of(
      sample.size(), error_of_sum(sample),
      [&](std::size_t i) { return sign * sample.centre(i)[axis] + sample.radius(i); },
      [&](std::size_t i) {
        return Rational(sign * sample.exact_coordinate(i, axis) + sample.exact_diameter(i) / 2);
      });
}

/// The smallest box around all spheres.
SpaceBox box_around(const SphereSample &sample) {
  SpaceBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = -end_of(sample, axis, -1);
    box.high[axis] = end_of(sample, axis, 1);
  }
  return box;
}

/// The square in the circle that fits into the box's ground, its side cut to 15 digits.
SpaceBox inside_cylinder(const SpaceBox &box) {
  SpaceBox inside = box;
  const Rational d = box.side(0);
  const Rational side =
      enclose_root(numerator(Rational(d * d / 2)), denominator(Rational(d * d / 2)), 2, 15).lower();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    inside.low[axis] += (d - side) / 2;
    inside.high[axis] -= (d - side) / 2;
  }
  return inside;
}

} // namespace

SpaceBox space_of(const SphereSample &sample, const SampleSpace &asked) {
  if (!asked.box)
    return box_around(sample);
  SpaceBox box = *asked.box;
  if (asked.to_top) {
    const Rational top = end_of(sample, 2, 1);
    box.high[2] = asked.has_top ? std::min(box.high[2], top) : top;
  }
  if (box.is_empty())
    throw InputError("all particles are below the floor of their box: is the box right?");
  return box;
}

Rational largest_diameter(const SphereSample &sample) {
  return largest_of(
      sample.size(), error_of_sum(sample), [&](std::size_t i) { return 2 * sample.radius(i); },
      [&](std::size_t i) { return sample.exact_diameter(i); });
}

std::optional<SpaceBox> inner_part(const SphereTexture &t, const Rational &off, const Rational &largest) {
  SpaceBox inner = t.space;
  if (t.is_cylinder) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      inner.low[axis] += off;
      inner.high[axis] -= off;
    }
    if (inner.is_empty())
      return std::nullopt;
    inner = inside_cylinder(inner);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!t.periodic[axis] && (axis == 2 || !t.is_cylinder)) {
      inner.low[axis] += off;
      inner.high[axis] -= off;
    }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (inner.side(axis) <= 0 || (!t.periodic[axis] && inner.side(axis) < largest))
      return std::nullopt;
  return inner;
}

} // namespace mdm::packing

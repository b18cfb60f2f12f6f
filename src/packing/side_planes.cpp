// The sides of a space as planes that touch it from within. A box has four. A cylinder has 256, whose edges
// are on it: what is inside of all planes is inside of the cylinder, and spheres roll on planes as they do
// in a box. Directions are made by halving angles with square roots, so that they are the same on every
// machine.

#include "packing/side_planes.hpp"

namespace mdm::packing {
namespace {

/// Directions around the axis, by halving angles: the same on every machine.
std::vector<Vector3> directions_around() {
  constexpr int halvings = 6; // 256 directions: sides are 8e-5 of the radius inside of the cylinder at most
  std::vector<Vector3> around{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (int i = 0; i < halvings; ++i) {
    std::vector<Vector3> finer;
    for (std::size_t k = 0; k < around.size(); ++k) {
      finer.push_back(around[k]);
      finer.push_back(direction(around[k] + around[(k + 1) % around.size()]));
    }
    around = std::move(finer);
  }
  return around;
}

} // namespace

std::vector<SidePlane> side_planes(const SphereSpace &space) {
  const auto a = static_cast<double>(space.a), b = static_cast<double>(space.b);
  if (space.sides == Sides::periodic)
    return {};
  if (space.sides == Sides::walls)
    return {{{1, 0, 0}, 0}, {{-1, 0, 0}, -a}, {{0, 1, 0}, 0}, {{0, -1, 0}, -b}};
  const Vector3 axis{a / 2, a / 2, 0};
  const std::vector<Vector3> around = directions_around();
  // The middle of a side is at the cosine of half the angle between its edges: that of the next halving.
  const double cosine = length(around[0] + around[1]) / 2;
  std::vector<SidePlane> planes;
  for (const Vector3 &outwards : around) {
    const Vector3 normal = -1 * outwards;
    planes.push_back({normal, dot(axis, normal) - a / 2 * cosine});
  }
  return planes;
}

} // namespace mdm::packing

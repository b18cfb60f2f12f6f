// Spheres by their places, for a deposit that grows. Radii within a factor of 2 share a level with cells of
// about their size, so that small spheres among large ones are found as quickly as among themselves. To
// find what is near a sphere, each level looks at the columns of cells in its reach, and leaves out those
// rows that hold no centre since it would be too near: centres are in a shell. Invariant: every sphere of
// the shell is handed on, and each of its images where the space is periodic.

#include "packing/sphere_grid.hpp"

namespace mdm::packing {

SphereGrid::SphereGrid(std::vector<double> radii, const SphereSpace &space)
    : space_(space), smallest_(*std::min_element(radii.begin(), radii.end())), radii_(std::move(radii)),
      centres_(radii_.size()), next_(radii_.size(), none) {
  std::vector<double> numbers;
  for (const double r : radii_) {
    const std::size_t n = level_of(r);
    if (n >= levels_.size()) {
      levels_.resize(n + 1);
      numbers.resize(n + 1);
    }
    levels_[n].least = std::min(levels_[n].least, r);
    levels_[n].greatest = std::max(levels_[n].greatest, r);
    ++numbers[n];
  }
  for (std::size_t n = 0; n < levels_.size(); ++n)
    make_cells(levels_[n], numbers[n]);
}

std::size_t SphereGrid::level_of(double radius) const {
  std::size_t level = 0;
  for (double limit = 2 * smallest_; limit < radius; limit *= 2)
    ++level;
  return level;
}

void SphereGrid::make_cells(Level &level, double number) const {
  // However few spheres of the level there are, a deposit as high as wide has no more cells than some of
  // their number.
  const double a = static_cast<double>(space_.a), b = static_cast<double>(space_.b);
  constexpr double wider = 1.125;
  double side = std::max(2 * level.greatest, 1.0);
  while (side * side * side * (4 * number + 64) < a * b * std::max(a, b))
    side *= wider;
  const std::array<double, 2> wide{a, b};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    level.n[axis] = std::max<std::int64_t>(1, static_cast<std::int64_t>(wide[axis] / side));
    level.cell[axis] = wide[axis] / static_cast<double>(level.n[axis]);
  }
  level.cell[2] = std::floor(side);
}

std::int64_t SphereGrid::cell_of(const Level &level, std::size_t axis, double x) const {
  return std::min(static_cast<std::int64_t>(std::floor(x / level.cell[axis])), level.n[axis] - 1);
}

void SphereGrid::add(std::int32_t id, const Vector3 &centre) {
  Level &level = levels_[level_of(radius(id))];
  const auto row = static_cast<std::int64_t>(std::floor(centre.z / level.cell[2]));
  if (row >= level.n[2]) {
    level.n[2] = row + 1;
    level.first.resize(static_cast<std::size_t>(level.n[0] * level.n[1] * level.n[2]), none);
  }
  const std::int64_t cell =
      (row * level.n[1] + cell_of(level, 1, centre.y)) * level.n[0] + cell_of(level, 0, centre.x);
  std::int32_t &first = level.first[static_cast<std::size_t>(cell)];
  centres_[static_cast<std::size_t>(id)] = centre;
  next_[static_cast<std::size_t>(id)] = first;
  first = id;
}

} // namespace mdm::packing

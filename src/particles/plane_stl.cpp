#include "particles/settle_model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// A rectangle at height 0, of two triangles that face downwards.
std::string rectangle_stl(const char *name, double west, double south, double east, double north) {
  const std::array<std::array<double, 2>, 4> corners = {
      {{west, south}, {east, south}, {east, north}, {west, north}}};
  std::string text = fmt::format("solid {}\n", name);
  for (const std::array<std::size_t, 3> &triangle : {std::array<std::size_t, 3>{0, 2, 1}, {0, 3, 2}}) {
    text += "facet normal 0 0 -1\nouter loop\n";
    for (const std::size_t i : triangle)
      text += fmt::format("vertex {:.12g} {:.12g} 0\n", corners.at(i)[0], corners.at(i)[1]);
    text += "endloop\nendfacet\n";
  }
  return text + fmt::format("endsolid {}\n", name);
}

} // namespace

std::string lid_stl(const ModelBox &box) {
  // A little smaller than the box: LIGGGHTS loses corners on its sides.
  constexpr double shrink = 1e-6;
  const double x = box.x * shrink, y = box.y * shrink;
  return rectangle_stl("lid", x, y, box.x - x, box.y - y);
}

std::string wall_stl(const ModelBox &box) {
  const double half = wall_by_box / 2 * std::max({box.x, box.y, box.z});
  return rectangle_stl("wall", -half, -half, half, half);
}

} // namespace mdm

#include "particles/settle_model.hpp"

#include <fmt/core.h>

#include <array>

namespace mdm {

std::string lid_stl(const ModelBox &box) {
  // A little smaller than the box: LIGGGHTS loses corners on its sides.
  constexpr double shrink = 1e-6;
  const double x = box.x * shrink, y = box.y * shrink;
  const std::array<std::array<double, 2>, 4> corners = {
      {{x, y}, {box.x - x, y}, {box.x - x, box.y - y}, {x, box.y - y}}};
  std::string text = "solid lid\n";
  for (const std::array<std::size_t, 3> &triangle : {std::array<std::size_t, 3>{0, 2, 1}, {0, 3, 2}}) {
    text += "facet normal 0 0 -1\nouter loop\n";
    for (const std::size_t i : triangle)
      text += fmt::format("vertex {:.12g} {:.12g} 0\n", corners.at(i)[0], corners.at(i)[1]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid lid\n";
}

} // namespace mdm

#include "plot/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mdm {

std::string palette_color(double share) {
  using Color = std::array<double, 3>; // red, green and blue
  static constexpr std::array<Color, 9> nodes = {{{0x44, 0x01, 0x54},
                                                  {0x47, 0x2c, 0x7a},
                                                  {0x3b, 0x51, 0x8b},
                                                  {0x2c, 0x71, 0x8e},
                                                  {0x21, 0x90, 0x8d},
                                                  {0x27, 0xad, 0x81},
                                                  {0x5c, 0xc8, 0x63},
                                                  {0xaa, 0xdc, 0x32},
                                                  {0xfd, 0xe7, 0x25}}};
  constexpr double last = nodes.size() - 1;
  const double at = last * std::clamp(std::isnan(share) ? 0 : share, 0.0, 1.0);
  const auto node = static_cast<std::size_t>(std::min(std::floor(at), last - 1));
  const double part = at - static_cast<double>(node);
  const auto mixed = [&](std::size_t i) {
    return static_cast<unsigned>(
        std::lround(nodes.at(node).at(i) * (1 - part) + nodes.at(node + 1).at(i) * part));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

const char *series_color(std::size_t i) {
  static constexpr std::array<const char *, series_colors> colors = {
      "#1f4e79", "#c0392b", "#7d3c98", "#b9770e", "#0e7c86", "#5d6d7e", "#6e2c00", "#c2185b"};
  return colors.at(i % series_colors);
}

} // namespace mdm

#include "particles/lammps_units.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <array>

namespace mdm {

void take_units(std::string_view style, ParticleSource &source) {
  // https://docs.lammps.org/units.html
  const std::array<std::pair<std::string_view, StatedUnit>, 4> styles = {
      {{"si", {"m", 1000}},
       {"cgs", {"cm", 10}},
       {"micro", {"um", ratio(1, 1000)}},
       {"nano", {"nm", ratio(1, 1000000)}}}};
  for (const auto &[name, unit] : styles)
    if (style == name) {
      source.take_unit(unit, fmt::format("units {}", name));
      return;
    }
  source.refuse(
      fmt::format("the units are {}, whose lengths are not read: write the file with units si, cgs, "
                  "micro or nano, or convert its lengths and leave the word out",
                  in_quotes(style)));
}

} // namespace mdm

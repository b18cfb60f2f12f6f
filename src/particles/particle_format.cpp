#include "particles/particle_format.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 19> format_names = {"csv",         "answer",      "xyzr",
                                                           "lammps-data", "lammps-dump", "liggghts-dump",
                                                           "vtk",         "diameters",   "liggghts-insertion",
                                                           "mercurydpm",  "extxyz",      "esys",
                                                           "lethe",       "kratos",      "dem-engine",
                                                           "musen",       "gsd",         "phasicflow",
                                                           "vtp"};

} // namespace

std::string_view name(ParticleFormat format) {
  return format_names.at(static_cast<std::size_t>(format));
}

std::optional<ParticleFormat> parse_particle_format(std::string_view name) {
  const auto is_name = [name](std::string_view known) {
    return std::equal(name.begin(), name.end(), known.begin(), known.end(),
                      [](char theirs, char ours) { return lower(theirs) == ours; });
  };
  const auto *const found = std::find_if(format_names.begin(), format_names.end(), is_name);
  if (found == format_names.end())
    return std::nullopt;
  return static_cast<ParticleFormat>(found - format_names.begin());
}

std::string particle_format_names() {
  std::string text;
  for (const std::string_view name : format_names)
    text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

} // namespace mdm

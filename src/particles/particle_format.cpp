#include <mdm/particles/particle_format.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 14> format_names = {"csv",         "answer",      "xyzr",
                                                           "lammps-data", "lammps-dump", "liggghts-dump",
                                                           "vtk",         "diameters",   "liggghts-insertion",
                                                           "mercurydpm",  "extxyz",      "esys",
                                                           "lethe",       "kratos"};
constexpr std::array<std::string_view, 4> unit_names = {"mm", "um", "m", "in"};

/// The enumerator at the place of the name.
template <typename Enum, std::size_t n>
std::optional<Enum> find(const std::array<std::string_view, n> &names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

} // namespace

std::string_view name(ParticleFormat format) {
  return format_names.at(static_cast<std::size_t>(format));
}

std::optional<ParticleFormat> parse_particle_format(std::string_view name) {
  return find<ParticleFormat>(format_names, name);
}

std::string particle_format_names() {
  std::string text;
  for (const std::string_view name : format_names)
    text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string_view name(LengthUnit unit) {
  return unit_names.at(static_cast<std::size_t>(unit));
}

std::optional<LengthUnit> parse_length_unit(std::string_view name) {
  return find<LengthUnit>(unit_names, name);
}

LengthUnit length_unit(SizeUnit unit) {
  return parse_length_unit(name(unit)).value();
}

Rational in_mm(LengthUnit unit) {
  switch (unit) {
  case LengthUnit::um:
    return ratio(1, 1000);
  case LengthUnit::m:
    return 1000;
  case LengthUnit::in:
    return ratio(254, 10);
  case LengthUnit::mm:
    break;
  }
  return 1;
}

} // namespace mdm

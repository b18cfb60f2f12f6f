#include "particles/export_format.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// Bytes were measured with 97,336 particles of one size in contact with six others each, and rounded up.
/// Rates by tests/benchmark/engine_rates.py.
constexpr std::array<ExportFormat, export_format_count> writers = {
    {{ExportTo::liggghts, "liggghts", write_liggghts, nullptr, 1000, 5.4e6},
     {ExportTo::lammps, "lammps", nullptr, write_lammps_data, 1000, 4.7e6},
     {ExportTo::yade, "yade", nullptr, write_xyzr, 10000, 6.4e5},
     {ExportTo::mercurydpm, "mercurydpm", write_mercurydpm, nullptr, 0, 0},
     {ExportTo::vtk, "vtk", nullptr, write_vtk, 0, 0},
     {ExportTo::esys, "esys", nullptr, write_esys, 0, 0, false, false},
     {ExportTo::lethe, "lethe", nullptr, write_lethe, 0, 0, false, false},
     {ExportTo::kratos, "kratos", nullptr, write_kratos, 0, 0},
     {ExportTo::dem_engine, "dem-engine", nullptr, write_dem_engine, 0, 0, true, false},
     {ExportTo::musen, "musen", nullptr, write_musen, 0, 0, false, false},
     {ExportTo::phasicflow, "phasicflow", nullptr, write_phasicflow, 0, 0},
     {ExportTo::gsd, "gsd", nullptr, write_gsd, 0, 0, true, false},
     {ExportTo::extxyz, "extxyz", nullptr, write_extxyz, 0, 0},
     {ExportTo::pfc, "pfc", nullptr, write_pfc, 0, 0, false, false},
     {ExportTo::csv, "csv", write_size_csv, nullptr, 0, 0},
     {ExportTo::diameters, "diameters", write_diameters, nullptr, 0, 0}}};

} // namespace

const std::array<ExportFormat, export_format_count> &all_export_formats() {
  return writers;
}

const ExportFormat *find_export_format(std::string_view name) {
  const auto *const found = std::find_if(writers.begin(), writers.end(),
                                         [name](const ExportFormat &format) { return name == format.name; });
  return found == writers.end() ? nullptr : found;
}

Rational mass_error_of_floats() {
  return ratio(1, 5000000);
}

std::string export_format_names() {
  std::string text;
  for (const ExportFormat &format : writers)
    text += (text.empty() ? "" : ", ") + std::string(format.name);
  return text;
}

} // namespace mdm

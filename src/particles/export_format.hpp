#pragma once
/// \file
/// The formats that particles of a set are written in.

#include "particles/particle_writer.hpp"

#include <array>
#include <string>
#include <string_view>

namespace mdm {

/// A format; in the order of all_export_formats().
enum class ExportTo {
  liggghts,
  lammps,
  yade,
  mercurydpm,
  vtk,
  esys,
  lethe,
  kratos,
  dem_engine,
  musen,
  phasicflow,
  gsd,
  extxyz,
  pfc,
  csv,
  diameters
};

/// What is known of a format: it has sizes alone, or particles in their places.
struct ExportFormat {
  ExportTo id;
  const char *name; ///< for example `dem-engine`
  void (*write)(const ParticleSet &, const Sink &);
  void (*write_placed)(const Placement &, const Sink &); ///< null: sizes alone
  unsigned bytes;           ///< of the engine's memory for a particle; 0: not known
  double rate;              ///< grains by steps that the engine makes in a second of one core; 0: not known
  bool has_floats = false;  ///< sizes are read as floats, not as doubles
  bool has_comments = true; ///< there is room for a statement about masses
};

inline constexpr std::size_t export_format_count = 16;
/// All formats, in the order of the help.
const std::array<ExportFormat, export_format_count> &all_export_formats();

/// The format of that name, or null.
const ExportFormat *find_export_format(std::string_view name);

/// The relative error that masses may have where sizes are floats: that of a cube, three times that of a
/// float.
Rational mass_error_of_floats();

/// All names, separated by commas.
std::string export_format_names();

} // namespace mdm

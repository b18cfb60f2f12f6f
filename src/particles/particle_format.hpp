#pragma once
/// \file
/// Formats of particle files, and what their numbers mean.

#include "gradation/length.hpp"

#include <optional>
#include <string>

namespace mdm {

/// A format that particles are read from.
enum class ParticleFormat {
  csv, ///< header `size_mm,quantity` (or _um, _m, _in, _phi; or `sieve`), then a size and its quantity a row
  answer,        ///< mdm-answer-1, see answer_sample.hpp
  xyzr,          ///< `x y z r` a line, # comments: YADE's ymport.text
  lammps_data,   ///< data file of LAMMPS or LIGGGHTS, atom_style sphere
  lammps_dump,   ///< text dump of LAMMPS with a column radius or diameter
  liggghts_dump, ///< the same of LIGGGHTS
  vtk,           ///< legacy VTK in ASCII, POLYDATA or UNSTRUCTURED_GRID, with an array radius or diameter
  diameters,     ///< one diameter a line, # comments
  liggghts_insertion, ///< script of LIGGGHTS with an insertion of one template after the other, to running
                      ///< totals
  mercurydpm,         ///< cumulative number distribution below the heading that mdm export writes
  extxyz,             ///< extended XYZ with a radius among the `Properties=` of its second line: ASE, OVITO
  esys,               ///< ESyS-Particle: geometry (LSMGeometry), or snapshot `*_1.txt`
  lethe,              ///< Lethe: file of its insertion method `file`, `p_x; p_y; p_z; ...; diameters;`
  kratos,             ///< Kratos: model part (mdpa) of its DEM application, with NodalData RADIUS
  dem_engine, ///< DEM-Engine: CSV of spheres with r, or of clumps whose types are named r and the radius
  musen,      ///< MUSEN: scene as text, with its spheres and the materials of these
  gsd,        ///< GSD of HOOMD-blue, binary, with particles/diameter
  phasicflow, ///< PhasicFlow: particlesDict that mdm export writes, sizes without places
  vtp         ///< VTK's XML in ASCII, PolyData or UnstructuredGrid, with an array radius or diameter
};

/// `csv`, `answer`, `xyzr`, `lammps-data`, `lammps-dump`, `liggghts-dump`, `vtk`, `diameters`,
/// `liggghts-insertion`, `mercurydpm`, `extxyz`, `esys`, `lethe`, `kratos`, `dem-engine`, `musen`, `gsd`,
/// `phasicflow` or `vtp`.
std::string_view name(ParticleFormat format);
/// The format of that name, or nothing.
std::optional<ParticleFormat> parse_particle_format(std::string_view name);
/// All names, separated by commas.
std::string particle_format_names();

/// The meaning of a particle's size.
enum class SizeMeaning { radius, diameter };

} // namespace mdm

#pragma once
/// \file
/// Packings of discs as files for engines.

#include "packing/packing.hpp"
#include "particles/particle_format.hpp"
#include "text/sink.hpp"

namespace mdm {

/// Data file of LAMMPS, atom_style sphere, z = 0, in a box that is flat: for `dimension 2` and `fix
/// enforce2d`. Lengths of all files are in the unit, exact decimals; those of a packing that has no unit are
/// as they are. Densities are in kg per cube of that unit, of which LAMMPS makes masses as of spheres.
void write_packing_lammps(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

/// The same for LIGGGHTS, which has no second dimension: a slab as thick as the largest disc.
void write_packing_liggghts(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

/// `x y z r` a line for YADE's ymport.text, below comments that say how the discs are kept in their plane.
void write_packing_yade(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

/// `radius x y` a line below comments, for numpy.loadtxt and rigidDisk of LMGC90.
void write_packing_lmgc90(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

/// Legacy VTK 3.0 in ASCII, POLYDATA with VERTICES and radii.
void write_packing_vtk(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

/// `x,y,radius,left,right` a row, the unit in the names; supports as in the packing's file.
void write_packing_csv(const Packing &packing, SizeUnit unit, const Rational &density, const Sink &out);

} // namespace mdm

#pragma once
/// \file
/// Particle files, written.

#include "particles/placement.hpp"
#include "text/sink.hpp"

namespace mdm {

/// The gradation's name, N, unit and density, in one line of printable text.
std::string title(const ParticleSet &set);
/// The exactness of the masses, and law_statement(), in one line.
std::string mass_statement(const ParticleSet &set);
/// The mass law if it is not that of spheres, behind a space; else empty.
std::string law_statement(const ParticleSet &set);
/// set.mass_error() rounded up to three digits.
std::string stated_error(const ParticleSet &set);
/// The head of files that have comments: both lines, each behind `# `.
std::string comment_lines(const ParticleSet &set);

/// `size_<unit>,quantity` below comments: a diameter and its quantity a row, ascending.
void write_size_csv(const ParticleSet &set, const Sink &out);

/// One diameter a line below comments, descending.
void write_diameters(const ParticleSet &set, const Sink &out);

/// Commands of LIGGGHTS that insert the particles into the region `mdm_region`, class by class, the largest
/// first, to exact counts, and stop with a message where a count is not reached.
/// \throws InputError if there are more particles than LIGGGHTS counts
void write_liggghts(const ParticleSet &set, const Sink &out);

/// Cumulative number distribution for MercuryDPM's setPSDFromCSV: `radius,cumulative` a row, radii twice. It
/// cannot carry counts: MercuryDPM draws at random.
void write_mercurydpm(const ParticleSet &set, const Sink &out);

/// Data file of LAMMPS and LIGGGHTS, atom_style sphere, one type.
void write_lammps_data(const Placement &start, const Sink &out);
/// The same with a type for each class of the set, 1 for the smallest, and one more for walls.
void write_lammps_data_of_classes(const Placement &start, const Sink &out);

/// The same of discs in a plane, one type, all two thirds of the smallest diameter long: the plane is x y, y
/// upwards, in a box that is flat in z. Densities are such that spheres have the masses of the discs.
void write_lammps_data_of_discs(const Placement &start, const Sink &out);

/// `x y z r` a line below comments, for YADE's ymport.text.
void write_xyzr(const Placement &start, const Sink &out);

/// Geometry of ESyS-Particle (LSMGeometry 1.2); tags are the numbers of the classes.
void write_esys(const Placement &start, const Sink &out);

/// File of Lethe's insertion method `file`.
void write_lethe(const Placement &start, const Sink &out);

/// Model part (mdpa) of Kratos' DEM application: nodes, elements SphericParticle3D of properties 0, radii.
void write_kratos(const Placement &start, const Sink &out);

/// CSV of clumps that DEM-Engine reads (ReadClumpXyzFromCsv); their types, one a size, are named r and the
/// radius, which LoadSphereType and AssignName then give it. It reads no comments.
void write_dem_engine(const Placement &start, const Sink &out);

/// Scene of MUSEN as text: a material a class, which has the density alone; the box is the domain.
void write_musen(const Placement &start, const Sink &out);

/// Table of PFC's balls in CSV: number, place, radius, and the number of the class as PFC_BALL_ATTR.
void write_pfc(const Placement &start, const Sink &out);

/// particlesDict of PhasicFlow: a shape a size, by ranges of the particles, which are in the file
/// `positions`.
void write_phasicflow(const Placement &start, const Sink &out);
/// Its caseSetup/shapes: the sizes, of the material `grains`.
void write_phasicflow_shapes(const Placement &start, const Sink &out);
/// Its file `positions`, `x y z` a line.
void write_phasicflow_positions(const Placement &start, const Sink &out);

/// GSD of HOOMD-blue, of one frame: the class is the type, named by its number; masses as of spheres; places
/// from the middle of the box, as floats. \pre the set has floats
void write_gsd(const Placement &start, const Sink &out);

/// Extended XYZ for ASE and OVITO: species X, the number of the class as type, place, radius, id.
void write_extxyz(const Placement &start, const Sink &out);

/// Legacy VTK 3.0 in ASCII, POLYDATA with VERTICES, radius, and the number of the class.
void write_vtk(const Placement &start, const Sink &out);

} // namespace mdm

#include "ask/particle_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

const std::vector<OptionRow<ParticleTexts>> ParticleTexts::options = {
    {"from", "FORMAT", OptionKind::text,
     "format of SAMPLE: csv (size_mm,quantity; also size_um, size_m, size_in, size_phi or sieve), "
     "answer (JSON of mdm solve), xyzr (x y z r a line), lammps-data, lammps-dump, liggghts-dump, vtk, vtp "
     "(VTK's XML in ASCII), diameters (one a line), liggghts-insertion, mercurydpm (scripts and "
     "distributions of mdm export), "
     "extxyz (extended XYZ of ASE and OVITO with radius among its Properties), esys (geometry or snapshot "
     "of ESyS-Particle with one worker), lethe (insertion file), kratos (mdpa), musen (scene as text), gsd "
     "(HOOMD-blue), phasicflow (particlesDict of mdm export) or dem-engine (CSV of spheres, or of clumps "
     "whose types are named r and the radius, as r0.00025); told by the content if left out",
     &ParticleTexts::from},
    {"radius", "", OptionKind::flag, "sizes are radii, whatever their name", &ParticleTexts::radius},
    {"diameter", "", OptionKind::flag, "sizes are diameters, whatever their name", &ParticleTexts::diameter},
    {"size-column", "NAME", OptionKind::text,
     "the column of sizes in a dump or CSV, or array in VTK, where it has a name of its own, such as c_r; "
     "with --radius or "
     "--diameter; other columns that are not known are then passed over",
     &ParticleTexts::size_column},
    {"size-unit", "UNIT", OptionKind::text,
     "unit of SAMPLE: mm, um, m or in; if left out what the file states, else m for LAMMPS, LIGGGHTS, "
     "VTK, ESyS-Particle, Lethe, Kratos, MUSEN, GSD, PhasicFlow and DEM-Engine if left out, for xyzr, "
     "extxyz and diameters that of the gradation (mm for size_in, size_phi and sieve)",
     &ParticleTexts::size_unit},
    {"timestep", "T", OptionKind::number,
     "the timestep of a dump or of GSD, instead of the last; of several of that number the last",
     &ParticleTexts::timestep}};

ParticleOptions ParticleTexts::reading(SizeUnit target) const {
  ParticleOptions o;
  o.target = target;
  o.can_choose_timestep = true;
  o.says_otherwise = option("radius") + ", " + option("diameter") + " and " + option("size-unit") + " say";
  if (from)
    o.format = parse_particle_format(*from);
  if (from && !o.format)
    throw InputError(option("from") + ": " + in_quotes(*from) + " is no format: use one of " +
                     particle_format_names());
  if (radius && diameter)
    throw InputError(option("radius") + " and " + option("diameter") + ": give one of them");
  if (radius || diameter)
    o.meaning = radius ? SizeMeaning::radius : SizeMeaning::diameter;
  if (size_column && !o.meaning)
    throw InputError(option("size-column") + ": say what its sizes are with " + option("radius") + " or " +
                     option("diameter"));
  o.size_column = size_column;
  if (size_unit)
    o.unit = size_unit_of("size-unit", *size_unit);
  if (timestep)
    o.timestep = natural("timestep", *timestep, 0);
  return o;
}

ParticleOptions read_as_gradation(const OptionText &unit) {
  ParticleOptions o;
  o.says_otherwise = option("unit") + " says";
  o.unit_option = "unit";
  if (unit)
    o.unit = size_unit_of("unit", *unit);
  return o;
}

} // namespace mdm

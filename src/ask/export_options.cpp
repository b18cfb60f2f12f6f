#include "ask/export_options.hpp"

#include "ask/option_values.hpp"
#include "text/file_names.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
const ExportFormat &export_format(const ExportTexts &c) {
  const ExportFormat *const found = find_export_format(c.to);
  if (found == nullptr)
    throw InputError(option("to") + ": " + in_quotes(c.to) + " is no format: use one of " +
                     export_format_names());
  return *found;
}

std::vector<FileBeside> files_beside(const ExportTexts &c, const ExportFormat &format) {
  if (format.id != ExportTo::phasicflow)
    return {};
  if (c.out == "-")
    throw InputError("-o: PhasicFlow reads two more files, which lie beside it: say where with -o FILE");
  return {{c.out + "-shapes", write_phasicflow_shapes}, {c.out + "-positions", write_phasicflow_positions}};
}

Rational physical(const std::string &name, const std::string &text) {
  constexpr unsigned most_exponent = 30;
  const Rational most = power_of_ten(most_exponent);
  const Rational r = positive(name, text);
  if (r > most || r * most < 1)
    throw InputError(option(name) + ": " + in_quotes(text) +
                     " is not from 1e-30 to 1e30: give it in SI units");
  return r;
}

Rational pressure(const std::string &name, const std::string &text) {
  constexpr std::array<std::pair<std::string_view, unsigned>, 4> units = {
      {{"kPa", 3}, {"MPa", 6}, {"GPa", 9}, {"Pa", 0}}};
  for (const auto &[unit, exponent] : units)
    if (text.ends_with(unit)) {
      const std::string_view number = trimmed(std::string_view(text).substr(0, text.size() - unit.size()));
      return physical(name, std::string(number)) * power_of_ten(exponent);
    }
  return physical(name, text);
}

std::uint64_t export_seed(const ExportTexts &c) {
  return seed64("seed", c.seed.value_or("1"));
}

Elasticity elasticity(const ExportTexts &c) {
  Elasticity e;
  if (c.young)
    e.young = pressure("young", *c.young);
  if (c.poisson)
    e.poisson = not_negative("poisson", *c.poisson);
  if (e.poisson > ratio(1, 2))
    throw InputError(option("poisson") + ": " + in_quotes(*c.poisson) +
                     " is above 0.5, which no material has");
  return e;
}

namespace {

/// True if a model takes the option, too: the specimen's shape and void ratio.
bool is_of_model(const ExportTexts &c, const std::string &name) {
  return c.model && (name == "specimen" || name == "void-ratio");
}

bool is_cylinder_asked(const ExportTexts &c) {
  return c.sides == "cylinder" || (!c.box && c.solve.specimen && c.solve.specimen->rfind("cylinder", 0) == 0);
}

/// An option that a model alone takes, if one is given.
const char *option_of_model(const ExportTexts &c) {
  const std::array<std::pair<bool, const char *>, 14> options = {
      {{c.steps.has_value(), "steps"},
       {c.dimension.has_value(), "dimension"},
       {c.pressure.has_value(), "stress"},
       {c.tolerance.has_value(), "target-tolerance"},
       {c.axial_strain.has_value(), "axial-strain"},
       {c.constant.has_value(), "constant"},
       {c.friction.has_value(), "friction"},
       {c.friction_while_filling.has_value(), "friction-while-filling"},
       {c.rolling_friction.has_value(), "rolling-friction"},
       {c.surface_energy.has_value(), "surface-energy"},
       {c.cohesion_energy_density.has_value(), "cohesion-energy-density"},
       {c.material.has_value(), "material"},
       {c.periodic, "periodic"},
       {c.unjammed, "unjammed"}}};
  const auto *const found =
      std::find_if(options.begin(), options.end(), [](const auto &given) { return given.first; });
  return found == options.end() ? nullptr : found->second;
}

void check_model(const ExportTexts &c) {
  if (c.unit && c.unit != "m")
    throw InputError(option("unit") + ": models are in SI units: leave it out");
  const bool has_target = c.solve.void_ratio || c.pressure;
  if (c.solve.void_ratio && c.pressure && !c.is_triaxial())
    throw InputError(option("void-ratio") + " and " + option("stress") +
                     ": the density follows from either: give one of them");
  if (c.tolerance && !has_target)
    throw InputError(option("target-tolerance") + ": it is of " + option("void-ratio") + " or " +
                     option("stress") + ": give one of them");
  if (c.solve.specimen && c.solve.solids_volume)
    throw InputError(option("specimen") + " and " + option("solids-volume") + ": give one of them");
  if (c.material && c.types == "one")
    throw InputError(option("types") + " one: " + option("material") +
                     " gives each class a type of its own: leave one of them out");
  if (c.material && c.young)
    throw InputError(option("young") + ": " + option("material") + " has that of each class: leave it out");
  if (c.start == "layers" && is_cylinder_asked(c))
    throw InputError(option("start") +
                     " layers: they have walls, and the specimen is a cylinder: take mixed or deposit");
}

/// A model of discs.
void check_discs(const ExportTexts &c) {
  const std::string discs = option("dimension") + " 2: ";
  if (c.to == "liggghts")
    throw InputError(discs + "LIGGGHTS has no second dimension: use " + option("to") + " lammps or yade");
  if (c.moves_faces() || c.sides || c.solve.specimen)
    throw InputError(discs + "discs settle between two walls: leave " +
                     (c.is_triaxial() ? option("model") + " triaxial"
                      : c.periodic    ? option("periodic")
                      : c.sides       ? option("sides")
                                      : option("specimen")) +
                     " out");
  if (c.start && c.start != "mixed")
    throw InputError(discs + "discs start mixed: leave " + option("start") + " out");
  if (c.rolling_friction || c.surface_energy || c.material)
    throw InputError(discs + "discs are of one material without rolling friction and cohesion: leave " +
                     option(c.material           ? "material"
                            : c.rolling_friction ? "rolling-friction"
                                                 : "surface-energy") +
                     " out");
  if (c.types == "class")
    throw InputError(discs + "discs are of one type: leave " + option("types") + " out");
}

void check_triaxial(const ExportTexts &c) {
  const std::string model = option("model") + " triaxial: ";
  if (!c.pressure)
    throw InputError(model + "say the pressure before the shear by " + option("stress") + ", in Pa; a " +
                     option("void-ratio") + " may be beside it");
  if (c.steps)
    throw InputError(option("steps") + ": nothing settles in a model that is triaxial: leave it out");
}

/// \pre the model's box has six faces that move
void check_moved_box(const ExportTexts &c) {
  const std::string cell = c.periodic ? option("periodic") : option("model") + " triaxial";
  if (c.periodic && c.to == "liggghts")
    throw InputError(cell + ": LIGGGHTS has no model of such a box: use " + option("to") + " lammps or yade");
  if (is_cylinder_asked(c))
    throw InputError(cell + ": its box has six faces that move, a cylinder has not: give " +
                     option("specimen") + " box:AxBxC, or leave it out");
  if (c.sides)
    throw InputError(cell + ": it is " + (c.has_six_walls() ? "between six walls" : "periodic on all sides") +
                     ": leave " + option("sides") + " out");
  if (c.has_six_walls() && c.types == "one")
    throw InputError(option("types") +
                     ": each class has a type where walls have one of their own: leave it out");
  if (c.start && c.start != "mixed" && c.start != "as-is")
    throw InputError(cell + ": grains start mixed, and nothing settles: leave " + option("start") + " out");
  if (!c.solve.void_ratio && !c.pressure)
    throw InputError(cell + ": nothing settles without gravity: say by " + option("void-ratio") + " or " +
                     option("stress") + " how far the box is compressed");
}

void check_sides(const ExportTexts &c) {
  if (!c.sides)
    return;
  if (c.sides != "walls" && c.sides != "cylinder" && c.sides != "periodic")
    throw InputError(option("sides") + ": " + in_quotes(*c.sides) +
                     " is neither walls nor cylinder nor periodic");
  const bool is_deposit = c.start == "deposit" || c.start == "as-is";
  if (c.sides == "periodic" && !is_deposit)
    throw InputError(option("sides") + ": a deposit alone can be periodic: give " + option("start") +
                     " deposit, or leave " + option("sides") + " out");
  if (!is_deposit && c.start != "mixed" && !c.model)
    throw InputError(option("sides") + ": layers have the walls of a box: give " + option("start") +
                     " mixed or deposit, or leave " + option("sides") + " out");
  if (c.sides == "periodic" && c.model && c.to == "yade")
    throw InputError(
        option("sides") +
        ": models of YADE have walls on all sides or on none: leave it out, or take lammps or liggghts");
}

} // namespace

void check_export(const ExportTexts &c, const ExportFormat &format) {
  c.solve.check_source(c.file, c.reading.given(), "export");
  if ((c.axial_strain || c.constant) && !c.is_triaxial())
    throw InputError(option(c.axial_strain ? "axial-strain" : "constant") +
                     ": what is settled is not sheared: give " + option("model") + " triaxial");
  if (const char *const name = option_of_model(c); name != nullptr && !c.model)
    throw InputError(option(name) + " is for a model: give " + option("model") + " settle too");
  if (c.model)
    check_model(c);
  if (c.has_discs())
    check_discs(c);
  if (c.is_triaxial())
    check_triaxial(c);
  if (c.moves_faces())
    check_moved_box(c);
  if (c.start && c.start != "layers" && c.start != "mixed" && c.start != "deposit" && c.start != "as-is")
    throw InputError(option("start") + ": " + in_quotes(*c.start) +
                     " is neither layers nor mixed nor deposit nor as-is");
  if (c.start == "as-is" && (c.box || c.solve.specimen))
    throw InputError(option(c.box ? "box" : "specimen") + ": " + option("start") +
                     " as-is has the box of its file: leave it out");
  if (c.types && c.types != "class" && c.types != "one")
    throw InputError(option("types") + ": " + in_quotes(*c.types) + " is neither one nor class");
  if (c.types == "class" && c.to != "lammps" && !c.model)
    throw InputError(option("types") + ": " + std::string(format.name) + " has no types here: leave it out");
  if (format.write_placed == nullptr && c.start && !c.model)
    throw InputError(std::string(option("start") + ": ") + format.name + " has no places here: leave it out");
  check_sides(c);
  const bool has_no_places = format.write_placed == nullptr && !c.model;
  if (has_no_places && (c.box || (c.seed && !c.spread)))
    throw InputError(std::string(c.box ? option("box") : option("seed")) + ": " + format.name +
                     " has sizes without places: leave it out");
}

void check_export_of_packing(const ExportTexts &c) {
  if (c.box || c.seed || c.start || c.sides || c.model || option_of_model(c) != nullptr || c.types ||
      c.young || c.poisson || c.mass_error || c.spread || c.reading.is_given() || !c.solving.empty() ||
      c.particles.say_sizes() || c.particles.timestep)
    throw InputError("a packing has its places and sizes: leave out options but " + option("to") + ", " +
                     option("unit") + ", " + option("density") + " and -o");
}

ParticleSetOptions set_options(const ExportTexts &c, bool has_floats) {
  ParticleSetOptions options;
  if (c.unit)
    options.unit = size_unit_of("unit", *c.unit);
  if (c.density)
    options.density = physical("density", *c.density);
  options.has_floats = has_floats;
  if (has_floats)
    options.most_mass_error = mass_error_of_floats();
  if (c.mass_error)
    options.most_mass_error = positive("mass-error", *c.mass_error);
  return options;
}

/// A specimen sets the number of particles where its void ratio is known; a model takes either alone.
SolveTexts texts_of_solving(const ExportTexts &c) {
  SolveTexts flags = c.solve;
  if (c.model && !(flags.specimen && flags.void_ratio))
    flags.specimen = flags.void_ratio = std::nullopt;
  return flags;
}

void refuse_options_of_solving(const ExportTexts &c, const char *what) {
  for (const std::string &name : c.solving)
    if (name != "law" && !is_of_model(c, name))
      throw InputError(fmt::format("{}: {} in {} is solved already: leave it out, or export the gradation",
                                   option(name), what, printable(shown_name(*c.file))));
}

std::optional<std::string> verify_options(const ExportTexts &c) {
  if (!c.file)
    return std::nullopt;
  std::string options;
  const auto add = [&options](const char *name, const OptionText &value) {
    if (value)
      options += std::string(" --") + name + " " + *value;
  };
  add("law", c.solve.law);
  add("size-factor", c.solve.size_factor);
  add("cut-below", c.solve.cut_below);
  add("pan-size", c.solve.pan_size);
  return options + c.reading.words();
}

const std::vector<OptionRow<ExportTexts>> ExportTexts::options = {
    {"unit", "UNIT", OptionKind::text, "unit of lengths in the file: m (default), mm, um or in",
     &ExportTexts::unit},
    {"gradation", "GRADATION", OptionKind::file,
     "whose classes the particles of FILE are in, where it is a file of particles: their numbers, materials "
     "and "
     "densities; without it a class has sizes up to 1.41 times its smallest",
     &ExportTexts::gradation},
    {"density", "RHO", OptionKind::number,
     "of the grains in kg/m^3 (2650); a class's factor, where there is one, multiplies it",
     &ExportTexts::density},
    {"mass-error", "EPS", OptionKind::number,
     "relative error of the mass of a class that rounded sizes may make (1e-9; 2e-7 for gsd and "
     "dem-engine, "
     "which have floats)",
     &ExportTexts::mass_error},
    {"yes-huge", "", OptionKind::flag, "more than 10000000 particles are wanted", &ExportTexts::yes_huge},
    {"yes-units", "", OptionKind::flag,
     "sizes below 1 um and boxes above 100 m are right: the units are no mistake", &ExportTexts::yes_units}};

const std::vector<OptionRow<ParticleTexts>> ExportTexts::particle_options = {
    {"size-unit", "UNIT", OptionKind::text, "unit of FILE where it is a file of particles: as in mdm verify",
     &ParticleTexts::size_unit},
    {"size-column", "NAME", OptionKind::text,
     "its column of sizes where that has a name of its own, such as c_r: as in mdm verify",
     &ParticleTexts::size_column},
    {"radius", "", OptionKind::flag, "its sizes are radii, whatever their name", &ParticleTexts::radius},
    {"diameter", "", OptionKind::flag, "its sizes are diameters, whatever their name",
     &ParticleTexts::diameter},
    {"timestep", "T", OptionKind::number, "its timestep, instead of the last: as in mdm verify",
     &ParticleTexts::timestep}};

const std::vector<OptionRow<ExportTexts>> ExportTexts::start_options = {
    {"box", "AxB[xC]", OptionKind::text,
     "footprint of the start, and its height, in the answer's unit (lammps, yade, vtk, models); without "
     "it the specimen's, a square in it for a cylinder, or a square that makes the start as high "
     "as wide",
     &ExportTexts::box},
    {"start", "START", OptionKind::text,
     "layers, a slab for each class; mixed, at random places of a higher box; or deposit, a dense "
     "one, dropped and rolled to rest (lammps, yade, vtk, models; layers, but mixed for a model of up "
     "to 1000000 particles, and a deposit for one with a density to reach); as-is, where the particles of "
     "FILE lie, the default where it has their places",
     &ExportTexts::start},
    {"sides", "SIDES", OptionKind::text,
     "of the start's box: walls; cylinder, in a --box as long as wide, the default for such a "
     "specimen but "
     "in layers; or periodic, of a deposit, repeated in x and y (models: lammps, liggghts)",
     &ExportTexts::sides},
    {"seed", "K", OptionKind::number, "of the places of the start, and of a spread's sizes (1)",
     &ExportTexts::seed}};

const std::vector<OptionRow<ExportTexts>> ExportTexts::model_options = {
    {"model", "MODEL", OptionKind::text,
     "settle: a complete model that lets the particles settle in the specimen, for liggghts, lammps or "
     "yade, and beside it the files that it reads; with --void-ratio or --stress it compacts them; triaxial: "
     "a drained triaxial test, for lammps or yade in a periodic box, for liggghts between six walls without "
     "friction: isotropic "
     "compression to --stress, and to --void-ratio by friction where that is given, then shear; its log, "
     "FILE-triaxial.csv with compression positive, is drawn by mdm plot",
     &ExportTexts::model},
    {"dimension",
     "D",
     OptionKind::text,
     "3, spheres (the default), or 2, discs of one length: a model in which they settle between two walls; "
     "masses are by --law power:2, and --box is width x height (lammps, yade)",
     &ExportTexts::dimension,
     {"2", "3"}},
    {"steps", "N", OptionKind::number,
     "time steps of the model while particles settle, at most; without it five times as long as a "
     "fall from the top of the box",
     &ExportTexts::steps},
    {"stress", "S", OptionKind::number,
     "pressure in Pa (or as 100kPa, 5MPa) to which the model compacts the particles, by a lid or the faces "
     "of a "
     "--periodic box; --void-ratio is another such target; of a triaxial model the pressure before the "
     "shear, which sigma_3 or p keeps: see --constant",
     &ExportTexts::pressure},
    {"axial-strain", "E", OptionKind::number, "of a triaxial model at its end, 1 - h/h0, up to 0.5 (0.2)",
     &ExportTexts::axial_strain},
    {"constant", "STRESS", OptionKind::text,
     "while a triaxial model is sheared: sigma_3, on its sides (default), or p, the mean (sigma_1 + 2 "
     "sigma_3)/3",
     &ExportTexts::constant},
    {"target-tolerance", "T", OptionKind::number, "of --void-ratio, or of --stress as a part of it (0.01)",
     &ExportTexts::tolerance},
    {"friction", "MU", OptionKind::number, "coefficient of friction of a model's particles (0.5)",
     &ExportTexts::friction},
    {"friction-while-filling", "MU", OptionKind::number,
     "the same while they settle and are compacted, and of walls: less makes denser beds (--friction)",
     &ExportTexts::friction_while_filling},
    {"rolling-friction", "MU", OptionKind::number,
     "coefficient of rolling friction of a model's particles and walls: the most moment of a contact over "
     "its normal "
     "force and effective radius; none without it (liggghts, lammps)",
     &ExportTexts::rolling_friction},
    {"surface-energy", "G", OptionKind::number,
     "cohesion of a model's particles by the law of Johnson, Kendall and Roberts, in J/m^2: two part at a "
     "tension of 3 pi G "
     "and their effective radius; walls and particles have none (lammps)",
     &ExportTexts::surface_energy},
    {"cohesion-energy-density", "K", OptionKind::number,
     "the same by the law SJKR, in J/m^3: a contact has a tension of K times its area (liggghts)",
     &ExportTexts::cohesion_energy_density},
    {"periodic", "", OptionKind::flag,
     "a model in a box that is repeated on all sides: nothing settles, its faces compress it to "
     "--void-ratio or --stress (lammps, yade)",
     &ExportTexts::periodic},
    {"unjammed", "", OptionKind::flag,
     "a model's result may be grains that are not at rest, or that do not carry each other; without it the "
     "engine stops there with what it measures",
     &ExportTexts::unjammed},
    {"types", "TYPES", OptionKind::text,
     "class: each class has a type of its own, walls the next; else one (lammps, models; YADE has "
     "a material a class)",
     &ExportTexts::types},
    {"material", "FILE", OptionKind::file,
     "CSV: the material of each class in a model: columns class (number) or lower_mm, and some of "
     "young_modulus, poisson, friction, restitution, rolling_friction; implies --types class",
     &ExportTexts::material},
    {"young", "E", OptionKind::number,
     "Young's modulus for the time step, in Pa (or as 70GPa; 7e10; a model is softer, and says so)",
     &ExportTexts::young},
    {"poisson", "NU", OptionKind::number, "Poisson's ratio for the time step (0.25)", &ExportTexts::poisson}};

const std::vector<OptionRow<ExportTexts>> ExportTexts::size_options = {
    {"spread", "", OptionKind::flag,
     "sizes for all particles, as solve --spread gives them: exact masses of the classes",
     &ExportTexts::spread}};

} // namespace mdm

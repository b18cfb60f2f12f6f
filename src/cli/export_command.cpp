#include "cli/export_command.hpp"

#include "ask/option_values.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

namespace mdm::cli {
const ExportFormat &export_format(const ExportCommand &c) {
  const ExportFormat *const found = find_export_format(c.to);
  if (found == nullptr)
    throw InputError("--to: " + in_quotes(c.to) + " is no format: use one of " + export_format_names());
  return *found;
}

std::vector<FileBeside> files_beside(const ExportCommand &c, const ExportFormat &format) {
  if (format.id != ExportTo::phasicflow)
    return {};
  if (c.output.path() == "-")
    throw InputError("-o: PhasicFlow reads two more files, which lie beside it: say where with -o FILE");
  const std::filesystem::path folder = std::filesystem::path(c.output.path()).parent_path();
  return {{(folder / "shapes").string(), write_phasicflow_shapes},
          {(folder / "positions").string(), write_phasicflow_positions}};
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

std::uint64_t seed_of(const ExportCommand &c) {
  return seed64("seed", c.seed.value_or("1"));
}

Elasticity elasticity(const ExportCommand &c) {
  Elasticity e;
  if (c.young)
    e.young = physical("young", *c.young);
  if (c.poisson)
    e.poisson = not_negative("poisson", *c.poisson);
  if (e.poisson > ratio(1, 2))
    throw InputError("--poisson: " + in_quotes(*c.poisson) + " is above 0.5, which no material has");
  return e;
}

namespace {

bool is_cylinder(const ExportCommand &c) {
  return c.sides == "cylinder" || (!c.box && c.flags.specimen && c.flags.specimen->rfind("cylinder", 0) == 0);
}

/// A value that a model alone takes, if one is given.
const char *option_of_model(const ExportCommand &c) {
  const std::array<std::pair<bool, const char *>, 7> options = {
      {{c.steps.has_value(), "--steps"},
       {c.pressure.has_value(), "--stress"},
       {c.tolerance.has_value(), "--target-tolerance"},
       {c.friction.has_value(), "--friction"},
       {c.friction_while_filling.has_value(), "--friction-while-filling"},
       {c.material.has_value(), "--material"},
       {c.periodic, "--periodic"}}};
  const auto *const found =
      std::find_if(options.begin(), options.end(), [](const auto &option) { return option.first; });
  return found == options.end() ? nullptr : found->second;
}

void check_model(const ExportCommand &c) {
  if (c.unit && c.unit != "m")
    throw InputError("--unit: models are in SI units: leave it out");
  const bool has_target = c.flags.void_ratio || c.pressure;
  if (c.flags.void_ratio && c.pressure)
    throw InputError("--void-ratio and --stress: the density follows from either: give one of them");
  if (c.tolerance && !has_target)
    throw InputError("--target-tolerance: it is of --void-ratio or --stress: give one of them");
  if (c.flags.specimen && c.flags.solids_volume)
    throw InputError("--specimen and --solids-volume: give one of them");
  if (c.material && c.young)
    throw InputError("--young: --material has that of each class: leave it out");
  if (c.start == "layers" && is_cylinder(c))
    throw InputError(
        "--start layers: they have walls, and the specimen is a cylinder: take mixed or deposit");
}

void check_periodic(const ExportCommand &c) {
  if (c.to == "liggghts")
    throw InputError("--periodic: LIGGGHTS has no model of such a box: use --to lammps or yade");
  if (is_cylinder(c))
    throw InputError("--periodic: a cylinder cannot be repeated: give --specimen box:AxBxC, or leave it out");
  if (c.sides)
    throw InputError("--periodic: it is periodic on all sides: leave --sides out");
  if (c.start && c.start != "mixed")
    throw InputError("--periodic: grains start mixed, and nothing settles: leave --start out");
  if (!c.flags.void_ratio && !c.pressure)
    throw InputError(
        "--periodic: nothing settles without gravity: say by --void-ratio or --stress how far the "
        "box is compressed");
}

void check_sides(const ExportCommand &c) {
  if (!c.sides)
    return;
  if (c.sides != "walls" && c.sides != "cylinder" && c.sides != "periodic")
    throw InputError("--sides: " + in_quotes(*c.sides) + " is neither walls nor cylinder nor periodic");
  const bool is_deposit = c.start == "deposit";
  if (c.sides == "periodic" && !is_deposit)
    throw InputError("--sides: a deposit alone can be periodic: give --start deposit, or leave --sides out");
  if (!is_deposit && c.start != "mixed" && !c.model)
    throw InputError(
        "--sides: layers have the walls of a box: give --start mixed or deposit, or leave --sides out");
  if (c.sides == "periodic" && c.model && c.to == "yade")
    throw InputError(
        "--sides: models of YADE have walls on all sides or on none: leave it out, or take lammps or "
        "liggghts");
}

} // namespace

void check_export(const ExportCommand &c, const ExportFormat &format) {
  c.flags.check_source(c.file, c.reading.given(), "export");
  if (const char *const option = option_of_model(c); option != nullptr && !c.model)
    throw InputError(std::string(option) + " is for a model: give --model settle too");
  if (c.model)
    check_model(c);
  if (c.periodic)
    check_periodic(c);
  if (c.start && c.start != "layers" && c.start != "mixed" && c.start != "deposit")
    throw InputError("--start: " + in_quotes(*c.start) + " is neither layers nor mixed nor deposit");
  if (c.types && c.types != "class" && c.types != "one")
    throw InputError("--types: " + in_quotes(*c.types) + " is neither one nor class");
  if (c.types == "class" && c.to != "lammps" && !c.model)
    throw InputError("--types: " + std::string(format.name) + " has no types here: leave it out");
  if (format.write_placed == nullptr && c.start && !c.model)
    throw InputError(std::string("--start: ") + format.name + " has no places here: leave it out");
  check_sides(c);
  const bool has_no_places = format.write_placed == nullptr && !c.model;
  if (has_no_places && (c.box || (c.seed && !c.spread)))
    throw InputError(std::string(c.box ? "--box" : "--seed") + ": " + format.name +
                     " has sizes without places: leave it out");
}

void check_export_of_packing(const ExportCommand &c) {
  if (c.box || c.seed || c.start || c.sides || c.model || option_of_model(c) != nullptr || c.types ||
      c.young || c.poisson || c.mass_error || c.spread || c.reading.is_given() ||
      std::any_of(c.solving.begin(), c.solving.end(),
                  [](const CLI::Option *option) { return option->count() > 0; }))
    throw InputError(
        "a packing has its places and sizes: leave out options but --to, --unit, --density and -o");
}

} // namespace mdm::cli

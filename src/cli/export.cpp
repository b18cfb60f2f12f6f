#include "cli/commands.hpp"
#include "cli/export_model.hpp"
#include "cli/export_packing.hpp"
#include "cli/export_report.hpp"
#include "cli/help.hpp"
#include "cli/packing_file.hpp"
#include "cli/progress.hpp"
#include "files/file_ending.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "text/lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

void write_model(const ExportCommand &c, const ExportFormat &format, const ModelWriter &writer,
                 const ExportedParticles &found, const Placement &start) {
  const SettleModel model = writer.model(c, found, start);
  writer.write(model, start);
  if (!c.output.quiet && c.flags.specimen && !c.box && !c.flags.void_ratio)
    tell("note: without --void-ratio the gradation sets the number of particles, and they the specimen's "
         "height\n");
  if (!c.output.quiet)
    tell(cost_guide(format, *found.set, &start, settling(model).elasticity) + model_guide(format, model));
}

void write_file(const std::string &path, const Placement &start,
                void (*write)(const Placement &, const Sink &)) {
  Output out(path);
  write(start, [&out](std::string_view text) { out.write(text); });
  out.commit();
}

void write_particles(const ExportCommand &c, const ExportFormat &format,
                     const std::optional<ModelWriter> &model, const ExportedParticles &found) {
  const ParticleSet &set = *found.set;
  const Elasticity e = elasticity(c);
  check_wanted(c, format, set, nullptr); // before a long search for places
  std::optional<Placement> start;
  if (format.write_placed != nullptr || c.model)
    start.emplace(placed(c, found));
  check_wanted(c, format, set, start ? &*start : nullptr);
  if (start)
    tell_rounding(c, found, *start);
  if (model)
    return write_model(c, format, *model, found, *start);
  Output out(c.output.path());
  if (!c.output.quiet)
    tell(cost_guide(format, set, start ? &*start : nullptr, e) +
         how_to_verify(c, format, found, start ? &*start : nullptr));
  Progress progress([] { return std::string("writing"); }, c.output.quiet);
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (start && c.types == "class")
    write_lammps_data_of_classes(*start, sink);
  else if (start)
    format.write_placed(*start, sink);
  else
    format.write(set, sink);
  for (const FileBeside &file : files_beside(c, format))
    write_file(file.path, *start, file.write);
  out.commit();
}

int run(const ExportCommand &c) {
  if (c.file && is_packing_file(*c.file)) {
    check_export_of_packing(c);
    check_distinct({*c.file, c.output.path()});
    const ParticleSetOptions options = set_options(c, false);
    export_packing(*c.file, c.to, options.unit, options.density, c.output.path());
    return Exit::done;
  }
  const ExportFormat &format = export_format(c);
  check_export(c, format);
  const ParticleSetOptions options = set_options(c, format.has_floats);
  std::vector<std::string> paths = {c.flags.source(c.file), c.output.path()};
  std::optional<ModelWriter> model;
  if (c.model) {
    model.emplace(*c.model, c.to, c.output.path());
    for (const std::string &path : model->other_files())
      paths.push_back(path);
  }
  for (const FileBeside &file : files_beside(c, format))
    paths.push_back(file.path);
  if (c.material)
    paths.push_back(*c.material);
  check_distinct(paths);
  if (c.flags.band) { // FILE may be the band
    paths.front() = *c.flags.band;
    check_distinct(paths);
  }
  const ExportedParticles found = exported_particles(c, options);
  if (!found.set)
    return found.exit_code;
  write_particles(c, format, model, found);
  return found.exit_code;
}

} // namespace

namespace {

void add_start(CLI::App &command, ExportCommand &c) {
  const OptionGroup group(command, "The start");
  command
      .add_option(
          "--box", c.box,
          "footprint of the start, and its height, in the answer's unit (lammps, yade, vtk, models); without "
          "it the specimen's, a square in it for a cylinder, or a square that makes the start as high "
          "as wide")
      ->type_name("AxB[xC]");
  command
      .add_option(
          "--start", c.start,
          "layers, a slab for each class; mixed, at random places of a higher box; or deposit, a dense "
          "one, dropped and rolled to rest (lammps, yade, vtk, models; layers, but mixed for a model of up "
          "to 1000000 particles, and a deposit for one with a density to reach)")
      ->type_name("START");
  command
      .add_option("--sides", c.sides,
                  "of the start's box: walls; cylinder, in a --box as long as wide, the default for such a "
                  "specimen but "
                  "in layers; or periodic, of a deposit, repeated in x and y (models: lammps, liggghts)")
      ->type_name("SIDES");
  command.add_option("--seed", c.seed, "of the places of the start, and of a spread's sizes (1)")
      ->type_name("K");
}

void add_model(CLI::App &command, ExportCommand &c) {
  const OptionGroup group(command, "The model");
  command
      .add_option(
          "--model", c.model,
          "settle: a complete model that lets the particles settle in the specimen, for liggghts, lammps or "
          "yade, and beside it the files that it reads; with --void-ratio or --stress it compacts them")
      ->type_name("MODEL");
  command
      .add_option(
          "--steps", c.steps,
          "time steps of the model while particles settle, at most; without it three times as long as a "
          "fall from the top of the box")
      ->type_name("N");
  command
      .add_option("--stress", c.pressure,
                  "pressure in Pa to which the model compacts the particles, by a lid or the faces of a "
                  "--periodic box; --void-ratio is another such target")
      ->type_name("S");
  command
      .add_option("--target-tolerance", c.tolerance, "of --void-ratio, or of --stress as a part of it (0.01)")
      ->type_name("T");
  command.add_option("--friction", c.friction, "coefficient of friction of a model's particles (0.5)")
      ->type_name("MU");
  command
      .add_option(
          "--friction-while-filling", c.friction_while_filling,
          "the same while they settle and are compacted, and of walls: less makes denser beds (--friction)")
      ->type_name("MU");
  command.add_flag(
      "--periodic", c.periodic,
      "a model in a box that is repeated on all sides: nothing settles, its faces compress it to "
      "--void-ratio or --stress (lammps, yade)");
  command
      .add_option(
          "--types", c.types,
          "class: each class has a type of its own, walls the next; else one (lammps, models; YADE has "
          "a material a class)")
      ->type_name("TYPES");
  command
      .add_option(
          "--material", c.material,
          "CSV: the material of each class in a model: columns class (number) or lower_mm, and some of "
          "young_modulus, poisson, friction, restitution; implies --types class")
      ->type_name("FILE");
  command
      .add_option("--young", c.young,
                  "Young's modulus for the time step, in Pa (7e10; a model is softer, and says so)")
      ->type_name("E");
  command.add_option("--poisson", c.poisson, "Poisson's ratio for the time step (0.25)")->type_name("NU");
}

} // namespace

Run add_export(CLI::App &app) {
  const auto c = std::make_shared<ExportCommand>();
  CLI::App &command = *app.add_subcommand("export", "Particle files for DEM codes, with exact counts");
  command.add_option(
      "FILE", c->file,
      "answer of mdm solve, gradation to solve (any that mdm convert reads), set of mdm generate with its "
      "--sizes, file of particles as mdm verify reads, or packing of discs by mdm pack; - for "
      "standard input; needed unless there is a --band");
  command
      .add_option("--to", c->to,
                  "format: " + export_format_names() +
                      "; of a packing lammps, liggghts, yade, lmgc90, vtk or csv")
      ->transform([](std::string name) { // engines write their names in capitals
        std::transform(name.begin(), name.end(), name.begin(), lower);
        return name;
      })
      ->type_name("FORMAT")
      ->required();
  command.add_option("--unit", c->unit, "unit of lengths in the file: m (default), mm, um or in")
      ->type_name("UNIT");
  command
      .add_option("--size-unit", c->size_unit,
                  "unit of FILE where it is a file of particles: as in mdm verify")
      ->type_name("UNIT");
  command
      .add_option("--density", c->density,
                  "of the grains in kg/m^3 (2650); a class's factor, where there is one, multiplies it")
      ->type_name("RHO");
  command
      .add_option("--mass-error", c->mass_error,
                  "relative error of the mass of a class that rounded sizes may make (1e-9; 2e-7 for gsd and "
                  "dem-engine, "
                  "which have floats)")
      ->type_name("EPS");
  command.add_flag("--yes-huge", c->yes_huge, "more than 10000000 particles are wanted");
  command.add_flag("--yes-units", c->yes_units,
                   "sizes below 1 um and boxes above 100 m are right: the units are no mistake");
  add_start(command, *c);
  add_model(command, *c);
  CLI::Option *const spread =
      command.add_flag("--spread", c->spread,
                       "sizes for all particles, as solve --spread gives them: exact masses of the classes");
  const std::size_t before = command.get_options().size();
  c->flags.add_to(command);
  command.get_option("--digits")
      ->description("taken as solve takes it, without effect here: sizes are decimals as exact as "
                    "--mass-error says");
  c->solving = command.get_options();
  c->solving.erase(c->solving.begin(), c->solving.begin() + static_cast<std::ptrdiff_t>(before));
  c->solving.push_back(spread);
  for (CLI::Option *const option : c->reading.add_to(command))
    c->solving.push_back(option);
  c->output.add_out(command, "write the file", text_endings);
  c->output.add_quiet(command, "no progress, costs and notes on standard error");
  command.footer(footer(
      paragraph(
          "LIGGGHTS, LAMMPS, YADE, VTK, csv and diameters carry exact counts; MercuryDPM draws at random. "
          "Give mdm verify the same --size-factor, --cut-below and --pan-size."),
      {"mdm export sand.csv --to lammps --box 50x50 -o sand.data",
       "mdm export sand.csv --cut-below 0.1 --to liggghts --model settle --start deposit -o sand.in",
       "mdm export sand.csv --to lammps --model settle --specimen cylinder:5x9 --void-ratio 0.7 -o a.in",
       "mdm export start.packing --to yade -o start.txt"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

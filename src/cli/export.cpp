#include "ask/export_model.hpp"
#include "ask/export_packing.hpp"
#include "ask/export_report.hpp"
#include "cli/commands.hpp"
#include "cli/export_command.hpp"
#include "cli/export_particles.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "files/byte_source.hpp"
#include "files/file_ending.hpp"
#include "files/output.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/standard_streams.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace mdm::cli {

ExportTexts ExportCommand::asked() const {
  ExportTexts texts = own;
  texts.solve = flags;
  texts.budget = flags.budget;
  texts.reading = reading;
  texts.out = output.path();
  for (const CLI::Option *const option : solving)
    if (option->count() > 0)
      texts.solving.push_back(option->get_single_name());
  return texts;
}

namespace {

std::string material_in_file(const std::string &path) {
  constexpr std::size_t most_bytes = 1000000;
  return read_file(path, most_bytes);
}

/// The files of a model. The first is committed last: what it reads is there when it is.
void write_files(const std::vector<ModelFile> &files) {
  std::vector<std::unique_ptr<Output>> outputs;
  for (const ModelFile &file : files) {
    Output &out = *outputs.emplace_back(std::make_unique<Output>(file.path));
    file.write([&out](std::string_view text) { out.write(text); });
  }
  for (auto out = outputs.rbegin(); out != outputs.rend(); ++out)
    (*out)->commit();
}

void write_model(const ExportTexts &c, bool quiet, const ExportFormat &format, const ModelWriter &writer,
                 const ExportedParticles &found, const Placement &start) {
  const SettleModel model = writer.model(c, found, start, material_in_file);
  writer.write(model, start, write_files);
  if (quiet)
    return;
  if (c.solve.specimen && !c.box && !c.solve.void_ratio)
    tell("note: without " + option("void-ratio") +
         " the gradation sets the number of particles, and they the specimen's "
         "height\n");
  tell(cost_guide(format, *found.set, &start, settling(model).elasticity) + model_guide(format, model));
}

void write_file(const std::string &path, const Placement &start,
                void (*write)(const Placement &, const Sink &)) {
  Output out(path);
  write(start, [&out](std::string_view text) { out.write(text); });
  out.commit();
}

/// The start of the particles; that of a deposit takes its time.
Placement start_at(const ExportTexts &c, bool quiet, const ExportedParticles &found) {
  std::atomic<std::size_t> lying{0};
  const ProgressLine progress([&lying] { return fmt::format("placing, {} particles lie", lying.load()); },
                              quiet || start_of(c, found) != Start::deposit);
  return placed(c, found, [&lying](std::size_t n) { lying = n; });
}

void write_particles(const ExportTexts &c, bool quiet, const ExportFormat &format,
                     const std::optional<ModelWriter> &model, const ExportedParticles &found) {
  const ParticleSet &set = *found.set;
  const Elasticity e = elasticity(c);
  check_wanted(c, format, set, nullptr); // before a long search for places
  std::optional<Placement> start;
  if (format.write_placed != nullptr || c.model)
    start.emplace(start_at(c, quiet, found));
  check_wanted(c, format, set, start ? &*start : nullptr);
  if (start && !quiet)
    for (const std::string &note : rounding_notes(c, found, *start))
      tell("note: " + note + "\n");
  if (model)
    return write_model(c, quiet, format, *model, found, *start);
  Output out(c.out);
  if (!quiet)
    tell(cost_guide(format, set, start ? &*start : nullptr, e) +
         how_to_verify(c, format, found, start ? &*start : nullptr));
  ProgressLine progress([] { return std::string("writing"); }, quiet);
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

int run(const ExportCommand &command) {
  const ExportTexts c = command.asked();
  if (c.file && is_packing_file(*c.file)) {
    check_export_of_packing(c);
    check_paths({*c.file}, {c.out});
    const ParticleSetOptions options = set_options(c, false);
    const Packing packing = read_packing_file(*c.file);
    Output out(c.out);
    export_packing(packing, c.to, options.unit, options.density,
                   [&out](std::string_view text) { out.write(text); });
    out.commit();
    return Exit::done;
  }
  const ExportFormat &format = export_format(c);
  check_export(c, format);
  const ParticleSetOptions options = set_options(c, format.has_floats);
  std::vector<std::string> inputs = {c.solve.source(c.file)}, outputs = {c.out};
  for (const std::optional<std::string> &input : {c.solve.band, c.material, c.gradation})
    if (input)
      inputs.push_back(*input);
  std::optional<ModelWriter> model;
  if (c.model) {
    model.emplace(*c.model, c.to, c.out);
    for (const std::string &path : model->other_files())
      outputs.push_back(path);
  }
  for (const FileBeside &file : files_beside(c, format))
    outputs.push_back(file.path);
  check_paths(inputs, outputs);
  const ExportedParticles found = exported_particles(c, command.output, options);
  if (!found.set)
    return exit_code(found.outcome);
  ExportTexts as_found = c;
  if (found.size_factor)
    as_found.solve.size_factor = found.size_factor;
  write_particles(as_found, command.output.quiet, format, model, found);
  return exit_code(found.outcome);
}

} // namespace

Run add_export(CLI::App &app) {
  const auto c = std::make_shared<ExportCommand>();
  CLI::App &command = *app.add_subcommand("export", "Particle files for DEM codes, with exact counts");
  command.add_option(
      "FILE", c->own.file,
      "answer of mdm solve, gradation to solve (any that mdm convert reads), set of mdm generate with its "
      "--sizes, file of particles as mdm verify reads, or packing of discs by mdm pack; - for "
      "standard input; needed unless there is a --band");
  command
      .add_option("--to", c->own.to,
                  "format: " + export_format_names() +
                      "; of a packing lammps, liggghts, yade, lmgc90, vtk or csv")
      ->transform([](std::string name) { // engines write their names in capitals
        std::transform(name.begin(), name.end(), name.begin(), lower);
        return name;
      })
      ->type_name("FORMAT")
      ->required();
  add_options(command, ExportTexts::options, c->own);
  add_options(command, ExportTexts::particle_options, c->own.particles);
  {
    const OptionGroup group(command, "The start");
    add_options(command, ExportTexts::start_options, c->own);
  }
  {
    const OptionGroup group(command, "The model");
    add_options(command, ExportTexts::model_options, c->own);
  }
  add_options(command, ExportTexts::size_options, c->own);
  const std::size_t before = command.get_options().size();
  c->flags.add_to(command);
  command.get_option("--digits")
      ->description("taken as solve takes it, without effect here: sizes are decimals as exact as "
                    "--mass-error says");
  c->solving = command.get_options();
  c->solving.erase(c->solving.begin(), c->solving.begin() + static_cast<std::ptrdiff_t>(before));
  c->solving.push_back(command.get_option("--spread"));
  for (CLI::Option *const option : c->reading.add_to(command))
    c->solving.push_back(option);
  c->output.add_out(command, "write the file", text_endings);
  c->output.add_verbose(command, "on standard error also the answer to a gradation, with its scale");
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

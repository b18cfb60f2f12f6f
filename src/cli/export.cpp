#include "answer/answer_particles.hpp"
#include "cli/commands.hpp"
#include "cli/export_model.hpp"
#include "cli/export_packing.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/packing_file.hpp"
#include "cli/progress.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/solve_flags.hpp"
#include "particles/cost.hpp"
#include "particles/sample_set.hpp"
#include "text/json_member.hpp"
#include "text/lines.hpp"

#include <mdm/answer/answer.hpp>
#include <mdm/answer/answer_sample.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/particles/particle_writer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

/// A format that export writes: sizes alone, or particles in their places.
struct Format {
  const char *name;
  void (*write)(const ParticleSet &, const Sink &);
  void (*write_placed)(const Placement &, const Sink &);
  unsigned bytes; ///< of the engine's memory for a particle; 0: not known
};

/// Bytes were measured with 97,336 particles of one size in contact with six others each, and rounded up.
constexpr std::array<Format, 14> formats = {{{"liggghts", write_liggghts, nullptr, 1000},
                                             {"lammps", nullptr, write_lammps_data, 1000},
                                             {"yade", nullptr, write_xyzr, 10000},
                                             {"mercurydpm", write_mercurydpm, nullptr, 0},
                                             {"vtk", nullptr, write_vtk, 0},
                                             {"esys", nullptr, write_esys, 0},
                                             {"lethe", nullptr, write_lethe, 0},
                                             {"kratos", nullptr, write_kratos, 0},
                                             {"dem-engine", nullptr, write_dem_engine, 0},
                                             {"musen", nullptr, write_musen, 0},
                                             {"extxyz", nullptr, write_extxyz, 0},
                                             {"pfc", nullptr, write_pfc, 0},
                                             {"csv", write_size_csv, nullptr, 0},
                                             {"diameters", write_diameters, nullptr, 0}}};

/// Above this number, --yes-huge is required.
constexpr std::uint64_t huge = 10000000;
/// Boxes and sizes beyond these, in m, are mostly wrong units.
const Rational &largest_box() {
  static const Rational side = 100;
  return side;
}
const Rational &smallest_size() {
  static const Rational micrometre = ratio(1, 1000000);
  return micrometre;
}

struct ExportCommand {
  GradationFlags::Text file; ///< open: the band alone
  SolveFlags flags;
  std::vector<CLI::Option *> solving; ///< options that only a gradation has a use for
  GradationFlags::Text unit, size_unit, density, mass_error, box, seed, young, poisson, model, steps, start,
      sides;
  ReadingFlags reading;
  std::string to;
  OutputFlags output;
  bool spread = false;
  bool yes_huge = false;
  bool yes_units = false;
};

std::string format_names() {
  std::string text;
  for (const Format &format : formats)
    text += (text.empty() ? "" : ", ") + std::string(format.name);
  return text;
}

const Format &format_of(const ExportCommand &c) {
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&c](const Format &format) { return c.to == format.name; });
  if (found == formats.end())
    throw InputError("--to: " + in_quotes(c.to) + " is no format: use one of " + format_names());
  return *found;
}

/// A positive number that engines compute with as a double.
Rational physical(const std::string &option, const std::string &text) {
  constexpr unsigned most_exponent = 30;
  const Rational most = power_of_ten(most_exponent);
  const Rational r = positive(option, text);
  if (r > most || r * most < 1)
    throw InputError(option + ": " + in_quotes(text) + " is not from 1e-30 to 1e30: give it in SI units");
  return r;
}

ParticleSetOptions set_options(const ExportCommand &c) {
  ParticleSetOptions options;
  if (c.unit)
    options.unit = length_unit_of("--unit", *c.unit);
  if (c.density)
    options.density = physical("--density", *c.density);
  if (c.mass_error)
    options.most_mass_error = positive("--mass-error", *c.mass_error);
  return options;
}

std::uint64_t seed_of(const ExportCommand &c) {
  return seed64("--seed", c.seed.value_or("1"));
}

/// The particles to export, and the exit code.
struct Particles {
  std::optional<ParticleSet> set; ///< nothing: there is no match
  int exit_code = Exit::done;
  SizeUnit unit = SizeUnit::mm; ///< of lengths in options
  std::optional<Solids> solids; ///< that were asked for
  std::string question;         ///< of an answer, in words
  bool has_gradation = true;    ///< FILE is one, by which the particles can be judged
};

/// Refuses the options of solving, of which there is no more to ask. \param what  the particles
void refuse_solving(const ExportCommand &c, const char *what) {
  for (const CLI::Option *option : c.solving)
    if (option->count() > 0 && option->get_name() != "--law")
      throw InputError(fmt::format("{}: {} in {} is solved already: leave it out, or export the gradation",
                                   option->get_name(), what, printable(shown_name(*c.file))));
}

Particles answer_particles(const ExportCommand &c, const std::string &content,
                           const ParticleSetOptions &options) {
  refuse_solving(c, "the answer");
  const AnswerSample answer = read_answer(content, shown_name(*c.file));
  const MassLaw law = c.flags.GradationFlags::question().rest.law;
  return {in_file(*c.file, [&] { return particle_set(answer, law, options); }),
          Exit::done,
          answer.unit,
          std::nullopt,
          answer.question,
          false};
}

/// The particles of a file of them, as they are.
Particles sample_particles(const ExportCommand &c, const ParticleSetOptions &options) {
  refuse_solving(c, "the set of particles");
  if (c.spread || c.reading.is_given())
    throw InputError((c.spread ? "--spread" : c.reading.given()) + ": " + printable(*c.file) +
                     " holds particles already: leave it out");
  ParticleOptions reading;
  reading.says_otherwise = "--size-unit says";
  if (c.size_unit)
    reading.unit = length_unit_of("--size-unit", *c.size_unit);
  SampleSet sample;
  c.output.tell_notes(read_sample_file(*c.file, reading, sample, c.output.quiet));
  return {in_file(*c.file, [&] { return sample.set(stem(*c.file), LengthUnit::mm, options); }),
          Exit::done,
          SizeUnit::mm,
          std::nullopt,
          "",
          false};
}

/// \param content of FILE; open: there is the band alone
Particles solved_particles(const ExportCommand &c, const std::optional<std::string> &content,
                           const ParticleSetOptions &options) {
  const AskedQuestion asked = c.flags.question();
  Progress progress([] { return std::string("solving"); }, c.output.quiet);
  const std::string &source = c.flags.source(c.file);
  const Gradation g = content ? read_gradation(*content, shown_name(source), c.reading.reading())
                              : in_file(source, [&] { return middle_of(*asked.rest.band); });
  const Question question = asked.in(g.unit());
  const SolveOptions solve_options = c.flags.options();
  const Match m = in_file(source, [&] { return solve(g, question, solve_options); });
  c.output.tell_notes(m.gradation.notes()); // solve's own are of doubles that may leave their class
  if (m.status != Status::optimal)
    tell(printable(m.gradation.id()) + ": " + headline(m) + "\n");
  const int code = exit_code(m.status);
  if (!m.has_answer())
    return {std::nullopt, code, m.gradation.unit(), std::nullopt, ""};
  const std::uint64_t seed = seed_of(c);
  return {
      in_file(source,
              [&] { return c.spread ? spread_particle_set(m, seed, options) : particle_set(m, options); }),
      code, m.gradation.unit(), question.solids, ""};
}

Particles particles(const ExportCommand &c, const ParticleSetOptions &options) {
  if (c.file && is_sample_file(*c.file))
    return sample_particles(c, options);
  if (c.size_unit)
    throw InputError("--size-unit: it is of files of particles, and FILE is none: leave it out");
  std::optional<std::string> content;
  if (c.file)
    content = read_file(*c.file, max_gradation_bytes);
  return content && json_schema(*content) ? answer_particles(c, *content, options)
                                          : solved_particles(c, content, options);
}

/// Reads `AxB` or `AxBxC`. \param unit  of lengths without one, and of the result
Footprint parse_box(const std::string &text, SizeUnit unit) {
  std::vector<Rational> lengths;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('x', begin), text.size());
    lengths.push_back(length("--box", text.substr(begin, end - begin)).in(unit));
    begin = end + 1;
  }
  if (lengths.size() < 2 || lengths.size() > 3)
    throw InputError("--box: " + in_quotes(text) + " is neither AxB nor AxBxC: write for example 50x50");
  return {lengths[0], lengths[1], lengths.size() == 3 ? std::optional(lengths[2]) : std::nullopt};
}

/// True if the specimen is a cylinder and no --box takes its place.
bool is_cylinder(const ExportCommand &c, const Particles &found) {
  return !c.box && found.solids && std::holds_alternative<Cylinder>(*found.solids);
}

/// The sides of a deposit: as asked for, or those of the specimen; models have walls unless asked for others.
Sides sides_of(const ExportCommand &c, const Particles &found) {
  if (c.sides)
    return *c.sides == "cylinder" ? Sides::cylinder : *c.sides == "periodic" ? Sides::periodic : Sides::walls;
  const bool is_deposit = c.start && *c.start == "deposit" && !c.model;
  return is_deposit && is_cylinder(c, found) ? Sides::cylinder : Sides::walls;
}

/// The ground of the start: --box, or else the specimen.
std::optional<Footprint> footprint(const ExportCommand &c, const Particles &found) {
  const Sides sides = sides_of(c, found);
  std::optional<Footprint> floor;
  if (c.box)
    floor = parse_box(*c.box, found.unit);
  else if (found.solids && std::holds_alternative<Box>(*found.solids))
    floor = {std::get<Box>(*found.solids).a, std::get<Box>(*found.solids).b, std::nullopt};
  else if (is_cylinder(c, found) && sides == Sides::cylinder)
    floor = {std::get<Cylinder>(*found.solids).diameter, std::get<Cylinder>(*found.solids).diameter,
             std::nullopt};
  else if (is_cylinder(c, found))
    floor = inscribed_square(std::get<Cylinder>(*found.solids).diameter);
  if (!floor && sides != Sides::walls) {
    floor = deposit_square(*found.set);
    floor->sides = sides;
    return floor;
  }
  if (!floor)
    return floor;
  if (sides == Sides::cylinder && floor->a != floor->b)
    throw InputError("--sides cylinder: its box is as long as wide: give --box its diameter twice");
  floor->sides = sides;
  const Rational unit = in_mm(length_unit(found.unit)) / in_mm(found.set->unit);
  floor->a *= unit;
  floor->b *= unit;
  if (floor->c)
    *floor->c *= unit;
  return floor;
}

Elasticity elasticity(const ExportCommand &c) {
  Elasticity e;
  if (c.young)
    e.young = physical("--young", *c.young);
  if (c.poisson)
    e.poisson = not_negative("--poisson", *c.poisson);
  if (e.poisson > ratio(1, 2))
    throw InputError("--poisson: " + in_quotes(*c.poisson) + " is above 0.5, which no material has");
  return e;
}

/// \throws InputError if a side of that many metres looks like a mistake
void check_side(const ExportCommand &c, const Rational &side) {
  if (!c.yes_units && side > largest_box())
    throw InputError(fmt::format("the particles need a box of {} m, more than 100 m: is the unit of the "
                                 "gradation right, and --box wide enough? --yes-units if they are",
                                 approximate(side, 3)));
}

/// Warnings about what a user may not have meant.
void check_wanted(const ExportCommand &c, const Format &format, const ParticleSet &set,
                  const std::optional<Placement> &start) {
  if (!c.yes_huge && set.particles() > huge && format.write != write_size_csv)
    throw InputError(fmt::format("{} particles are more than {}: --yes-huge if that is wanted; else a "
                                 "--tolerance or --cut-below needs fewer, and --to csv writes counts alone",
                                 to_string(set.particles()), huge));
  if (format.bytes > 0)
    check_simulated(set);
  if (c.yes_units)
    return;
  const Rational smallest = in_metres(set, set.smallest().diameter.decimal());
  if (smallest < smallest_size())
    throw InputError(fmt::format("particles of {} m are below 1 um: is the unit of the gradation right? "
                                 "--yes-units if it is, --cut-below leaves fine classes out",
                                 approximate(smallest, 3)));
  Rational side = loose_side(set);
  if (start)
    for (const std::int64_t length : start->box())
      side = std::max(side, in_metres(set, parse_decimal(start->text(length))));
  check_side(c, side);
}

/// `1.5 MB`, three digits of it.
std::string bytes_text(const Integer &bytes) {
  constexpr int step = 1000;
  Rational n = bytes;
  std::size_t i = 0;
  constexpr std::array<const char *, 5> units = {"bytes", "kB", "MB", "GB", "TB"};
  for (; n >= step && i + 1 < units.size(); ++i)
    n /= step;
  return approximate(n, 3) + " " + units.at(i);
}

/// The digits that two bounds of a number have in common, four at most.
std::string certain_digits(const std::pair<Rational, Rational> &bounds) {
  unsigned digits = 4;
  while (digits > 1 && approximate(bounds.first, digits) != approximate(bounds.second, digits))
    --digits;
  return approximate(bounds.first, digits);
}

/// True if files of the format have no room for a statement about masses.
bool has_no_comments(const Format &format) {
  constexpr std::array writers = {write_esys, write_lethe, write_pfc, write_dem_engine, write_musen};
  return std::find(writers.begin(), writers.end(), format.write_placed) != writers.end();
}

/// The cost of the simulation, and the start of the particles.
std::string guide(const Format &format, const ParticleSet &set, const std::optional<Placement> &start,
                  const Elasticity &e) {
  std::string text = fmt::format(
      "{} particles; Rayleigh time {} s (E = {} Pa, nu = {}): take some 20 % of it as time step\n",
      to_string(set.particles()), approximate(rayleigh_time(set, e), 3), short_decimal(e.young),
      short_decimal(e.poisson));
  if (format.bytes > 0)
    text += fmt::format("memory of {}: some {} ({} bytes a particle, more where sizes are far apart)\n",
                        format.name, bytes_text(Integer(set.particles() * format.bytes)), format.bytes);
  if (format.write == write_mercurydpm)
    text += "MercuryDPM draws sizes at random from the shares: its counts are not exact\n";
  if (format.write_placed == write_dem_engine)
    text += "each clump_type is r and a radius: give it to DEM-Engine by LoadSphereType(mass, radius, "
            "material)->AssignName(clump_type)\n";
  if (has_no_comments(format) && !set.law.is_sphere())
    text += law_statement(set).substr(1) + "\n";
  if (start)
    text +=
        fmt::format("{}: {} x {} x {} {}{}, void ratio {}; no two particles overlap\n",
                    start->sides() == Sides::cylinder ? "cylinder in a box" : "box",
                    start->text(start->box()[0]), start->text(start->box()[1]), start->text(start->box()[2]),
                    name(set.unit), start->sides() == Sides::periodic ? ", repeated in x and y" : "",
                    certain_digits(start->void_ratio()));
  return text;
}

/// Above this number, particles are mixed by request alone: it takes seconds and memory.
constexpr std::uint64_t most_mixed = 1000000;

Start start_of(const ExportCommand &c, const ParticleSet &set) {
  if (!c.start)
    return c.model && set.particles() <= most_mixed ? Start::mixed : Start::layers;
  if (*c.start == "deposit")
    return Start::deposit;
  if (*c.start != "layers" && *c.start != "mixed")
    throw InputError("--start: " + in_quotes(*c.start) + " is neither layers nor mixed nor deposit");
  return *c.start == "mixed" ? Start::mixed : Start::layers;
}

/// The start of the particles; that of a deposit takes its time.
Placement placed(const ExportCommand &c, const Particles &found, std::uint64_t seed) {
  std::atomic<std::size_t> lying{0};
  const Progress progress([&lying] { return fmt::format("placing, {} particles lie", lying.load()); },
                          c.output.quiet || c.start != "deposit");
  return {*found.set, footprint(c, found), seed, start_of(c, *found.set),
          [&lying](std::size_t n) { lying = n; }};
}

/// The options with which mdm verify takes the gradation as it was asked for; nothing where there is a band
/// alone.
std::optional<std::string> verify_options(const ExportCommand &c) {
  if (!c.file)
    return std::nullopt;
  std::string options;
  const auto add = [&options](const char *option, const GradationFlags::Text &value) {
    if (value)
      options += std::string(" ") + option + " " + *value;
  };
  add("--law", c.flags.law);
  add("--size-factor", c.flags.size_factor);
  add("--cut-below", c.flags.cut_below);
  add("--pan-size", c.flags.pan_size);
  return options + c.reading.words();
}

std::uint64_t steps_of(const std::string &text) {
  const Integer steps = natural("--steps", text, 0);
  if (steps > Settling::most_steps)
    throw InputError(
        fmt::format("--steps: {} are more than the {} that LAMMPS and LIGGGHTS make in a run: give "
                    "fewer --steps",
                    in_quotes(text), Settling::most_steps));
  return static_cast<std::uint64_t>(steps);
}

void write_model(const ExportCommand &c, const Format &format, const ModelWriter &writer,
                 const Particles &found, const std::optional<Placement> &start, std::uint64_t seed) {
  SettleModel model = writer.model(*found.set, start, footprint(c, found));
  check_side(c, Rational(std::max({model.box.x, model.box.y, model.box.z})));
  model.seed = seed;
  model.verify_options = verify_options(c);
  model.question = found.question;
  model.deposited = c.start == "deposit";
  model.sides = sides_of(c, found);
  if (c.steps)
    model.steps = steps_of(*c.steps);
  const Elasticity e = elasticity(c);
  if (c.young)
    model.young = e.young;
  model.poisson = e.poisson;
  writer.write(model, start);
  if (c.output.quiet)
    return;
  const Settling s = settling(model);
  tell(guide(format, *found.set, start, s.elasticity));
  tell(fmt::format(
      "model: {} step{} of {:.3g} s; its first lines say how to run it and to verify what it leaves\n",
      s.steps, s.steps == 1 ? "" : "s", s.step));
}

/// Says where the box of the file is smaller than it was asked for: its lengths are whole units of the
/// start's places. The square in a cylinder is rounded by itself.
void tell_rounding(const ExportCommand &c, const Particles &found, const Placement &start) {
  const std::optional<Footprint> asked = footprint(c, found);
  const bool is_exact = c.box || (found.solids && std::holds_alternative<Box>(*found.solids));
  if (!asked || !is_exact || c.output.quiet)
    return;
  const auto tell_side = [&](const Rational &side, std::int64_t units) {
    if (side * power_of_ten(start.places()) != Rational(units))
      tell(fmt::format("note: the box's side of {} {} was rounded down to {}\n", approximate(side, 17),
                       name(found.set->unit), start.text(units)));
  };
  tell_side(asked->a, start.box()[0]);
  tell_side(asked->b, start.box()[1]);
  if (asked->c)
    tell_side(*asked->c, start.box()[2]);
}

/// The command that judges the file; empty where there is none to judge, or no exact counts in it.
std::string how_to_verify(const ExportCommand &c, const Format &format, const Particles &found) {
  const ParticleSet &set = *found.set;
  const std::optional<std::string> options = verify_options(c);
  if (!options || !found.has_gradation || c.file == "-" || c.output.path() == "-" ||
      format.write == write_mercurydpm)
    return "";
  const std::string unit =
      format.write == write_size_csv ? "" : " --size-unit " + std::string(name(set.unit));
  return fmt::format("check it by: mdm verify {} {}{}{} --tolerance {}\n", shell_word(*c.file),
                     shell_word(c.output.path()), *options, unit, share_tolerance(set));
}

void write_file(const ExportCommand &c, const Format &format, const std::optional<ModelWriter> &model,
                const Particles &found) {
  const std::uint64_t seed = seed_of(c);
  const Elasticity e = elasticity(c);
  std::optional<Placement> start;
  check_wanted(c, format, *found.set, start); // before a long search for places
  if (format.write_placed != nullptr || c.start)
    start.emplace(placed(c, found, seed));
  check_wanted(c, format, *found.set, start);
  if (start)
    tell_rounding(c, found, *start);
  if (model)
    return write_model(c, format, *model, found, start, seed);
  Output out(c.output.path());
  if (!c.output.quiet)
    tell(guide(format, *found.set, start, e) + how_to_verify(c, format, found));
  Progress progress([] { return std::string("writing"); }, c.output.quiet);
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (start)
    format.write_placed(*start, sink);
  else
    format.write(*found.set, sink);
  out.commit();
}

/// Refuses options that the format has no use for.
void check_options(const ExportCommand &c, const Format &format) {
  c.flags.check_source(c.file, c.reading.given(), "export");
  if (c.steps && !c.model)
    throw InputError("--steps is for a model: give --model settle too");
  if (c.model && c.unit && c.unit != "m")
    throw InputError("--unit: models are in SI units: leave it out");
  const bool is_deposit = c.start && *c.start == "deposit";
  if (format.write_placed == nullptr && c.start && !(c.model && is_deposit))
    throw InputError(std::string("--start: ") + format.name + " has no places here: leave it out" +
                     (c.model ? ", or give --start deposit" : ""));
  if (c.sides && !is_deposit)
    throw InputError("--sides: other starts have walls: give --start deposit, or leave it out");
  if (c.sides && *c.sides != "walls" && c.model && c.to == "yade")
    throw InputError("--sides: models of YADE have walls: leave it out, or take lammps or liggghts");
  if (c.sides && *c.sides != "walls" && *c.sides != "cylinder" && *c.sides != "periodic")
    throw InputError("--sides: " + in_quotes(*c.sides) + " is neither walls nor cylinder nor periodic");
  const bool has_no_places = format.write_placed == nullptr && !c.model;
  if (has_no_places && (c.box || (c.seed && !c.spread)))
    throw InputError(std::string(c.box ? "--box" : "--seed") + ": " + format.name +
                     " has sizes without places: leave it out");
}

/// Refuses options that only particles of a gradation have a use for.
void check_packing_options(const ExportCommand &c) {
  if (c.box || c.seed || c.steps || c.start || c.sides || c.model || c.young || c.poisson || c.mass_error ||
      c.spread || c.reading.is_given() ||
      std::any_of(c.solving.begin(), c.solving.end(),
                  [](const CLI::Option *option) { return option->count() > 0; }))
    throw InputError(
        "a packing has its places and sizes: leave out options but --to, --unit, --density and -o");
}

int run(const ExportCommand &c) {
  if (c.file && is_packing_file(*c.file)) {
    check_packing_options(c);
    check_distinct({*c.file, c.output.path()});
    const ParticleSetOptions options = set_options(c);
    export_packing(*c.file, c.to, options.unit, options.density, c.output.path());
    return Exit::done;
  }
  const Format &format = format_of(c);
  check_options(c, format);
  const ParticleSetOptions options = set_options(c);
  std::vector<std::string> paths = {c.flags.source(c.file), c.output.path()};
  std::optional<ModelWriter> model;
  if (c.model) {
    model.emplace(*c.model, c.to, c.output.path(), c.start == "deposit");
    if (!model->particles().empty())
      paths.push_back(model->particles());
  }
  check_distinct(paths);
  if (c.flags.band) { // FILE may be the band
    paths.front() = *c.flags.band;
    check_distinct(paths);
  }
  const Particles found = particles(c, options);
  if (!found.set)
    return found.exit_code;
  write_file(c, format, model, found);
  return found.exit_code;
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
                  "format: " + format_names() + "; of a packing lammps, liggghts, yade, lmgc90, vtk or csv")
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
                  "relative error of the mass of a class that rounded sizes may make (1e-9)")
      ->type_name("EPS");
  command
      .add_option(
          "--box", c->box,
          "footprint of the start, and its height, in the answer's unit (lammps, yade, vtk, models); without "
          "it the specimen's, a square in it for a cylinder, or a square that makes the start as high "
          "as wide")
      ->type_name("AxB[xC]");
  command
      .add_option(
          "--model", c->model,
          "settle: a complete model that lets the particles settle in the box, for liggghts, lammps or "
          "yade, and beside it the file of particles that it reads")
      ->type_name("MODEL");
  command
      .add_option(
          "--steps", c->steps,
          "time steps of the model; without it three times as long as a fall from the top of the box, of a "
          "deposit as long")
      ->type_name("N");
  command
      .add_option(
          "--start", c->start,
          "layers, a slab for each class; mixed, at random places of a higher box; or deposit, a dense "
          "one, dropped and rolled to rest (lammps, yade, vtk, models; layers, but mixed for a model of up "
          "to 1000000 particles)")
      ->type_name("START");
  command
      .add_option(
          "--sides", c->sides,
          "of the box of --start deposit: walls; cylinder, in a --box as long as wide, the default for such "
          "a specimen without a model; or periodic, repeated in x and y (models: lammps, liggghts)")
      ->type_name("SIDES");
  command.add_option("--seed", c->seed, "of the places of the start, and of a spread's sizes (1)")
      ->type_name("K");
  command
      .add_option("--young", c->young,
                  "Young's modulus for the time step, in Pa (7e10; a model is softer, and says so)")
      ->type_name("E");
  command.add_option("--poisson", c->poisson, "Poisson's ratio for the time step (0.25)")->type_name("NU");
  command.add_flag("--yes-huge", c->yes_huge, "more than 10000000 particles are wanted");
  command.add_flag("--yes-units", c->yes_units,
                   "sizes below 1 um and boxes above 100 m are right: the units are no mistake");
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
  c->output.add_out(command, "write the file");
  c->output.add_quiet(command, "no progress, costs and notes on standard error");
  command.footer(footer(
      paragraph(
          "LIGGGHTS, LAMMPS, YADE, VTK, csv and diameters carry exact counts; MercuryDPM draws at random. "
          "Give mdm verify the same --size-factor, --cut-below and --pan-size."),
      {"mdm export sand.csv --to lammps --box 50x50 -o sand.data",
       "mdm export sand.csv --cut-below 0.1 --to liggghts --model settle --start deposit -o sand.in",
       "mdm export start.packing --to yade -o start.txt"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/packing_file.hpp"
#include "cli/place_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/solve_flags.hpp"
#include "cli/verify_packing.hpp"
#include "gradation/likelier_unit.hpp"
#include "particles/description_sink.hpp"
#include "particles/unasked_texture.hpp"
#include "report/allowed_error.hpp"
#include "report/verification.hpp"

#include <mdm/answer/answer_sample.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/particles/particle_reader.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {
namespace {

struct VerifyCommand {
  std::string gradation, sample;
  GradationFlags flags;
  GradationFlags::Text from, size_unit, timestep, snap, band, digits;
  std::vector<std::string> tolerances;
  ReadingFlags reading;
  PlaceFlags places;
  bool radius = false;
  bool diameter = false;
  OutputFlags output;
};

AllowedError allowed(const VerifyCommand &c, const Gradation &g, const Question &question) {
  std::vector<AskedTolerance> asked;
  for (const std::string &text : c.tolerances)
    asked.push_back(named("--tolerance", text, parse_tolerance));
  std::optional<Envelope> band;
  if (c.band)
    band = band_in_file(*c.band);
  return in_file(c.gradation, [&] { return allowed_error(g, asked, band, question.size_factor); });
}

ParticleOptions particle_options(const VerifyCommand &c, SizeUnit target) {
  ParticleOptions options;
  options.target = target;
  options.says_otherwise = "--radius, --diameter and --size-unit say";
  if (c.from)
    options.format = parse_particle_format(*c.from);
  if (c.from && !options.format)
    throw InputError("--from: " + in_quotes(*c.from) + " is no format: use one of " +
                     particle_format_names());
  if (c.radius || c.diameter)
    options.meaning = c.radius ? SizeMeaning::radius : SizeMeaning::diameter;
  if (c.size_unit)
    options.unit = length_unit_of("--size-unit", *c.size_unit);
  if (c.timestep)
    options.timestep = natural("--timestep", *c.timestep, 0);
  return options;
}

/// A note where the sizes may have another unit.
std::optional<std::string> unit_note(const Description &d, LengthUnit unit) {
  const std::optional<LengthUnit> other = likelier_unit(d, unit);
  if (!other)
    return std::nullopt;
  return fmt::format("The sizes were read in {}, and no particle lies in a class (the pan's aside); with "
                     "--size-unit {} the first would.",
                     name(unit), name(*other));
}

/// The particles that were read of a sample.
struct Found {
  Description description;
  std::vector<std::string> objections, notes;
  std::optional<SphereTexture> packing = {};
};

/// What the places say; nothing where there are none, or too many to be judged without being asked.
std::optional<SphereTexture> texture(const VerifyCommand &c, const PlacedSink &placed, const Gradation &g,
                                     std::vector<std::string> &notes) {
  return in_file(c.sample, [&] {
    const SphereTextureOptions options = c.places.options(placed.box(), g.unit());
    return c.places.packing ? sphere_texture(placed.sample(), g.classes(), options)
                            : unasked_texture(placed, g.classes(), options, "--packing", notes);
  });
}

[[noreturn]] void refuse_without_places(const VerifyCommand &c) {
  throw file_error(c.sample, "it has no places of particles: leave out --packing");
}

/// All lines of a file of which the first were taken already.
std::string whole_text(const std::vector<FileLines::Line> &first, FileLines &rest, const std::string &file) {
  std::string text;
  for (std::vector<FileLines::Line> lines = first; !lines.empty(); lines = rest.next(lines_at_once))
    for (const FileLines::Line &line : lines) {
      if (!line || text.size() + line->size() > FileLines::longest_line)
        refuse_long(file, "the answer");
      text += (text.empty() ? "" : "\n") + *line;
    }
  return text;
}

Found read_answer_sample(const VerifyCommand &c, const std::string &content, Gradation g,
                         const Question &question, const Rational &snap) {
  if (c.places.packing)
    refuse_without_places(c);
  const AnswerSample answer = read_answer(content, shown_name(c.sample));
  return in_file(c.sample, [&] {
    if (c.radius || c.diameter || c.size_unit || c.timestep)
      throw InputError(
          "an answer of mdm says what its sizes are: leave out --radius, --diameter, --size-unit "
          "and --timestep");
    AnswerDescription described = describe_answer(answer, std::move(g), question.law, snap);
    return Found{std::move(described.description), std::move(described.objections),
                 std::move(described.notes)};
  });
}

/// True if a file that begins with these lines is a JSON object.
bool begins_json(const std::vector<FileLines::Line> &lines) {
  for (const FileLines::Line &line : lines) {
    if (!line)
      return false;
    const std::size_t first = line->find_first_not_of(" \t\r\xEF\xBB\xBF");
    if (first != std::string::npos)
      return (*line)[first] == '{';
  }
  return false;
}

Found read_sample(const VerifyCommand &c, const Gradation &g, const Question &question,
                  const Rational &snap) {
  const ParticleOptions options = particle_options(c, g.unit());
  DescriptionSink sink(Description(g, {question.law, snap, 1, 1}));
  if (!options.format && (is_generated_file(c.sample) || is_packing_file(c.sample))) {
    if (c.places.packing)
      refuse_without_places(c);
    std::vector<std::string> notes = read_sample_file(c.sample, options, sink, c.output.quiet);
    return {sink.description(), {}, std::move(notes)};
  }
  PlacedSink placed(g, sink, c.places.packing ? std::nullopt : std::optional(most_unasked_places));
  ReadParticles read;
  if (options.format ? options.format == ParticleFormat::gsd : is_gsd_file(c.sample)) {
    read = read_gsd_file(c.sample, options, placed);
  } else {
    FileLines lines(c.sample);
    std::vector<FileLines::Line> chunk = lines.next(lines_at_once);
    if (options.format ? options.format == ParticleFormat::answer : begins_json(chunk))
      return read_answer_sample(c, whole_text(chunk, lines, c.sample), g, question, snap);
    read = read_lines(std::move(chunk), lines, c.sample, options, placed, c.output.quiet);
  }
  Found found{sink.description(), {}, std::move(read.notes)};
  found.packing = texture(c, placed, g, found.notes);
  if (const std::optional<std::string> note = unit_note(found.description, read.unit))
    found.notes.push_back(*note);
  if (found.description.hair_above() > 0)
    found.notes.push_back(fmt::format("Particles larger than a sieve by less than 1e-12 of it: {}; --snap "
                                      "1e-12 takes sizes as near as that as the sieve.",
                                      to_string(found.description.hair_above())));
  return found;
}

/// A gradation with what the question changes, and its smallest match.
struct Asked {
  Question question;
  Gradation gradation;
  SmallestMatch smallest;
};

Asked read_target(const VerifyCommand &c, const AskedQuestion &stated) {
  refuse_sample(c.gradation);
  Gradation g = read_gradation(read_file(c.gradation, max_gradation_bytes), shown_name(c.gradation),
                               c.reading.reading());
  const Question question = stated.in(g.unit());
  return in_file(c.gradation, [&] {
    Gradation asked = asked_gradation(std::move(g), question);
    SmallestMatch smallest = smallest_match(asked, question.law);
    return Asked{question, std::move(asked), std::move(smallest)};
  });
}

int exit_code(Verdict verdict) {
  switch (verdict) {
  case Verdict::match:
    return Exit::done;
  case Verdict::undecided:
    return Exit::limited;
  default:
    return Exit::negative;
  }
}

int run(const VerifyCommand &c) {
  c.places.check();
  if (c.gradation == "-" && c.sample == "-")
    throw InputError("GRADATION and SAMPLE cannot both be standard input: give one of them as a file");
  check_distinct({c.gradation, c.output.path()});
  check_distinct({c.sample, c.output.path()});
  if (c.band)
    check_distinct({*c.band, c.output.path()});
  if (is_disc_sizes_file(c.gradation))
    return verify_packing(c.gradation, c.sample, c.output);
  const AskedQuestion stated = c.flags.question();
  const Rational snap = c.snap ? not_negative("--snap", *c.snap) : Rational(0);
  const unsigned digits = c.digits ? digits_of("--digits", *c.digits) : 6;
  const Asked target = read_target(c, stated);
  const Question &question = target.question;
  Output out(c.output.path());

  Found found = read_sample(c, target.gradation, question, snap);
  AllowedError within = allowed(c, target.gradation, question);
  Verification v(std::move(found.description), question, within.most);
  v.bounds = std::move(within.bounds);
  v.within = std::move(within.within);
  v.smallest = target.smallest;
  v.sample = shown_name(c.sample);
  v.digits = digits;
  v.packing = std::move(found.packing);
  v.objections = std::move(found.objections);
  v.notes = target.gradation.notes();
  v.notes.insert(v.notes.end(), found.notes.begin(), found.notes.end());

  out.write(c.output.report([&] { return verification_text(v); }, [&] { return verification_json(v); },
                            [&] { return verification_csv(v); }));
  // CSV has no place for a verdict.
  if (c.output.is_csv() && v.verdict() != Verdict::match)
    tell(printable(v.sample) + ": " + headline(v) + "\n");
  c.output.tell_notes_beside_csv(v.notes);
  out.commit();
  return exit_code(v.verdict());
}

} // namespace

Run add_verify(CLI::App &app) {
  const auto c = std::make_shared<VerifyCommand>();
  CLI::App &command = *app.add_subcommand("verify", "Whether a sample of particles matches a gradation");
  command
      .add_option("GRADATION", c->gradation,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard input; "
                  "or sizes of discs that mdm generate "
                  "--sizes wrote, "
                  "of which SAMPLE is a packing that mdm pack wrote")
      ->required();
  command.add_option("SAMPLE", c->sample, "particles, in one of the formats of --from; - for standard input")
      ->required();
  command
      .add_option(
          "--from", c->from,
          "format of SAMPLE: csv (size_mm,quantity; also size_um, size_m, size_in, size_phi or sieve), "
          "answer (JSON of mdm solve), xyzr (x y z r a "
          "line), lammps-data, lammps-dump, liggghts-dump, vtk, diameters (one a line), liggghts-insertion, "
          "mercurydpm (scripts and distributions of mdm export), extxyz (extended XYZ of ASE and OVITO "
          "with radius among its Properties), esys (geometry or snapshot of ESyS-Particle with one worker), "
          "lethe (insertion file), kratos (mdpa), musen (scene as text), gsd (HOOMD-blue), phasicflow "
          "(particlesDict of mdm export) or dem-engine (CSV "
          "of spheres, or of "
          "clumps whose types are named r and the radius, as r0.00025); told by the content if left out")
      ->type_name("FORMAT");
  CLI::Option *const radius = command.add_flag("--radius", c->radius, "sizes are radii, whatever their name");
  command.add_flag("--diameter", c->diameter, "sizes are diameters, whatever their name")->excludes(radius);
  command
      .add_option(
          "--size-unit", c->size_unit,
          "unit of SAMPLE: mm, um, m or in; m for LAMMPS, LIGGGHTS, VTK, ESyS-Particle, Lethe, Kratos, "
          "MUSEN, GSD, PhasicFlow and DEM-Engine if left out, for xyzr, extxyz and diameters that of the "
          "gradation "
          "(mm for size_in, size_phi and sieve)")
      ->type_name("UNIT");
  command.add_option("--timestep", c->timestep, "the timestep of a dump, instead of the last")
      ->type_name("T");
  command
      .add_option(
          "--tolerance", c->tolerances,
          "what shares may differ by: retained:1% or 1% (percentage points, of each class), passing:0.5%, "
          "total:1%, "
          "retained:file, passing:file, laboratory, rounding; none is 0; may be repeated, and all hold")
      ->type_name("WHICH")
      ->allow_extra_args(false);
  command.add_option("--band", c->band, "what passes lies within the envelope in FILE, as for solve")
      ->type_name("FILE");
  command
      .add_option("--snap", c->snap,
                  "take a size within EPS times an opening of it as that opening (0), for sizes computed in "
                  "double: 1e-12")
      ->type_name("EPS");
  c->places.add_to(command);
  c->flags.add_to(command);
  command.add_option("--digits", c->digits, "significant digits of percents (6)")->type_name("D");
  c->output.add_format(command);
  c->output.add_out(command, "write the report");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Errors are target minus found (Arnold, Eq. 13), of shares of the mass; error_as_given, "
                "in JSON, of masses.") +
          "\n" +
          paragraph("Exit 0 if no particle lies outside all classes and every share is within the "
                    "tolerance; 1 if not; 3 if an irrational law leaves it open."),
      {"mdm verify sand.csv packing.txt --from xyzr --size-unit m --tolerance 1%",
       "mdm verify sand.csv sand-settled.dump --tolerance passing:0.5% --tolerance retained:2%",
       "mdm verify sand.csv sand-settled.dump --packing --tolerance 1%",
       "mdm verify sand.csv sizes.csv --format json -o report.json"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

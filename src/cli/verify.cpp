#include "ask/outcome.hpp"
#include "ask/timesteps.hpp"
#include "ask/verifier.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/plot_flag.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"
#include "cli/verification_output.hpp"
#include "cli/verify_materials.hpp"
#include "cli/verify_packing.hpp"
#include "files/byte_source.hpp"
#include "files/file_lines.hpp"
#include "files/output.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/sample_proof_files.hpp"
#include "gradation/material_gradation.hpp"
#include "particles/particle_reader.hpp"
#include "plot/timesteps_figure.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {
namespace {

struct VerifyCommand {
  std::string gradation, sample;
  std::optional<std::string> proof;
  VerifyTexts asked;
  bool over_time = false;
  PlotFlag plot;
  ReadingFlags reading;
  OutputFlags output;
};

/// True if the checker reads the sample as it is, and as it is read here.
bool is_canonical_sample(const VerifyCommand &c) {
  const ParticleTexts &said = c.asked.particles;
  if (c.sample == "-" || !is_plain_file(c.sample) || said.say_sizes() || (said.from && *said.from != "csv"))
    return false;
  ByteSource bytes(c.sample);
  CanonicalSampleTest test;
  for (std::string piece; bytes.read_some(piece); piece.clear())
    if (!test.take(piece))
      return false;
  return test.is_canonical();
}

[[noreturn]] void refuse_without_places(const VerifyCommand &c) {
  throw file_error(c.sample, "it has no places of particles: leave out " + option("packing") +
                                 " and the options about places");
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

/// Hands the sample to the judge.
void read_sample(const VerifyCommand &c, Verifier &verifier) {
  const ParticleOptions &options = verifier.reading();
  if (!options.format && (is_generated_file(c.sample) || is_packing_file(c.sample))) {
    if (verifier.are_places_asked())
      refuse_without_places(c);
    return verifier.note(read_sample_file(c.sample, options, verifier.sizes(), c.output.quiet));
  }
  if (options.format ? options.format == ParticleFormat::gsd : is_gsd_file(c.sample))
    return verifier.end(read_gsd_file(c.sample, options, verifier.particles()));
  FileLines lines(c.sample);
  std::vector<FileLines::Line> chunk = lines.next(lines_at_once);
  if (options.format ? options.format == ParticleFormat::answer : begins_json(chunk)) {
    if (verifier.are_places_asked())
      refuse_without_places(c);
    return verifier.take_answer(whole_text(chunk, lines, c.sample), shown_name(c.sample));
  }
  verifier.end(read_lines(std::move(chunk), lines, c.sample, options, verifier.particles(), c.output.quiet));
}

/// What is seen of a dump, or of GSD, timestep by timestep.
TimestepsReport read_timesteps(const VerifyCommand &c, Verifier &verifier) {
  ParticleOptions options = verifier.reading();
  options.every_timestep = true;
  Timesteps timesteps(verifier, shown_name(c.sample));
  if (options.format ? options.format == ParticleFormat::gsd : is_gsd_file(c.sample))
    return timesteps.report(read_gsd_file(c.sample, options, timesteps));
  FileLines lines(c.sample);
  std::vector<FileLines::Line> chunk = lines.next(lines_at_once);
  if (options.format == ParticleFormat::answer || is_generated_file(c.sample) || begins_json(chunk))
    throw file_error(c.sample, "it has no timesteps: leave out " + option("over-time"));
  return timesteps.report(read_lines(std::move(chunk), lines, c.sample, options, timesteps, c.output.quiet));
}

int run_over_time(const VerifyCommand &c, Verifier &verifier) {
  const TimestepsReport r = read_timesteps(c, verifier);
  const std::unique_ptr<Output> plot = c.plot ? c.plot.drawn(timesteps_figure(r), c.output.quiet) : nullptr;
  Output out(c.output.path());
  out.write(c.output.report([&] { return timesteps_text(r); }, [&] { return timesteps_json(r); },
                            [&] { return timesteps_csv(r); }));
  c.output.tell_notes_beside_csv(r.notes);
  if (plot)
    plot->commit();
  out.commit();
  return exit_code(outcome_of(r.verdict()));
}

/// Refuses options that do not go together, and outputs that are inputs.
void check(const VerifyCommand &c) {
  c.asked.places.check();
  if (c.gradation == "-" && c.sample == "-")
    throw InputError("GRADATION and SAMPLE cannot both be standard input: give one of them as a file");
  if (c.plot && !c.over_time)
    throw InputError(option("plot") + " draws a sample over time: give " + option("over-time") +
                     " too; mdm plot " + option("sample") + " draws one beside its gradation");
  c.plot.check();
  std::vector<std::string> inputs = {c.gradation, c.sample};
  if (c.asked.band)
    inputs.push_back(*c.asked.band);
  check_paths(inputs, {c.output.path(), c.plot.path()});
  if (c.proof)
    SampleProofFiles::check(*c.proof, {c.gradation, c.sample, c.output.path(), c.asked.band.value_or("-")});
}

/// An option that has no use with a gradation of several materials, but those of VerifyTexts; empty: none.
std::string idle_in_verify(const VerifyCommand &c) {
  return c.proof ? option("proof") : c.over_time ? option("over-time") : c.reading.given();
}

int run(const VerifyCommand &c) {
  check(c);
  if (is_disc_sizes_file(c.gradation) && c.proof)
    throw file_error(c.gradation, "it has sizes of discs, and certificates are of gradations: leave out " +
                                      option("proof"));
  if (is_disc_sizes_file(c.gradation))
    return verify_packing(c.gradation, c.sample, c.output);
  static_cast<void>(c.asked.gradation.question()); // what is wrong is said before a file is read
  refuse_sample(c.gradation);
  const std::string content = read_file(c.gradation, max_gradation_bytes);
  if (is_material_gradation(content))
    return verify_materials({c.gradation, content, c.sample, c.asked, c.output, idle_in_verify(c)});
  UnderstoodGradation read = understand_gradation(content, shown_name(c.gradation), c.reading.reading());
  std::optional<Envelope> band;
  if (c.asked.band)
    band = band_in_file(*c.asked.band);
  std::optional<SampleProofFiles> files;
  if (c.proof)
    files.emplace(*c.proof, c.gradation, read,
                  is_canonical_sample(c) ? std::optional(c.sample) : std::nullopt);
  VerifyQuestion asked = in_file(c.gradation, [&] { return c.asked.question(read.gradation, band); });
  Verifier verifier(std::move(read.gradation), shown_name(c.gradation), std::move(asked),
                    files ? std::optional(Verifier::AskedProof{files->begin()}) : std::nullopt);
  if (c.over_time)
    return run_over_time(c, verifier);
  Output out(c.output.path());
  read_sample(c, verifier);
  Verification v = verifier.verification(shown_name(c.sample));
  if (files)
    in_file(c.sample, [&] {
      const Verifier::Proof proof = verifier.proof(v);
      files->write(proof.text, proof.missing, v.notes);
    });
  write_verification(v, c.output, out);
  if (files)
    files->commit();
  out.commit();
  return exit_code(outcome_of(v.verdict()));
}

} // namespace

Run add_verify(CLI::App &app) {
  const auto c = std::make_shared<VerifyCommand>();
  CLI::App &command = *app.add_subcommand("verify", "Whether a sample of particles matches a gradation");
  command
      .add_option("GRADATION", c->gradation,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads, or CSV of several "
                  "materials (material), with which SAMPLE has a column material too, or is an answer; - for "
                  "standard input; or sizes of discs that mdm generate "
                  "--sizes wrote, "
                  "of which SAMPLE is a packing that mdm pack wrote")
      ->required();
  command.add_option("SAMPLE", c->sample, "particles, in one of the formats of --from; - for standard input")
      ->required();
  add_options(command, ParticleTexts::options, c->asked.particles);
  command.get_option("--diameter")->excludes(command.get_option("--radius"));
  add_options(command, VerifyTexts::options, c->asked);
  add_options(command, PlaceTexts::options, c->asked.places);
  add_gradation_options(command, c->asked.gradation);
  add_options(command, VerifyTexts::answer_options, c->asked);
  command
      .add_option(
          "--proof", c->proof,
          "write a certificate of the verdict for mdm-check GRADATION SAMPLE OUT: counts, shares, errors, "
          "and whether the sample matches; beside it OUT.sample.csv and OUT.gradation.csv where it "
          "cannot read the files")
      ->type_name("OUT");
  command
      .add_flag(
          "--over-time", c->over_time,
          "each timestep of a dump or of GSD: a line with its verdict, fines lost, coordination, segregation "
          "and relative breakage")
      ->excludes(command.get_option("--proof"))
      ->excludes(command.get_option("--timestep"));
  c->plot.add_to(command, "draw what --over-time tells");
  c->output.add_format(command);
  c->output.add_out(command, "write the report");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Errors are target minus found (Arnold, Eq. 13), of shares of the mass; error_as_given, "
                "in JSON, of masses.") +
          "\n" +
          paragraph(
              "Exit 0 if no particle lies outside all classes, none has its centre outside the box of the "
              "file, --box or --specimen, and every share is within the tolerance; 1 if not; 3 if an "
              "irrational law, or ranges of sizes as in CSV answers, leave it open.") +
          "\n" +
          paragraph("With --over-time the exit code is that of all timesteps together. Breakage is told "
                    "against the "
                    "gradation, with curves linear in log size: B_r of Hardin (1985) from 0.074 mm on, B of "
                    "Einav (2007) "
                    "towards a fractal of dimension 2.6. Fines lost are particles of the finest class with "
                    "mass, since "
                    "the first timestep.") +
          "\n" +
          paragraph(
              "An id that is there twice is refused. Ids cost some 5 bits each where they mostly follow "
              "each other (10^7 of them 6 MB), and up to 43 bytes each where they are scattered."),
      {"mdm verify sand.csv packing.txt --from xyzr --size-unit m --tolerance 1%",
       "mdm verify sand.csv sand-settled.dump --tolerance passing:0.5% --tolerance retained:2%",
       "mdm verify sand.csv sand-settled.dump --packing --tolerance 1%",
       "mdm verify sand.csv run.dump --over-time --tolerance 1% -o run.csv --plot run.svg",
       "mdm verify sand.csv sizes.csv --format json -o report.json",
       "mdm verify sand.csv sizes.csv --proof sizes.proof && mdm-check sand.csv sizes.csv sizes.proof"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

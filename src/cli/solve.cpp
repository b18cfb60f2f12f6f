#include "commands.hpp"
#include "files.hpp"
#include "option_values.hpp"
#include "progress.hpp"
#include "solve_flags.hpp"

#include <mdm/error.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/proof/vipr.hpp>
#include <mdm/report/answer.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct SolveCommand {
  std::optional<std::string> file;
  SolveFlags flags;
  std::optional<std::string> proof, vipr, out, specimen_id;
  std::string format = "text";
  std::optional<std::string> seed;
  bool spectrum = false, spread = false;
  bool quiet = false;
};

/// A side result of solve: a file that is to be written with the rest or not at all.
struct SideFile {
  std::unique_ptr<Output> output;
  std::string text;
};

/// What is asked about, and why the checker could not read it in the user's file.
struct Target {
  Gradation gradation;
  std::string unreadable; ///< empty: it could
};

Target target(const SolveCommand &c, const Question &question) {
  if (!c.file)
    return {named(printable(shown_name(c.flags.source(c.file))), "",
                  [&](const std::string &) { return middle_of(*question.band); }),
            "mdm-check reads a gradation beside a band"};
  const std::string content = read_file(*c.file, max_gradation_bytes);
  return {read_gradation(content, shown_name(c.flags.source(c.file)), c.specimen_id),
          is_ags4(content) ? "mdm-check does not read AGS4" : ""};
}

/// The gradation file that the checker reads beside the proof, where it cannot read the user's own.
std::optional<SideFile> readable_gradation(const SolveCommand &c, const Target &of,
                                           std::vector<std::string> &notes) {
  if (!c.proof || of.unreadable.empty())
    return std::nullopt;
  const std::string path = *c.proof + ".csv";
  check_distinct({c.flags.source(c.file), *c.proof, path, c.vipr.value_or("-"), c.out.value_or("-")});
  notes.push_back(of.unreadable + ": the gradation is in " + path + " as CSV; check with: mdm-check " + path +
                  " " + *c.proof);
  return SideFile{std::make_unique<Output>(path), gradation_csv(of.gradation)};
}

void report(const SolveCommand &c, const Match &m, const Spectrum *spectrum, const Spread *spread,
            Output &out) {
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (c.format == "text")
    out.write(answer_text(m, spectrum, spread));
  else if (c.format == "csv" && spread != nullptr)
    spread_csv(m, *spread, sink);
  else if (c.format == "csv")
    out.write(answer_csv(m));
  else if (spread != nullptr)
    spread_json(m, spectrum, *spread, sink);
  else
    out.write(answer_json(m, spectrum));
  if (c.format == "json")
    out.write("\n");
}

int exit_code(const Match &m, const std::optional<Spectrum> &spectrum) {
  if (m.status == Status::none)
    return Exit::negative;
  if (m.status != Status::optimal || (spectrum && !spectrum->complete))
    return Exit::limited;
  return Exit::done;
}

void check_files(const SolveCommand &c) {
  c.flags.check_source(c.file, c.specimen_id, "solve");
  if (c.spectrum && c.flags.is_tolerant())
    throw InputError("--spectrum: it is of exact matches: leave it out, or --tolerance and --band");
  if (c.spectrum && c.format == "csv")
    throw InputError("--spectrum: CSV has no place for it: use --format text or json");
  if (c.seed && !c.spread)
    throw InputError("--seed: it is of a spread: add --spread, or leave it out");
  if (c.proof == "-" || c.vipr == "-")
    throw InputError("--proof and --vipr need a file: standard output has the answer");
  std::vector<std::string> paths = {c.flags.source(c.file)};
  for (const std::optional<std::string> &path : {c.proof, c.vipr, c.out})
    if (path)
      paths.push_back(*path);
  check_distinct(paths);
  if (c.flags.band) {
    paths.front() = *c.flags.band;
    check_distinct(paths);
  }
}

std::uint64_t seed_of(const SolveCommand &c) {
  return seed64("--seed", c.seed.value_or("1"));
}

int run(const SolveCommand &c) {
  check_files(c);
  const Question question = c.flags.question();
  const std::uint64_t seed = seed_of(c);
  const Target asked = target(c, question);
  Output out(c.out.value_or("-"));

  Progress progress([] { return std::string("solving"); }, c.quiet);
  const SolveOptions options = c.flags.options();
  const auto in_file = [&](const auto &action) {
    return named(printable(shown_name(c.flags.source(c.file))), "",
                 [&](const std::string &) { return action(); });
  };
  Match m = in_file([&] { return solve(asked.gradation, question, options); });
  std::optional<Spectrum> reachable;
  if (c.spectrum)
    reachable = spectrum(m.problem, options.limits);
  std::optional<Spread> particles;
  if (c.spread && m.has_answer())
    particles = spread(m, seed);

  std::vector<SideFile> files;
  if (c.proof && m.complete) {
    files.push_back({std::make_unique<Output>(*c.proof), in_file([&] { return certificate(m); })});
    if (std::optional<SideFile> csv = readable_gradation(c, asked, m.notes))
      files.push_back(std::move(*csv));
  } else if ((c.proof || c.vipr) && !m.complete) {
    m.notes.push_back("no proof was written: the limit came before the end");
  }
  if (c.vipr && m.complete)
    files.push_back({std::make_unique<Output>(*c.vipr), in_file([&] { return vipr(m); })});
  for (const SideFile &file : files)
    file.output->write(file.text);
  report(c, m, reachable ? &*reachable : nullptr, particles ? &*particles : nullptr, out);
  // CSV has no place for a verdict.
  if (c.format == "csv" && m.status != Status::optimal)
    tell(printable(m.gradation.id()) + ": " + headline(m) + "\n");
  if (c.format == "csv" && !c.quiet)
    for (const std::string &note : m.notes)
      tell("note: " + note + "\n");
  for (const SideFile &file : files)
    file.output->commit();
  out.commit();
  return exit_code(m, reachable);
}

} // namespace

Run add_solve(CLI::App &app) {
  const auto c = std::make_shared<SolveCommand>();
  CLI::App &command = *app.add_subcommand("solve", "The smallest set of particles that matches a gradation");
  command.add_option("FILE", c->file,
                     "gradation: CSV, JSON or AGS4; - for standard input; needed unless there is a --band");
  c->flags.add_to(command);
  command.add_option("--proof", c->proof, "write the certificate for mdm-check")->type_name("OUT");
  command.add_option("--vipr", c->vipr, "write the proof in the VIPR format (at most 200 classes)")
      ->type_name("OUT");
  command.add_flag("--spectrum", c->spectrum, "all numbers of particles that have an exact match");
  command.add_flag("--spread", c->spread,
                   "sizes for all particles, uniform by volume in their class as far as its exact mass lets "
                   "them (CSV: a row a particle)");
  command.add_option("--seed", c->seed, "of a spread's sizes (1)")->type_name("K");
  command.add_option("--specimen-id", c->specimen_id, "the specimen of an AGS4 file with several")
      ->type_name("ID");
  command.add_option("--format", c->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command.add_option("-o", c->out, "write the answer to OUT instead of standard output")->type_name("OUT");
  command.add_flag("--quiet", c->quiet, "no progress and no notes on standard error");
  command.footer("Example: mdm solve sand.csv --min-per-class 10 --proof sand.proof");
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "commands.hpp"
#include "files.hpp"
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
  std::string file;
  SolveFlags flags;
  std::optional<std::string> proof, vipr, out, specimen_id;
  std::string format = "text";
  bool spectrum = false;
  bool quiet = false;
};

std::string shown_name(const SolveCommand &c) {
  return c.file == "-" ? "stdin" : c.file;
}

/// A side result of solve: a file that is to be written with the rest or not at all.
struct SideFile {
  std::unique_ptr<Output> output;
  std::string text;
};

/// The gradation file that the checker reads beside the proof, where it cannot read the user's own.
std::optional<SideFile> readable_gradation(const SolveCommand &c, const std::string &content,
                                           const Gradation &g, std::vector<std::string> &notes) {
  if (!c.proof || !is_ags4(content))
    return std::nullopt;
  const std::string path = *c.proof + ".csv";
  check_distinct({c.file, *c.proof, path, c.vipr.value_or("-"), c.out.value_or("-")});
  notes.push_back("mdm-check does not read AGS4: the gradation is in " + path +
                  " as CSV; check with: mdm-check " + path + " " + *c.proof);
  return SideFile{std::make_unique<Output>(path), gradation_csv(g)};
}

std::string report(const SolveCommand &c, const Match &m, const Spectrum *spectrum) {
  if (c.format == "json")
    return answer_json(m, spectrum) + "\n";
  if (c.format == "csv")
    return answer_csv(m);
  return answer_text(m, spectrum);
}

int exit_code(const Match &m, const std::optional<Spectrum> &spectrum) {
  if (m.status == Status::none)
    return Exit::negative;
  if (m.status != Status::optimal || (spectrum && !spectrum->complete))
    return Exit::limited;
  return Exit::done;
}

void check_outputs(const SolveCommand &c) {
  if (c.spectrum && c.format == "csv")
    throw InputError("--spectrum: CSV has no place for it: use --format text or json");
  if (c.proof == "-" || c.vipr == "-")
    throw InputError("--proof and --vipr need a file: standard output has the answer");
  std::vector<std::string> paths = {c.file};
  for (const std::optional<std::string> &path : {c.proof, c.vipr, c.out})
    if (path)
      paths.push_back(*path);
  check_distinct(paths);
}

int run(const SolveCommand &c) {
  check_outputs(c);
  const Question question = c.flags.question();
  const std::string content = read_file(c.file, max_gradation_bytes);
  const Gradation g = read_gradation(content, shown_name(c), c.specimen_id);
  Output out(c.out.value_or("-"));

  Progress progress([] { return std::string("solving"); }, c.quiet);
  const SolveOptions options = c.flags.options();
  Match m = [&] {
    try {
      return solve(g, question, options);
    } catch (const InputError &e) {
      throw InputError(printable(shown_name(c)) + ": " + e.what());
    }
  }();
  std::optional<Spectrum> reachable;
  if (c.spectrum)
    reachable = spectrum(m.problem, options.limits);

  std::vector<SideFile> files;
  if (c.proof && m.complete) {
    files.push_back({std::make_unique<Output>(*c.proof), certificate(m)});
    if (std::optional<SideFile> csv = readable_gradation(c, content, g, m.notes))
      files.push_back(std::move(*csv));
  } else if (c.proof || c.vipr) {
    m.notes.push_back("no proof was written: the limit came before the end");
  }
  if (c.vipr && m.complete)
    files.push_back({std::make_unique<Output>(*c.vipr), vipr(m)});
  for (const SideFile &file : files)
    file.output->write(file.text);
  out.write(report(c, m, reachable ? &*reachable : nullptr));
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
  command.add_option("FILE", c->file, "gradation: CSV, JSON or AGS4; - for standard input")->required();
  c->flags.add_to(command);
  command.add_option("--proof", c->proof, "write the certificate for mdm-check")->type_name("OUT");
  command.add_option("--vipr", c->vipr, "write the proof in the VIPR format (at most 200 classes)")
      ->type_name("OUT");
  command.add_flag("--spectrum", c->spectrum, "all numbers of particles that have an exact match");
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

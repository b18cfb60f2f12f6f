#include "answer/answer.hpp"
#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/match_proofs.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/searched.hpp"
#include "cli/solve_flags.hpp"
#include "cli/solve_number.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/sample_file.hpp"
#include "files/standard_streams.hpp"
#include "gradation/material_gradation.hpp"
#include "gradation/number_gradation.hpp"
#include "match/costly_fines.hpp"
#include "proof/coq_file.hpp"
#include "proof/vipr.hpp"
#include "text/filesystem_path.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>

namespace mdm::cli {
namespace {

struct SolveCommand {
  std::optional<std::string> file;
  SolveFlags flags;
  std::optional<std::string> proof, vipr, coq, seed;
  ReadingFlags reading;
  OutputFlags output;
  bool spectrum = false, spread = false;

  bool asks_proof() const { return proof || vipr || coq; }
};

/// A side result of solve: a file that is to be written with the rest or not at all.
struct SideFile {
  std::unique_ptr<Output> output;
  std::string text;
};

/// The gradation of the proof, the bytes of its file, and whether the checker reads it in them.
struct Target {
  Gradation gradation;
  std::optional<Envelope> limits; ///< where the file is that of a band
  std::string bytes;
  bool is_canonical = true;

  std::string canonical() const { return limits ? envelope_csv(*limits) : gradation_csv(gradation); }
};

/// \param band  the bytes of the band's file
Target target(const SolveCommand &c, const Question &question, const std::string &band, std::string content) {
  if (!c.file)
    return {in_file(c.flags.source(c.file), [&] { return middle_of(*question.band); }), question.band, band,
            is_canonical_envelope(band)};
  if (is_material_gradation(content)) {
    Gradation g = read_material_gradation(content, shown_name(*c.file));
    return {std::move(g), std::nullopt, std::move(content)};
  }
  UnderstoodGradation read = understand_gradation(content, shown_name(*c.file), c.reading.reading());
  return {std::move(read.gradation), std::nullopt, std::move(content), read.is_canonical};
}

/// The gradation file that the checker reads beside the proof, where it cannot read the user's own.
/// \pre c.proof
std::optional<SideFile> readable_gradation(const SolveCommand &c, const Target &of,
                                           std::vector<std::string> &notes) {
  const std::string &source = c.flags.source(c.file);
  if (of.is_canonical && is_plain_file(source))
    return std::nullopt;
  if (is_stream(*c.proof)) {
    notes.push_back(
        "mdm-check does not read this file as it was read here: mdm convert makes a file that it reads");
    return std::nullopt;
  }
  const std::string path = *c.proof + ".gradation.csv";
  check_distinct({source, *c.proof, path, c.vipr.value_or("-"), c.coq.value_or("-"), c.output.path()});
  notes.push_back("mdm-check does not read this file as it was read here: " +
                  std::string(of.limits ? "the band" : "the gradation") + " is in " + printable(path) +
                  "; check with: mdm-check " + shell_word(path) + " " + shell_word(*c.proof));
  return SideFile{std::make_unique<Output>(path), of.canonical()};
}

/// A hint where most particles are in classes that hold little mass.
std::string hint(const SolveCommand &c, const Match &m) {
  const bool can_cut = c.file && m.gradation.materials().empty();
  const std::optional<CostlyFines> fines = can_cut ? costly_fines(m) : std::nullopt;
  if (!fines)
    return "";
  const auto percent = [](const Rational &share) { return approximate(Rational(share * 100), 3) + " %"; };
  return "  hint: " + percent(fines->particles) + " of the particles are finer than " + fines->below.text() +
         " " + std::string(name(m.gradation.unit())) + " and hold " + percent(fines->mass) +
         " of the mass: see mdm tradeoff " + shell_word(*c.file) + ", and --cut-below\n";
}

void report(const SolveCommand &c, const Match &m, const Spectrum *spectrum, const Spread *spread,
            Output &out) {
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  if (spread != nullptr && c.output.is_csv()) {
    spread_csv(m, *spread, sink);
  } else if (spread != nullptr && c.output.is_json()) {
    spread_json(m, spectrum, *spread, sink);
    out.write("\n");
  } else {
    out.write(c.output.report([&] { return answer_text(m, spectrum, spread, c.output.verbose) + hint(c, m); },
                              [&] { return answer_json(m, spectrum); }, [&] { return answer_csv(m); }));
  }
}

/// The exit code of the match, unless it is done and the spectrum beside it is not.
Exit exit_code_beside(const std::optional<Spectrum> &spectrum, Outcome outcome) {
  const bool is_cut = outcome == Outcome::done && spectrum && !spectrum->complete;
  return is_cut ? Exit::limited : exit_code(outcome);
}

/// True for a name that Coq takes a module from.
bool is_coq_file(const std::string &path) {
  const std::filesystem::path name = filesystem_path(path).filename();
  const std::string module = path_name(name.stem());
  const auto is_letter = [](char ch) {
    return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z') || ch == '_';
  };
  return name.extension() == ".v" && is_letter(module.front()) &&
         std::all_of(module.begin(), module.end(),
                     [&](char ch) { return is_letter(ch) || (ch >= '0' && ch <= '9'); });
}

/// The theorem names the gradation as the checkers' verdicts do. Where they could not read it in the user's
/// file, it is that in canonical CSV, and is named so.
std::string theorem(const SolveCommand &c, const Target &asked, const Match &m,
                    const std::string &certificate) {
  const std::string file = path_name(filesystem_path(*c.coq).filename());
  const std::string source = c.flags.source(c.file);
  const std::string name = source == "-" ? "standard input" : printable(source);
  return coq_file(m, {asked.is_canonical ? name : name + " as canonical CSV",
                      asked.is_canonical ? asked.bytes : asked.canonical(), certificate,
                      "coqc -Q " MDM_COQ_FOLDER " Mdm " + file});
}

void check_files(const SolveCommand &c) {
  c.flags.check_source(c.file, c.reading.given(), "solve");
  if (c.spectrum && c.flags.is_tolerant())
    throw InputError(option("spectrum") + ": it is of exact matches: leave it out, or " +
                     option("tolerance") + " and " + option("band"));
  if (c.spectrum && c.output.is_csv())
    throw InputError(option("spectrum") + ": CSV has no place for it: use " + option("format") +
                     " text or json");
  if (c.spectrum && c.flags.budget.particles)
    throw InputError(option("spectrum") + ": it is of exact matches: leave it out, or " +
                     option("particles"));
  if (c.seed && !c.spread)
    throw InputError(option("seed") + ": it is of a spread: add " + option("spread") + ", or leave it out");
  if (c.proof == "-" || c.vipr == "-")
    throw InputError(option("proof") + " and " + option("vipr") +
                     " need a file: standard output has the answer");
  if (c.coq && !is_coq_file(*c.coq))
    throw InputError(option("coq") +
                     ": Coq takes file names of letters, digits and _ that end in .v: give for example "
                     "sand.v");
  std::vector<std::string> paths = {c.flags.source(c.file)};
  for (const std::optional<std::string> &path : {c.proof, c.vipr, c.coq, c.output.out})
    if (path)
      paths.push_back(*path);
  if (c.proof && c.flags.budget.particles)
    paths.push_back(finer_proof(*c.proof));
  check_distinct(paths);
  std::for_each(paths.begin() + 1, paths.end(), refuse_protected);
}

std::uint64_t seed_of(const SolveCommand &c) {
  return seed64("seed", c.seed.value_or("1"));
}

/// The second proof of a budget; a note says where one of another run is in its place.
void add_finer(std::vector<SideFile> &files, const std::string &path,
               const std::optional<std::string> &certificate, std::vector<std::string> &notes) {
  if (certificate)
    files.push_back({std::make_unique<Output>(path), *certificate});
  else if (std::filesystem::exists(filesystem_path(path)))
    notes.push_back(printable(path) + " is of another run: this one has no such proof");
}

/// The proofs that were asked for. Notes say which are not written, and where the gradation is written for
/// mdm-check.
std::vector<SideFile> side_files(const SolveCommand &c, const Target &asked, Found &found) {
  Match &m = found.match;
  const std::string &source = c.flags.source(c.file);
  std::vector<SideFile> files;
  const auto add = [&](const std::optional<std::string> &path, bool can_be,
                       const std::function<std::string()> &text) {
    if (path && can_be)
      files.push_back({std::make_unique<Output>(*path), in_file(source, text)});
    else if (path)
      m.notes.push_back(
          "no proof was written to " + printable(*path) + ": the limit came before the end" +
          (std::filesystem::exists(filesystem_path(*path)) ? "; the file that is there is older" : ""));
  };
  std::string made;
  if ((c.proof || c.coq) && has_certificate(m))
    made = in_file(source, [&] { return noted_certificate(m); });
  add(c.proof, has_certificate(m), [&] { return made; });
  if (!files.empty())
    if (std::optional<SideFile> csv = readable_gradation(c, asked, m.notes))
      files.push_back(std::move(*csv));
  if (c.proof && !is_stream(*c.proof))
    add_finer(files, finer_proof(*c.proof), in_file(source, [&] { return finer_certificate(found); }),
              m.notes);
  add(c.vipr, m.complete, [&] { return vipr(m); });
  add(c.coq, has_certificate(m), [&] { return theorem(c, asked, m, made); });
  return files;
}

/// An option that has no use for a gradation by number, but those of SolveFlags; empty: none.
std::string idle_for_numbers(const SolveCommand &c) {
  if (const std::string budget = c.flags.budget.given(); !budget.empty())
    return budget;
  const std::pair<const char *, bool> given[] = {{"vipr", c.vipr.has_value()}, {"coq", c.coq.has_value()},
                                                 {"seed", c.seed.has_value()}, {"spectrum", c.spectrum},
                                                 {"spread", c.spread},         {"verbose", c.output.verbose}};
  for (const auto &[name, is_given] : given)
    if (is_given)
      return option(name);
  return c.reading.given();
}

/// An option that has no use for a gradation of several materials; empty: none.
std::string idle_for_materials(const SolveCommand &c) {
  if (const std::string idle = c.flags.idle_for_materials(c.flags.budget); !idle.empty())
    return idle;
  const std::pair<const char *, bool> given[] = {
      {"coq", c.coq.has_value()}, {"seed", c.seed.has_value()}, {"spread", c.spread}};
  for (const auto &[name, is_given] : given)
    if (is_given)
      return option(name);
  return c.reading.given();
}

Exit run(const SolveCommand &c) {
  check_files(c);
  std::string content;
  if (c.file) {
    refuse_sample(*c.file);
    content = read_file(*c.file, max_gradation_bytes);
    if (is_number_gradation(content))
      return solve_number({*c.file, content, c.flags, c.output, c.proof, idle_for_numbers(c)});
    if (is_material_gradation(content))
      refuse_beside_materials(idle_for_materials(c), *c.file);
  }
  std::string band;
  const ReadBand read_band = [&band](const std::string &path) {
    band = read_file(path, max_gradation_bytes);
    return read_envelope(band, shown_name(path));
  };
  const AskedSearch search(c.flags, c.flags.budget, read_band, c.asks_proof());
  const std::uint64_t seed = seed_of(c);
  const Target asked = target(c, search.question().rest, band, std::move(content));
  Question question = search.question().of(asked.gradation);
  question.band_alone = !c.file;
  Output out(c.output.path());

  const std::string &source = c.flags.source(c.file);
  Found found = in_file(source, [&] {
    if (c.proof || c.coq)
      check_certifiable(asked_gradation(asked.gradation, question), question);
    return searched(search, asked.gradation, question, c.output.quiet);
  });
  Match &m = found.match;
  const ProgressLine progress([] { return std::string("writing"); }, c.output.quiet);
  std::optional<Spectrum> reachable;
  if (c.spectrum)
    reachable = spectrum(m, found.limits);
  std::optional<Spread> particles;
  if (c.spread && m.has_answer())
    particles = spread(m, seed);

  std::vector<SideFile> files;
  if (c.asks_proof())
    files = side_files(c, asked, found);
  for (const SideFile &file : files)
    file.output->write(file.text);
  report(c, m, reachable ? &*reachable : nullptr, particles ? &*particles : nullptr, out);
  // CSV has no place for a verdict and a budget.
  if (c.output.is_csv() && m.status != Status::optimal)
    tell(printable(m.gradation.id()) + ": " + headline(m) + "\n");
  if (c.output.is_csv() && m.budget && !c.output.quiet)
    tell(printable(m.gradation.id()) + ": " + budget_text(*m.budget) + "\n");
  c.output.tell_notes_beside_csv(m.notes);
  for (const SideFile &file : files)
    file.output->commit();
  out.commit();
  return exit_code_beside(reachable, found.outcome);
}

} // namespace

Run add_solve(CLI::App &app) {
  const auto c = std::make_shared<SolveCommand>();
  CLI::App &command = *app.add_subcommand("solve", "The smallest set of particles that matches a gradation");
  command.add_option(
      "FILE", c->file,
      "gradation: CSV, JSON, AGS4, or another file that mdm convert reads, or CSV with shares by "
      "number (number_percent, cumulative_number_percent), or CSV of several materials (material); "
      "- for standard input; needed "
      "unless there is a --band");
  c->flags.add_to(command);
  const OptionGroup group(command, "The answer");
  command
      .add_option("--proof", c->proof,
                  "write the certificate for mdm-check; where a limit ends the search, of the bounds")
      ->type_name("OUT");
  command.add_option("--vipr", c->vipr, "write the proof in the VIPR format (at most 200 classes)")
      ->type_name("OUT");
  command
      .add_option(
          "--coq", c->coq,
          "write the theorem that Coq checks with its kernel alone; where a limit ends the search, of the "
          "bounds")
      ->type_name("OUT");
  command.add_flag("--spectrum", c->spectrum, "all numbers of particles that have an exact match");
  command.add_flag("--spread", c->spread,
                   "sizes for all particles, uniform by volume in their class as far as its exact mass lets "
                   "them (CSV: a row a particle)");
  command.add_option("--seed", c->seed, "of a spread's sizes (1)")->type_name("K");
  c->output.add_verbose(command, "in text also the scale: its window and the one that was chosen");
  c->output.add_format(command);
  c->output.add_out(command, "write the answer");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Exit code 1: no match within what was asked; 3: a limit was reached, and the answer says "
                "what is certain."),
      {"mdm solve sand.csv --min-per-class 10 --proof sand.proof",
       "mdm solve sand.csv --tolerance retained:1%", "mdm solve sand.csv --particles 500 --tolerance passing",
       "mdm solve sand.csv --specimen cylinder:50x100 --void-ratio 0.6 --format json",
       "mdm solve sand.csv --specimen cylinder:50x100 --void-ratio 0.6 --particles 20000 --by size-factor"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

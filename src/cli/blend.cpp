#include "ask/blend.hpp"

#include "ask/option_values.hpp"
#include "blend/target_curve.hpp"
#include "cli/blend_problems.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/plot_flag.hpp"
#include "cli/reading_flags.hpp"
#include "cli/whole_number.hpp"
#include "files/byte_source.hpp"
#include "files/file_ending.hpp"
#include "files/interrupt.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "gradation/csv_reader.hpp"
#include "plot/curves_figure.hpp"
#include "text/file_names.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/judge/specification.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct BlendCommand {
  std::vector<std::string> files;
  std::string specification;
  OptionText problems;
  unsigned threads = 1;
  BlendTexts asked;
  OptionText blended, proof, vipr;
  std::vector<std::string> densities; ///< of the stockpiles in the blend's gradation
  PlotFlag plot;
  ReadingFlags reading;
  OutputFlags output;
};

/// The gradation of the best blend, where it is to be written and there is one; notes are told.
std::optional<std::string> blended_file(const BlendCommand &c, const Blending &blending) {
  if (!c.blended)
    return std::nullopt;
  const std::optional<Gradation> g =
      c.densities.empty() ? blending.blended() : blending.blended_with(c.densities);
  if (!g)
    return std::nullopt;
  c.output.tell_notes(g->notes());
  return c.blended->ends_with(".json") ? gradation_json(*g) : gradation_csv(*g);
}

/// The gradation of a stockpile; where there is to be a proof, of a file that mdm-check reads as it is.
Gradation stockpile_in(const std::string &file, const BlendCommand &c) {
  UnderstoodGradation g = any_curve(file, c.reading, c.output.quiet);
  if (c.proof && (!g.is_canonical || c.reading.is_given() || !is_plain_file(file)))
    throw InputError(option("proof") + ": mdm-check does not read " + shown_name(file) +
                     " as it was read: let mdm convert write it, and give that");
  return std::move(g.gradation);
}

/// The limits of the specification; where there is to be a proof, of a file that mdm-check reads as it is.
Envelope specification_in(const BlendCommand &c) {
  if (const std::optional<Specification> shipped = shipped_specification(c.specification)) {
    if (c.proof)
      throw InputError(
          fmt::format("{}: mdm-check reads files, and {} comes with mdm: give its file, of the folder "
                      "share/exactmdm/specifications",
                      option("proof"), c.specification));
    return envelope_of(*shipped);
  }
  const std::string content = read_file(c.specification, max_gradation_bytes);
  Envelope e = read_envelope(content, shown_name(c.specification));
  if (c.proof &&
      (!is_canonical_envelope(content) || e.passing_max.back() != 100 || !is_plain_file(c.specification)))
    throw InputError(
        option("proof") + ": mdm-check does not read " + shown_name(c.specification) +
        ": give size_mm,passing_min_percent,passing_max_percent, with a largest sieve that lets 100 "
        "percent pass");
  return e;
}

/// The gradation in the file of the target, or a curve that is computed.
Gradation target_in(const BlendCommand &c, const Envelope &specification) {
  const std::string &target = *c.asked.target;
  if (!names_target_curve(target))
    return any_curve(target, {}, c.output.quiet).gradation;
  return gradation_of(named("target", target, parse_target_curve), specification, target);
}

void check_files(const BlendCommand &c) {
  std::vector<std::string> paths = c.files;
  paths.push_back(c.specification);
  if (c.asked.target && !names_target_curve(*c.asked.target))
    paths.push_back(*c.asked.target);
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw InputError("standard input can be one file alone: give the others by name");
  for (const auto &[name, path] : {std::pair("proof", c.proof), std::pair("vipr", c.vipr)})
    if (path == "-")
      throw InputError(option(name) + " needs a file: standard output has the report");
  if (!c.densities.empty() && (!c.blended || c.blended->ends_with(".json")))
    throw InputError(option("density") + ": it is of the materials in " + option("blended") +
                     " OUT, which are in CSV: give it such a file");
  if (c.blended == "-")
    throw InputError(option("blended") + " needs a file: standard output has the report");
  for (const std::string &path : paths) // the target may be a stockpile
    check_distinct({path, c.output.path(), c.blended.value_or("-"), c.proof.value_or("-"),
                    c.vipr.value_or("-"), c.plot.path()});
  c.plot.check();
}

/// The files beside the report. They are opened before the search, so that what cannot be written is said at
/// once.
class SideOutputs {
public:
  explicit SideOutputs(const BlendCommand &c) : paths_{c.blended, c.proof, c.vipr} {
    for (const OptionText &path : paths_)
      outputs_.push_back(path ? std::make_unique<Output>(*path) : nullptr);
  }

  /// Writes the texts that there are, one for each path. \return notes on the others
  std::vector<std::string> write(const std::vector<std::optional<std::string>> &texts) {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (texts[i]) {
        outputs_[i]->write(*texts[i]);
      } else if (paths_[i]) {
        outputs_[i].reset();
        notes.push_back(shown_name(*paths_[i]) + " is not written: there is nothing to write");
      }
    return notes;
  }
  void commit() const {
    for (const std::unique_ptr<Output> &output : outputs_)
      if (output)
        output->commit();
  }

private:
  std::vector<OptionText> paths_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

/// Stockpiles, target and the best blend beside the limits.
Figure figure_of(const std::vector<Gradation> &stockpiles, const Envelope &specification,
                 const std::optional<Gradation> &target, const Blending &blending) {
  const std::optional<Gradation> blended = blending.blended();
  CurvesFigure figure{blended ? "" : "no blend", {}, specification, {}};
  if (blended)
    figure.curves.push_back({"blend", *blended, DrawnCurve::Weight::thick});
  if (target)
    figure.curves.push_back({"target", *target, DrawnCurve::Weight::dashed});
  for (const Gradation &g : stockpiles)
    figure.curves.push_back({g.id(), g, DrawnCurve::Weight::thin});
  Figure drawn = curves_figure(figure);
  drawn.remarks = blending.problem().notes;
  return drawn;
}

/// Refuses what the lines of problems have no use for.
void check_alone(const BlendCommand &c) {
  const BlendTexts &a = c.asked;
  if (!c.files.empty() || !c.specification.empty() || a.target || a.minimise || a.step || a.at_most ||
      a.relax || !a.costs.empty() || !a.shares.empty() || !a.limits.empty() || !c.densities.empty() ||
      c.blended || c.proof || c.vipr || c.plot || c.reading.is_given())
    throw InputError(option("problems") + ": its lines say all that is asked: beside it stand " +
                     option("all") + ", " + option("node-limit") + ", " + option("time-limit") +
                     ", -j, -o and " + option("quiet") + " alone");
  if (c.output.asked_format && !c.output.is_json())
    throw InputError(option("problems") + ": the answers are JSON Lines: leave out " + option("format"));
  if (c.output.out && !c.output.asked_format)
    check_ending(*c.output.out, {"jsonl", "ndjson", "json"}, "blend",
                 "; the answers to " + option("problems") + " are JSON Lines");
  check_distinct({*c.problems, c.output.path()});
}

int run(const BlendCommand &c) {
  if (c.problems) {
    check_alone(c);
    return blend_problems(*c.problems, c.asked, c.threads, c.output);
  }
  if (c.output.out && !c.output.asked_format)
    check_ending(*c.output.out, {"txt", "json", "csv"}, "blend",
                 "; .jsonl is for " + option("problems") + ", with one answer a line");
  if (c.files.empty() || c.specification.empty())
    throw InputError("give the gradations of stockpiles and " + option("spec") + ", or " +
                     option("problems"));
  check_files(c);
  static_cast<void>(c.asked.aim()); // what is wrong is said before a file is read
  std::vector<Gradation> stockpiles;
  for (const std::string &file : c.files)
    stockpiles.push_back(stockpile_in(file, c));
  const Envelope specification = specification_in(c);
  std::optional<Gradation> target;
  if (c.asked.target)
    target = target_in(c, specification);
  Blending blending(c.asked, stockpiles, specification, target);
  Output out(c.output.path());
  SideOutputs beside(c);
  {
    const Interrupt interrupt;
    blending.search([] { return !Interrupt::was_pressed(); });
    if (blending.outcome() == Outcome::limited && Interrupt::was_pressed())
      blending.add_note("the search was interrupted");
  }
  const std::unique_ptr<Output> plot =
      c.plot ? c.plot.drawn(figure_of(stockpiles, specification, target, blending), c.output.quiet) : nullptr;
  const std::optional<std::string> blended = blended_file(c, blending);
  const std::optional<std::string> vipr = c.vipr ? blending.vipr() : std::nullopt;
  const std::vector<std::string> unwritten =
      beside.write({blended, c.proof ? blending.proof() : std::nullopt, vipr});
  const BlendReport r = blending.report();
  out.write(c.output.report([&] { return blend_text(r); }, [&] { return blend_json(r); },
                            [&] { return blend_csv(r); }));
  c.output.tell_notes_beside_csv(blending.problem().notes);
  c.output.tell_notes(unwritten);
  beside.commit();
  if (plot)
    plot->commit();
  out.commit();
  return exit_code(blending.outcome());
}

void add_question(CLI::App &command, BlendCommand &c) {
  const OptionGroup group(command, "The question");
  command
      .add_option("--spec", c.specification,
                  "the limits: CSV with passing_min_percent,passing_max_percent, another envelope, or a name "
                  "that mdm judge knows")
      ->type_name("SPEC");
  add_options(command, BlendTexts::question_options, c.asked);
}

void add_answer(CLI::App &command, BlendCommand &c) {
  const OptionGroup group(command, "The answer");
  add_options(command, BlendTexts::answer_options, c.asked);
  command.add_option("--blended", c.blended, "write the gradation of the best blend to OUT (CSV, or .json)")
      ->type_name("OUT");
  command
      .add_option(
          "--density", c.densities,
          "the density of each stockpile, as A=2650,B=2710: the gradation of the blend then keeps them "
          "apart, each a material with its density as factor")
      ->type_name("NAME=DENSITY,...");
  command
      .add_option("--proof", c.proof,
                  "write a proof of the best blend, or that there is none, for mdm-check SPEC FILE... OUT")
      ->type_name("OUT");
  command
      .add_option("--vipr", c.vipr,
                  "write the proof in the VIPR format; not of squares, nor with --at-most-stockpiles")
      ->type_name("OUT");
  c.plot.add_to(command, "draw the stockpiles, the best blend and the limits");
  add_options(command, BlendTexts::limit_options, c.asked);
}

} // namespace

Run add_blend(CLI::App &app) {
  const auto c = std::make_shared<BlendCommand>();
  CLI::App &command =
      *app.add_subcommand("blend", "The best mix of stockpiles within a specification, or why there is none");
  command.add_option(
      "FILE", c->files,
      "gradations of the stockpiles, any that mdm convert reads; their names are those of the files");
  command
      .add_option("--problems", c->problems,
                  "in place of FILE and --spec: many problems, one a line, each an object with the members "
                  "stockpiles, sieves, steps, at_most and aim of mdm-blend-1, and an id; an answer a line")
      ->type_name("JSONL");
  command.add_option("-j", c->threads, "threads, of --problems")
      ->type_name("THREADS")
      ->transform(whole_number(1, 1024))
      ->needs("--problems");
  add_question(command, *c);
  add_answer(command, *c);
  c->output.add_format(command);
  c->output.add_out(command, "write", {"txt", "json", "jsonl", "csv"});
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "Shares are of the mass. All numbers are exact: the blend is the best of all in steps, and keeps "
          "every "
          "limit as it is written. Of blends that are equally good that one comes first of which the first "
          "stockpile has the smaller share, then the second, and so on. What passes a sieve that a stockpile "
          "does "
          "not have is interpolated between its sieves, linear in size, with a note; below its finest sieve "
          "it is "
          "not known. A price is the most that a point more room at a limit saves, near the best real "
          "shares.") +
          "\n" +
          paragraph("Exit code 1: there is no blend. The report says which limits contradict each other, and "
                    "by how "
                    "much they must be widened."),
      {"mdm blend sand.csv gravel.csv dust.csv --spec limits.csv",
       "mdm blend A.csv B.csv C.csv --spec limits.csv --cost A=7,B=10.82,C=9.5 --share C=5..30%",
       "mdm blend A.csv B.csv C.csv --spec limits.csv --target fuller:31.5mm",
       "mdm blend --problems problems.jsonl -j 2 -o answers.jsonl",
       "mdm blend A.csv B.csv --spec limits.csv --target curve.csv --step '5kg of 1000kg' "
       "--blended m.csv"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "ask/plot.hpp"

#include "answer/answer.hpp"
#include "answer/answer_sample.hpp"
#include "ask/asked_search.hpp"
#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/picture.hpp"
#include "cli/reading_flags.hpp"
#include "cli/search_progress.hpp"
#include "cli/soil_flags.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/sample_file.hpp"
#include "files/sample_names.hpp"
#include "files/standard_streams.hpp"
#include "packing/packing_reader.hpp"
#include "plot/curves_figure.hpp"
#include "plot/gradation_figure.hpp"
#include "plot/packing_figure.hpp"
#include "plot/section_figure.hpp"
#include "plot/texture_figure.hpp"
#include "plot/tradeoff_figure.hpp"
#include "plot/triaxial_figure.hpp"
#include "report/sample_notes.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <memory>

namespace mdm::cli {
namespace {

struct PlotCommand {
  std::string file;
  std::vector<std::string> beside; ///< other gradations on the same chart
  PlotTexts asked;
  OutputFlags output;
  PictureFlags picture;
  SoilFlags soil;
  ReadingFlags reading;
};

/// Answers have a line a class.
constexpr std::size_t max_answer_bytes = std::size_t{1} << 30;

/// Refuses what a triangle of textures has no use for.
void check_texture(const PlotCommand &c) {
  const PlotTexts &a = c.asked;
  if (a.sample || a.wants_match() || a.what || a.band || a.bands || a.coarse_left || a.sieve_names ||
      a.colour || a.size_unit || a.soil.is_given())
    throw InputError(option("texture") +
                     " shows gradations as points of a triangle: of the options for what is drawn " +
                     option("beside") + ", " + option("width") + ", " + option("language") + ", " +
                     option("caption") + " and " + option("bare") + " are for it: leave out the others");
}

/// Refuses what curves of several gradations have no use for.
void check_beside(const PlotCommand &c) {
  const PlotTexts &a = c.asked;
  if (a.sample || a.wants_match() || a.what || a.bands || a.coarse_left || a.sieve_names || a.colour ||
      a.size_unit || a.soil.is_given())
    throw InputError(option("beside") + " shows curves alone: of the options for what is drawn " +
                     option("band") + ", " + option("width") + ", " + option("language") + ", " +
                     option("caption") + " and " + option("bare") + " are for it: leave out the others");
}

void check(const PlotCommand &c) {
  c.picture.picture();
  if (c.asked.texture)
    check_texture(c);
  else if (!c.beside.empty())
    check_beside(c);
  c.asked.check();
  std::vector<std::string> inputs = c.beside;
  inputs.push_back(c.file);
  for (const std::optional<std::string> &path : {c.asked.sample, c.asked.band})
    if (path)
      inputs.push_back(*path);
  check_paths(inputs, {c.picture.out.value_or("-")});
}

/// The particles of a sample beside g; also their places where a section is wanted.
std::optional<SphereSample> add_sample(GradationFigure &what, const Gradation &g, const PlotCommand &c,
                                       std::vector<std::string> &notes) {
  DrawnSample sample(g);
  ParticleOptions options;
  options.target = g.unit();
  options.says_otherwise = option("size-unit") + " says";
  if (c.asked.size_unit)
    options.unit = size_unit_of("size-unit", *c.asked.size_unit);
  const std::vector<std::string> read =
      read_sample_file(*c.asked.sample, options, sample.sink(c.asked.wants_section()), c.output.quiet);
  notes.insert(notes.end(), read.begin(), read.end());
  sample.add_to(what);
  if (!c.asked.wants_section())
    return std::nullopt;
  return in_file(*c.asked.sample, [&] { return sample.places(); });
}

/// The match that was asked for, or what is known of it.
Found solved(const Gradation &g, const PlotCommand &c, const std::optional<Envelope> &limits) {
  const AskedSearch search(
      c.asked.match_texts(), c.asked.budget, [&limits](const std::string &) { return limits.value(); },
      false);
  SearchProgress progress(c.output.quiet);
  Found found = in_file(c.file, [&] { return search.ask(g, progress.call()); });
  SearchProgress::note_interrupt(found.match);
  if (c.output.verbose && !c.output.quiet)
    tell(answer_text(found.match, nullptr, nullptr, true));
  return found;
}

/// What the picture does not show of the match: an exact one of the gradation alone needs no words.
/// \param shown  they stand below the picture already
void add_notes(std::vector<std::string> &notes, const Match &m, const std::vector<std::string> &shown) {
  if (!in_words(m.question, m.gradation.unit()).empty())
    notes.push_back(headline(m));
  if (m.budget)
    notes.push_back(budget_text(*m.budget));
  std::copy_if(m.notes.begin(), m.notes.end(), std::back_inserter(notes), [&shown](const std::string &note) {
    return std::find(shown.begin(), shown.end(), note) == shown.end();
  });
}

/// Why there is no match to draw, and what to do.
std::string why_none(const Found &found) {
  const Match &m = found.match;
  if (found.outcome == Outcome::negative)
    return m.budget ? budget_text(*m.budget) : headline(m);
  const std::string least = to_string(m.lower_bound);
  return "the smallest match was not found within the limit, " +
         (m.particles() ? "N in [" + least + ", " + to_string(*m.particles()) + "]" : "N at least " + least) +
         "; give another limit, or an ANSWER of mdm solve --format json in the place of " + option("match");
}

int not_drawn(const PlotCommand &c, const Found &found) {
  tell(printable(shown_name(c.file)) + ": nothing was drawn: " + why_none(found) + "\n");
  return exit_code(found.outcome);
}

int run_packing(const PlotCommand &c, const Packing &packing) {
  if (c.asked.is_of_gradation() || c.asked.has_form() || c.reading.is_given())
    throw InputError(printable(shown_name(c.file)) + " is a packing: of the options for what is drawn " +
                     option("colour") +
                     " alone is for it: leave out "
                     "the others");
  if (packing.discs.empty())
    throw file_error(c.file, "a packing of no disc: there is nothing to draw");
  draw(packing_figure(packing, c.asked.packing_colour()), c.picture, c.output.quiet);
  return Exit::done;
}

/// \param figure  to which the caption is added
int run_figure(const PlotCommand &c, Figure figure) {
  if (c.asked.caption)
    figure.remarks.insert(figure.remarks.begin(), *c.asked.caption);
  draw(figure, c.picture, c.output.quiet);
  return Exit::done;
}

/// Refuses what a diagram that is no gradation's has no use for. \param what  it is of
void check_diagram(const PlotCommand &c, const std::string &what) {
  if (c.asked.is_of_gradation() || c.asked.colour || c.asked.size_unit || c.reading.is_given())
    throw InputError(printable(shown_name(c.file)) + " is " + what + ": of the options for what is drawn " +
                     option("width") + ", " + option("language") + ", " + option("caption") + " and " +
                     option("bare") + " are for it: leave out the others");
}

int run_triaxial(const PlotCommand &c, const TriaxialLog &log) {
  check_diagram(c, "the log of a triaxial model");
  return run_figure(c, triaxial_figure(stem(shown_name(c.file)), log, c.asked.form()));
}

int run_tradeoff(const PlotCommand &c, const StatedTradeoff &tradeoff) {
  check_diagram(c, "a trade-off");
  return run_figure(c, tradeoff_figure(tradeoff, c.asked.form()));
}

/// The band in the file, in which there is a curve.
Envelope band_with_curve(const std::string &file) {
  Envelope band = band_in_file(file);
  if (const std::optional<std::string> why = contradiction(band))
    throw InputError(shown_name(file) + ": no curve is within this band: " + *why + ": correct one of them");
  return band;
}

/// The gradations of all files, with names that tell them apart.
std::vector<DrawnCurve> all_curves(const PlotCommand &c) {
  std::vector<std::string> files = {c.file};
  files.insert(files.end(), c.beside.begin(), c.beside.end());
  std::vector<DrawnCurve> curves;
  for (const std::string &file : files) {
    const Gradation g = any_curve(file, c.reading, c.output.quiet).gradation;
    curves.push_back({g.id(), g});
  }
  tell_apart(curves, &DrawnCurve::name, files);
  return curves;
}

/// The notes of reading them.
std::vector<std::string> notes_of(const std::vector<DrawnCurve> &curves) {
  std::vector<std::pair<std::string, std::vector<std::string>>> notes;
  for (const DrawnCurve &curve : curves)
    notes.emplace_back(curve.name, curve.gradation.notes());
  return notes_of_samples(notes);
}

int run_texture(const PlotCommand &c) {
  const std::vector<DrawnCurve> curves = all_curves(c);
  std::vector<NamedCurve> named;
  named.reserve(curves.size());
  for (const DrawnCurve &curve : curves)
    named.push_back({curve.name, GradingCurve(curve.gradation)});
  Figure drawn = texture_figure(*c.asked.texture_system(), named, c.asked.form());
  const std::vector<std::string> notes = notes_of(curves);
  drawn.remarks.insert(drawn.remarks.end(), notes.begin(), notes.end());
  c.output.tell_notes(drawn.remarks);
  return run_figure(c, std::move(drawn));
}

/// The curves of several gradations.
int run_beside(const PlotCommand &c) {
  const PlotTexts &a = c.asked;
  CurvesFigure figure;
  figure.form = a.form();
  if (a.band)
    figure.limits = band_with_curve(*a.band);
  figure.curves = all_curves(c);
  Figure drawn = curves_figure(figure);
  drawn.remarks = notes_of(figure.curves);
  if (figure.limits)
    drawn.remarks.insert(drawn.remarks.end(), figure.limits->notes.begin(), figure.limits->notes.end());
  c.output.tell_notes(drawn.remarks);
  return run_figure(c, std::move(drawn));
}

int run(const PlotCommand &command) {
  PlotCommand c = command;
  c.asked.soil = command.soil;
  check(c);
  if (c.asked.texture)
    return run_texture(c);
  if (!c.beside.empty())
    return run_beside(c);
  if (is_packing_file(c.file))
    return run_packing(c, read_packing_file(c.file));
  const bool is_sample = is_sample_file(c.file);
  const std::string content = is_sample ? "" : read_file(c.file, max_gradation_bytes);
  if (is_packing(content))
    return run_packing(c, read_packing(content, shown_name(c.file)));
  if (is_tradeoff(content))
    return run_tradeoff(c, read_tradeoff(content, shown_name(c.file)));
  if (is_triaxial_log(content))
    return run_triaxial(c, read_triaxial_log(content, shown_name(c.file)));
  if (c.asked.colour)
    throw InputError(option("colour") + " is for packings: give a FILE that mdm pack -o wrote");
  GradationFigure what = c.asked.figure(is_sample);
  const Gradation read = is_sample ? any_curve(c.file, c.reading, c.output.quiet).gradation
                         : is_answer(content)
                             ? answer_curve(content, shown_name(c.file))
                             : read_gradation(content, shown_name(c.file), c.reading.reading());
  const Gradation g = in_file(c.file, [&] { return c.soil.with_pan(read); });
  std::vector<std::string> notes;
  if (c.asked.band) {
    what.envelope = band_with_curve(*c.asked.band);
    notes.insert(notes.end(), what.envelope->notes.begin(), what.envelope->notes.end());
  }
  std::optional<SphereSample> places;
  if (c.asked.size_unit && (!c.asked.sample || is_answer_file(*c.asked.sample)))
    throw InputError(option("size-unit") + ": it is of a SAMPLE that is a file of particles: leave it out");
  if (c.asked.sample && !is_answer_file(*c.asked.sample)) {
    places = add_sample(what, g, c, notes);
  } else if (c.asked.sample) {
    what.particles = drawn(
        read_answer(read_file(*c.asked.sample, max_answer_bytes), shown_name(*c.asked.sample)), g.unit());
    if (!are_of(what.particles, g))
      notes.push_back(printable(*c.asked.sample) + ": its classes are not all of " + printable(c.file) +
                      ": it was solved with a cut, a pan size or a size factor, or for another gradation");
  } else if (c.asked.wants_match()) {
    const Found found = solved(g, c, what.envelope);
    if (found.outcome != Outcome::done)
      return not_drawn(c, found);
    what.particles = drawn(found.match);
    add_notes(notes, found.match, g.notes());
  }
  const std::string panels = c.asked.what.value_or(what.particles.empty() ? "curve" : "both");
  if (panels != "curve" && what.particles.empty())
    throw InputError(printable(*c.asked.sample) + ": no particle lies in a class: " + option("what") +
                     " curve shows its sizes, or "
                     "give another unit");
  what.curve = panels != "counts";
  what.counts = panels != "curve";
  what.counts = what.counts && panels != "section";
  Figure figure = gradation_figure(g, what);
  figure.remarks.insert(figure.remarks.end(), notes.begin(), notes.end());
  if (c.asked.wants_section()) {
    if (!places)
      throw InputError(option("what") +
                       " section: there are no places of particles: give a SAMPLE such as a dump");
    figure.columns = 2;
    figure.panels.push_back(section_panel(*places, g, figure.panel_height / figure.panel_width));
  }
  c.output.tell_notes(figure.remarks);
  return run_figure(c, std::move(figure));
}

} // namespace

Run add_plot(CLI::App &app) {
  const auto c = std::make_shared<PlotCommand>();
  CLI::App &command = *app.add_subcommand("plot", "A gradation as the field draws it with the particles that "
                                                  "match it, a trade-off, a triaxial test, or a packing of "
                                                  "discs");
  command
      .add_option("FILE", c->file,
                  "gradation (any that mdm convert reads), set of mdm generate, or file of particles as mdm "
                  "verify reads; or a packing that mdm pack -o wrote, a trade-off in JSON, or the log of a "
                  "triaxial model; - for standard input")
      ->required();
  command.add_option(
      "SAMPLE", c->asked.sample,
      "particles to show: an answer of mdm solve, a set of mdm generate with --sizes, or a file of "
      "particles as mdm verify reads, such as a dump");
  command.add_option("--beside", c->beside, "another gradation on the same chart, any number of them")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_options(command, PlotTexts::options, c->asked);
  c->soil.add_to(command);
  add_match_options(command, c->asked.solve, c->asked.budget);
  command.get_option("--digits")
      ->description("taken as solve takes it, without effect here: a picture has no digits of sizes");
  c->picture.add_to(command);
  c->output.add_verbose(command, "on standard error also the answer of a match, with its scale");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Exit code 1: there is no match within what was asked; 3: none was found within the limit, "
                "without one some seconds for an exact match. Nothing is drawn."),
      {"mdm plot sand.csv --match -o sand.svg", "mdm plot sand.csv --tolerance retained:1% -o sand.svg",
       "mdm plot sand.csv settled.dump --what section -o settled.png",
       "mdm plot sand.csv --band limits.csv -o sand.pdf",
       "mdm plot bh1.csv --beside bh2.csv --beside bh3.csv -o bh.svg",
       "mdm plot station1.csv --beside station2.csv --texture folk -o stations.svg",
       "mdm plot start.packing --colour contacts -o start.png",
       "mdm plot sand-triaxial.csv -o sand-triaxial.svg",
       "mdm plot tradeoff.json --language de --width 500 -o tradeoff.svg"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/plot_gradation.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/sample_names.hpp"
#include "packing/packing_reader.hpp"
#include "plot/curves_figure.hpp"
#include "plot/packing_figure.hpp"
#include "plot/texture_figure.hpp"
#include "plot/tradeoff_figure.hpp"
#include "plot/triaxial_figure.hpp"
#include "report/sample_notes.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {

Envelope band_with_curve(const std::string &file) {
  Envelope band = band_in_file(file);
  if (const std::optional<std::string> why = contradiction(band))
    throw InputError(shown_name(file) + ": no curve is within this band: " + *why + ": correct one of them");
  return band;
}

int draw_figure(const PlotCommand &c, Figure figure) {
  if (c.asked.caption)
    figure.remarks.insert(figure.remarks.begin(), *c.asked.caption);
  draw(figure, c.picture, c.output.quiet);
  return Exit::done;
}

namespace {

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

/// Refuses what a diagram that is no gradation's has no use for. \param what  it is of
void check_diagram(const PlotCommand &c, const std::string &what) {
  if (c.asked.is_of_gradation() || c.asked.colour || c.asked.size_unit || c.reading.is_given())
    throw InputError(printable(shown_name(c.file)) + " is " + what + ": of the options for what is drawn " +
                     option("width") + ", " + option("language") + ", " + option("caption") + " and " +
                     option("bare") + " are for it: leave out the others");
}

int run_triaxial(const PlotCommand &c, const TriaxialLog &log) {
  check_diagram(c, "the log of a triaxial model");
  return draw_figure(c, triaxial_figure(stem(shown_name(c.file)), log, c.asked.form()));
}

int run_tradeoff(const PlotCommand &c, const StatedTradeoff &tradeoff) {
  check_diagram(c, "a trade-off");
  return draw_figure(c, tradeoff_figure(tradeoff, c.asked.form()));
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
  return draw_figure(c, std::move(drawn));
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
  return draw_figure(c, std::move(drawn));
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
  return plot_gradation(c, is_sample, content);
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
  command.get_option("--digits")->description("significant digits of the sizes that --verbose tells (15)");
  c->picture.add_to(command);
  c->output.add_verbose(command, "on standard error also the answer of a match, with its scale");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(paragraph("Exit code 1: there is no match within what was asked; 3: the smallest was "
                                  "not found within the limit, "
                                  "without one some seconds for an exact match. Then nothing is drawn, "
                                  "unless the budget alone is open."),
                        {"mdm plot sand.csv --match -o sand.svg",
                         "mdm plot sand.csv --tolerance retained:1% -o sand.svg",
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

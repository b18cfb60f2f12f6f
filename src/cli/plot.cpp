#include "answer/answer_sample.hpp"
#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/packing_file.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/soil_flags.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "match/smallest_match.hpp"
#include "packing/packing_reader.hpp"
#include "particles/description_sink.hpp"
#include "particles/placed_sink.hpp"
#include "particles/sample_sieves.hpp"
#include "plot/gradation_figure.hpp"
#include "plot/packing_figure.hpp"
#include "plot/section_figure.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct PlotCommand {
  std::string file;
  std::optional<std::string> answer, band, bands, what, colour; ///< answer: or another sample
  std::optional<std::string> sieve_names, size_unit;
  bool match = false;
  bool coarse_left = false;
  OutputFlags output;
  PictureFlags picture;
  SoilFlags soil;
  ReadingFlags reading;
};

/// Answers have a line a class.
constexpr std::size_t max_answer_bytes = std::size_t{1} << 30;

void check(const PlotCommand &c) {
  c.picture.picture();
  if (c.answer && c.match)
    throw InputError("SAMPLE and --match: give one of them, particles or the wish for a match");
  if (c.what && *c.what != "curve" && !c.answer && !c.match)
    throw InputError("--what " + *c.what +
                     ": give a SAMPLE, for example the answer of mdm solve --format json, or --match");
  std::vector<std::string> inputs = {c.file};
  for (const std::optional<std::string> &path : {c.answer, c.band})
    if (path)
      inputs.push_back(*path);
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw InputError("-: standard input is one file: give the others by name");
  for (const std::string &input : inputs)
    check_distinct({input, c.picture.out.value_or("-")});
}

/// The classes of an answer with lengths in the gradation's unit.
std::vector<DrawnClass> drawn(const AnswerSample &answer, SizeUnit unit) {
  const Rational factor = in_mm(answer.unit) / in_mm(unit);
  std::vector<DrawnClass> classes;
  for (const AnswerSample::Class &c : answer.classes)
    classes.push_back({drawn_size(c.lower) * factor, drawn_size(c.upper) * factor, c.mass, c.quantity,
                       (c.size_lo + c.size_hi) / 2 * factor});
  return classes;
}

/// The smallest match of the gradation as it is, or what was found of it.
Match solved(const Gradation &g, bool quiet) {
  const Progress progress([] { return std::string("solving"); }, quiet);
  SolveOptions options;
  options.limits.max_steps = most_steps_beside;
  options.limits.keep_proof = false;
  return solve(g, {}, options);
}

std::vector<DrawnClass> drawn(const Match &m) {
  std::vector<DrawnClass> classes;
  for (const MatchClass &c : m.classes())
    if (c.size)
      classes.push_back({drawn_size(c.lower), drawn_size(c.upper), c.mass, c.quantity,
                         (c.size->lower() + c.size->upper()) / 2});
  return classes;
}

/// Gathers particles class by class and size by size.
class DrawnSample : public ParticleSink {
public:
  explicit DrawnSample(const Gradation &g) : classes_(Description(g)) {}

  void restart() override {
    classes_.restart();
    sieves_.restart();
  }
  void add(const RootSize &diameter, const Integer &quantity) override {
    classes_.add(diameter, quantity);
    sieves_.add(diameter, quantity);
  }
  void add(const SizeRange &diameter, const Integer &quantity) override {
    classes_.add(diameter, quantity);
    sieves_.add(diameter, quantity);
  }

  const Description &description() const { return classes_.description(); }
  const SampleSieves &sieves() const { return sieves_; }

private:
  DescriptionSink classes_;
  SampleSieves sieves_;
};

bool wants_section(const PlotCommand &c) {
  return c.what == "section";
}

/// The particles of a sample beside g; also their places where a section is wanted.
std::optional<SphereSample> add_sample(GradationFigure &what, const Gradation &g, const PlotCommand &c,
                                       std::vector<std::string> &notes) {
  DrawnSample sample(g);
  PlacedSink placed(g, sample);
  ParticleOptions options;
  options.target = g.unit();
  options.says_otherwise = "--size-unit says";
  if (c.size_unit)
    options.unit = length_unit_of("size-unit", *c.size_unit);
  ParticleSink &sink = wants_section(c) ? static_cast<ParticleSink &>(placed) : sample;
  const std::vector<std::string> read = read_sample_file(*c.answer, options, sink, c.output.quiet);
  notes.insert(notes.end(), read.begin(), read.end());
  const Description &d = sample.description();
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (const Integer &n = d.of_class(j).count; n > 0)
      what.particles.push_back(
          {drawn_size(g.opening(j)), drawn_size(g.opening(j + 1)), 0, n, drawn_size(g.opening(j + 1))});
  for (const auto &[size, mass] : sample.sieves().masses())
    what.sizes.push_back({size, mass});
  what.outside = d.below().count + d.above().count + d.unplaced().count;
  if (!wants_section(c))
    return std::nullopt;
  return in_file(*c.answer, [&] { return placed.sample(); });
}

/// True if each class of the particles is one of the gradation: not so after a cut, a pan size or a factor.
bool are_of(const std::vector<DrawnClass> &classes, const Gradation &g) {
  std::vector<Rational> sizes;
  for (std::size_t j = 0; j <= g.classes(); ++j)
    sizes.push_back(drawn_size(g.opening(j)));
  return std::all_of(classes.begin(), classes.end(), [&sizes](const DrawnClass &c) {
    const auto lower = std::lower_bound(sizes.begin(), sizes.end(), c.lower);
    return lower != sizes.end() && *lower == c.lower && lower + 1 != sizes.end() && *(lower + 1) == c.upper;
  });
}

/// As asked for; else none of a sample's sizes.
SieveNames sieve_names(const PlotCommand &c, bool is_sample) {
  if (c.sieve_names)
    return *c.sieve_names == "astm"  ? SieveNames::astm
           : *c.sieve_names == "iso" ? SieveNames::iso
                                     : SieveNames::none;
  return is_sample ? SieveNames::none : SieveNames::iso;
}

int limited(const PlotCommand &c, const Match &m) {
  tell(fmt::format("{}: nothing was drawn: the smallest match was not found within {} steps, N in [{}, {}]; "
                   "solve it with mdm solve --format json and give that ANSWER\n",
                   printable(shown_name(c.file)), most_steps_beside, to_string(m.lower_bound),
                   to_string(*m.particles())));
  return Exit::limited;
}

int run_packing(const PlotCommand &c, const Packing &packing) {
  if (c.answer || c.match || c.what || c.band || c.bands || c.coarse_left || c.sieve_names ||
      c.soil.is_given() || c.reading.is_given())
    throw InputError(printable(shown_name(c.file)) +
                     " is a packing: of the options for what is drawn --colour alone is for it: leave out "
                     "the others");
  if (packing.discs.empty())
    throw file_error(c.file, "a packing of no disc: there is nothing to draw");
  const std::string colour = c.colour.value_or("size");
  draw(packing_figure(packing, colour == "size"       ? PackingColour::size
                               : colour == "contacts" ? PackingColour::contacts
                                                      : PackingColour::cells),
       c.picture, c.output.quiet);
  return Exit::done;
}

int run(const PlotCommand &c) {
  check(c);
  if (is_packing_file(c.file))
    return run_packing(c, read_packing_file(c.file));
  const bool is_sample = is_sample_file(c.file);
  const std::string content = is_sample ? "" : read_file(c.file, max_gradation_bytes);
  if (is_packing(content))
    return run_packing(c, read_packing(content, shown_name(c.file)));
  if (c.colour)
    throw InputError("--colour is for packings: give a FILE that mdm pack -o wrote");
  GradationFigure what;
  what.soil = c.soil.describe_options();
  const Gradation read = is_sample ? any_gradation(c.file, c.reading, c.output.quiet).gradation
                                   : read_gradation(content, shown_name(c.file), c.reading.reading());
  const Gradation g = in_file(c.file, [&] { return c.soil.with_pan(read); });
  std::vector<std::string> notes;
  if (c.bands && c.bands != "uscs")
    what.bands = c.bands == "iso" ? Bands::iso_14688 : Bands::none;
  what.coarse_left = c.coarse_left;
  what.sieve_names = sieve_names(c, is_sample);
  if (is_sample)
    what.curve_title = "set of particles";
  if (c.band) {
    what.envelope = band_in_file(*c.band);
    if (const std::optional<std::string> why = contradiction(*what.envelope))
      throw InputError(shown_name(*c.band) + ": no curve is within this band: " + *why +
                       ": correct one of them");
    notes.insert(notes.end(), what.envelope->notes.begin(), what.envelope->notes.end());
  }
  std::optional<SphereSample> places;
  if (c.size_unit && (!c.answer || is_answer_file(*c.answer)))
    throw InputError("--size-unit: it is of a SAMPLE that is a file of particles: leave it out");
  if (c.answer && !is_answer_file(*c.answer)) {
    places = add_sample(what, g, c, notes);
  } else if (c.answer) {
    what.particles =
        drawn(read_answer(read_file(*c.answer, max_answer_bytes), shown_name(*c.answer)), g.unit());
    if (!are_of(what.particles, g))
      notes.push_back(printable(*c.answer) + ": its classes are not all of " + printable(c.file) +
                      ": it was solved with a cut, a pan size or a size factor, or for another gradation");
  } else if (c.match) {
    const Match m = solved(g, c.output.quiet);
    if (!m.complete)
      return limited(c, m);
    what.particles = drawn(m);
  }
  const std::string panels = c.what.value_or(what.particles.empty() ? "curve" : "both");
  if (panels != "curve" && what.particles.empty())
    throw InputError(printable(*c.answer) + ": no particle lies in a class: --what curve shows its sizes, or "
                                            "give another unit");
  what.curve = panels != "counts";
  what.counts = panels != "curve";
  what.counts = what.counts && panels != "section";
  Figure figure = gradation_figure(g, what);
  figure.remarks.insert(figure.remarks.end(), notes.begin(), notes.end());
  if (wants_section(c)) {
    if (!places)
      throw InputError("--what section: there are no places of particles: give a SAMPLE such as a dump");
    figure.columns = 2;
    figure.panels.push_back(section_panel(*places, g, figure.panel_height / figure.panel_width));
  }
  draw(figure, c.picture, c.output.quiet);
  c.output.tell_notes(figure.remarks);
  return Exit::done;
}

} // namespace

Run add_plot(CLI::App &app) {
  const auto c = std::make_shared<PlotCommand>();
  CLI::App &command = *app.add_subcommand("plot", "A gradation as the field draws it with the particles that "
                                                  "match it, or a packing of discs");
  command
      .add_option("FILE", c->file,
                  "gradation (any that mdm convert reads), set of mdm generate, or file of particles as mdm "
                  "verify reads; or a "
                  "packing that mdm pack -o wrote; - for standard input")
      ->required();
  command.add_option(
      "SAMPLE", c->answer,
      "particles to show: an answer of mdm solve, a set of mdm generate with --sizes, or a file of "
      "particles as mdm verify reads, such as a dump");
  command.add_flag("--match", c->match, "show the smallest match: solve now");
  command
      .add_option(
          "--what", c->what,
          "curve, counts or both; both where there are particles, else curve; or section: of a SAMPLE with "
          "places, the curve and an upright cut through its middle, coloured by class")
      ->check(CLI::IsMember({"curve", "counts", "both", "section"}));
  command
      .add_option("--band", c->band,
                  "show an envelope: CSV with passing_min_percent,passing_max_percent, or a table with "
                  "columns such as "
                  "Lower and Upper")
      ->type_name("FILE");
  command.add_option("--bands", c->bands, "size bands: uscs, iso (14688) or none (uscs)")
      ->check(CLI::IsMember({"uscs", "iso", "none"}));
  command
      .add_option(
          "--sieve-names", c->sieve_names,
          "at the sieves: astm (No. 200, 3/8 in), iso (their openings, the default), or none (the default "
          "of particles)")
      ->check(CLI::IsMember({"astm", "iso", "none"}));
  command.add_flag("--coarse-left", c->coarse_left, "coarse sizes on the left, as in the United States");
  command
      .add_option(
          "--colour", c->colour,
          "of a packing, whose discs are drawn at scale: by their size (the default), by the number of "
          "others that they touch (contacts), or of the cells of the contact graph by their corners "
          "(cells)")
      ->check(CLI::IsMember({"size", "contacts", "cells"}));
  command
      .add_option("--size-unit", c->size_unit,
                  "unit of SAMPLE where it is a file of particles: as in mdm verify")
      ->type_name("UNIT");
  c->soil.add_to(command);
  c->picture.add_to(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(
      footer(paragraph("Exit code 3: --match was not solved within some seconds; nothing is drawn."),
             {"mdm plot sand.csv --match -o sand.svg",
              "mdm plot sand.csv settled.dump --what section -o settled.png",
              "mdm plot sand.csv --band limits.csv -o sand.pdf",
              "mdm plot start.packing --colour contacts -o start.png"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

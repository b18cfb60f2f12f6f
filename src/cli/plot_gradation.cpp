#include "cli/plot_gradation.hpp"

#include "answer/answer.hpp"
#include "answer/answer_sample.hpp"
#include "ask/asked_search.hpp"
#include "ask/option_values.hpp"
#include "cli/exit_code.hpp"
#include "cli/searched.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/standard_streams.hpp"
#include "plot/gradation_figure.hpp"
#include "plot/section_figure.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <iterator>

namespace mdm::cli {
namespace {

/// Answers have a line a class.
constexpr std::size_t max_answer_bytes = std::size_t{1} << 30;

/// A picture while it is put together.
struct Draft {
  GradationFigure figure;
  std::vector<std::string> notes;
  std::optional<SphereSample> places; ///< of a section
};

void add(std::vector<std::string> &notes, const std::vector<std::string> &more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

Gradation gradation_in_file(const PlotCommand &c, bool is_sample, const std::string &content) {
  return is_sample            ? any_curve(c.file, c.reading, c.output.quiet).gradation
         : is_answer(content) ? answer_curve(content, shown_name(c.file))
                              : read_gradation(content, shown_name(c.file), c.reading.reading());
}

/// The particles of a sample beside g; also their places where a section is wanted.
void add_sample(Draft &draft, const Gradation &g, const PlotCommand &c) {
  DrawnSample sample(g);
  ParticleOptions options;
  options.target = g.unit();
  options.says_otherwise = option("size-unit") + " says";
  if (c.asked.size_unit)
    options.unit = size_unit_of("size-unit", *c.asked.size_unit);
  add(draft.notes,
      read_sample_file(*c.asked.sample, options, sample.sink(c.asked.wants_section()), c.output.quiet));
  sample.add_to(draft.figure);
  if (c.asked.wants_section())
    draft.places = in_file(*c.asked.sample, [&] { return sample.places(); });
}

/// The particles of an answer.
void add_answer(Draft &draft, const Gradation &g, const PlotCommand &c) {
  const std::string &path = *c.asked.sample;
  draft.figure.particles = drawn(read_answer(read_file(path, max_answer_bytes), shown_name(path)), g.unit());
  if (!are_of(draft.figure.particles, g))
    draft.notes.push_back(
        printable(path) + ": its classes are not all of " + printable(c.file) +
        ": it was solved with a cut, a pan size or a size factor, or for another gradation");
}

/// The match that was asked for, or what is known of it.
Found solved(const Gradation &g, const PlotCommand &c, const std::optional<Envelope> &limits) {
  const AskedSearch search(
      c.asked.match_texts(), c.asked.budget, [&limits](const std::string &) { return limits.value(); },
      false);
  Found found = in_file(c.file, [&] { return searched(search, g, search.question().of(g), c.output.quiet); });
  if (c.output.verbose && !c.output.quiet)
    tell(answer_text(found.match, nullptr, nullptr, true));
  return found;
}

/// The particles of a match. What the picture does not show of it is noted: an exact one of the gradation
/// alone needs no words, and notes of the gradation stand below the picture already.
void add_match(Draft &draft, const Match &m) {
  draft.figure.particles = drawn(m);
  if (!in_words(m.question, m.gradation.unit()).empty())
    draft.notes.push_back(headline(m));
  if (m.budget)
    draft.notes.push_back(budget_text(*m.budget));
  const std::vector<std::string> &shown = m.gradation.notes();
  std::copy_if(m.notes.begin(), m.notes.end(), std::back_inserter(draft.notes),
               [&shown](const std::string &note) {
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

/// The panels that are asked for, one below the other, a section beside them.
Figure finished(Draft draft, const Gradation &g, const PlotCommand &c) {
  const std::string panels = c.asked.what.value_or(draft.figure.particles.empty() ? "curve" : "both");
  if (panels != "curve" && draft.figure.particles.empty())
    throw InputError(printable(*c.asked.sample) + ": no particle lies in a class: " + option("what") +
                     " curve shows its sizes, or give another unit");
  if (c.asked.wants_section() && !draft.places)
    throw InputError(option("what") +
                     " section: there are no places of particles: give a SAMPLE such as a dump");
  draft.figure.curve = panels != "counts";
  draft.figure.counts = panels == "counts" || panels == "both";
  Figure figure = gradation_figure(g, draft.figure);
  add(figure.remarks, draft.notes);
  if (draft.places) {
    figure.columns = 2;
    figure.panels.push_back(section_panel(*draft.places, g, figure.panel_height / figure.panel_width));
  }
  return figure;
}

} // namespace

int plot_gradation(const PlotCommand &c, bool is_sample, const std::string &content) {
  const bool has_answer = c.asked.sample && is_answer_file(*c.asked.sample);
  if (c.asked.size_unit && (!c.asked.sample || has_answer))
    throw InputError(option("size-unit") + ": it is of a SAMPLE that is a file of particles: leave it out");
  Draft draft{c.asked.figure(is_sample), {}, {}};
  const Gradation read = gradation_in_file(c, is_sample, content);
  Gradation g = in_file(c.file, [&] { return c.soil.with_pan(read); });
  if (c.asked.band) {
    draft.figure.envelope = band_with_curve(*c.asked.band);
    add(draft.notes, draft.figure.envelope->notes);
  }
  int exit = Exit::done;
  if (c.asked.wants_match()) {
    const Found found = solved(read, c, draft.figure.envelope);
    exit = exit_code(found.outcome);
    if (found.outcome != Outcome::done && found.match.status != Status::optimal) {
      tell(printable(shown_name(c.file)) + ": nothing was drawn: " + why_none(found) + "\n");
      return exit;
    }
    add_match(draft, found.match);
    g = found.match.gradation; // as it was asked for: cut, magnified
  } else if (has_answer) {
    add_answer(draft, g, c);
  } else if (c.asked.sample) {
    add_sample(draft, g, c);
  }
  const Figure figure = finished(std::move(draft), g, c);
  c.output.tell_notes(figure.remarks);
  draw_figure(c, figure);
  return exit;
}

} // namespace mdm::cli

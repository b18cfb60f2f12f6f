#include "ask/plot.hpp"

#include "ask/option_values.hpp"
#include "match/smallest_match.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {

const std::vector<OptionRow<PlotTexts>> PlotTexts::options = {
    {"match", "", OptionKind::flag,
     "show the smallest match: solve now; options of solving say how, and mean it too", &PlotTexts::match},
    {"what",
     "TEXT",
     OptionKind::text,
     "curve, counts or both; both where there are particles, else curve; or section: of a SAMPLE with "
     "places, the curve and an upright cut through its middle, coloured by class",
     &PlotTexts::what,
     {"curve", "counts", "both", "section"}},
    {"band", "FILE", OptionKind::file,
     "show an envelope, in which a match is to be: CSV with passing_min_percent,passing_max_percent, or a "
     "table with columns such as Lower and Upper",
     &PlotTexts::band},
    {"bands",
     "TEXT",
     OptionKind::text,
     "size bands: uscs, iso (14688) or none (uscs)",
     &PlotTexts::bands,
     {"uscs", "iso", "none"}},
    {"sieve-names",
     "TEXT",
     OptionKind::text,
     "at the sieves: astm (No. 200, 3/8 in), iso (their openings, the default), or none (the default "
     "of particles)",
     &PlotTexts::sieve_names,
     {"astm", "iso", "none"}},
    {"coarse-left", "", OptionKind::flag, "coarse sizes on the left, as in the United States",
     &PlotTexts::coarse_left},
    {"colour",
     "TEXT",
     OptionKind::text,
     "of a packing, whose discs are drawn at scale: by their size (the default), by the number of "
     "others that they touch (contacts), or of the cells of the contact graph by their corners "
     "(cells)",
     &PlotTexts::colour,
     {"size", "contacts", "cells"}},
    {"texture",
     "SYSTEM",
     OptionKind::text,
     "the triangle of textures with the gradation as a point in it: folk (mud, sand, gravel), shepard or "
     "usda "
     "(sand, silt, clay)",
     &PlotTexts::texture,
     {"folk", "shepard", "usda"}},
    {"size-unit", "UNIT", OptionKind::text,
     "unit of SAMPLE where it is a file of particles: as in mdm verify", &PlotTexts::size_unit},
    {"width", "PT", OptionKind::number,
     "width of the picture in pt, from 200 to 5000; letters stay as large as they are", &PlotTexts::width},
    {"language",
     "TEXT",
     OptionKind::text,
     "language of the picture's own words: en (the default) or de; names and notes stay as they are",
     &PlotTexts::language,
     {"en", "de"}},
    {"caption", "TEXT", OptionKind::text, "a sentence to stand below the picture, before the notes",
     &PlotTexts::caption},
    {"bare", "", OptionKind::flag,
     "the diagram with its legend alone, without title, index numbers and notes: for a page that has them",
     &PlotTexts::bare}};

void PlotTexts::check() const {
  if (sample && wants_match())
    throw InputError("SAMPLE and " + (match ? option("match") : given_of_solving()) +
                     ": give one of them, particles or the wish for a match");
  if (wants_section() && wants_match())
    throw InputError(option("what") +
                     " section: there are no places of particles in a match: give a SAMPLE such as a dump");
  if (what && *what != "curve" && !sample && !wants_match())
    throw InputError(option("what") + " " + *what +
                     ": give a SAMPLE, for example the answer of mdm solve --format json, or " +
                     option("match"));
}

std::string PlotTexts::given_of_solving() const {
  SolveTexts asked = solve;
  asked.digits.reset(); // of what is told alone
  const std::string given = asked.given();
  return given.empty() ? budget.given() : given;
}

SolveTexts PlotTexts::match_texts() const {
  SolveTexts texts = solve;
  texts.band = band;
  texts.pan_size = soil.pan_size;
  if (!texts.is_tolerant() && !budget.particles && !texts.max_steps && !texts.time_limit)
    texts.max_steps = std::to_string(most_steps_beside);
  return texts;
}

SieveNames PlotTexts::names_of_sieves(bool is_sample) const {
  if (sieve_names)
    return *sieve_names == "astm"  ? SieveNames::astm
           : *sieve_names == "iso" ? SieveNames::iso
                                   : SieveNames::none;
  return is_sample ? SieveNames::none : SieveNames::iso;
}

GradationFigure PlotTexts::figure(bool is_sample) const {
  GradationFigure figure;
  figure.soil = soil.describe_options();
  if (bands && bands != "uscs")
    figure.bands = bands == "iso" ? Bands::iso_14688 : Bands::none;
  figure.coarse_left = coarse_left;
  figure.sieve_names = names_of_sieves(is_sample);
  figure.of_particles = is_sample;
  figure.form = form();
  return figure;
}

FigureForm PlotTexts::form() const {
  if (bare && caption)
    throw InputError(option("bare") + " leaves out what stands around the diagram: leave it out, or " +
                     option("caption"));
  FigureForm form;
  form.bare = bare;
  if (language == "de")
    form.language = Language::german;
  constexpr unsigned least_width = 200, most_width = 5000;
  if (width)
    form.width = small_natural("width", *width, least_width, most_width);
  if (wants_section()) // two panels side by side
    form.width /= 2;
  return form;
}

PackingColour PlotTexts::packing_colour() const {
  const std::string by = colour.value_or("size");
  return by == "size"       ? PackingColour::size
         : by == "contacts" ? PackingColour::contacts
                            : PackingColour::cells;
}

std::optional<TextureSystem> PlotTexts::texture_system() const {
  if (!texture)
    return std::nullopt;
  return *texture == "folk"      ? TextureSystem::folk
         : *texture == "shepard" ? TextureSystem::shepard
                                 : TextureSystem::usda;
}

bool PlotTexts::is_of_gradation() const {
  return sample || texture || wants_match() || what || band || bands || coarse_left || sieve_names ||
         soil.is_given();
}

std::vector<DrawnClass> drawn(const AnswerSample &answer, SizeUnit unit) {
  const Rational factor = in_mm(answer.unit) / in_mm(unit);
  std::vector<DrawnClass> classes;
  for (const AnswerSample::Class &c : answer.classes)
    classes.push_back({drawn_size(c.lower) * factor, drawn_size(c.upper) * factor, c.mass, c.quantity,
                       (c.size_lo + c.size_hi) / 2 * factor});
  return classes;
}

std::vector<DrawnClass> drawn(const Match &m) {
  std::vector<DrawnClass> classes;
  for (const MatchClass &c : m.classes())
    if (c.size)
      classes.push_back({drawn_size(c.lower), drawn_size(c.upper), c.mass, c.quantity,
                         (c.size->lower() + c.size->upper()) / 2});
  return classes;
}

bool are_of(const std::vector<DrawnClass> &classes, const Gradation &g) {
  std::vector<Rational> sizes;
  for (std::size_t j = 0; j <= g.classes(); ++j)
    sizes.push_back(drawn_size(g.opening(j)));
  return std::all_of(classes.begin(), classes.end(), [&sizes](const DrawnClass &c) {
    const auto lower = std::lower_bound(sizes.begin(), sizes.end(), c.lower);
    return lower != sizes.end() && *lower == c.lower && lower + 1 != sizes.end() && *(lower + 1) == c.upper;
  });
}

void DrawnSample::add_to(GradationFigure &figure) const {
  const Description &d = gathered_.description();
  for (std::size_t j = 0; j < gradation_.classes(); ++j)
    if (const Integer &n = d.of_class(j).count; n > 0)
      figure.particles.push_back({drawn_size(gradation_.opening(j)), drawn_size(gradation_.opening(j + 1)), 0,
                                  n, drawn_size(gradation_.opening(j + 1))});
  for (const auto &[size, mass] : gathered_.sieves().masses())
    figure.sizes.push_back({size, mass});
  figure.outside = d.outside() + d.unplaced().count;
}

} // namespace mdm

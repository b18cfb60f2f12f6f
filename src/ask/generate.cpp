#include "ask/generate.hpp"

#include "ask/option_values.hpp"
#include "number/counted.hpp"
#include "text/file_names.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace mdm {
namespace {

constexpr unsigned most_table = 100000;
constexpr unsigned most_points = 1000;
constexpr std::size_t most_shapes = 100000;

/// The most sizes of a file: none holds more.
const Integer &most_listed_sizes() {
  static const Integer most = power_of_ten(12);
  return most;
}

std::shared_ptr<const SieveCurve> sieve_curve(const GenerateTexts &c, const ReadCurve &read,
                                              std::vector<std::string> &notes) {
  if (c.d_min || c.d_max || c.span || c.ratio)
    throw InputError(option("curve") + ": the file has the sizes: leave out " + option("dmin") + ", " +
                     option("dmax") + ", " + option("span") + " and " + option("ratio"));
  Gradation g = read_gradation(read(*c.curve), shown_name(*c.curve), c.reading.reading());
  notes = g.notes();
  if (g.has_factors()) {
    g = by_volume(g);
    notes.push_back("masses are divided by their factors: the curve and its shares are by volume");
  }
  const std::string between = c.between.value_or("log");
  const Interpolation interpolation = between == "log"      ? Interpolation::log
                                      : between == "linear" ? Interpolation::linear
                                                            : Interpolation::stair;
  return in_file(*c.curve, [&] {
    if (c.pan_size)
      g = g.with_pan_size(length("pan-size", *c.pan_size).in(g));
    return std::make_shared<const SieveCurve>(GradingCurve(g), interpolation);
  });
}

unsigned class_number(const GenerateTexts &c) {
  return small_natural("classes", c.classes.value_or("10"), 1, max_size_classes);
}

Classing classing_named(const std::string &name) {
  return name == "regular"     ? Classing::regular
         : name == "geometric" ? Classing::geometric
                               : Classing::isochoric;
}

/// The least P: what asks for more particles than that is a slip.
Rational least_largest_share() {
  return ratio(1, power_of_ten(8));
}

std::uint64_t set_seed(const GenerateTexts &c) {
  return seed64("seed", c.seed.value_or("1"));
}

unsigned digits_of_match(const GenerateTexts &c) {
  return digits_of("match-digits", c.match_digits.value_or("6"));
}

std::chrono::milliseconds match_time(const GenerateTexts &c) {
  return duration("time-limit", c.time_limit.value_or("60"));
}

/// Particles of sets of which the quality is told without being asked for: a second or so.
constexpr unsigned most_judged = 1000000;
constexpr unsigned most_judged_if_asked = 10000000;
constexpr unsigned usual_points = 100;

/// C_r and the rest of Eq. 18-21 for the particles themselves.
void add_quality(const GenerateTexts &c, GeneratedSet &set) {
  set.points = c.points ? small_natural("points", *c.points, 0, most_points) : usual_points;
  if (set.points == 1)
    throw InputError(option("points") + ": at least 2, or 0 to leave the quality out");
  if (set.points == 0 || c.is_csv())
    return;
  const auto is_judged = [&c](const Integer &sizes) {
    return sizes <= (c.points ? most_judged_if_asked : most_judged);
  };
  const bool matched = set.match && set.match->complete;
  const bool match_judged = matched && (!set.spread || is_judged(*set.match->particles()));
  const bool drawn_judged = set.counts.decided() && is_judged(set.counts.particles());
  if (match_judged)
    set.match_quality =
        matched_quality(*set.match, *set.curve, set.wanted.dimension, set.points, set.match_particles());
  if (drawn_judged)
    set.drawn_quality = set_quality(
        *set.curve, set.classes, set.wanted.dimension, set.points,
        drawn_particles(set.classes, set.counts.numbers, set.wanted.dimension, set.digits, draws_of(c)));
  if (match_judged != matched || drawn_judged != set.counts.decided())
    set.notes.push_back("the quality of a set of more than 10^6 particles is told with " + option("points") +
                        ", up to 10^7");
}

std::string classes_in_words(unsigned n, const std::string &how) {
  return fmt::format("{} {} {}", n, how, n == 1 ? "class" : "classes");
}

/// Adds the curve and its classes.
void add_curve(const GenerateTexts &c, const ReadCurve &read, GeneratedSet &set) {
  const unsigned n = class_number(c);
  if (c.beta) {
    const std::shared_ptr<const BetaCurve> curve = beta_curve(c);
    const std::string how = c.classing.value_or("geometric");
    set.curve = curve;
    set.unit = beta_unit(c);
    set.id = fmt::format("beta curve ({}, {}): volume density {}; grading curve {}", to_decimal(curve->a()),
                         to_decimal(curve->b()), curve->shape(), curve->course());
    set.terms = classes_in_words(n, how);
    set.classes = size_classes(*curve, classing_named(how), n);
    return;
  }
  const std::shared_ptr<const SieveCurve> curve = sieve_curve(c, read, set.notes);
  const std::string how = c.classing.value_or(c.classes ? "geometric" : "sieves");
  set.curve = curve;
  set.unit = "mm";
  const std::string between = c.between.value_or("log");
  set.id = shown_name(*c.curve) +
           (between == "stair" ? ", a stair"
                               : ", linear in " + std::string(between == "log" ? "log size" : "size"));
  set.terms = how == "sieves" ? "classes between the sieves" : classes_in_words(n, how);
  set.classes = how == "sieves" ? sieve_classes(*curve) : size_classes(*curve, classing_named(how), n);
}

void check_at_most(const Integer &at_most, const Representativity &wanted) {
  if (at_most < wanted.at_least)
    throw InputError(fmt::format("{}: fewer than the {} of {}: no set can have both", option("at-most"),
                                 to_string(wanted.at_least), option("at-least")));
}

Representativity representativity(const GenerateTexts &c) {
  Representativity wanted{natural("min-per-class", c.min_per_class.value_or("10"), 1),
                          natural("at-least", c.at_least.value_or("2000"), 1), c.dimension == "2" ? 2U : 3U};
  if (c.largest_share) {
    wanted.largest_share = percent_of("largest-share", *c.largest_share) / 100;
    if (*wanted.largest_share < least_largest_share())
      throw InputError(option("largest-share") + ": " + in_quotes(*c.largest_share) +
                       " is not from 1e-6 to 100 %: then a class "
                       "would take more than 10^8 particles");
  }
  return wanted;
}

/// Notes the classes whose drawn particles have more than that: they may be smaller than the median size.
void note_large_particles(GeneratedSet &set) {
  if (!set.wanted.largest_share || !set.drawn_quality)
    return;
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    if (set.drawn_quality->largest[j].lo > *set.wanted.largest_share)
      set.notes.push_back(fmt::format("class {}: its largest particle as drawn has {} % of its volume", j + 1,
                                      approximate(Rational(100 * set.drawn_quality->largest[j].lo), 3)));
}

/// Parameters of shapes, as of --beta.
std::vector<Rational> parameters(const std::string &name, const std::string &text) {
  std::vector<Rational> all = number_list(name, text);
  if (all.front() < BetaCurve::least_parameter() || all.back() > BetaCurve::largest_parameter())
    throw InputError(option(name) + ": " + in_quotes(text) +
                     ": a and b must be from 0.001 to 1000: leave out those that are not");
  return all;
}

} // namespace

const std::vector<OptionRow<GenerateTexts>> GenerateTexts::options = {
    {"beta", "A,B", OptionKind::text,
     "the cumulative beta curve, a and b from 0.001 to 1000; 1,1 is uniform by volume", &GenerateTexts::beta},
    {"dmin", "SIZE", OptionKind::number, "smallest size of a beta curve", &GenerateTexts::d_min},
    {"dmax", "SIZE", OptionKind::number, "largest size of a beta curve", &GenerateTexts::d_max},
    {"span", "S", OptionKind::number, "(dmax - dmin) / (dmax + dmin), between 0 and 1", &GenerateTexts::span},
    {"ratio", "R", OptionKind::number, "dmax / dmin, above 1", &GenerateTexts::ratio},
    {"curve", "FILE", OptionKind::file,
     "the curve of a gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard "
     "input",
     &GenerateTexts::curve},
    {"between",
     "TEXT",
     OptionKind::text,
     "what the curve of a file does between sieves: linear in log size (log, the "
     "default) or in size (linear), or constant (stair)",
     &GenerateTexts::between,
     {"log", "linear", "stair"}},
    {"pan-size", "SIZE", OptionKind::number, "take the pan of a file as a sieve of this size",
     &GenerateTexts::pan_size},
    {"classes", "N", OptionKind::number, "number of size classes (10)", &GenerateTexts::classes},
    {"classing",
     "TEXT",
     OptionKind::text,
     "classes of equal widths (regular), equal ratios (geometric, the default), equal volumes (isochoric; "
     "with a or b near 0.001 some 0.2 s a class), or between the sieves (sieves, the default of --curve "
     "without --classes)",
     &GenerateTexts::classing,
     {"regular", "geometric", "isochoric", "sieves"}},
    {"min-per-class", "N", OptionKind::number, "particles in the scarcest class (10)",
     &GenerateTexts::min_per_class},
    {"largest-share", "P%", OptionKind::number,
     "no particle has more than P % of the volume of its class, counted with its median size (the paper's "
     "second "
     "criterion)",
     &GenerateTexts::largest_share},
    {"at-least", "N", OptionKind::number, "particles in all (2000)", &GenerateTexts::at_least},
    {"at-most", "N", OptionKind::number, "more are not accessible: exit 1", &GenerateTexts::at_most},
    {"dimension",
     "D",
     OptionKind::number,
     "2, discs, or 3, spheres (3)",
     &GenerateTexts::dimension,
     {"2", "3"}},
    {"method",
     "TEXT",
     OptionKind::text,
     "counts by rounding (paper), or the smallest set whose class volumes are exact (match)",
     &GenerateTexts::method,
     {"paper", "match"}},
    {"match-digits", "D", OptionKind::number,
     "significant digits of bounds and volumes for --method match or --accessible (6)",
     &GenerateTexts::match_digits},
    {"time-limit", "SECONDS", OptionKind::seconds,
     "of --method match, or of each match of --accessible (60); then exit 3 with what is certain",
     &GenerateTexts::time_limit},
    {"sizes", "", OptionKind::flag, "the size of every particle (JSON and CSV)", &GenerateTexts::sizes},
    {"seed", "K", OptionKind::number, "draw sizes at random, by the counter-based generator Philox 4x32-10",
     &GenerateTexts::seed},
    {"spread", "", OptionKind::flag,
     "for --method match: sizes drawn uniform by volume in their class by --seed (1), and enough particles "
     "for that; JSON and CSV have them, as with --sizes",
     &GenerateTexts::spread},
    {"quantiles", "", OptionKind::flag, "draw sizes without randomness (the default)",
     &GenerateTexts::quantiles},
    {"points", "K", OptionKind::number,
     "sizes, equally spaced in log size, at which the set's curve is compared (C_r; 100 for up to "
     "10^6 particles, if given up to 10^7 in 1 GB); 0: no quality",
     &GenerateTexts::points},
    {"table", "K", OptionKind::number,
     "h, V, F and f of the set, and h of the curve, at K equally spaced sizes", &GenerateTexts::table}};

const std::vector<OptionRow<GenerateTexts>> GenerateTexts::accessible_options = {
    {"accessible", "", OptionKind::flag,
     "instead of one set: which shapes a, b take at most --at-most (10000) particles, by Eq. 6-9 and by the "
     "smallest match, at the --span (one or several, as the shapes)",
     &GenerateTexts::accessible},
    {"a", "LIST", OptionKind::text, "shapes of --accessible: numbers 1,2,5 or FROM:TO:STEP (0.5:10:0.5)",
     &GenerateTexts::a},
    {"b", "LIST", OptionKind::text, "the same for b (0.5:10:0.5)", &GenerateTexts::b}};

const std::vector<OptionRow<GenerateTexts>> GenerateTexts::inverse_options = {
    {"cu", "CU", OptionKind::number,
     "instead of a set: the shapes a, b of the beta curve with this C_u = d_60 / d_10 and the C_c of --cc, "
     "at the --span (one "
     "or several, as the shapes of --accessible; 0.05 to 0.99)",
     &GenerateTexts::c_u},
    {"cc", "CC", OptionKind::number, "the same of C_c = d_30^2 / (d_60 d_10)", &GenerateTexts::c_c},
    {"fit", "FILE", OptionKind::file,
     "the same with the C_u and C_c of a gradation, and without --span with that of its sieves; - for "
     "standard input",
     &GenerateTexts::fit},
    {"within", "FROM:TO", OptionKind::text,
     "the range of a and of b that is searched, from 0.001 to 1000 (0.1:20)", &GenerateTexts::within}};

const std::vector<OptionRow<GenerateTexts>> GenerateTexts::answer_options = {
    {"digits", "D", OptionKind::number, "significant digits of enclosures (15)", &GenerateTexts::digits}};

Draws draws_of(const GenerateTexts &c) {
  return c.seed ? Draws::random(set_seed(c)) : Draws::quantiles();
}

void check_generate(const GenerateTexts &c) {
  if (c.beta.has_value() == c.curve.has_value())
    throw InputError("a curve is needed: " + option("beta") + " A,B or " + option("curve") +
                     " FILE, one of them");
  if (c.beta && (c.between || c.pan_size || c.reading.is_given()))
    throw InputError(option("between") + ", " + option("pan-size") + " and the options of reading need " +
                     option("curve") + ": a beta curve has no sieves");
  if (c.beta && c.classing == "sieves")
    throw InputError(option("classing") +
                     ": a beta curve has no sieves: use regular, geometric or isochoric");
  if (c.seed && c.quantiles)
    throw InputError(option("seed") + " and " + option("quantiles") +
                     " exclude each other: random sizes, or none by chance");
  if (c.classes && c.classing == "sieves")
    throw InputError(option("classes") +
                     ": between the sieves there are as many as the file has: leave it out, or use " +
                     option("classing") + " regular, geometric or isochoric");
  if (c.sizes && c.is_text())
    throw InputError(option("sizes") + ": text has no place for them: use " + option("format") +
                     " json or csv");
  if (c.spread && !c.is_matched())
    throw InputError(option("spread") + ": it is of " + option("method") + " match; " + option("method") +
                     " paper draws sizes anyhow, with " + option("seed") + " K");
  if (c.spread && c.quantiles)
    throw InputError(option("spread") + " draws at random: leave out " + option("quantiles"));
  if (c.sizes && c.is_matched() && !c.spread && (c.seed || c.quantiles))
    throw InputError(option("method") + " match gives a class one size: leave out " + option("seed") +
                     " and " + option("quantiles") + ", or add " + option("spread"));
  if (!c.is_matched() && (c.match_digits || c.time_limit))
    throw InputError(option("match-digits") + " and " + option("time-limit") + " are of " + option("method") +
                     " match: add it or leave them out");
  if ((c.seed || c.quantiles) && c.is_csv() && !c.writes_sizes())
    throw InputError(option("seed") + " and " + option("quantiles") + ": CSV has no drawn sizes without " +
                     option("sizes") + ": add it or leave them out");
  if (c.points && c.is_csv())
    throw InputError(option("points") + ": CSV has no place for the quality of the set; use " +
                     option("format") + " text or json");
  if (c.writes_sizes() && c.table && c.is_csv())
    throw InputError(std::string(c.sizes ? option("sizes") : option("spread")) + " and " + option("table") +
                     ": CSV has place for one of them; use " + option("format") + " json");
}

GeneratedSet generated(const GenerateTexts &c, const ReadCurve &read) {
  GeneratedSet set;
  set.digits = digits_of("digits", c.digits.value_or("15"));
  set.match_digits = digits_of_match(c);
  set.wanted = representativity(c);
  if (c.at_most) {
    set.at_most = natural("at-most", *c.at_most, 1);
    check_at_most(*set.at_most, set.wanted);
  }
  if (c.table)
    set.table = small_natural("table", *c.table, 2, most_table);
  add_curve(c, read, set);
  set.terms +=
      fmt::format(", at least {} in each and {} in all, dimension {}", counted(set.wanted.min_per_class),
                  to_string(set.wanted.at_least), set.wanted.dimension);
  if (set.wanted.largest_share)
    set.terms += fmt::format(", no particle above {} % of its class",
                             to_decimal(Rational(100 * *set.wanted.largest_share)));
  set.counts = class_counts(set.classes, *set.curve, set.wanted);
  std::string empty;
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    if (set.classes[j].is_empty())
      empty += (empty.empty() ? "" : ", ") + std::to_string(j + 1);
  if (!empty.empty())
    set.notes.push_back("no volume, thus no particles, in class " + empty);
  if (c.is_matched()) {
    SolveOptions options;
    options.digits = set.digits;
    options.at_most = set.at_most;
    options.limits.deadline = std::chrono::steady_clock::now() + match_time(c);
    const Gradation rounded = rounded_gradation(set.classes, set.match_digits, set.id);
    const Representativity wanted = of_match(set.wanted, rounded, c.spread);
    set.match = c.spread ? roomy_set(rounded, wanted, options, set.match_digits)
                         : matched_set(rounded, wanted, options);
    set.notes.insert(set.notes.end(), set.match->notes.begin(), set.match->notes.end());
    if (c.spread)
      set.spread = set_seed(c);
  } else if (set.counts.decided() && set.counts.particles() < set.wanted.at_least) {
    set.notes.push_back("the floors of Eq. 9 sum to " + to_string(set.counts.particles()) + ", below N_min");
  }
  if (c.seed)
    set.seed = set_seed(c);
  add_quality(c, set);
  note_large_particles(set);
  return set;
}

void check_listed(const GeneratedSet &set, const Integer &particles) {
  if (particles > most_listed_sizes())
    throw InputError(option("sizes") + ": " + to_string(particles) +
                     " particles: at most 10^12 can be listed; leave out " + option("sizes") +
                     " or ask for fewer classes");
  if (set.spread && particles > most_spread_particles)
    throw InputError(option("spread") + ": " + to_string(particles) +
                     " particles: at most 10^9 can be spread; leave out " + option("spread") +
                     " or ask for fewer classes");
}

Outcome outcome_of(const GeneratedSet &set) {
  const std::optional<bool> accessible = set.accessible();
  if (accessible == false)
    return Outcome::negative;
  return accessible && set.particles() ? Outcome::done : Outcome::limited;
}

AccessibleQuestion accessible_question(const GenerateTexts &c) {
  if (c.beta || c.curve || c.d_min || c.d_max || c.ratio || c.pan_size || c.between || c.reading.is_given())
    throw InputError(option("accessible") + ": shapes are asked for with " + option("a") + " and " +
                     option("b") + ", their sizes with " + option("span") +
                     " alone: leave out other options of the curve");
  if (!c.span)
    throw InputError(option("accessible") + ": give " + option("span") +
                     ": one number or several, between 0 and 1");
  if (c.is_matched())
    throw InputError(option("accessible") + ": it tells of both methods: leave out " + option("method"));
  if (c.sizes || c.seed || c.quantiles || c.spread || c.table || c.points)
    throw InputError(option("accessible") +
                     " tells how many particles there would be and draws none: leave out " + option("sizes") +
                     ", " + option("seed") + ", " + option("quantiles") + ", " + option("spread") + ", " +
                     option("points") + " and " + option("table"));
  if (c.digits)
    throw InputError(option("digits") + ": " + option("accessible") +
                     " has certain digits of its own: leave it out");
  if (c.classing == "sieves")
    throw InputError(option("classing") +
                     ": a beta curve has no sieves: use regular, geometric or isochoric");
  AccessibleQuestion q;
  q.a = parameters("a", c.a.value_or("0.5:10:0.5"));
  q.b = parameters("b", c.b.value_or("0.5:10:0.5"));
  q.spans = number_list("span", *c.span);
  if (q.spans.back() >= 1)
    throw InputError(option("span") + ": " + to_decimal(q.spans.back()) +
                     " is not below 1: then d_min would be 0");
  q.classing = classing_named(c.classing.value_or("geometric"));
  q.classes = class_number(c);
  q.wanted = representativity(c);
  q.at_most = natural("at-most", c.at_most.value_or("10000"), 1);
  check_at_most(q.at_most, q.wanted);
  q.match_digits = digits_of_match(c);
  q.time_limit = match_time(c);
  return q;
}

std::vector<AccessibleRow> accessible_grid(const AccessibleQuestion &question) {
  std::vector<AccessibleRow> rows = grid(question);
  if (rows.size() > most_shapes)
    throw InputError(option("accessible") + ": more than 100000 shapes: take larger steps or fewer spans");
  return rows;
}

} // namespace mdm

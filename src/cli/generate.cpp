#include "answer/generated.hpp"
#include "ask/option_values.hpp"
#include "cli/accessible.hpp"
#include "cli/beta_options.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "cli/reading_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <atomic>
#include <chrono>
#include <memory>

namespace mdm::cli {
namespace {

constexpr unsigned most_table = 100000;
constexpr unsigned most_points = 1000;

/// The most sizes of a file: none holds more.
const Integer &most_sizes() {
  static const Integer most = power_of_ten(12);
  return most;
}

struct GenerateCommand : BetaOptions {
  std::optional<std::string> curve, pan_size, between;
  ReadingFlags reading;
  std::optional<std::string> classes, classing, at_most, seed, points, table;
  std::optional<std::string> digits, match_digits, time_limit;
  std::string min_per_class = "10", at_least = "2000", dimension = "3", method = "paper";
  OutputFlags output;
  AccessibleFlags accessible;
  bool quantiles = false, sizes = false, spread = false;

  /// The sizes of a spread are what it is asked for.
  bool writes_sizes() const { return sizes || (spread && !output.is_text()); }
};

std::shared_ptr<const SieveCurve> sieve_curve(const GenerateCommand &c, std::vector<std::string> &notes) {
  if (c.d_min || c.d_max || c.span || c.ratio)
    throw InputError("--curve: the file has the sizes: leave out --dmin, --dmax, --span and --ratio");
  Gradation g =
      read_gradation(read_file(*c.curve, max_gradation_bytes), shown_name(*c.curve), c.reading.reading());
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
      g = g.with_pan_size(length("pan-size", *c.pan_size).in(g.unit()));
    return std::make_shared<const SieveCurve>(GradingCurve(g), interpolation);
  });
}

unsigned class_number(const GenerateCommand &c) {
  return small_natural("classes", c.classes.value_or("10"), 1, max_size_classes);
}

Classing classing(const std::string &name) {
  return name == "regular"     ? Classing::regular
         : name == "geometric" ? Classing::geometric
                               : Classing::isochoric;
}

std::uint64_t seed_of(const GenerateCommand &c) {
  return seed64("seed", c.seed.value_or("1"));
}

Draws draws(const GenerateCommand &c) {
  return c.seed ? Draws::random(seed_of(c)) : Draws::quantiles();
}

unsigned match_digits(const GenerateCommand &c) {
  return digits_of("match-digits", c.match_digits.value_or("6"));
}

std::chrono::milliseconds time_limit(const GenerateCommand &c) {
  return duration("time-limit", c.time_limit.value_or("60"));
}

void check(const GenerateCommand &c) {
  if (c.beta.has_value() == c.curve.has_value())
    throw InputError("a curve is needed: --beta A,B or --curve FILE, one of them");
  if (c.beta && (c.between || c.pan_size || c.reading.is_given()))
    throw InputError(
        "--between, --pan-size and the options of reading need --curve: a beta curve has no sieves");
  if (c.beta && c.classing == "sieves")
    throw InputError("--classing: a beta curve has no sieves: use regular, geometric or isochoric");
  if (c.seed && c.quantiles)
    throw InputError("--seed and --quantiles exclude each other: random sizes, or none by chance");
  if (c.classes && c.classing == "sieves")
    throw InputError("--classes: between the sieves there are as many as the file has: leave it out, or use "
                     "--classing regular, geometric or isochoric");
  if (c.sizes && c.output.is_text())
    throw InputError("--sizes: text has no place for them: use --format json or csv");
  if (c.spread && c.method != "match")
    throw InputError("--spread: it is of --method match; --method paper draws sizes anyhow, with --seed K");
  if (c.spread && c.quantiles)
    throw InputError("--spread draws at random: leave out --quantiles");
  if (c.sizes && c.method == "match" && !c.spread && (c.seed || c.quantiles))
    throw InputError(
        "--method match gives a class one size: leave out --seed and --quantiles, or add --spread");
  if (c.method != "match" && (c.match_digits || c.time_limit))
    throw InputError("--match-digits and --time-limit are of --method match: add it or leave them out");
  if ((c.seed || c.quantiles) && c.output.is_csv() && !c.writes_sizes())
    throw InputError(
        "--seed and --quantiles: CSV has no drawn sizes without --sizes: add it or leave them out");
  if (c.points && c.output.is_csv())
    throw InputError("--points: CSV has no place for the quality of the set; use --format text or json");
  if (c.writes_sizes() && c.table && c.output.is_csv())
    throw InputError(std::string(c.sizes ? "--sizes" : "--spread") +
                     " and --table: CSV has place for one of them; use --format json");
}

/// Particles of sets of which the quality is told without being asked for: a second or so.
constexpr unsigned most_judged = 1000000;
constexpr unsigned most_judged_if_asked = 10000000;
constexpr unsigned usual_points = 100;

/// C_r and the rest of Eq. 18-21 for the particles themselves.
void add_quality(const GenerateCommand &c, GeneratedSet &set) {
  set.points = c.points ? small_natural("points", *c.points, 0, most_points) : usual_points;
  if (set.points == 1)
    throw InputError("--points: at least 2, or 0 to leave the quality out");
  if (set.points == 0 || c.output.is_csv())
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
        drawn_particles(set.classes, set.counts.numbers, set.wanted.dimension, set.digits, draws(c)));
  if (match_judged != matched || drawn_judged != set.counts.decided())
    set.notes.push_back("the quality of a set of more than 10^6 particles is told with --points, up to 10^7");
}

std::string classes_in_words(unsigned n, const std::string &how) {
  return fmt::format("{} {} {}", n, how, n == 1 ? "class" : "classes");
}

/// Adds the curve and its classes.
void add_curve(const GenerateCommand &c, GeneratedSet &set) {
  const unsigned n = class_number(c);
  if (c.beta) {
    const std::shared_ptr<const BetaCurve> curve = beta_curve(c);
    const std::string how = c.classing.value_or("geometric");
    set.curve = curve;
    set.unit = beta_unit(c);
    set.id = "beta curve (" + to_decimal(curve->a()) + ", " + to_decimal(curve->b()) + "), " + curve->shape();
    set.terms = classes_in_words(n, how);
    set.classes = size_classes(*curve, classing(how), n);
    return;
  }
  const std::shared_ptr<const SieveCurve> curve = sieve_curve(c, set.notes);
  const std::string how = c.classing.value_or(c.classes ? "geometric" : "sieves");
  set.curve = curve;
  set.unit = "mm";
  const std::string between = c.between.value_or("log");
  set.id = shown_name(*c.curve) +
           (between == "stair" ? ", a stair"
                               : ", linear in " + std::string(between == "log" ? "log size" : "size"));
  set.terms = how == "sieves" ? "classes between the sieves" : classes_in_words(n, how);
  set.classes = how == "sieves" ? sieve_classes(*curve) : size_classes(*curve, classing(how), n);
}

Representativity representativity(const GenerateCommand &c) {
  return {natural("min-per-class", c.min_per_class, 1), natural("at-least", c.at_least, 1),
          c.dimension == "2" ? 2U : 3U};
}

GeneratedSet generated(const GenerateCommand &c) {
  GeneratedSet set;
  set.digits = digits_of("digits", c.digits.value_or("15"));
  set.match_digits = match_digits(c);
  set.wanted = representativity(c);
  if (c.at_most) {
    set.at_most = natural("at-most", *c.at_most, 1);
    if (*set.at_most < set.wanted.at_least)
      throw InputError("--at-most: fewer than --at-least: no set can have both");
  }
  if (c.table)
    set.table = small_natural("table", *c.table, 2, most_table);
  add_curve(c, set);
  set.terms += fmt::format(", at least {} particles in each and {} in all, dimension {}",
                           to_string(set.wanted.min_per_class), to_string(set.wanted.at_least), c.dimension);
  set.counts = class_counts(set.classes, *set.curve, set.wanted);
  std::string empty;
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    if (set.classes[j].is_empty())
      empty += (empty.empty() ? "" : ", ") + std::to_string(j + 1);
  if (!empty.empty())
    set.notes.push_back("no volume, thus no particles, in class " + empty);
  if (c.method == "match") {
    SolveOptions options;
    options.digits = set.digits;
    options.at_most = set.at_most;
    options.limits.deadline = std::chrono::steady_clock::now() + time_limit(c);
    const Gradation rounded = rounded_gradation(set.classes, set.match_digits, set.id);
    set.match = c.spread ? roomy_set(rounded, set.wanted, options, set.match_digits)
                         : matched_set(rounded, set.wanted, options);
    set.notes.insert(set.notes.end(), set.match->notes.begin(), set.match->notes.end());
    if (c.spread)
      set.spread = seed_of(c);
  } else if (set.counts.decided() && set.counts.particles() < set.wanted.at_least) {
    set.notes.push_back("the floors of Eq. 9 sum to " + to_string(set.counts.particles()) + ", below N_min");
  }
  if (c.seed)
    set.seed = seed_of(c);
  add_quality(c, set);
  return set;
}

int exit_code_of(const GeneratedSet &set) {
  const std::optional<bool> accessible = set.accessible();
  if (accessible == false)
    return Exit::negative;
  return accessible && set.particles() ? Exit::done : Exit::limited;
}

/// Parameters of shapes, as of --beta.
std::vector<Rational> parameters(const std::string &name, const std::string &text) {
  std::vector<Rational> all = number_list(name, text);
  if (all.front() < BetaCurve::least_parameter() || all.back() > BetaCurve::largest_parameter())
    throw InputError(option(name) + ": " + in_quotes(text) +
                     ": a and b must be from 0.001 to 1000: leave out those that are not");
  return all;
}

AccessibleQuestion accessible_question(const GenerateCommand &c) {
  if (c.beta || c.curve || c.d_min || c.d_max || c.ratio || c.pan_size || c.between || c.reading.is_given())
    throw InputError("--accessible: shapes are asked for with --a and --b, their sizes with --span "
                     "alone: leave out other options of the curve");
  if (!c.span)
    throw InputError("--accessible: give --span: one number or several, between 0 and 1");
  if (c.method == "match")
    throw InputError("--accessible: it tells of both methods: leave out --method");
  if (c.sizes || c.seed || c.quantiles || c.spread || c.table || c.points)
    throw InputError("--accessible tells how many particles there would be and draws none: leave out "
                     "--sizes, --seed, --quantiles, --spread, --points and --table");
  if (c.digits)
    throw InputError("--digits: --accessible has certain digits of its own: leave it out");
  if (c.classing == "sieves")
    throw InputError("--classing: a beta curve has no sieves: use regular, geometric or isochoric");
  AccessibleQuestion q;
  q.a = parameters("a", c.accessible.a.value_or("0.5:10:0.5"));
  q.b = parameters("b", c.accessible.b.value_or("0.5:10:0.5"));
  q.spans = number_list("span", *c.span);
  if (q.spans.back() >= 1)
    throw InputError("--span: " + to_decimal(q.spans.back()) + " is not below 1: then d_min would be 0");
  q.classing = classing(c.classing.value_or("geometric"));
  q.classes = class_number(c);
  q.wanted = representativity(c);
  q.at_most = natural("at-most", c.at_most.value_or("10000"), 1);
  if (q.at_most < q.wanted.at_least)
    throw InputError("--at-most: fewer than --at-least: no set can have both");
  q.match_digits = match_digits(c);
  q.time_limit = time_limit(c);
  return q;
}

void check_listed(const GeneratedSet &set, const Integer &particles) {
  if (particles > most_sizes())
    throw InputError("--sizes: " + to_string(particles) +
                     " particles: at most 10^12 can be listed; leave out --sizes or ask for fewer classes");
  if (set.spread && particles > most_spread_particles)
    throw InputError("--spread: " + to_string(particles) +
                     " particles: at most 10^9 can be spread; leave out --spread or ask for fewer classes");
}

int run(const GenerateCommand &c) {
  if (c.accessible.needless())
    throw InputError("--a, --b, --plot and -j are of --accessible: add it or leave them out");
  if (c.accessible.on)
    return run_accessible(accessible_question(c), c.output, c.accessible);
  check(c);
  check_distinct({c.curve.value_or("-"), c.output.path()});
  const std::optional<Draws> how = c.writes_sizes() ? std::optional(draws(c)) : std::nullopt;
  std::atomic<std::uint64_t> written = 0;
  Progress progress([&written] { return fmt::format("generating, {} MB written", written / 1000000); },
                    c.output.quiet);
  const GeneratedSet set = generated(c);
  if (how && set.particles())
    check_listed(set, *set.particles());
  Output out(c.output.path());
  const Sink sink = [&](std::string_view text) {
    out.write(text);
    written += text.size();
  };
  if (c.output.is_json()) {
    generated_json(set, how, sink);
    out.write("\n");
  } else if (c.output.is_csv()) {
    generated_csv(set, how, sink);
  } else {
    out.write(generated_text(set));
  }
  out.commit();
  const int code = exit_code_of(set);
  // CSV has no place for them.
  if (c.output.is_csv() && code != Exit::done)
    tell(printable(set.id) + ": " + headline(set) + "\n");
  c.output.tell_notes_beside_csv(set.notes);
  return code;
}

} // namespace

Run add_generate(CLI::App &app) {
  const auto c = std::make_shared<GenerateCommand>();
  CLI::App &command =
      *app.add_subcommand("generate", "A representative set of particles from a grading curve");
  const auto option = [&command](const char *name, auto &value, const char *type, const char *help) {
    return command.add_option(name, value, help)->type_name(type);
  };
  option("--beta", c->beta, "A,B",
         "the cumulative beta curve, a and b from 0.001 to 1000; 1,1 is uniform by volume");
  option("--dmin", c->d_min, "SIZE", "smallest size of a beta curve");
  option("--dmax", c->d_max, "SIZE", "largest size of a beta curve");
  option("--span", c->span, "S", "(dmax - dmin) / (dmax + dmin), between 0 and 1");
  option("--ratio", c->ratio, "R", "dmax / dmin, above 1");
  option("--curve", c->curve, "FILE",
         "the curve of a gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard "
         "input");
  option("--between", c->between, "TEXT",
         "what the curve of a file does between sieves: linear in log size (log, the "
         "default) or in size (linear), or constant (stair)")
      ->check(CLI::IsMember({"log", "linear", "stair"}));
  option("--pan-size", c->pan_size, "SIZE", "take the pan of a file as a sieve of this size");
  option("--classes", c->classes, "N", "number of size classes (10)");
  option(
      "--classing", c->classing, "TEXT",
      "classes of equal widths (regular), equal ratios (geometric, the default), equal volumes (isochoric; "
      "with a or b near 0.001 some 0.2 s a class), or between the sieves (sieves, the default of --curve "
      "without --classes)")
      ->check(CLI::IsMember({"regular", "geometric", "isochoric", "sieves"}));
  option("--min-per-class", c->min_per_class, "N", "particles in the scarcest class (10)");
  option("--at-least", c->at_least, "N", "particles in all (2000)");
  option("--at-most", c->at_most, "N", "more are not accessible: exit 1");
  option("--dimension", c->dimension, "D", "2, discs, or 3, spheres (3)")->check(CLI::IsMember({"2", "3"}));
  option("--method", c->method, "TEXT",
         "counts by rounding (paper), or the smallest set whose class volumes are exact (match)")
      ->check(CLI::IsMember({"paper", "match"}));
  option("--match-digits", c->match_digits, "D",
         "significant digits of bounds and volumes for --method match or --accessible (6)");
  option("--time-limit", c->time_limit, "SECONDS",
         "of --method match, or of each match of --accessible (60); then exit 3 with what is certain");
  command.add_flag("--sizes", c->sizes, "the size of every particle (JSON and CSV)");
  option("--seed", c->seed, "K", "draw sizes at random, by the counter-based generator Philox 4x32-10");
  command.add_flag(
      "--spread", c->spread,
      "for --method match: sizes drawn uniform by volume in their class by --seed (1), and enough "
      "particles for that; JSON and CSV have them, as with --sizes");
  command.add_flag("--quantiles", c->quantiles, "draw sizes without randomness (the default)");
  option("--points", c->points, "K",
         "sizes, equally spaced in log size, at which the set's curve is compared (C_r; 100 for up to "
         "10^6 particles, if given up to 10^7 in 1 GB); 0: no quality");
  option("--table", c->table, "K", "h, V, F and f of the set, and h of the curve, at K equally spaced sizes");
  c->accessible.add_to(command);
  option("--digits", c->digits, "D", "significant digits of enclosures (15)");
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer("", {"mdm generate --beta 1,3 --dmin 0.1 --ratio 20 --sizes --seed 1 --format csv",
                             "mdm generate --curve sand.csv --method match --spread -o set.json",
                             "mdm generate --accessible --span 0.42,0.97 --plot shapes.svg"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

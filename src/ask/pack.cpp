#include "ask/pack.hpp"

#include "ask/option_values.hpp"
#include "number/typed_number.hpp"
#include "packing/set_discs.hpp"
#include "sets/matched_set.hpp"
#include "sets/set_sizes.hpp"
#include "text/file_names.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>

#include <array>

namespace mdm {
namespace {

/// As mdm generate has them.
constexpr unsigned size_digits = 15;

/// A whole number with its sign.
Integer whole_curvature(const std::string &text) {
  const bool negative = !text.empty() && text.front() == '-';
  const std::optional<Integer> n = parse_typed_natural(negative ? std::string_view(text).substr(1) : text);
  if (!n)
    throw InputError(option("apollonian") + ": " + in_quotes(text) +
                     " is no whole number: write equal, or for example -1,2,2,3");
  return negative ? Integer(-*n) : *n;
}

ApollonianGasket gasket_of(const std::string &text) {
  if (text == "equal")
    return ApollonianGasket::equal();
  std::array<Integer, 4> w;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const std::size_t end = i + 1 < w.size() ? text.find(',', begin) : text.size();
    if (end == std::string::npos)
      throw InputError(option("apollonian") + ": " + in_quotes(text) +
                       " is not four curvatures: write equal, or for example "
                       "-1,2,2,3");
    w.at(i) = whole_curvature(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return named("apollonian", text, [&w](const std::string &) { return ApollonianGasket::integral(w); });
}

/// `0.001` or `1/1000`.
Rational smallest_radius(const std::string &text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    return positive("smallest", text);
  return positive("smallest", text.substr(0, slash)) / positive("smallest", text.substr(slash + 1));
}

} // namespace

const std::vector<OptionRow<PackTexts>> PackTexts::disc_options = {
    {"sizes", "FILE", OptionKind::file, "the same as FILE, sizes alone", &PackTexts::sizes},
    {"spread", "", OptionKind::flag,
     "FILE is a gradation: the discs of its smallest match with masses x^2, of a size each by --seed",
     &PackTexts::spread},
    {"beta", "A,B", OptionKind::text,
     "discs of the cumulative beta curve, a and b from 0.001 to 1000, drawn by --seed", &PackTexts::beta},
    {"dmin", "SIZE", OptionKind::number, "smallest size of a beta curve (1 where --span or --ratio is alone)",
     &PackTexts::d_min},
    {"dmax", "SIZE", OptionKind::number, "largest size of a beta curve", &PackTexts::d_max},
    {"span", "S", OptionKind::number, "(dmax - dmin) / (dmax + dmin), between 0 and 1", &PackTexts::span},
    {"ratio", "R", OptionKind::number, "dmax / dmin, above 1", &PackTexts::ratio},
    {"classes", "N", OptionKind::number, "number of size classes of a beta curve (10)", &PackTexts::classes},
    {"classing", "TEXT", OptionKind::text,
     "classes of equal widths (regular), ratios (geometric, the default) or volumes (isochoric)",
     &PackTexts::classing},
    {"min-per-class", "N", OptionKind::number, "discs in the scarcest class (10; of a gradation 1)",
     &PackTexts::min_per_class},
    {"at-least", "N", OptionKind::number,
     "discs in all, of which the floors of Eq. 9 may lose some (2000; of a gradation 1)",
     &PackTexts::at_least}};

const std::vector<OptionRow<PackTexts>> PackTexts::gasket_options = {
    {"apollonian", "equal|A,B,C,D", OptionKind::text,
     "no deposit: the Apollonian packing around three circles of radius 1 (equal), or of the four "
     "whole curvatures, the outer circle's below 0",
     &PackTexts::gasket},
    {"smallest", "R", OptionKind::number,
     "radius of the smallest circles of an Apollonian packing, as 0.001 or "
     "1/1000; the outer circle is not counted",
     &PackTexts::smallest},
    {"count-only", "", OptionKind::flag, "of an Apollonian packing: the number of circles alone",
     &PackTexts::count_only}};

const std::vector<OptionRow<PackTexts>> PackTexts::place_options = {
    {"width", "W", OptionKind::number,
     "of the box, 3 of the largest discs or more (as wide as the packing is high)", &PackTexts::width},
    {"periodic", "", OptionKind::flag, "the box repeats itself to both sides (the default)",
     &PackTexts::periodic},
    {"walls", "", OptionKind::flag, "the box has walls", &PackTexts::walls},
    {"floor",
     "TEXT",
     OptionKind::text,
     "a disc for which the floor is bare goes to the left end of the first bare "
     "piece (left), or to its middle (centred, the default)",
     &PackTexts::floor,
     {"left", "centred"}},
    {"rule",
     "TEXT",
     OptionKind::text,
     "each disc goes to the lowest place that is reached from above (lowest, the default), or is dropped "
     "in a "
     "random column and rolls to rest (drop)",
     &PackTexts::rule,
     {"lowest", "drop"}},
    {"order",
     "TEXT",
     OptionKind::text,
     "of the discs: shuffled by --seed (the default), or as given",
     &PackTexts::order,
     {"shuffled", "given"}},
    {"seed", "K", OptionKind::number, "of drawn sizes, of the order and of random columns (1)",
     &PackTexts::seed}};

const std::vector<OptionRow<PackTexts>> PackTexts::answer_options = {
    {"positions", "", OptionKind::flag, "with --format json: centre and radius of every disc",
     &PackTexts::positions}};

bool PackTexts::are_discs_given() const {
  return file || sizes || beta || d_min || d_max || span || ratio || reading.is_given() || classes ||
         classing || min_per_class || at_least || spread;
}

bool PackTexts::are_places_given() const {
  return width || floor || rule || order || seed || periodic || walls || positions;
}

std::string PackTexts::source() const {
  return file ? *file : sizes.value_or("-");
}

DiscSizes PackTexts::discs(const ReadDiscs &read_file) const {
  if (file.has_value() + sizes.has_value() + beta.has_value() != 1)
    throw InputError("give the discs in one way: FILE, " + option("sizes") + " or " + option("beta"));
  if (!beta && (d_min || d_max || span || ratio || classes || classing))
    throw InputError(option("dmin") + ", " + option("dmax") + ", " + option("span") + ", " + option("ratio") +
                     ", " + option("classes") + " and " + option("classing") + " are of " + option("beta") +
                     ": add it or leave them out");
  if (spread && !file)
    throw InputError(option("spread") + ": it is of a gradation: give its FILE");
  if (beta && reading.is_given())
    throw InputError(option("beta") + ": no file is read: leave out the options of reading");
  if (!spread && !beta && (min_per_class || at_least))
    throw InputError(option("min-per-class") + " and " + option("at-least") +
                     ": the file has its discs: leave them out");
  return beta ? of_curve() : of_file(read_file);
}

DiscSizes PackTexts::of_curve() const {
  BetaTexts curve_of = *this;
  if (!d_min && !d_max)
    curve_of.d_min = "1";
  const std::string how = classing.value_or("geometric");
  if (how != "regular" && how != "geometric" && how != "isochoric")
    throw InputError(option("classing") + ": " + in_quotes(how) +
                     " is unknown: use regular, geometric or isochoric");
  const Integer n = natural("classes", classes.value_or("10"), 1);
  if (n > max_size_classes)
    throw InputError(option("classes") + ": " + to_string(n) + " is too large: at most " +
                     std::to_string(max_size_classes));
  const std::shared_ptr<const BetaCurve> curve = beta_curve(curve_of);
  const std::vector<SizeClass> all = size_classes(*curve,
                                                  how == "regular"     ? Classing::regular
                                                  : how == "geometric" ? Classing::geometric
                                                                       : Classing::isochoric,
                                                  static_cast<unsigned>(n));
  const ClassCounts counts = class_counts(all, *curve,
                                          {natural("min-per-class", min_per_class.value_or("10"), 1),
                                           natural("at-least", at_least.value_or("2000"), 1), 2});
  if (!counts.decided())
    throw InputError(option("beta") +
                     ": the numbers of discs are not decided by 4096 bits: change a size a little");
  if (counts.particles() > most_discs)
    throw InputError(option("beta") + ": " + to_string(counts.particles()) +
                     " discs are more than 10^7: ask for fewer, for fewer classes or for a smaller span");
  return set_discs(drawn_particles(all, counts.numbers, 2, size_digits, Draws::random(draw_seed())),
                   all.size(), beta_unit(curve_of));
}

DiscSizes PackTexts::of_file(const ReadDiscs &read_file) const {
  const std::string content = read_file(source()), name = shown_name(source());
  if (spread)
    return of_gradation(content, name);
  if (!has_disc_sizes(content))
    throw InputError(
        printable(name) +
        ": no sizes of discs: write them with mdm generate --dimension 2 --sizes --format csv, or add " +
        option("spread") + " to a gradation");
  return read_disc_sizes(content, name);
}

DiscSizes PackTexts::of_gradation(const std::string &content, const std::string &name) const {
  const Gradation g = read_gradation(content, name, reading.reading());
  Representativity wanted;
  wanted.min_per_class = natural("min-per-class", min_per_class.value_or("1"), 1);
  wanted.at_least = natural("at-least", at_least.value_or("1"), 1);
  wanted.dimension = 2;
  SolveOptions limits;
  limits.at_most = Integer(most_discs);
  const Match m = matched_set(g.has_factors() ? by_volume(g) : g, wanted, limits);
  if (!m.complete)
    throw InputError(printable(name) + ": its smallest match of discs was not found, or has more than 10^7: "
                                       "leave out fine classes");
  if (*m.particles() > most_discs)
    throw InputError(printable(name) + ": its smallest match has " + to_string(*m.particles()) +
                     " discs, more than 10^7: leave out fine classes");
  DiscSizes discs = set_discs(spread_particles(m, draw_seed()), m.gradation.classes(),
                              std::string(mdm::name(m.gradation.unit())));
  discs.notes = g.notes();
  return discs;
}

DepositOptions PackTexts::deposit_options() const {
  if (width)
    length("width", *width); // what is wrong is said before a file is read
  if (periodic && walls)
    throw InputError(option("periodic") + " and " + option("walls") + " exclude each other");
  DepositOptions o;
  o.rule = rule == "drop" ? DepositRule::drop : DepositRule::lowest;
  o.floor = floor == "left" ? FloorRule::left : FloorRule::centred;
  o.periodic = !walls;
  o.seed = draw_seed();
  o.shuffled = order != "given";
  return o;
}

std::optional<Rational> PackTexts::width_in(const std::string &unit) const {
  if (!width)
    return std::nullopt;
  const Length asked = length("width", *width);
  const std::optional<SizeUnit> of_discs = parse_size_unit(unit);
  if (asked.unit && !of_discs)
    throw InputError(option("width") + ": the discs have no unit: write the number alone");
  return asked.unit ? Rational(asked.value * in_mm(*asked.unit) / in_mm(*of_discs)) : asked.value;
}

ApollonianGasket PackTexts::asked_gasket() const {
  return gasket_of(*gasket);
}

Rational PackTexts::smallest_circle() const {
  return smallest_radius(*smallest);
}

std::uint64_t PackTexts::draw_seed() const {
  return seed64("seed", seed.value_or("1"));
}

} // namespace mdm

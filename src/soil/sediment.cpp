// What sedimentology says of a gradation. What comes in is a grading curve; what goes out are numbers on the
// phi scale with their words.
//
// The graphic measures are linear in logarithms of diameters, and diameters are products of powers of the
// sieves: mean and sorting are the logarithm of one product, kurtosis is the quotient of the logarithms of
// two. So a number that equals a limit is known to equal it, and rounding never chooses a word. Skewness is a
// sum of two such quotients, moments are sums of squares of logarithms: where refining does not tell such a
// number from a limit, the word is undecided.

#include "soil/sediment.hpp"

#include "soil/texture.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// The words of a measure: each holds from the limit before it up to its own, which the next word has.
struct Words {
  std::vector<const char *> limits, words;
};

const Words &sorting_words() {
  static const Words words = {{"0.35", "0.5", "0.7", "1", "2", "4"},
                              {"very well sorted", "well sorted", "moderately well sorted",
                               "moderately sorted", "poorly sorted", "very poorly sorted",
                               "extremely poorly sorted"}};
  return words;
}

const std::vector<const char *> &skewness_names() {
  static const std::vector<const char *> names = {"very coarse skewed", "coarse skewed", "symmetrical",
                                                  "fine skewed", "very fine skewed"};
  return names;
}

const Words &graphic_skewness_words() {
  static const Words words = {{"-0.3", "-0.1", "0.1", "0.3"}, skewness_names()};
  return words;
}

const Words &moment_skewness_words() {
  static const Words words = {{"-1.3", "-0.43", "0.43", "1.3"}, skewness_names()};
  return words;
}

const Words &graphic_kurtosis_words() {
  static const Words words = {{"0.67", "0.9", "1.11", "1.5", "3"},
                              {"very platykurtic", "platykurtic", "mesokurtic", "leptokurtic",
                               "very leptokurtic", "extremely leptokurtic"}};
  return words;
}

const Words &moment_kurtosis_words() {
  static const Words words = {
      {"1.7", "2.55", "3.7", "7.4"},
      {"very platykurtic", "platykurtic", "mesokurtic", "leptokurtic", "very leptokurtic"}};
  return words;
}

/// Wentworth (1922), by the mean in phi.
const Words &size_words() {
  static const Words words = {{"-8", "-6", "-2", "-1", "0", "1", "2", "3", "4", "8"},
                              {"boulder", "cobble", "pebble", "granule", "very coarse sand", "coarse sand",
                               "medium sand", "fine sand", "very fine sand", "silt", "clay"}};
  return words;
}

std::string word_for(const Real &value, const Words &words) {
  for (std::size_t i = 0; i < words.limits.size(); ++i)
    switch (compare(value, Real(parse_decimal(words.limits[i])))) {
    case Order::less:
      return words.words[i];
    case Order::undecided:
      return "undecided";
    default:
      break;
    }
  return words.words.back();
}

NamedMeasure named(const Available<Real> &value, const Words &words) {
  return {value, value ? word_for(*value, words) : ""};
}

const PowerProduct &two() {
  static const PowerProduct product(2);
  return product;
}

/// log a / log b, made from a fraction where it is one, so that sums of such are known too.
Real logarithm(const PowerProduct &a, const PowerProduct &b) {
  const Real quotient = log_ratio(a, b);
  const std::optional<Rational> exact = quotient.exact();
  return exact ? Real(*exact) : quotient;
}

/// -log2.
Real phi(const PowerProduct &size) {
  return logarithm(PowerProduct(1) / size, two());
}

/// The diameters of the graphic measures: sizes that so many percent pass.
struct Diameters {
  PowerProduct d5, d16, d25, d50, d75, d84, d95;
};

Available<Diameters> diameters_of(const GradingCurve &curve, bool extrapolate) {
  Diameters d;
  const std::array<std::pair<int, PowerProduct *>, 7> wanted = {
      {{5, &d.d5}, {16, &d.d16}, {25, &d.d25}, {50, &d.d50}, {75, &d.d75}, {84, &d.d84}, {95, &d.d95}}};
  for (const auto &[percent, place] : wanted) {
    const Available<PowerProduct> found = curve.diameter(ratio(percent, 100), extrapolate);
    if (!found)
      return NotAvailable{"D" + std::to_string(percent) + " lies " + found.why().reason};
    *place = *found;
  }
  return d;
}

PhiMeasures graphic_measures(const Diameters &d) {
  const PowerProduct middle = d.d84 / d.d16, wide = d.d95 / d.d5, median_squared = pow(d.d50, 2);
  const Real mean = phi(pow(d.d16 * d.d50 * d.d84, ratio(1, 3)));
  const Real sorting = logarithm(pow(middle, ratio(1, 4)) * pow(wide, ratio(5, 33)), two());
  const Real skewness = Real(ratio(-1, 2)) * (logarithm(d.d16 * d.d84 / median_squared, middle) +
                                              logarithm(d.d5 * d.d95 / median_squared, wide));
  const Real kurtosis = Real(ratio(25, 61)) * logarithm(wide, d.d75 / d.d25);
  return {named(mean, size_words()), named(sorting, sorting_words()),
          named(skewness, graphic_skewness_words()), named(kurtosis, graphic_kurtosis_words())};
}

PhiMeasures without_measures(const NotAvailable &why) {
  return {{why, ""}, {why, ""}, {why, ""}, {why, ""}};
}

/// The middle of class j: the size whose phi it is.
PowerProduct middle_size(const GradingCurve &curve, std::size_t j) {
  return pow(curve.power_of(j) * curve.power_of(j + 1), ratio(1, 2));
}

PhiMeasures moment_measures(const GradingCurve &curve) {
  if (curve.has_pan() && curve.mass(0) > 0)
    return without_measures({"a pan at size 0 holds mass, and has no middle in phi"});
  PowerProduct mean_size;
  std::size_t classes = 0;
  for (std::size_t j = curve.finest(); j <= curve.coarsest(); ++j) {
    mean_size *= pow(middle_size(curve, j), curve.mass(j));
    if (curve.mass(j) > 0)
      ++classes;
  }
  const NamedMeasure named_mean = named(phi(mean_size), size_words());
  if (classes == 1) {
    const NotAvailable one{"all mass is in one class"};
    return {named_mean, {one, ""}, {one, ""}, {one, ""}};
  }
  std::array<Real, 3> sums = {Real(0), Real(0), Real(0)}; // of the powers 2, 3, 4
  for (std::size_t j = curve.finest(); j <= curve.coarsest(); ++j) {
    if (curve.mass(j) == 0)
      continue;
    // As one logarithm: it may be a fraction where those of the middle and of the mean are none.
    const Real from_mean = phi(middle_size(curve, j) / mean_size);
    Real power = from_mean;
    for (Real &sum : sums) {
      power = power * from_mean;
      sum = sum + Real(curve.mass(j)) * power;
    }
  }
  const Real sorting = pow(sums[0], ratio(1, 2));
  return {named_mean, named(sorting, sorting_words()),
          named(sums[1] / (sums[0] * sorting), moment_skewness_words()),
          named(sums[2] / (sums[0] * sums[0]), moment_kurtosis_words())};
}

/// Mass over width in phi.
Real density(const GradingCurve &curve, std::size_t j) {
  return Real(curve.mass(j)) / logarithm(curve.power_of(j + 1) / curve.power_of(j), two());
}

/// Empty classes and a pan, of which no density is known, are lower than all others. Neighbours of one
/// density are one mode.
std::vector<SizeMode> modes_of(const GradingCurve &curve) {
  struct Peak {
    Real height;
    std::size_t from, to;
  };
  std::vector<Peak> peaks;
  const std::size_t first = std::max<std::size_t>(curve.finest(), curve.has_pan() ? 1 : 0),
                    last = curve.coarsest();
  for (std::size_t j = first, next = first; j <= last; j = next) {
    const Real height = density(curve, j);
    for (next = j + 1; next <= last && compare(density(curve, next), height) == Order::equal;)
      ++next;
    const auto is_higher_than = [&](std::size_t i) {
      return i < first || i > last || compare(density(curve, i), height) == Order::less;
    };
    if (curve.mass(j) > 0 && (j == 0 || is_higher_than(j - 1)) && is_higher_than(next))
      peaks.push_back({height, j, next});
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak &a, const Peak &b) { return compare(b.height, a.height) == Order::less; });
  std::vector<SizeMode> modes;
  for (const Peak &peak : peaks)
    modes.push_back({curve.opening(peak.from), curve.opening(peak.to)});
  return modes;
}

/// The name, or `undecided` with a note; empty where the curve does not tell.
std::string texture_word(const char *system, const Available<std::string> &texture,
                         std::vector<std::string> &notes) {
  if (texture)
    return *texture;
  if (!texture.why().limited)
    return "";
  notes.push_back(fmt::format("The texture of {} is undecided: {}.", system, texture.why().reason));
  return "undecided";
}

} // namespace

bool SedimentDescription::limited() const {
  std::vector<std::string> words = {folk, shepard, usda};
  for (const PhiMeasures *m : {&graphic, &moments})
    for (const NamedMeasure *each : {&m->mean, &m->sorting, &m->skewness, &m->kurtosis})
      words.push_back(each->word);
  return std::find(words.begin(), words.end(), "undecided") != words.end();
}

SedimentDescription describe_sediment(const Gradation &g, bool extrapolate) {
  const GradingCurve curve(g);
  const Available<Diameters> d = diameters_of(curve, extrapolate);
  const Available<Real> no_trask = d ? Available<Real>(Real(0)) : Available<Real>(d.why());
  SedimentDescription s{g.id(),
                        d ? graphic_measures(*d) : without_measures(d.why()),
                        moment_measures(curve),
                        d ? Available<Real>(pow(d->d75 / d->d25, ratio(1, 2)).real()) : no_trask,
                        d ? Available<Real>((d->d25 * d->d75 / pow(d->d50, 2)).real()) : no_trask,
                        modes_of(curve),
                        "",
                        "",
                        "",
                        wentworth_fractions(curve),
                        g.notes()};
  if (!d)
    s.notes.push_back("The graphic measures are not available: " + d.why().reason + ".");
  if (!s.moments.mean.value)
    s.notes.push_back("The moments are not available: " + s.moments.mean.value.why().reason + ".");
  s.folk = texture_word("Folk", texture(TextureSystem::folk, curve), s.notes);
  s.shepard = texture_word("Shepard", texture(TextureSystem::shepard, curve), s.notes);
  s.usda = texture_word("the USDA", texture(TextureSystem::usda, curve), s.notes);
  if (s.limited())
    s.notes.emplace_back(
        "Where a word is undecided, 1,200 digits do not tell its number from a limit of the words.");
  s.notes.emplace_back(
      "A number at a limit has the word above it. Moments are of the classes' middles in phi.");
  return s;
}

} // namespace mdm

#include "gradation/description.hpp"

#include "gradation/material_gradation.hpp"
#include "gradation/shown.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace mdm {
namespace {

/// Binary places of an irrational mass.
constexpr unsigned root_bits = 4096;
/// Units of masses that are told apart; each costs a root of every mass that is irrational.
constexpr std::size_t most_units = 8;

/// x / y.
RootSize quotient(const RootSize &x, const RootSize &y) {
  if (y.power == 1)
    return x;
  const unsigned degree = std::lcm(x.degree, y.degree);
  return {power(x.power, degree / x.degree) / power(y.power, degree / y.degree), degree};
}

Rational sum_of(const std::vector<Rational> &numbers) {
  FractionSum sum;
  for (const Rational &r : numbers)
    sum.add(numerator(r), denominator(r));
  return sum.value();
}

} // namespace

Description::Description(Gradation g, DescriptionOptions options)
    : g_(std::move(g)), options_(std::move(options)), classes_(g_.classes()) {
  if (options_.snap < 0)
    throw InputError("a negative snap has no meaning: leave it out, or give one above 0");
  const Rational hair = ratio(1, power_of_ten(12));
  const unsigned d = g_.root();
  const Rational below = options_.snap < 1 ? power(Rational(1 - options_.snap), d) : Rational(0);
  const Rational above = power(Rational(1 + options_.snap), d), beyond = power(Rational(1 + hair), d);
  for (const Rational &x : g_.powers()) {
    lowest_.push_back({x * below, d});
    highest_.push_back({x * above, d});
    hair_beyond_.push_back({x * beyond, d});
    const std::size_t j = highest_.size() - 1;
    if (j > 0 && g_.is_class(j - 1) && compare(highest_[j - 1], lowest_[j]) >= 0)
      throw InputError(fmt::format("a snap of {} makes one of the openings {} and {}: give a smaller one",
                                   shown(options_.snap), shown(g_.opening(j - 1)), shown(g_.opening(j))));
  }
}

Description::Description(Gradation g, const Sample &sample, DescriptionOptions options)
    : Description(std::move(g), std::move(options)) {
  add(sample);
}

void Description::add(const Sample &sample) {
  for (std::size_t i = 0; i < sample.sizes().size(); ++i)
    add(sample.sizes()[i], sample.quantities()[i]);
}

void Description::note(Outside &side, const RootSize &size, const Integer &quantity) {
  side.count += quantity;
  if (!side.first)
    side.first = size;
}

/// The first of these rows whose opening is not smaller than the size, or is taken as it; or their end.
std::size_t Description::openings_below(const RootSize &size, const MaterialRows &of) const {
  const auto at = [this](std::size_t row) { return highest_.begin() + static_cast<std::ptrdiff_t>(row); };
  const auto found = std::partition_point(
      at(of.begin), at(of.end), [&size](const RootSize &highest) { return compare(size, highest) > 0; });
  return static_cast<std::size_t>(found - highest_.begin());
}

/// The rows of the material; null where there are none, and the particles are counted as foreign.
const MaterialRows *Description::rows_of(const std::string &material, const Integer &quantity) {
  const MaterialRows *const rows = find_material(g_, material);
  if (rows != nullptr)
    return rows;
  if (foreign_ == 0)
    foreign_material_ = material;
  foreign_ += quantity;
  return nullptr;
}

void Description::add_of(const std::string &material, const RootSize &size, const Integer &quantity) {
  if (const MaterialRows *const rows = rows_of(material, quantity))
    add(size, quantity, *rows);
}

void Description::add_of(const std::string &material, const SizeRange &size, const Integer &quantity) {
  if (const MaterialRows *const rows = rows_of(material, quantity))
    add(size, quantity, *rows);
}

void Description::add(const RootSize &size, const Integer &quantity, const MaterialRows &of) {
  assert(size.power > 0 && quantity >= 1);
  const std::size_t i = openings_below(size, of);
  if (i > of.begin && compare(size, hair_beyond_[i - 1]) <= 0)
    hair_above_ += quantity;
  if (i == of.end) {
    note(above_, size, quantity);
    return;
  }
  const RootSize opening = g_.opening(i);
  const bool snaps = options_.snap > 0 && compare(size, lowest_[i]) >= 0 && compare(size, opening) != 0;
  if (snaps)
    snapped_ += quantity;
  if (i == of.begin)
    note(below_, size, quantity);
  else
    weigh(classes_[i - 1], snaps ? opening : size, quantity);
}

void Description::add(const SizeRange &size, const Integer &quantity, const MaterialRows &of) {
  assert(options_.mass_unit == 1 && size.lo >= 0 && size.lo <= size.hi);
  if (size.is_point()) {
    add(RootSize{size.hi}, quantity, of);
    return;
  }
  knows_sizes_ = false;
  const RootSize lo{size.lo}, hi{size.hi};
  std::size_t first = openings_below(lo, of);
  const bool is_above = size.is_open || size.lo == 0; // a size is above 0
  if (is_above && first < of.end && compare(lo, g_.opening(first)) == 0)
    ++first;
  const std::size_t last = openings_below(hi, of);
  const auto mass = [&](const Rational &x) { // an enclosure of f(x)
    constexpr unsigned bits = 256;
    if (!options_.law.is_power()) // no particle of a class is larger than all openings
      return Interval(options_.law.powered(std::min(x, g_.sizes()[of.end - 1])));
    return root(options_.law.powered(x), options_.law.b, bits);
  };
  const bool is_placed = first == last;
  if (!is_placed)
    note(unplaced_, hi, quantity);
  else if (last == of.begin)
    note(below_, hi, quantity);
  else if (last == of.end)
    note(above_, hi, quantity);
  for (std::size_t i = std::max(first, of.begin + 1); i <= last && i < of.end; ++i) {
    Tally &tally = classes_[i - 1];
    const Rational most = mass(size.hi).hi * quantity;
    tally.most.add(numerator(most), denominator(most));
    if (!is_placed)
      continue;
    see(tally.seen, size, quantity);
    const Rational least = mass(size.lo).lo * quantity;
    tally.least.add(numerator(least), denominator(least));
  }
}

void Description::add_of_mass(const Rational &mass, const Rational &near, const Integer &quantity) {
  assert(mass > 0 && quantity >= 1 && !options_.law.is_power());
  const std::vector<Rational> &x = g_.sizes();
  const auto opening = std::partition_point(
      x.begin(), x.end(), [&](const Rational &y) { return options_.law.powered(y) < mass; });
  const RootSize size{near};
  if (opening == x.end())
    return note(above_, size, quantity);
  if (opening == x.begin())
    return note(below_, size, quantity);
  Tally &tally = classes_[static_cast<std::size_t>(opening - x.begin()) - 1];
  Class &seen = tally.seen;
  seen.count += quantity;
  if (!seen.first) {
    seen.first = size;
    tally.first_mass = mass;
  } else if (!seen.second && tally.first_mass != mass) {
    seen.second = size;
  }
  tally.multiples[0].add(numerator(mass) * quantity, denominator(mass));
}

void Description::see(Class &seen, const RootSize &size, const Integer &quantity) {
  seen.count += quantity;
  if (!seen.first)
    seen.first = size;
  else if (!seen.second && compare(*seen.first, size) != 0)
    seen.second = size;
}

/// Two ranges that have no size in common are of different sizes.
void Description::see(Class &seen, const SizeRange &size, const Integer &quantity) {
  const RootSize lo{size.lo}, hi{size.hi};
  seen.may_differ = seen.may_differ || seen.count > 0 || quantity > 1;
  seen.count += quantity;
  if (!seen.least_hi || compare(hi, *seen.least_hi) < 0)
    seen.least_hi = hi;
  if (!seen.most_lo || compare(lo, *seen.most_lo) > 0)
    seen.most_lo = lo;
  if (compare(*seen.most_lo, *seen.least_hi) > 0) {
    seen.first = seen.least_hi;
    seen.second = seen.most_lo;
  }
}

void Description::weigh(Tally &tally, const RootSize &size, const Integer &quantity) {
  see(tally.seen, size, quantity);
  // x^D = power and common = gcd(a, D): f(x)^(b D / common) = power^(a / common).
  const unsigned a = options_.law.a, b = options_.law.b;
  if (!options_.law.is_power()) {
    const std::optional<Rational> x = size.fraction();
    if (!x)
      throw InputError("a size is irrational, and a mass law by table or sum is one of fractions: give sizes "
                       "as decimals");
    const Rational mass = options_.law.powered(*x);
    tally.multiples[0].add(numerator(mass) * quantity, denominator(mass));
    return;
  }
  const unsigned common = std::gcd(a, size.degree);
  const unsigned exponent = a / common;
  const unsigned degree = b * (size.degree / common);
  if (degree == 1 && options_.mass_unit == 1) {
    tally.multiples[0].add(power(Integer(numerator(size.power)), exponent) * quantity,
                           power(Integer(denominator(size.power)), exponent));
    return;
  }
  const RootSize weight =
      quotient({power(size.power, exponent), degree}, {options_.mass_unit, options_.unit_power});
  for (std::size_t i = 0; i < units_.size(); ++i) {
    const RootSize multiple = quotient(weight, units_[i]);
    if (const std::optional<Rational> exact = exact_root(multiple.power, multiple.degree)) {
      tally.multiples.resize(std::max(tally.multiples.size(), i + 1));
      tally.multiples[i].add(numerator(*exact) * quantity, denominator(*exact));
      return;
    }
  }
  if (units_.size() < most_units) {
    units_.push_back(weight);
    tally.multiples.resize(units_.size());
    tally.multiples.back().add(quantity, 1);
    return;
  }
  const Integer scaled =
      floor_div(numerator(weight.power) << (root_bits * weight.degree), denominator(weight.power));
  tally.roots += floor_root(scaled, weight.degree) * quantity;
  tally.rooted_count += quantity;
}

Interval Description::mass(const Tally &tally) const {
  Interval sum;
  for (std::size_t i = 0; i < tally.multiples.size(); ++i)
    sum = sum + root(units_[i].power, units_[i].degree, root_bits) * tally.multiples[i].value();
  if (!knows_sizes_)
    sum = sum + Interval(tally.least.value(), tally.most.value());
  if (tally.rooted_count == 0)
    return sum;
  const Integer unit = Integer(1) << root_bits;
  return sum + Interval(ratio(tally.roots, unit), ratio(tally.roots + tally.rooted_count, unit));
}

/// The classes' shares of the mass where they are rational and that is known. Roots of which no two are
/// commensurable are linearly independent over the rationals (Besicovitch 1940, Mordell 1953): a share is
/// rational iff it is the same of every unit.
std::vector<std::optional<Rational>> Description::exact_shares() const {
  std::vector<std::optional<Rational>> shares(classes_.size());
  const auto has_particles = [](const Tally &t) { return t.seen.count > 0; };
  if (unplaced_.count > 0)
    return shares;
  if (std::count_if(classes_.begin(), classes_.end(), has_particles) <= 1) {
    std::transform(classes_.begin(), classes_.end(), shares.begin(),
                   [&](const Tally &t) { return Rational(has_particles(t) ? 1 : 0); });
    return shares;
  }
  if (std::any_of(classes_.begin(), classes_.end(), [this](const Tally &t) {
        return t.rooted_count > 0 || (!knows_sizes_ && t.most.value() > 0);
      }))
    return shares;
  std::vector<std::vector<Rational>> masses; // of each class, in each unit
  std::vector<Rational> sums(units_.size());
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    std::vector<Rational> &mass = masses.emplace_back(units_.size());
    for (std::size_t i = 0; i < classes_[j].multiples.size(); ++i) {
      mass[i] = classes_[j].multiples[i].value() * g_.factor(j);
      sums[i] += mass[i];
    }
  }
  const auto some = static_cast<std::size_t>(
      std::find_if(sums.begin(), sums.end(), [](const Rational &sum) { return sum != 0; }) - sums.begin());
  for (std::size_t j = 0; j < masses.size(); ++j) {
    const Rational share = masses[j][some] / sums[some];
    bool same = true;
    for (std::size_t i = 0; i < sums.size(); ++i)
      same = same && masses[j][i] == share * sums[i];
    if (same)
      shares[j] = share;
  }
  return shares;
}

Integer Description::particles() const {
  Integer n = outside() + unplaced_.count;
  for (const Tally &tally : classes_)
    n += tally.seen.count;
  return n;
}

std::optional<bool> Description::articulately() const {
  if (!describes() || inarticulate_class())
    return false;
  const bool may_differ =
      std::any_of(classes_.begin(), classes_.end(), [](const Tally &t) { return t.seen.may_differ; });
  return may_differ || unplaced_.count > 0 ? std::nullopt : std::optional(true);
}

std::optional<std::size_t> Description::inarticulate_class() const {
  const auto found = std::find_if(classes_.begin(), classes_.end(),
                                  [](const Tally &t) { return t.seen.second.has_value(); });
  if (found == classes_.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - classes_.begin());
}

MatchError Description::error() const {
  const Interval unit = root(options_.mass_unit, options_.unit_power, root_bits);
  const Rational target_sum = sum_of(g_.masses());
  std::vector<Interval> masses;
  Interval mass_sum;
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    masses.push_back(mass(classes_[j]) * g_.factor(j));
    mass_sum = mass_sum + masses.back();
  }
  const std::vector<std::optional<Rational>> exact = exact_shares();
  MatchError e;
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    e.as_given.push_back(Interval(g_.mass(j)) - masses[j] * unit);
    e.shares.push_back(
        exact[j] ? Interval(*exact[j])
                 : Interval(masses[j].lo / mass_sum.hi,
                            mass_sum.lo == 0 ? Rational(1)
                                             : std::min(Rational(1), Rational(masses[j].hi / mass_sum.lo))));
    e.targets.push_back(g_.mass(j) / target_sum);
    e.normalised.push_back(Interval(e.targets[j]) - e.shares[j]);
    const Interval size = absolute(e.normalised[j]);
    if (size.hi > absolute(e.normalised[e.worst]).hi)
      e.worst = j;
    e.maximum = greater(e.maximum, size);
    e.total = e.total + size;
  }
  return e;
}

} // namespace mdm

#include "message.hpp"

#include <mdm/gradation/description.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Binary places of an irrational mass.
constexpr unsigned root_bits = 4096;

/// Sign of x - y for the x > 0 with x^degree = power.
int compare(const Rational &power, unsigned degree, const Rational &y) {
  return degree == 1 ? power.compare(y) : power.compare(mdm::power(y, degree));
}

Rational sum_of(const std::vector<Rational> &numbers) {
  FractionSum sum;
  for (const Rational &r : numbers)
    sum.add(numerator(r), denominator(r));
  return sum.value();
}

} // namespace

bool RootSize::is(const Rational &other, unsigned of_degree) const {
  if (degree == of_degree)
    return power == other;
  return mdm::power(power, of_degree) == mdm::power(other, degree);
}

Description::Description(Gradation g, DescriptionOptions options)
    : g_(std::move(g)), options_(std::move(options)), classes_(g_.classes()) {
  if (options_.snap < 0)
    throw InputError("a negative snap has no meaning: leave it out, or give one above 0");
  const Rational hair = ratio(1, power_of_ten(12));
  for (const Rational &x : g_.sizes()) {
    lowest_.push_back(x * (1 - options_.snap));
    highest_.push_back(x * (1 + options_.snap));
    hair_beyond_.push_back(x * (1 + hair));
    const std::size_t j = highest_.size() - 1;
    if (j > 0 && highest_[j - 1] >= lowest_[j])
      throw InputError(fmt::format("a snap of {} makes one of the openings {} and {}: give a smaller one",
                                   shown(options_.snap), shown(g_.sizes()[j - 1]), shown(x)));
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

void Description::place(const Rational &power, unsigned degree, const Integer &quantity) {
  const auto found =
      std::partition_point(highest_.begin(), highest_.end(), [&power, degree](const Rational &highest) {
        return compare(power, degree, highest) > 0;
      });
  const auto i = static_cast<std::size_t>(found - highest_.begin());
  if (i > 0 && compare(power, degree, hair_beyond_[i - 1]) <= 0)
    hair_above_ += quantity;
  if (found == highest_.end()) {
    note(above_, {power, degree}, quantity);
    return;
  }
  const Rational &opening = g_.sizes()[i];
  const bool snaps =
      options_.snap > 0 && compare(power, degree, lowest_[i]) >= 0 && compare(power, degree, opening) != 0;
  if (snaps)
    snapped_ += quantity;
  if (i == 0)
    note(below_, {power, degree}, quantity);
  else
    classes_[i - 1].add(snaps ? opening : power, snaps ? 1 : degree, quantity, options_);
}

void Description::Tally::add(const Rational &power, unsigned degree, const Integer &quantity,
                             const DescriptionOptions &options) {
  seen.count += quantity;
  if (!seen.first)
    seen.first = RootSize{power, degree};
  else if (!seen.second && !seen.first->is(power, degree))
    seen.second = RootSize{power, degree};

  const auto [a, b] = options.law;
  const unsigned exponent = degree == 1 ? a : 1;
  if (b == 1 && options.mass_unit == 1) {
    mass.add(mdm::power(Integer(numerator(power)), exponent) * quantity,
             mdm::power(Integer(denominator(power)), exponent));
    return;
  }
  const Rational powered = mdm::power(power, exponent) / options.mass_unit; // (f(x) / u)^b
  if (const std::optional<Rational> exact = exact_root(powered, b)) {
    mass.add(numerator(*exact) * quantity, denominator(*exact));
    return;
  }
  roots += floor_root(floor_div(numerator(powered) << (root_bits * b), denominator(powered)), b) * quantity;
  rooted_count += quantity;
}

Interval Description::Tally::total() const {
  const Rational fraction = mass.value();
  if (rooted_count == 0)
    return fraction;
  const Integer unit = Integer(1) << root_bits;
  return {fraction + ratio(roots, unit), fraction + ratio(roots + rooted_count, unit)};
}

Integer Description::particles() const {
  Integer n = below_.count + above_.count;
  for (const Tally &tally : classes_)
    n += tally.seen.count;
  return n;
}

std::optional<std::size_t> Description::inarticulate_class() const {
  const auto found = std::find_if(classes_.begin(), classes_.end(),
                                  [](const Tally &t) { return t.seen.second.has_value(); });
  if (found == classes_.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - classes_.begin());
}

MatchError Description::error() const {
  const Interval unit = root(options_.mass_unit, law().b, root_bits);
  const Rational target_sum = sum_of(g_.masses());
  std::vector<Interval> masses;
  Interval mass_sum;
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    masses.push_back(classes_[j].total() * g_.factor(j));
    mass_sum = mass_sum + masses.back();
  }
  MatchError e;
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    e.as_given.push_back(Interval(g_.mass(j)) - masses[j] * unit);
    e.shares.push_back(mass_sum.hi == 0
                           ? Interval()
                           : Interval(masses[j].lo / mass_sum.hi,
                                      mass_sum.lo == 0 ? Rational(1) : Rational(masses[j].hi / mass_sum.lo)));
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

// A sample's rows come in one after the other. Each is placed between openings by powers of both, and its
// mass, relative to that of the first row where the law can be irrational, is bounded by fractions. What goes
// out are enclosures of all that a certificate of the sample says: they hold for every sample with such rows
// (Theorem 23). The sums are exact, so that they do not depend on the order of rows.

#include "proof/sample_tally.hpp"

#include "match/problem.hpp"
#include "proof/certificate_parts.hpp"

#include <mdm/match/tolerance.hpp>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace mdm {
namespace {

constexpr std::uint64_t most_rows_work = std::uint64_t{1} << 36, most_classes_work = std::uint64_t{1} << 28;

void demand(bool holds) {
  if (!holds)
    refuse_long_numbers();
}

/// Places with which the mass of the smallest class is known to some 30 digits, whatever row is the first.
unsigned places_for(const Gradation &g, const MassLaw &law) {
  const auto &Y = g.powers();
  const Rational &least = Y.front() == 0 ? Y[1] : Y.front();
  constexpr std::uint64_t digits_enough = 30, most = 1000;
  const std::uint64_t bits = longest_part(Rational(Y.back() / least)) / g.root() + 1;
  return static_cast<unsigned>(std::min(digits_enough + bits * law.a * 3 / (10 * law.b), most));
}

std::string_view word(bool yes, bool no) {
  return no ? "no" : yes ? "yes" : "open";
}

Interval error(const Interval &value, const Rational &target) {
  const Rational over = value.hi - target, under = target - value.lo;
  return {std::max({Rational(0), Rational(-over), Rational(-under)}), std::max(over, under)};
}

} // namespace

SampleTally::SampleTally(const Gradation &g, const MassLaw &law, unsigned N) : g_(g), classes_(g.classes()) {
  const std::uint64_t bN = std::uint64_t{law.b} * N, common = std::gcd(std::uint64_t{law.a}, bN);
  exponent_ = static_cast<unsigned>(law.a / common);
  root_ = static_cast<unsigned>(bN / common);
  places_ = root_ > 1 ? places_for(g, law) : 0;
  unit_of_places_ = power_of_ten(places_);
  for (const Rational &Y : g.powers())
    opening_bits_ = std::max(opening_bits_, N * longest_part(Y));
  demand(opening_bits_ <= max_power_bits && opening_bits_ * g.powers().size() <= most_classes_work);
  for (const Rational &Y : g.powers())
    openings_.push_back(power(Y, N));
}

std::optional<unsigned> SampleTally::places() const {
  return root_ > 1 ? std::optional(places_) : std::nullopt;
}

std::size_t SampleTally::openings_below(const Rational &z, bool or_at) const {
  const Rational powered = power(z, g_.root());
  const auto end = std::partition_point(openings_.begin(), openings_.end(), [&](const Rational &Y) {
    return Y < powered || (or_at && Y == powered);
  });
  return static_cast<std::size_t>(end - openings_.begin());
}

SampleTally::Mass SampleTally::mass(const Rational &z) {
  const Rational T = power(root_ > 1 ? Rational(z / unit_) : z, exponent_);
  Mass mass{root_ > 1 ? exact_root(T, root_) : T, 0};
  if (!mass.exact) {
    const Integer scaled = floor_div(numerator(T) * power(unit_of_places_, root_), denominator(T));
    mass.places = floor_root(scaled, root_);
  } else if (common_ % denominator(*mass.exact) != 0) {
    common_ = lcm(common_, denominator(*mass.exact));
    demand(bit_length(common_) <= max_power_bits);
  }
  return mass;
}

void SampleTally::add(Sum &sum, const Mass &mass, const Integer &quantity, bool upper) {
  if (!mass.exact) {
    sum.places += (mass.places + (upper ? 1 : 0)) * quantity;
    return;
  }
  const Integer denominator_of = denominator(*mass.exact);
  if (sum.denominator % denominator_of != 0) {
    const Integer common = lcm(sum.denominator, denominator_of);
    sum.numerator *= common / sum.denominator;
    sum.denominator = common;
  }
  sum.numerator += numerator(*mass.exact) * quantity * (sum.denominator / denominator_of);
}

void SampleTally::see(Class &seen, const SampleRow &row) {
  const bool is_first = seen.count == 0;
  const auto keep_least = [is_first](Rational &least, const Rational &value) {
    if (is_first || value < least)
      least = value;
  };
  const auto keep_most = [is_first](Rational &most, const Rational &value) {
    if (is_first || value > most)
      most = value;
  };
  keep_least(seen.least_lo, row.lo);
  keep_most(seen.most_lo, row.lo);
  keep_least(seen.least_hi, row.hi);
  keep_most(seen.most_hi, row.hi);
  seen.count += row.quantity;
}

void SampleTally::check_work() const {
  const std::uint64_t of_row = 2 * longest_ * exponent_ + std::uint64_t{4} * root_ * places_ +
                               longest_ * g_.root() + opening_bits_ + bit_length(common_);
  demand(rows_ <= most_rows_work && rows_ * of_row <= most_rows_work);
}

void SampleTally::add(const SampleRow &row) {
  assert(row.lo >= 0 && row.lo <= row.hi && row.hi > 0 && row.quantity >= 1);
  if (rows_ == 0)
    unit_ = row.hi;
  longest_ = std::max({longest_, longest_part(row.lo), longest_part(row.hi)});
  demand(2 * longest_ * exponent_ + std::uint64_t{4} * root_ * places_ <= max_power_bits &&
         longest_ * g_.root() <= max_power_bits);
  const bool is_point = row.lo == row.hi;
  const std::size_t last = openings_below(row.hi, false);
  const std::size_t first = is_point ? last : openings_below(row.lo, row.is_open || row.lo == 0);
  const bool is_placed = first == last, is_inside = last > 0 && first < openings_.size();
  const Mass most = mass(row.hi), least = is_point ? most : mass(row.lo);
  rows_ += is_placed ? 1 : last - first + 2;
  check_work();
  if (!is_placed) {
    unplaced_ += row.quantity;
    may_be_outside_ = may_be_outside_ || first == 0 || last == openings_.size();
  } else if (!is_inside) {
    (first == 0 ? below_ : above_) += row.quantity;
  } else {
    see(classes_[first - 1], row);
    add(classes_[first - 1].least, least, row.quantity, false);
  }
  for (std::size_t i = std::max<std::size_t>(first, 1); is_inside && i <= last && i < openings_.size(); ++i)
    add(classes_[i - 1].most, most, row.quantity, true);
}

Interval SampleTally::mass_of_class(std::size_t j) const {
  const auto value = [&](const Sum &sum) {
    return Rational(g_.factor(j) *
                    (ratio(sum.numerator, sum.denominator) + ratio(sum.places, unit_of_places_)));
  };
  return {value(classes_[j].least), value(classes_[j].most)};
}

void SampleTally::find_shares(SampleFindings &f) const {
  std::vector<Interval> masses;
  Interval all;
  std::size_t longest = 0;
  for (std::size_t j = 0; j < g_.classes(); ++j) {
    masses.push_back(mass_of_class(j));
    longest = std::max({longest, longest_part(masses[j].lo), longest_part(masses[j].hi)});
    demand(g_.classes() * longest <= most_classes_work);
    all = all + masses[j];
  }
  const Rational one = 1;
  Rational least = 0, most = 0;
  for (const Interval &mass : masses) {
    const Rational lo = all.hi > 0 ? Rational(mass.lo / all.hi) : Rational(0);
    const Rational hi = all.lo > 0   ? std::min(one, Rational(mass.hi / all.lo))
                        : all.hi > 0 ? one
                                     : Rational(0);
    f.shares.emplace_back(lo, hi);
    least += lo;
    most += hi;
    f.passing.emplace_back(least, std::min(one, most));
  }
  if (all.lo > 0)
    f.passing.back() = one;
}

void SampleTally::find_errors(SampleFindings &f) const {
  const std::vector<Rational> targets = mdm::shares(g_), passing = accumulated(targets);
  for (std::size_t j = 0; j < targets.size(); ++j) {
    f.share_errors.push_back(error(f.shares[j], targets[j]));
    f.total = f.total + f.share_errors[j];
    if (j + 1 < targets.size())
      f.passing_errors.push_back(error(f.passing[j], passing[j]));
  }
}

void SampleTally::find_conditions(SampleFindings &f) const {
  const bool is_outside = below_ > 0 || above_ > 0, describes = !is_outside && !may_be_outside_;
  const bool is_placed = describes && unplaced_ == 0;
  const auto some = [&](auto holds) { return std::any_of(classes_.begin(), classes_.end(), holds); };
  const bool differ = some([](const Class &c) { return c.most_lo > c.least_hi; });
  const bool may_differ = some([](const Class &c) { return c.count > 1 && c.least_lo != c.most_hi; });
  bool equal = true, unequal = false; // for sure
  for (const Interval &e : f.share_errors) {
    equal = equal && e.hi == 0;
    unequal = unequal || e.lo > 0;
  }
  f.conditions = {"yes", word(describes, is_outside), word(is_placed && !may_differ, is_outside || differ),
                  word(is_placed && equal, is_outside || unequal)};
}

SampleFindings SampleTally::findings() const {
  SampleFindings f;
  f.below = below_;
  f.above = above_;
  f.unplaced = unplaced_;
  f.particles = below_ + above_ + unplaced_;
  for (const Class &c : classes_) {
    f.counts.push_back(c.count);
    f.particles += c.count;
  }
  find_shares(f);
  find_errors(f);
  find_conditions(f);
  return f;
}

} // namespace mdm

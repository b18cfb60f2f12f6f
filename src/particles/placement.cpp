#include "particles/placement.hpp"

#include "number/pi.hpp"
#include "particles/shuffle.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The smallest size has so many units or more, and less than ten times as many unless a unit is 1.
constexpr int units_of_smallest = 1000;
/// More than rounding to doubles can take at each side of a particle.
constexpr std::int64_t slack = 2;
/// Lengths in units are below it, so that doubles are within half a unit of them.
constexpr std::int64_t most_units = std::int64_t{1} << 52;
/// A cell is by this wider than its particle where there is room: its place in it is no regular one.
const Rational &looseness() {
  static const Rational tenth = ratio(11, 10);
  return tenth;
}

} // namespace

void check_simulated(const ParticleSet &set) {
  if (set.particles() > most_simulated)
    throw InputError(fmt::format(
        "{} particles are more than the {} that programs count: take a gradation or a "
        "{} that needs fewer, {}, or {} csv",
        to_string(set.particles()), most_simulated, option("tolerance"), option("cut-below"), option("to")));
}

Footprint inscribed_square(const Rational &diameter) {
  const Rational square = diameter * diameter / 2;
  unsigned places = 0;
  while (square * power(Rational(power_of_ten(places)), 2) < Rational(power_of_ten(30)))
    ++places;
  const Rational side =
      ratio(floor_root(floor(Rational(square * power(Rational(power_of_ten(places)), 2))), 2),
            power_of_ten(places));
  return {side, side, std::nullopt};
}

Placement::Placement(const ParticleSet &set, const std::optional<Footprint> &floor, std::uint64_t seed,
                     Start start, const StartProgress &progress)
    : set_(&set), seed_(seed) {
  check_simulated(set);
  choose_unit();
  if (start == Start::deposit) {
    deposit(floor, progress);
    return;
  }
  choose_floor(floor);
  if (start == Start::mixed) {
    choose_mixed_box(floor);
    mix();
    return;
  }
  for (std::size_t i = set.classes.size(); i > 0; --i)
    add_slab(i - 1);
  if (floor)
    set_height(*floor);
}

/// Raises the box to the height that was asked for.
void Placement::set_height(const Footprint &floor) {
  if (!floor.c)
    return;
  const std::int64_t height = units(*floor.c);
  if (height < box_[2])
    throw InputError(fmt::format("a start without overlaps on {} x {} is {} high, more than {}: leave the "
                                 "height of {} out, or make the box wider",
                                 set_->length_text(floor.a), set_->length_text(floor.b), text(box_[2]),
                                 set_->length_text(*floor.c), option("box")));
  box_[2] = height;
}

void Placement::choose_unit() {
  const Rational smallest = set_->smallest().diameter.decimal();
  while (places_ <= most_places && smallest * power_of_ten(places_) < units_of_smallest)
    ++places_;
  if (places_ > most_places)
    throw InputError(fmt::format("a size of {} is too small a number to be placed: take a smaller {}",
                                 set_->length_text(smallest), option("unit")));
}

std::int64_t Placement::units(const Rational &length) const {
  const Integer n = floor(Rational(length * power_of_ten(places_)));
  if (n >= most_units)
    throw InputError(fmt::format("a length of {} is too far from the smallest size, {}: are the units right? "
                                 "Else leave fine classes out with {}",
                                 set_->length_text(length),
                                 set_->length_text(set_->smallest().diameter.decimal()),
                                 option("cut-below")));
  return n.convert_to<std::int64_t>();
}

std::int64_t Placement::radius(const ParticleSize &size) const {
  return units(exact_value(std::max(size.radius.value, size.diameter.value / 2))) + 1 + slack;
}

std::int64_t Placement::radius(const ParticleClass &c) const {
  std::int64_t largest = 0;
  for (const ParticleSize &size : c.sizes)
    largest = std::max(largest, radius(size));
  return largest;
}

void Placement::choose_floor(const std::optional<Footprint> &floor) {
  const std::int64_t widest = 2 * radius(set_->classes.back());
  if (floor) {
    box_ = {units(floor->a), units(floor->b), 0};
    if (std::min(box_[0], box_[1]) < widest)
      throw InputError(
          fmt::format("the footprint, {} x {}, is narrower than the largest particle, {}: give a "
                      "{} that it fits into",
                      set_->length_text(floor->a), set_->length_text(floor->b),
                      set_->length_text(set_->largest().diameter.decimal()), option("box")));
    return;
  }
  Rational volume = 0;
  for (const ParticleClass &c : set_->classes)
    volume += Rational(c.quantity()) * power(Rational(looseness() * 2 * radius(c)), 3);
  const Integer side = std::max(floor_root(mdm::floor(volume), 3), mdm::ceil(Rational(looseness() * widest)));
  box_[0] = box_[1] = units(ratio(side, power_of_ten(places_)));
}

void Placement::add_slab(std::size_t class_index) {
  const ParticleClass &c = set_->classes[class_index];
  const auto quantity = c.quantity().convert_to<std::uint64_t>();
  Slab slab{class_index, radius(c), {}, {}, box_[2]};
  const std::int64_t wide =
      units(ratio(mdm::ceil(Rational(looseness() * 2 * slab.radius)), power_of_ten(places_)));
  for (const std::size_t axis : {0U, 1U}) {
    const std::int64_t fit = std::max<std::int64_t>(1, box_[axis] / wide);
    slab.n[axis] = std::min(static_cast<std::uint64_t>(fit), quantity);
    slab.cell[axis] = box_[axis] / static_cast<std::int64_t>(slab.n[axis]);
  }
  const std::uint64_t layer = slab.n[0] * slab.n[1];
  slab.n[2] = (quantity + layer - 1) / layer;
  slab.cell[2] = wide;
  const Integer top = Integer(box_[2]) + Integer(wide) * slab.n[2];
  box_[2] = units(ratio(top, power_of_ten(places_)));
  slabs_.push_back(slab);
}

std::array<bool, 3> Placement::repeated() const {
  const bool is_pillar = sides_ == Sides::periodic;
  return kept_repeated_.value_or(std::array<bool, 3>{is_pillar, is_pillar, false});
}

std::string Placement::repeated_text() const {
  std::string axes;
  const std::array<bool, 3> are = repeated();
  for (std::size_t axis = 0; axis < are.size(); ++axis)
    if (are[axis])
      axes += axes.empty() ? std::string(1, "xyz"[axis]) : std::string(" and ") + "xyz"[axis];
  return axes.empty() ? "" : ", repeated in " + axes;
}

std::string Placement::text(std::int64_t units) const {
  std::string digits = std::to_string(units);
  if (places_ == 0)
    return digits;
  if (digits.size() <= places_)
    digits.insert(0, places_ + 1 - digits.size(), '0');
  digits.insert(digits.size() - places_, 1, '.');
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.')
    digits.pop_back();
  return digits;
}

Placement::Sphere Placement::place(const Slab &slab, const ParticleSize &size, std::uint64_t i) const {
  const std::uint64_t key = mixed(seed_ ^ mixed(set_->classes[slab.class_index].number));
  const std::uint64_t cell = shuffled(i, slab.n[0] * slab.n[1] * slab.n[2], key);
  const std::array<std::uint64_t, 3> index = {cell % slab.n[0], cell / slab.n[0] % slab.n[1],
                                              cell / slab.n[0] / slab.n[1]};
  Sphere sphere{slab.class_index, &size, {0, 0, slab.base}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto room = static_cast<std::uint64_t>(slab.cell[axis] - 2 * slab.radius);
    const std::uint64_t shift = mixed(key ^ mixed(3 * cell + axis)) % (room + 1);
    sphere.at[axis] += static_cast<std::int64_t>(index[axis]) * slab.cell[axis] + slab.radius +
                       static_cast<std::int64_t>(shift);
  }
  return sphere;
}

void Placement::each(const std::function<void(const Sphere &)> &take) const {
  std::for_each(spheres_.begin(), spheres_.end(), take);
  for (const Slab &slab : slabs_) {
    std::uint64_t i = 0;
    const std::vector<ParticleSize> &sizes = set_->classes[slab.class_index].sizes;
    for (auto size = sizes.rbegin(); size != sizes.rend(); ++size)
      for (const std::uint64_t end = i + size->quantity.convert_to<std::uint64_t>(); i < end; ++i)
        take(place(slab, *size, i));
  }
}

std::pair<Rational, Rational> Placement::void_ratio() const {
  constexpr unsigned pi_places = 30;
  const Enclosure pi = enclose_pi(pi_places);
  if (is_flat_) {
    const Rational area = Rational(Integer(box_[0]) * box_[2]) / power(Rational(power_of_ten(places_)), 2);
    const auto [least, most] = std::minmax({set_->squares(), set_->squares_of_radii()});
    return {4 * area / (most * pi.upper()) - 1, 4 * area / (least * pi.lower()) - 1};
  }
  const Rational box =
      Rational(Integer(box_[0]) * box_[1] * box_[2]) / power(Rational(power_of_ten(places_)), 3);
  const auto [least, most] = std::minmax({set_->cubes(), set_->cubes_of_radii()});
  // Of a cylinder pi cancels: (pi / 4) by (pi / 6).
  if (sides_ == Sides::cylinder)
    return {ratio(3, 2) * box / most - 1, ratio(3, 2) * box / least - 1};
  return {6 * box / (most * pi.upper()) - 1, 6 * box / (least * pi.lower()) - 1};
}

} // namespace mdm

// Places of a deposited start.

#include "packing/shuffled.hpp"
#include "particles/placement.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The smallest size has so many units or more, where there is room for them: gaps are some units.
constexpr std::uint64_t fine_units = 1000000000;

/// A height that no deposit reaches: even the loosest fills more than 0.3 of its space, and pi / 6 / 0.3 is
/// below 7/4; of the square around it a cylinder has more than 3/4.
Rational highest(const ParticleSet &set, const Footprint &ground) {
  const Rational round = ground.sides == Sides::cylinder ? ratio(4, 3) : Rational(1);
  return round * ratio(7, 4) * std::max(set.cubes(), set.cubes_of_radii()) / (ground.a * ground.b) +
         4 * set.largest().diameter.decimal();
}

Rational least_side(const ParticleSet &set) {
  return (least_widths + ratio(1, 1000)) * set.largest().diameter.decimal();
}

} // namespace

Footprint deposit_square(const ParticleSet &set) {
  const Rational side = std::max(Rational(settled_side(set)), least_side(set));
  return {side, side, std::nullopt};
}

Footprint Placement::deposit_ground(const std::optional<Footprint> &floor) const {
  if (set_->particles() > most_deposited)
    throw InputError(fmt::format("{0} deposit: {1} particles are more than the {2} that it lays: take "
                                 "{0} layers, or {3}",
                                 option("start"), to_string(set_->particles()), most_deposited,
                                 option("cut-below")));
  if (!floor)
    return deposit_square(*set_);
  const Rational least = least_side(*set_);
  if (std::min(floor->a, floor->b) < least)
    throw InputError(fmt::format("{0} deposit: the footprint, {1} x {2}, is narrower than {3} of the largest "
                                 "particle: give a {4} of {5} or more, or take {0} mixed",
                                 option("start"), set_->length_text(floor->a), set_->length_text(floor->b),
                                 least_widths, option("box"), set_->length_text(least)));
  return *floor;
}

/// What choose_unit() found is coarse; finer units as far as there is room.
void Placement::refine_unit(const Rational &longest) {
  const Rational smallest = set_->smallest().diameter.decimal();
  while (places_ < most_places && smallest * power_of_ten(places_) < fine_units &&
         longest * power_of_ten(places_ + 1) < most_sphere_units)
    ++places_;
}

void Placement::choose_deposit_unit(const Footprint &ground) {
  const Rational smallest = set_->smallest().diameter.decimal();
  const Rational longest = std::max({ground.a, ground.b, ground.c.value_or(0), highest(*set_, ground)});
  refine_unit(longest);
  if (longest * power_of_ten(places_) >= most_sphere_units ||
      smallest * power_of_ten(places_) < 3 * least_radius_units)
    throw InputError(fmt::format("{0} deposit: a length of {1} is too far from the smallest size, {2}: leave "
                                 "fine classes out with {3}, or take {0} layers",
                                 option("start"), set_->length_text(longest), set_->length_text(smallest),
                                 option("cut-below")));
}

void Placement::list_in_order(std::vector<std::int64_t> &radii) {
  for (std::size_t i = set_->classes.size(); i > 0; --i) {
    const std::vector<ParticleSize> &sizes = set_->classes[i - 1].sizes;
    for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
      const auto n = size->quantity.convert_to<std::uint64_t>();
      spheres_.insert(spheres_.end(), n, Sphere{i - 1, &*size, {}});
      radii.insert(radii.end(), n, radius(*size));
    }
  }
}

void Placement::deposit(const std::optional<Footprint> &floor, const StartProgress &progress) {
  const Footprint ground = deposit_ground(floor);
  choose_deposit_unit(ground);
  sides_ = ground.sides;
  box_ = {units(ground.a), units(ground.b), 0};
  std::vector<std::int64_t> radii, shuffled_radii;
  list_in_order(radii);
  std::vector<std::uint32_t> order(radii.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<std::uint32_t>(i);
  packing::shuffle(order, seed_);
  for (const std::uint32_t i : order)
    shuffled_radii.push_back(radii[i]);
  const std::vector<DepositedSphere> lying =
      deposit_spheres(shuffled_radii, {box_[0], box_[1], sides_}, seed_, progress);
  for (std::size_t i = 0; i < order.size(); ++i) {
    spheres_[order[i]].at = lying[i].at;
    box_[2] = std::max(box_[2], lying[i].at[2] + shuffled_radii[i]);
  }
  set_height(ground);
}

} // namespace mdm

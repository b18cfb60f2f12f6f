// Places of a mixed start.

#include "particles/placement.hpp"
#include "particles/shuffle.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace mdm {
namespace {

using Point = std::array<std::int64_t, 3>;

/// Tries of one particle. In a box of insertion_height() so many fail with a chance of 0.8^10000, below
/// 10^-900.
constexpr unsigned most_tries = 10000;

/// Centres of spheres of one radius, in cells so wide that one more sphere that is no larger meets those of
/// 27 at most.
class Cells {
public:
  Cells(std::int64_t radius, std::uint64_t quantity, const Point &box) : radius_(radius) {
    const double volume =
        static_cast<double>(box[0]) * static_cast<double>(box[1]) * static_cast<double>(box[2]);
    // No more cells than spheres, but for those at the sides.
    side_ =
        std::max(2 * radius, static_cast<std::int64_t>(std::cbrt(volume / static_cast<double>(quantity))));
    for (std::size_t axis = 0; axis < 3; ++axis)
      n_[axis] = box[axis] / side_ + 1;
    first_.assign(static_cast<std::size_t>(n_[0] * n_[1] * n_[2]), none);
    centres_.reserve(quantity);
    next_.reserve(quantity);
  }

  void add(const Point &centre) {
    std::uint32_t &first = first_[cell(centre[0] / side_, centre[1] / side_, centre[2] / side_)];
    next_.push_back(first);
    first = static_cast<std::uint32_t>(centres_.size());
    centres_.push_back(centre);
  }

  /// True if the distance of all centres to this one is not less than the sum of the radii.
  bool leave_free(const Point &centre, std::int64_t radius) const {
    const std::int64_t reach = radius_ + radius;
    Point low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::max<std::int64_t>(0, centre[axis] - reach) / side_;
      high[axis] = std::min(n_[axis] - 1, (centre[axis] + reach) / side_);
    }
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
          for (std::uint32_t c = first_[cell(i, j, k)]; c != none; c = next_[c])
            if (is_nearer(centres_[c], centre, reach))
              return false;
    return true;
  }

private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Coordinates are below 2^52: a sum of three squares is below 2^106.
  static bool is_nearer(const Point &a, const Point &b, std::int64_t reach) {
    __extension__ using Wide = __int128;
    Wide square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      square += static_cast<Wide>(a[axis] - b[axis]) * (a[axis] - b[axis]);
    return square < static_cast<Wide>(reach) * reach;
  }

  std::size_t cell(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return static_cast<std::size_t>((i * n_[1] + j) * n_[2] + k);
  }

  std::int64_t radius_, side_;
  Point n_{};
  std::vector<std::uint32_t> first_, next_; ///< of each cell and after each centre, in centres_
  std::vector<Point> centres_;
};

/// The part of where centres can be that grains keep free at most.
constexpr double most_part = 0.8;

/// As high as the worst class needs it beside those before it, which are larger.
/// \param kept_free  what so many grains of a size keep free of centres of another
/// \param room  what may be kept free of centres of a size, by the height
template <class KeptFree, class Room>
double height_with_room(const ParticleSet &set, KeptFree kept_free, Room room) {
  std::vector<std::pair<double, double>> placed; // largest size and quantity of the classes that are there
  double height = 0;
  for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c) {
    double d = 0;
    for (const ParticleSize &size : c->sizes)
      d = std::max(d, size.diameter.value);
    placed.emplace_back(d, c->quantity().convert_to<double>());
    double kept = 0;
    for (const auto &[other, quantity] : placed)
      kept += kept_free(quantity, other, d);
    height = std::max(height, d + kept / room(d));
  }
  return height;
}

} // namespace

double insertion_height(const ParticleSet &set, double x, double y) {
  assert(std::min(x, y) > set.largest().diameter.value);
  return height_with_room(
      set,
      [](double quantity, double size, double d) {
        return quantity * std::numbers::pi / 6 * std::pow(size + d, 3);
      },
      [x, y](double d) { return most_part * (x - d) * (y - d); });
}

double disc_insertion_height(const ParticleSet &set, double x) {
  assert(x > set.largest().diameter.value);
  return height_with_room(
      set,
      [](double quantity, double size, double d) {
        return quantity * std::numbers::pi / 4 * std::pow(size + d, 2);
      },
      [x](double d) { return most_part * (x - d); });
}

Footprint disc_plane(const ParticleSet &set) {
  const double width =
      std::max(std::sqrt(set.squares().convert_to<double>()), 3 * set.largest().diameter.value);
  return disc_plane(set, Rational(width), std::nullopt);
}

Footprint disc_plane(const ParticleSet &set, const Rational &width, const std::optional<Rational> &height) {
  Footprint plane{width, ratio(11, 10) * set.largest().diameter.decimal(), height};
  plane.is_flat = true;
  return plane;
}

double settled_side(const ParticleSet &set) {
  return std::max(std::cbrt(set.cubes().convert_to<double>()), 2 * set.largest().diameter.value);
}

Footprint roomy_box(const ParticleSet &set, const std::array<Rational, 3> &ratios) {
  std::array<double, 3> side{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    side[axis] = ratios[axis].convert_to<double>();
  const double least = set.largest().diameter.value * 1.01 / *std::min_element(side.begin(), side.end());
  double scale = least;
  constexpr double step = 1.02;
  while (insertion_height(set, scale * side[0], scale * side[1]) > scale * side[2])
    scale *= step;
  scale *= step; // radii are rounded up
  return {Rational(scale * side[0]), Rational(scale * side[1]), Rational(scale * side[2])};
}

void Placement::choose_mixed_box(const std::optional<Footprint> &floor) {
  const double scale = std::pow(10, places_);
  if (floor)
    sides_ = floor->sides;
  else
    box_[0] = box_[1] = units(Rational(settled_side(*set_)));
  is_flat_ = floor && floor->is_flat;
  if (floor && floor->c) {
    box_[2] = units(*floor->c);
    return;
  }
  // Radii are rounded up by less than a hundredth of the smallest size.
  constexpr double rounding = 1.03;
  // A circle has pi / 4 of the places of its square, and of those that are farther from its side.
  const double round = sides_ == Sides::cylinder ? 4 / std::numbers::pi : 1;
  const auto side = [&](std::size_t axis) { return static_cast<double>(box_[axis]) / scale; };
  const double height =
      is_flat_ ? disc_insertion_height(*set_, side(0)) : round * insertion_height(*set_, side(0), side(1));
  box_[2] = units(Rational(rounding * height));
}

/// True if it is r or more away from the side of a cylinder that touches the sides of the box. Decided in
/// units of half a length.
bool Placement::is_in_circle(const std::array<std::int64_t, 3> &centre, std::int64_t r) const {
  __extension__ using Wide = __int128;
  const Wide dx = 2 * centre[0] - box_[0], dy = 2 * centre[1] - box_[0], room = box_[0] - 2 * r;
  return dx * dx + dy * dy <= room * room;
}

void Placement::mix() {
  std::vector<Cells> placed;
  std::uint64_t tries = 0;
  for (std::size_t i = set_->classes.size(); i > 0; --i) {
    const ParticleClass &c = set_->classes[i - 1];
    const std::int64_t r = radius(c);
    placed.emplace_back(r, c.quantity().convert_to<std::uint64_t>(), box_);
    if (std::min({box_[0], box_[1], box_[2]}) < 2 * r)
      throw InputError("the largest particle does not fit into the box: leave the height of " +
                       option("box") + " out");
    const auto is_free = [&](const Point &centre) {
      return (sides_ != Sides::cylinder || is_in_circle(centre, r)) &&
             std::all_of(placed.begin(), placed.end(),
                         [&](const Cells &cells) { return cells.leave_free(centre, r); });
    };
    for (auto size = c.sizes.rbegin(); size != c.sizes.rend(); ++size)
      for (Integer n = 0; n < size->quantity; ++n) {
        Point centre{};
        unsigned failed = 0;
        do {
          if (failed++ == most_tries)
            throw InputError(
                fmt::format("class {} found no room at random places: leave the height of {} out, "
                            "make the box wider, or take {} layers",
                            c.number, option("box"), option("start")));
          for (std::size_t axis = 0; axis < 3; ++axis)
            centre[axis] = r + static_cast<std::int64_t>(mixed(mixed(seed_) ^ mixed(tries++)) %
                                                         static_cast<std::uint64_t>(box_[axis] - 2 * r + 1));
          if (is_flat_)
            centre[1] = box_[1] / 2;
        } while (!is_free(centre));
        placed.back().add(centre);
        spheres_.push_back({i - 1, &*size, centre});
      }
  }
}

} // namespace mdm

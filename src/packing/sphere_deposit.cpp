// A deposit of spheres. What comes in are radii on the lattice in their order, and the space; what goes out
// is a centre for each, and the three that carry it.
//
// Each sphere is dropped in a random column and rolls to rest (sphere_roll.cpp) with a gap of 4 units to
// all that it touches. Its place is rounded to the lattice and moved by units to where it is inside the
// sides, both decided in integers. If it overlaps with another there, exactly, it is raised by units until
// it does not; if that takes more than 63, or it has not come to rest, it has no place there. It is dropped
// until it has eight places, sixteen times at most, and takes the lowest, which keeps the top level: a heap
// of single random columns has slopes, which slide under gravity. Without a place it is raised as far as it
// takes, which ends above all others.
//
// Invariant: no two spheres overlap, and all are inside the space.

#include "packing/shuffled.hpp"
#include "packing/sphere_roll.hpp"
#include "packing/wide.hpp"

#include <mdm/text/error.hpp>

#include <cassert>

namespace mdm {
namespace {

using packing::SphereGrid;
using packing::SphereRest;
using packing::Vector3;
using packing::Wide;

/// What spheres are larger by while they roll, in units: rounding to the lattice takes less, mostly.
constexpr double roll_gap = 4;
/// A sphere that needs more than so many units, or has not come to rest, has no place.
constexpr double slight_rise = 63;
constexpr int most_drops = 16;
/// Of so many places the lowest is taken, which keeps the top level.
constexpr int compared_places = 8;

std::vector<double> as_doubles(const std::vector<std::int64_t> &radii) {
  return {radii.begin(), radii.end()};
}

std::int64_t whole_units(double units) {
  return static_cast<std::int64_t>(units);
}

/// x moved into the first period of that width.
double wrapped(double x, double width) {
  while (x < 0)
    x += width;
  while (x >= width)
    x -= width;
  return x;
}

class SphereDeposit {
public:
  SphereDeposit(const std::vector<std::int64_t> &radii, const SphereSpace &space, std::uint64_t seed)
      : space_(space), random_(seed), sides_(packing::side_planes(space)), grid_(as_doubles(radii), space) {}

  DepositedSphere lay(std::int32_t id) {
    const double r = grid_.radius(id), q = r + roll_gap;
    std::uint64_t stream = packing::column_stream;
    Vector3 at, tried;
    SphereRest rest, found;
    int places = 0;
    for (int drops = 0; drops < most_drops && places < compared_places; ++drops) {
      const auto [x, y] = column(id, q, stream);
      found = packing::SphereRoll(grid_, sides_, q).from(x, y);
      tried = on_lattice(found.at, r);
      const double rise = rise_to_free(tried, r);
      const bool is_place = rise <= slight_rise && found.is_found();
      tried.z += is_place ? rise : 0;
      if (is_place ? places == 0 || tried.z < at.z : places == 0) {
        at = tried;
        rest = found;
      }
      places += is_place ? 1 : 0;
    }
    // Nearly always nothing; else to where there is room above.
    at.z += rise_to_free(at, r);
    if (at.z + r >= static_cast<double>(most_sphere_units))
      throw InputError("the deposit becomes too high for its lattice: give it a wider box");
    grid_.add(id, at);
    return {{whole_units(at.x), whole_units(at.y), whole_units(at.z)}, rest.supports};
  }

private:
  /// A random place where the sphere is inside the sides. Random numbers are taken from one stream after the
  /// other.
  std::pair<double, double> column(std::int32_t id, double q, std::uint64_t &stream) const {
    const double from = space_.sides == Sides::periodic ? 0 : std::ceil(q);
    const auto place = [&](int axis, std::int64_t width) {
      const auto room = static_cast<std::uint64_t>(width - 2 * whole_units(from)) + 1;
      const auto bits =
          random_(stream, 2 * static_cast<std::uint64_t>(id) + static_cast<std::uint64_t>(axis));
      return from + static_cast<double>(random_below(room, bits));
    };
    for (;; ++stream) {
      const double x = place(0, space_.a), y = place(1, space_.b);
      // A place that is outside of the round wall: another one is taken.
      if (std::all_of(sides_.begin(), sides_.end(), [&](const packing::SidePlane &side) {
            return side.gap({x, y, 0}, q) >= 0;
          })) {
        ++stream;
        return {x, y};
      }
    }
  }

  /// The place on the lattice, inside the space.
  Vector3 on_lattice(const Vector3 &at, double r) const {
    return inside({std::round(at.x), std::round(at.y), std::max(std::round(at.z), r)}, r);
  }

  /// How far it is up to where the sphere overlaps with no other, less than twice as far.
  double rise_to_free(const Vector3 &at, double r) const {
    double rise = 0;
    for (double step = 1; overlaps({at.x, at.y, at.z + rise}, r); step *= 2)
      rise += step;
    return rise;
  }

  /// The place in the first period; or moved by units to where the sphere is inside the sides, exactly.
  Vector3 inside(Vector3 at, double r) const {
    const auto a = static_cast<double>(space_.a), b = static_cast<double>(space_.b);
    if (space_.sides == Sides::periodic)
      return {wrapped(at.x, a), wrapped(at.y, b), at.z};
    at.x = std::clamp(at.x, r, a - r);
    at.y = std::clamp(at.y, r, b - r);
    while (space_.sides == Sides::cylinder && is_out_of_cylinder(at, r)) {
      at.x += 2 * at.x < a ? 1 : -1;
      at.y += 2 * at.y < a ? 1 : -1;
    }
    return at;
  }

  /// Exactly; doubled coordinates keep half of an odd diameter whole.
  bool is_out_of_cylinder(const Vector3 &at, double r) const {
    const Wide x = 2 * whole_units(at.x) - space_.a, y = 2 * whole_units(at.y) - space_.a;
    const Wide room = space_.a - 2 * whole_units(r);
    return x * x + y * y > room * room;
  }

  /// Exactly.
  bool overlaps(const Vector3 &at, double r) const {
    constexpr double deep = 1e15; // no shell is hollow: it may lie in another
    bool any = false;
    grid_.each_near(at, r, 0, deep, [&](std::int32_t id, const Vector3 &other) {
      const Vector3 d = other - at;
      const Wide x = whole_units(d.x), y = whole_units(d.y), z = whole_units(d.z),
                 sum = whole_units(r + grid_.radius(id));
      any = any || x * x + y * y + z * z < sum * sum;
    });
    return any;
  }

  const SphereSpace &space_;
  Philox random_;
  std::vector<packing::SidePlane> sides_;
  SphereGrid grid_;
};

} // namespace

std::vector<DepositedSphere> deposit_spheres(const std::vector<std::int64_t> &radii, const SphereSpace &space,
                                             std::uint64_t seed,
                                             const std::function<void(std::size_t)> &progress) {
  assert(radii.size() <= most_deposited);
  assert(space.a < most_sphere_units && space.b < most_sphere_units);
  assert(space.sides != Sides::cylinder || space.a == space.b);
  std::vector<DepositedSphere> spheres;
  if (radii.empty())
    return spheres;
  spheres.reserve(radii.size());
  SphereDeposit deposit(radii, space, seed);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    spheres.push_back(deposit.lay(static_cast<std::int32_t>(i)));
    if (progress)
      progress(i + 1);
  }
  return spheres;
}

} // namespace mdm

#pragma once
/// \file
/// Deposits of spheres: each in turn is dropped and rolls to rest on those before it.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace mdm {

/// The sides of the space that spheres are deposited in.
enum class Sides {
  walls,    ///< four walls
  cylinder, ///< a round wall, upright
  periodic  ///< none: all is repeated by the widths
};

/// The ground of a deposit, in units of its lattice: [0, a] x [0, b], the floor at height 0.
struct SphereSpace {
  std::int64_t a, b; ///< of a cylinder both its diameter; its axis is at (a/2, a/2)
  Sides sides = Sides::walls;
};

/// What carries a sphere where that is no sphere.
enum SphereSupport : std::int32_t { sphere_on_floor = -1, sphere_on_side = -2, no_sphere_support = -3 };

/// A sphere in its place.
struct DepositedSphere {
  std::array<std::int64_t, 3> at; ///< the centre, in units
  /// Earlier spheres, by their numbers, or SphereSupports. On the floor alone, the others are
  /// no_sphere_support; so are all where it has not come to rest.
  std::array<std::int32_t, 3> supports;
};

/// The most spheres of a deposit; they take some 100 bytes each.
inline constexpr std::uint64_t most_deposited = 10000000;
/// A space is as many of the largest diameters wide, at least.
inline constexpr std::int64_t least_widths = 3;
/// Lengths of a deposit are below it, so that all that is computed from them is exact where it has to be.
inline constexpr std::int64_t most_sphere_units = std::int64_t{1} << 50;
/// Radii of a deposit are above it: gaps are some units.
inline constexpr std::int64_t least_radius_units = std::int64_t{1} << 16;

/// Drops spheres in random columns, in the order of the radii (Visscher, Bolsterli 1972). A sphere falls
/// until it meets another, rolls down on it, on two, and comes to rest on three with its centre above their
/// triangle, or on the floor; sides count as spheres. It touches its supports but for some units. Of eight
/// places that it finds so it takes the lowest, which keeps the top level.
///
/// No two spheres overlap and all are inside the space: decided for each in integers. A sphere that does not
/// pass, because places are rounded, is raised by units until it does. Where it would have to be raised by
/// more than 63, or has not come to rest after many turns, it has no place; without one in sixteen drops it
/// stays, or is raised. Places are computed in doubles by + - * / and square roots alone: they are the same
/// on every machine.
///
/// Cost: some 100 us a sphere, more where sizes are far apart.
/// \param radii in units, each from least_radius_units to a sixth of the narrower side
/// \param progress is told the number of spheres that lie
/// \throws InputError if the deposit becomes higher than most_sphere_units
/// \pre there are at most most_deposited; a and b are below most_sphere_units, and equal for a cylinder
std::vector<DepositedSphere> deposit_spheres(const std::vector<std::int64_t> &radii, const SphereSpace &space,
                                             std::uint64_t seed,
                                             const std::function<void(std::size_t)> &progress = {});

} // namespace mdm

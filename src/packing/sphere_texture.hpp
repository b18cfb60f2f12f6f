#pragma once
/// \file
/// What is known of spheres in their places: void ratio, contacts, heights of their groups.

#include "packing/sphere_sample.hpp"

#include <mdm/number/interval.hpp>

#include <optional>

namespace mdm {

/// The space that spheres fill, with z upwards.
struct SampleSpace {
  std::optional<SpaceBox> box; ///< open: the smallest around all spheres
  bool to_top = true;          ///< it ends at the top of the highest sphere, and not at the box's
  bool has_top = true;         ///< of the box; without one its upper bound says nothing
  bool is_cylinder = false;    ///< upright, and as wide as the box, which is as long as wide
  std::array<bool, 3> periodic{};
};

/// The way spheres are looked at.
struct SphereTextureOptions {
  SampleSpace space;
  Rational gap = 0;               ///< up to which two spheres touch
  std::optional<Rational> margin; ///< of the inner part; open: two largest diameters
};

/// Which of some spheres touch others: floating ones none, rattlers one at most. They may touch walls.
struct SphereCoordination {
  std::uint64_t spheres = 0;
  std::uint64_t ends = 0; ///< sum of the numbers of those that each touches
  std::uint64_t floating = 0, rattlers = 0;

  /// Contacts of a sphere on average. \pre there is one
  Rational mean() const { return ratio(ends, spheres); }
  /// The mechanical coordination number (2 C - N1) / (N - N0 - N1) of Thornton (2000), Geotechnique 50,
  /// 43-53: of spheres that touch several, N0 and N1 being those that touch none and one.
  std::optional<Rational> mean_without_rattlers() const;
};

/// Overlaps r + r' - d > 0 of pairs of spheres.
struct SphereOverlaps {
  std::uint64_t pairs = 0;
  Interval largest;          ///< 0 where there are none, as below
  Interval largest_relative; ///< to the smaller diameter of the pair
  Interval mean;
};

/// Where a group of spheres lies.
struct SphereGroup {
  std::uint64_t spheres = 0;
  std::optional<Interval> mean_height; ///< of the volume, above the floor
  std::vector<Interval> shares;        ///< of the volume of the spheres of each band, from below
};

/// What is known of the spheres. Lengths are in the unit of the sample. Volumes are sums over all spheres:
/// what two of them share counts twice.
struct SphereTexture {
  SpaceBox space;
  bool is_cylinder = false;
  std::array<bool, 3> periodic{};
  std::uint64_t outside = 0; ///< spheres with their centre outside the space
  Interval void_ratio;
  /// The part a margin away from walls, floor and top; nothing if it is narrower than the largest
  /// sphere. Of a cylinder, inside the square that fits into the circle.
  std::optional<SpaceBox> inner;
  std::optional<Interval> inner_void_ratio; ///< of what of the spheres is inside; nothing if that is nothing
  Rational gap;
  std::uint64_t contacts = 0;                          ///< pairs of spheres with d <= r + r' + gap
  SphereCoordination coordination, inner_coordination; ///< of all; of those with centres in the inner part
  SphereOverlaps overlaps;
  std::vector<Rational> band_heights; ///< bounds of the ten bands, above the floor
  std::vector<SphereGroup> groups;    ///< by the heights of their centres
  /// The intensity of segregation of Danckwerts (1952), Appl. Sci. Res. A 3, 279-296, by height: the variance
  /// s^2 of a group's share of the volume among bands, weighted by their volumes, over p (1 - p), p being its
  /// share of all; of several groups sum s^2 / sum p (1 - p). 0: all bands are alike; 1: no band has two
  /// groups. Nothing where there are fewer than two.
  std::optional<Interval> segregation;
};

/// Decisions (what touches, overlaps, is inside) are exact; other numbers are enclosed. Doubles decide where
/// their proved error allows it, and fractions elsewhere.
/// Cost: some us a sphere; where many pairs touch to the last digit, some 10 us a pair.
/// \param groups  their number
/// \throws InputError if all spheres are below the floor of a box that ends at their top, a period is shorter than two of the largest diameters, or there are too many spheres
/// \pre there is a sphere
SphereTexture sphere_texture(const SphereSample &sample, std::size_t groups,
                             const SphereTextureOptions &options = {});

} // namespace mdm

#pragma once
/// \file
/// The pairs of spheres that are near each other.

#include "packing/sphere_texture.hpp"

#include <functional>

namespace mdm::packing {

/// A sphere, or the image of one: moved by whole periods.
struct SphereImage {
  std::uint32_t sphere = 0;
  std::array<std::int64_t, 3> periods{};
  std::array<double, 3> centre{};
};

class GridLattice;

/// Spheres in a space that may be periodic.
class NearSpheres {
public:
  NearSpheres(const SphereSample &sample, const SpaceBox &space, const std::array<bool, 3> &periodic,
              const Rational &gap);

  /// The sphere moved into the space along periodic axes.
  const SphereImage &moved(std::size_t i) const { return images_[i]; }
  /// r + r' - d of a pair in doubles, within error() of it.
  double overlap(const SphereImage &a, const SphereImage &b) const;
  double error() const { return error_; }
  /// The sign of r + r' + gap - d, exactly.
  int sign_of_reach(const SphereImage &a, const SphereImage &b, const Rational &gap) const;
  /// The exact coordinate.
  Rational exact(const SphereImage &a, std::size_t axis) const;

  /// Calls take(a, b, overlap in doubles) for each sphere a and all others, or their images, that it touches
  /// within the gap, and some more: each pair once from either side. \throws InputError if there are too
  /// many
  void each(const std::function<void(const SphereImage &, const SphereImage &, double)> &take) const;

private:
  void add_images();
  /// Images so that those near in memory are near in space: several times faster for many.
  std::vector<std::uint32_t> order_in_space(const GridLattice &lattice) const;

  const SphereSample &sample_;
  SpaceBox space_;
  std::array<bool, 3> periodic_;
  std::array<Rational, 3> periods_;
  double gap_, largest_radius_, error_ = 0;
  std::vector<SphereImage> images_; ///< all spheres, and behind them images in reach of their space
};

} // namespace mdm::packing

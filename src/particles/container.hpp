#pragma once
/// \file
/// The space that the centres of particles are to lie in.

#include "packing/sphere_texture.hpp"

namespace mdm {

/// A box or a cylinder whose sides count as inside; nothing is outside of a periodic axis.
class Container {
public:
  /// \pre space.box
  explicit Container(const SampleSpace &space);

  /// Decided exactly. \param unit  length of the unit of the place, in that of the space
  /// \throws InputError if a coordinate is no decimal
  bool holds(const SphereSample::Place &place, const Rational &unit) const;

private:
  bool holds(const std::array<Rational, 3> &centre) const;
  /// True if doubles tell that a place is inside.
  bool is_well_inside(const SphereSample::Place &place, const Rational &unit) const;

  SampleSpace space_;
  std::array<double, 3> low_{}, high_{};
};

} // namespace mdm

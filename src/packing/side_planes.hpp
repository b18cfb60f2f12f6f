#pragma once
/// \file
/// The sides of a space as planes.

#include "packing/sphere_deposit.hpp"
#include "packing/vector3.hpp"

namespace mdm::packing {

/// An upright side: bodies are where x . normal >= offset, farther by their radius.
struct SidePlane {
  Vector3 normal; ///< inwards, of length 1
  double offset;

  /// The distance of p from the plane, less q.
  double gap(const Vector3 &p, double q) const { return dot(p, normal) - offset - q; }
};

/// Four sides; none where the space is periodic. A cylinder has many that touch it from within between its
/// edges, which are in it: what is inside of them is in the cylinder.
std::vector<SidePlane> side_planes(const SphereSpace &space);

} // namespace mdm::packing

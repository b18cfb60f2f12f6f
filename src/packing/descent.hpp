#pragma once
/// \file
/// Which way a body moves down that touches others.

#include "packing/vector3.hpp"

#include <cstddef>
#include <vector>

namespace mdm::packing {

/// The steepest way down that leads into no contact.
struct Descent {
  bool rests = false;               ///< there is none
  Vector3 way;                      ///< of length 1, where there is one
  std::vector<std::size_t> carried; ///< the contacts that carry the body: along the way, two at most
};

/// The direction nearest to straight down among those d with d . n >= 0 for the normals n of all contacts.
/// What carries is found among all sets of up to three: with few contacts that is quickest.
/// \param normals of length 1, from the others to the body
/// \param slight cosines up to this one are rounding
Descent descent(const std::vector<Vector3> &normals, double slight);

} // namespace mdm::packing

#pragma once
/// \file
/// The lowest place on the surface of a deposit.

#include "packing/front.hpp"
#include "packing/packing.hpp"

#include <limits>

namespace mdm::packing {

/// Where a disc can lie, and on what.
struct Rest {
  double x = 0, y = std::numeric_limits<double>::infinity();
  Id left = the_floor, right = the_floor;

  bool is_found() const { return y < std::numeric_limits<double>::infinity(); }
  /// Lower; of two as high, further to the left.
  bool is_before(const Rest &other) const { return y != other.y ? y < other.y : x < other.x; }
};

/// The place of the first disc on an empty floor without walls. \param q its radius with its gap
Rest first_rest(const Front &front, FloorRule floor, double q);

/// The lowest place of a disc in a part of the surface: the centres of discs that can be reached from above,
/// at a distance of q from everything, are bounded by arcs around discs of the front, the floor and the
/// walls; the least height over them is at a vertex or on the floor. The walk goes along the boundary from
/// left to right.
/// \param q the disc's radius with its gap
/// \param from the left wall, or a disc on whose top a disc can lie
/// \param to the right wall, or such a disc; the same one for a whole period
Rest lowest_rest(const Front &front, FloorRule floor, double q, Id from, Id to);

/// The place touching two discs, or a disc and a wall, `left` and `right`.
Rest rest_on_discs(const Front &front, double q, Id left, Id right, double dx);
Rest rest_at_left_wall(const Front &front, double q, Id disc);
Rest rest_at_right_wall(const Front &front, double q, Id disc);

} // namespace mdm::packing

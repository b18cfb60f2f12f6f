#pragma once
/// \file
/// The integer lattice of a deposit.

#include "packing/disc_sizes.hpp"

#include <mdm/number/rational.hpp>

#include <optional>

namespace mdm::packing {

/// The units of a deposit, and the box in them.
struct Lattice {
  unsigned places; ///< units are 10^-places
  std::int64_t width;
  double highest; ///< no deposit is higher
};

/// The square root of 15/4 sum r^2, rounded up: a deposit of packing fraction 0.84 is as high.
Rational square_width(const DiscSizes &sizes);

/// The finest lattice on which box and deposit have lengths below 2^52 units.
/// \param width open: square_width()
/// \throws InputError if the box is narrower than three of the largest discs, or the smallest has fewer than
/// 2^24 units
Lattice lattice(const DiscSizes &sizes, const std::optional<Rational> &width);

} // namespace mdm::packing

#pragma once
/// \file
/// The parts of a sphere that planes at right angles cut off.

#include <mdm/number/interval.hpp>

#include <array>

namespace mdm::packing {

/// Encloses the share of the volume of a sphere of radius 1 around the origin that has x < depth[0],
/// y < depth[1] and z < depth[2], each -1 < depth <= 1. Cost: some us where one depth is below 1, some 100 us
/// a plane otherwise.
Interval kept_share(const std::array<Rational, 3> &depth);

} // namespace mdm::packing

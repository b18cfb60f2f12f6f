#pragma once
/// \file
/// Boxes of blends: bounds of the steps of each stockpile.

#include <mdm/blend/blend_problem.hpp>

#include <cstdint>
#include <vector>

namespace mdm {

/// Bounds of the steps of each stockpile, closed, and the number of its node in the tree of a search.
struct BlendBox {
  std::vector<std::uint64_t> least, most;
  std::size_t number = 0;
};

/// What the limits of the shares leave; a stockpile whose share is no whole number of steps has its least
/// above its most.
BlendBox whole_box(const BlendProblem &problem);

/// Takes out of a box what has too many stockpiles: where as many as may have a share must have one, the
/// others have none. False if nothing is left of it.
bool restrict_box(const BlendProblem &problem, BlendBox &box);

} // namespace mdm

#pragma once
/// \file
/// A disc that is dropped and rolls to rest.

#include "packing/surface_walk.hpp"

namespace mdm::packing {

/// Where a disc comes to rest that falls down at x, rolls over what it meets, falls again where it leaves a
/// disc sideways, and stops on two supports or on the floor (Visscher, Bolsterli 1972).
/// \param q its radius with its gap
Rest rolled_rest(const Front &front, double q, double x);

} // namespace mdm::packing

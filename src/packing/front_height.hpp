#pragma once
/// \file
/// The front of a deposit that lies already.

#include "packing/packing.hpp"

#include <optional>

namespace mdm::packing {

/// The height of the lowest centre among the discs that nothing covers, as Packing::front has it: the discs
/// are laid again in their order, each on its supports. Nothing where a support is covered when it is needed,
/// or the supports are not in the order of the surface. Cost: some steps a disc.
/// \pre there is a disc
std::optional<std::int64_t> front_height(const Packing &packing);

} // namespace mdm::packing

#pragma once
/// \file
/// Products of two places.

namespace mdm::packing {

/// Holds the product of two coordinates or radii, and sums of some of them, exactly.
__extension__ typedef __int128 Wide;

} // namespace mdm::packing

#pragma once
/// \file
/// The discs of a representative set.

#include "packing/disc_sizes.hpp"
#include "sets/set_quality.hpp"

namespace mdm {

/// The particles of all classes. \throws InputError if there are more than most_discs
DiscSizes set_discs(const ParticlesOf &particles, std::size_t classes, const std::string &unit);

} // namespace mdm

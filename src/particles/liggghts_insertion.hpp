#pragma once
// What LIGGGHTS' models and files for inclusion have in common.

#include "text_buffer.hpp"

#include <cstdint>

namespace mdm {

/// Commands that insert the set into the region `mdm_region`, size by size, largest first, and stop with a
/// message where a count is not reached. Afterwards `mdm_count` is the number of particles.
/// \param seed each has other seeds
/// \throws InputError if there are more particles than LIGGGHTS counts
void add_liggghts_insertion(const ParticleSet &set, std::uint64_t seed, TextBuffer &text);

} // namespace mdm

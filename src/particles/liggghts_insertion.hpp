#pragma once
// Lines that LIGGGHTS' models and files for inclusion share.

#include "particles/particle_writer.hpp"
#include "text/long_text.hpp"

#include <cstdint>

namespace mdm {

/// Commands that insert the set into the region `mdm_region`, size by size, largest first, and stop with a
/// message where a count is not reached. Afterwards `mdm_count` is the number of particles.
/// \param seed each has other seeds
/// \throws InputError if there are more particles than LIGGGHTS counts
void add_liggghts_insertion(const ParticleSet &set, std::uint64_t seed, LongText &text);

} // namespace mdm

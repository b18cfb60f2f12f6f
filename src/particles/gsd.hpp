#pragma once
/// \file
/// GSD, the binary format of HOOMD-blue: its file layer 2.0, schema hoomd 1.4.

#include "particles/particle_reader.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// True if a file that begins with these bytes is one.
bool is_gsd(std::string_view beginning);

/// Hands on the particles of the last frame, or of the one whose step is options.timestep. Diameters are
/// floats, taken as the fractions that they are.
/// \throws InputError naming the file if it is none, or damaged
ReadParticles read_gsd(std::string_view bytes, const std::string &file, ParticleSink &sink,
                       const ParticleOptions &options);

} // namespace mdm

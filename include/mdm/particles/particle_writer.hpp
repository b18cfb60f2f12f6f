#pragma once
/// \file
/// Particle files, written.

#include <mdm/particles/particle_set.hpp>

#include <functional>
#include <string_view>

namespace mdm {

/// Takes a file piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// Lines that begin with `# `: name of the gradation, N, unit, density, and how exact the masses are.
std::string comment_lines(const ParticleSet &set);

/// `size_<unit>,quantity` below comments: a diameter and its quantity a row, ascending.
void write_size_csv(const ParticleSet &set, const TextSink &out);

/// One diameter a line below comments, descending.
void write_diameters(const ParticleSet &set, const TextSink &out);

} // namespace mdm

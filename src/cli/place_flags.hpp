#pragma once
/// \file
/// The options of mdm verify about the places of particles.

#include "cli/solve_flags.hpp"

#include <mdm/packing/sphere_texture.hpp>
#include <mdm/particles/particle_reader.hpp>

namespace mdm::cli {

/// Whether places are looked at, and how.
struct PlaceFlags {
  bool packing = false;
  GradationFlags::Text box, specimen, periodic, gap, margin;

  void add_to(CLI::App &command);
  /// \throws InputError naming an option that is about places without --packing
  void check() const;
  /// \param of_file  the box that the file has
  /// \throws InputError naming the option where its value does not serve
  /// \param unit  of the gradation
  SphereTextureOptions options(const std::optional<ParticleBox> &of_file, SizeUnit unit) const;
};

} // namespace mdm::cli

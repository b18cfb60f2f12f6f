#pragma once
/// \file
/// What is asked about the places of particles.

#include "ask/option_row.hpp"
#include "packing/sphere_texture.hpp"
#include "particles/particle_reader.hpp"

#include <vector>

namespace mdm {

/// Whether places are looked at, and how.
struct PlaceTexts {
  bool packing = false;
  OptionText box, specimen, periodic, contact_gap, margin;

  static const std::vector<OptionRow<PlaceTexts>> options;

  /// True if places are to be looked at: each of the options asks for it.
  bool are_asked() const { return packing || box || specimen || periodic || contact_gap || margin; }
  /// \throws InputError naming options that contradict each other
  void check() const;
  /// The space of the particles. \param of_file  the box that the file has, \param unit  of the gradation
  /// \throws InputError naming the option where its value does not serve
  SampleSpace space(const std::optional<ParticleBox> &of_file, SizeUnit unit) const;
  /// The same with all that is asked of it. \throws InputError likewise
  SphereTextureOptions texture(const std::optional<ParticleBox> &of_file, SizeUnit unit) const;
};

} // namespace mdm

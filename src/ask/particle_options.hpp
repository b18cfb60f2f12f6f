#pragma once
/// \file
/// The options that say how a file of particles is to be read, as texts.

#include "ask/option_row.hpp"
#include "particles/particle_reader.hpp"

#include <vector>

namespace mdm {

struct ParticleTexts {
  OptionText from, size_column, size_unit, timestep;
  bool radius = false, diameter = false;

  static const std::vector<OptionRow<ParticleTexts>> options;

  bool say_sizes() const { return radius || diameter || size_column || size_unit; }
  /// \param target  the unit that sizes are wanted in
  /// \throws InputError naming the option where its value does not serve
  ParticleOptions reading(SizeUnit target) const;
};

/// How a file of particles is read as a gradation, of which only its unit is asked.
/// \throws InputError where that is no unit
ParticleOptions read_as_gradation(const OptionText &unit);

} // namespace mdm

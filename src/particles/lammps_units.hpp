#pragma once
/// \file
/// The styles of units of LAMMPS and LIGGGHTS.

#include "particles/line_reader.hpp"

namespace mdm {

/// Takes lengths in the unit of a style that a file states: si, cgs, micro or nano.
/// \throws InputError if it is another, whose lengths are no grains', or contradicts what the user said
void take_units(std::string_view style, ParticleSource &source);

} // namespace mdm

#pragma once
/// \file
/// Packings written for engines by mdm export.

#include "packing/packing.hpp"
#include "particles/particle_format.hpp"
#include "text/sink.hpp"

#include <string>

namespace mdm {

/// Writes the packing in a format: lammps, liggghts, yade, lmgc90, vtk or csv.
/// \throws InputError naming the option
void export_packing(const Packing &packing, const std::string &format, SizeUnit unit, const Rational &density,
                    const Sink &sink);

} // namespace mdm

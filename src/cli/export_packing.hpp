#pragma once
/// \file
/// Packings written for engines by mdm export.

#include "particles/particle_format.hpp"

#include <string>

namespace mdm::cli {

/// Writes the packing in a format: lammps, liggghts, yade, lmgc90, vtk or csv.
/// \throws InputError naming the option or the file
void export_packing(const std::string &packing, const std::string &format, LengthUnit unit,
                    const Rational &density, const std::string &out);

} // namespace mdm::cli

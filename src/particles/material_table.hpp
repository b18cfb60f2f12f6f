#pragma once
/// \file
/// The materials of classes, from a file.

#include "particles/settle_model.hpp"

#include <string_view>

namespace mdm {

/// Reads a CSV file with a row for each class of the set. Columns: `class`, its number in the gradation, or
/// `lower_mm`, its lower sieve; and some of `young_modulus` (Pa), `poisson`, `friction`, `restitution`,
/// `rolling_friction`. What has no column is that of `others`. Lines that begin with # are skipped.
/// \param source name of the file, for messages
/// \return the materials in the order of the classes
/// \throws InputError with the line if a value is none of such a material, or a class is missing, unknown or there
/// twice
std::vector<GrainMaterial> read_materials(std::string_view content, const std::string &source,
                                          const ParticleSet &set, const GrainMaterial &others);

} // namespace mdm

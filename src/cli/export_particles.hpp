#pragma once
/// \file
/// The particles that mdm export writes, from whatever FILE is.

#include "ask/export_options.hpp"
#include "cli/output_flags.hpp"

namespace mdm::cli {

/// Solves the gradation, or reads the answer or the particles.
ExportedParticles exported_particles(const ExportTexts &c, const OutputFlags &output,
                                     const ParticleSetOptions &options);

} // namespace mdm::cli

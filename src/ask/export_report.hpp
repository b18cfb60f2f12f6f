#pragma once
/// \file
/// What mdm export says about the file, the model and the simulation.

#include "ask/export_space.hpp"

namespace mdm {

/// Warnings about what a user may not have meant. \param start none yet: null
void check_wanted(const ExportTexts &c, const ExportFormat &format, const ParticleSet &set,
                  const Placement *start);

/// The cost of a step, and the start of the particles.
std::string cost_guide(const ExportFormat &format, const ParticleSet &set, const Placement *start,
                       const Elasticity &e);

/// Steps and time of the model, and what makes it cheaper.
std::string model_guide(const ExportFormat &format, const SettleModel &model);

/// The command that judges the file; empty where there is none to judge, or no exact counts in it.
std::string how_to_verify(const ExportTexts &c, const ExportFormat &format, const ExportedParticles &found,
                          const Placement *start);

} // namespace mdm

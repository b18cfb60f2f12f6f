#pragma once
/// \file
/// The particles that mdm export writes, from whatever FILE is.

#include "cli/exit_code.hpp"
#include "cli/export_command.hpp"

namespace mdm::cli {

/// The particles to export, and the exit code.
struct ExportedParticles {
  std::optional<ParticleSet> set; ///< nothing: there is no match
  int exit_code = Exit::done;
  SizeUnit unit = SizeUnit::mm; ///< of lengths in options
  std::string question;         ///< of an answer, in words
  bool has_gradation = true;    ///< FILE is one, by which the particles can be judged
};

ParticleSetOptions set_options(const ExportCommand &c, bool has_floats);

/// Solves the gradation, or reads the answer or the particles.
ExportedParticles exported_particles(const ExportCommand &c, const ParticleSetOptions &options);

/// The options with which mdm verify takes the gradation as it was asked for; nothing where there is a band
/// alone.
std::optional<std::string> verify_options(const ExportCommand &c);

} // namespace mdm::cli

#pragma once
/// \file
/// The space that exported particles start in, and where they start.

#include "cli/export_particles.hpp"
#include "particles/settle_model.hpp"

namespace mdm::cli {

/// The specimen that was asked for; nothing where there is none, or a --box takes its place.
/// \param unit  of its lengths, and of those that are written without one
std::optional<Solids> specimen(const ExportCommand &c, SizeUnit unit);

/// The space of a model.
Space space(const ExportCommand &c);

Start start_of(const ExportCommand &c, const ExportedParticles &found);

/// The ground of the start: --box, or else the specimen.
std::optional<Footprint> footprint(const ExportCommand &c, const ExportedParticles &found);

/// The start of the particles; that of a deposit takes its time.
Placement placed(const ExportCommand &c, const ExportedParticles &found);

/// Says where the box of the file is smaller than it was asked for: its lengths are whole units of the
/// start's places. The square in a cylinder is rounded by itself.
void tell_rounding(const ExportCommand &c, const ExportedParticles &found, const Placement &start);

} // namespace mdm::cli

#pragma once
/// \file
/// The space that exported particles start in, and where they start.

#include "ask/export_options.hpp"
#include "particles/settle_model.hpp"

#include <functional>
#include <string>
#include <vector>

namespace mdm {

/// The specimen that was asked for; nothing where there is none, or a --box takes its place.
/// \param unit  of its lengths, and of those that are written without one
std::optional<Solids> asked_specimen(const ExportTexts &c, SizeUnit unit);

/// The space of a model.
Space asked_space(const ExportTexts &c);

Start start_of(const ExportTexts &c, const ExportedParticles &found);

/// The ground of the start: --box, or else the specimen.
std::optional<Footprint> footprint(const ExportTexts &c, const ExportedParticles &found);

/// The start of the particles; that of a deposit takes its time. \param lying  hears how many lie by now
Placement placed(const ExportTexts &c, const ExportedParticles &found,
                 const std::function<void(std::size_t)> &lying);

/// Where the box of the file is smaller than it was asked for: its lengths are whole units of the start's
/// places. The square in a cylinder is rounded by itself.
std::vector<std::string> rounding_notes(const ExportTexts &c, const ExportedParticles &found,
                                        const Placement &start);

} // namespace mdm

#pragma once
/// \file
/// What places say of a sample that nobody asked about.

#include "packing/sphere_texture.hpp"
#include "particles/placed_sink.hpp"

#include <string>
#include <vector>

namespace mdm {

/// Places are judged unasked where there are no more.
inline constexpr std::size_t most_unasked_places = 20000;

/// What the places say; nothing, with a note, where there are too many or they cannot be judged, and nothing
/// where some particles have none.
/// \param placed keeps most_unasked_places
/// \param asking how more of them are judged, for the note
std::optional<SphereTexture> unasked_texture(const PlacedSink &placed, std::size_t classes,
                                             const SphereTextureOptions &options, const char *asking,
                                             std::vector<std::string> &notes);

} // namespace mdm

#pragma once
/// \file
/// What is known of the places of a sample, as text and JSON.

#include "packing/sphere_texture.hpp"
#include "text/json_writer.hpp"

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// For people, its lines indented. \param g  has a class for each group
std::string sphere_texture_text(const SphereTexture &t, const Gradation &g);

/// An object: the value of `packing` in mdm-verify-1.
void write_sphere_texture(JsonWriter &json, const SphereTexture &t, const Gradation &g);

} // namespace mdm

#pragma once
/// \file
/// The space that the spheres of a sample fill, and the part of it away from its sides.

#include "packing/sphere_texture.hpp"

namespace mdm::packing {

/// The box that was asked for, up to the top of the spheres where it ends there; else the one around them.
/// \throws InputError if they are all below its floor
SpaceBox space_of(const SphereSample &sample, const SampleSpace &asked);

Rational largest_diameter(const SphereSample &sample);

/// t.space so far off what is not periodic; nothing if it is narrower than the largest sphere, which two
/// opposite sides might cut. Of a cylinder, the square inside.
std::optional<SpaceBox> inner_part(const SphereTexture &t, const Rational &off, const Rational &largest);

} // namespace mdm::packing

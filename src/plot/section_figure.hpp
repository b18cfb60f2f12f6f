#pragma once
/// \file
/// A section through spheres in their places.

#include "packing/sphere_sample.hpp"
#include "plot/figure.hpp"

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// The circles in which the upright plane y = constant through the middle of the spheres cuts them, coloured
/// by their class, both axes at the same scale. \param g  whose classes are the groups of the sample
/// \param slope  height of the panel over its width
/// \pre there is a sphere
Panel section_panel(const SphereSample &sample, const Gradation &g, double slope);

} // namespace mdm

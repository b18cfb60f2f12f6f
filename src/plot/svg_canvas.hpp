#pragma once
/// \file
/// Pictures as SVG 1.1.

#include "plot/canvas.hpp"

#include <memory>

namespace mdm {

/// A white page of width x height pt. The same drawing gives the same bytes. Letters are those of the
/// viewer's sans-serif font.
std::unique_ptr<Canvas> svg_canvas(double width, double height);

} // namespace mdm

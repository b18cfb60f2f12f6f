#pragma once
/// \file
/// Pictures as SVG 1.1.

#include "plot/canvas.hpp"

#include <memory>

namespace mdm {

/// A white page of width x height pt. The same drawing gives the same bytes. Letters are those of the
/// viewer's sans-serif font. Title and description, as far as there are any, are for programs that read it
/// out.
std::unique_ptr<Canvas> svg_canvas(double width, double height, std::string_view title,
                                   std::string_view description);

} // namespace mdm

#pragma once
/// \file
/// Pictures as PNG and PDF, by the library cairo.

#include "plot/canvas.hpp"

#include <memory>

namespace mdm {

/// A white page of width x height pt; PNG has two pixels a pt. No date is in the file: the same drawing gives
/// the same bytes where the fonts are the same. Where the program was built without cairo they throw.
/// \throws InputError if cairo is not there, or cannot draw so large a page
std::unique_ptr<Canvas> png_canvas(double width, double height);
std::unique_ptr<Canvas> pdf_canvas(double width, double height);

} // namespace mdm

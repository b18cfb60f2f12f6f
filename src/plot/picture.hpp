#pragma once
/// \file
/// A figure as the bytes of a picture.

#include "plot/figure.hpp"

namespace mdm {

/// The formats of pictures. PNG and PDF are drawn by cairo, where the program was built with it.
enum class Picture { svg, png, pdf };

/// The picture of the figure. Texts of a figure are data: they appear as drawable() has them. The same figure
/// gives the same bytes, PNG and PDF as far as the fonts are the same. Cost: some milliseconds, and memory of
/// the order of its points.
/// \throws InputError if the format cannot be drawn here
std::string picture_of(const Figure &figure, Picture picture);

} // namespace mdm

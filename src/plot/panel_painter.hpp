#pragma once
/// \file
/// One diagram of a figure, drawn into its frame.

#include "plot/canvas.hpp"

namespace mdm {

/// Draws the panel: what is behind, the grid, the series, the frame with its ticks, strips and texts.
/// \param frame  of the panel, without its labels
/// \param room  width for its title
/// \param colors  scale of Point::value, or null
void paint_panel(Canvas &canvas, const Panel &panel, const Frame &frame, double room, const Axis *colors);

/// Draws the sample of a series in the legend, in the middle of [left, right] at the height y.
void paint_legend_sample(Canvas &canvas, const Series &series, double left, double right, double y);

} // namespace mdm

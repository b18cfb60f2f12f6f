#pragma once
/// \file
/// Packings of discs as figures.

#include "packing/packing.hpp"
#include "plot/figure.hpp"

#include <limits>

namespace mdm {

/// The meaning of the colours.
enum class PackingColour {
  size,     ///< of the discs
  contacts, ///< of the discs with others
  cells     ///< corners of the cells of the contact graph
};

/// Discs at scale in their box, whose frame is the panel's: images of those that stick out on one side come
/// in on the other, and all are cut there. Of an Apollonian packing all of the outer circle is shown.
struct PackingView {
  PackingColour colour = PackingColour::size;
  bool counts = true;                                         ///< titles of the legend say how many there are
  double most_high = std::numeric_limits<double>::infinity(); ///< in widths of the box: what is above is cut
  double least_high = 0; ///< in widths of the box: above what is lower is room
};

/// The panel of a packing. \pre there is a disc
Panel packing_panel(const Packing &packing, const PackingView &view);

/// The figure of one packing, both axes at the same scale, with what is known of how it was made.
/// \pre there is a disc
Figure packing_figure(const Packing &packing, PackingColour colour);

} // namespace mdm

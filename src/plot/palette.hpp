#pragma once
/// \file
/// The colours of values.

#include <cstddef>
#include <string>

namespace mdm {

/// The colour of a share of the way from the least value (0) to the greatest (1), as #rrggbb: from dark blue
/// over green to yellow, even in lightness. What is outside of [0, 1] has the colour of the nearer end.
std::string palette_color(double share);

/// The number of colours that tell things apart.
inline constexpr std::size_t series_colors = 8;
/// The colour of the i-th of several things, counted from 0; after the last the first comes again.
const char *series_color(std::size_t i);

} // namespace mdm

#pragma once
/// \file
/// The colours of values.

#include <string>

namespace mdm {

/// The colour of a share of the way from the least value (0) to the greatest (1), as #rrggbb: from dark blue
/// over green to yellow, even in lightness. What is outside of [0, 1] has the colour of the nearer end.
std::string palette_color(double share);

} // namespace mdm

#pragma once
/// \file
/// Colours of grains by their size.

#include <array>

namespace mdm {

/// From light to dark, so that they keep their order in print without colours.
inline constexpr std::array<const char *, 8> size_colors = {"#ffe699", "#fecf5c", "#fdb147", "#f98e2b",
                                                            "#e76f12", "#c44f04", "#933304", "#5a1c02"};
/// Of the lines around grains.
inline constexpr const char *edge_color = "#404040";

} // namespace mdm

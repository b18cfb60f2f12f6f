#pragma once
/// \file
/// Tables whose sieves stand in a row.

#include "gradation/cells.hpp"

#include <optional>

namespace mdm {

/// The table with its rows as columns, from the row on that begins with a header of sizes, where one of
/// values begins another; nothing where there are no such rows. All of them have the line of that of the
/// sizes. What stands above and below, of fewer than three cells a row, stays as it is.
std::optional<Cells> upright(const Cells &cells, const Source &source);

} // namespace mdm

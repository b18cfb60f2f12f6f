#pragma once
/// \file
/// Files of the CAMSIZER, an imaging instrument (.xle).

#include "gradation/cells.hpp"
#include "gradation/table.hpp"

#include <optional>

namespace mdm {

/// The row of the header `... [mm]`, `p3 [%]`, `Q3 [%]` of a table with tabs; nothing if there is none.
std::optional<std::size_t> camsizer_header(const Cells &cells);

/// The rows below the header have the lower and the upper size of a class, p3, its share, and Q3, what is
/// finer than the upper size. p3 is taken, and Q3 must be its sum within the digits of both. Words are
/// localised: a row without numbers ends the table.
/// \throws InputError with the line
Table read_camsizer(const Cells &cells, std::size_t header, const Source &source, const std::string &id);

} // namespace mdm

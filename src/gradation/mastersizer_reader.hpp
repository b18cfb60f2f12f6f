#pragma once
/// \file
/// Exports of the Mastersizer, a laser diffraction instrument, as CSV or workbook.

#include "gradation/cells.hpp"
#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// True where the first row names results between or under sizes.
bool is_mastersizer(const Cells &cells);

/// Row 1 has headers, row 2 the sizes of the channels, each further row a sample. Under `Result Between` a
/// value is the share in percent between its size and the next, under `Result Under` what is finer.
/// \throws InputError with the line
Table read_mastersizer(const Cells &cells, const Source &source, const std::string &id,
                       const Reading &reading);

} // namespace mdm

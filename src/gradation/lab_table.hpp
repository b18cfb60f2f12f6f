#pragma once
/// \file
/// The gradation in a table as laboratories have it.

#include "gradation/cells.hpp"
#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// The columns of a table and the rows below their header, until the end or an empty row below which no size
/// stands. Rows of a pan, of a total, of a second header with the same kind of values, and texts without a
/// number may be among them. What was read and what was left is in the notes.
/// \throws InputError with the line, with what the table begins with and the options where its columns are not certain
Table read_lab_table(const Cells &cells, const Source &source, const std::string &id, const Reading &reading);

/// Refuses a table whose columns are not known.
[[noreturn]] void refuse_table(const Cells &cells, const Reading &reading, const Source &source);

} // namespace mdm

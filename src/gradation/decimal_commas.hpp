#pragma once
/// \file
/// Tables with commas between their cells, in which numbers may have decimal commas too: each is cut in two.

#include "gradation/table_columns.hpp"
#include "text/source.hpp"

#include <vector>

namespace mdm {

/// Refuses a row in which a number is cut, such as `0,063,30`. \throws InputError with the line
void check_commas(const CellRow &row, const TableColumns &columns, const Source &source);

/// Refuses a last column that is not read and may have the decimals of the masses: `4,12,3` below `Sieb
/// (mm),Rückstand (g),Bemerkung`.
/// \param sieves  the rows of the table's sizes \throws InputError with the line
void check_last_column(const std::vector<const CellRow *> &sieves, const TableColumns &columns,
                       const Source &source);

} // namespace mdm

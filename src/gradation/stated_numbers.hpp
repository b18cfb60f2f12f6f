#pragma once
/// \file
/// What a sheet states around its table, and the numbers of these statements.

#include "gradation/table_sign.hpp"
#include "text/short_list.hpp"
#include "text/source.hpp"

namespace mdm {

/// The row without the cells of the table's columns.
CellRow beside_columns(CellRow row, const TableColumns &columns);

/// The statements above the table, and beside its header and its units.
std::vector<MassStatement> statements_above(const Cells &cells, const TableColumns &columns);

/// The statements with their numbers; those that say nothing of masses and have none, such as dates, are left
/// out. Words above the header that may be about fines are added to `left`.
/// \throws InputError with the line where a number is none, or may be a mass that belongs to the table
std::vector<StatedNumber> stated_numbers(const std::vector<MassStatement> &statements, const TableSign &sign,
                                         std::size_t header_line, ShortList &left, const Source &source);

} // namespace mdm

#pragma once
/// \file
/// Words around a table that may say that its values are others than their header says.

#include "gradation/table_columns.hpp"

namespace mdm {

/// The cell above the header of values in that row, or the one to its left that is merged with it, may say
/// more than the header: `Cumulative` above `Retained (g)`, `Number` above `Percent passing`.
/// \throws InputError where it does
void check_words_above(const Cells &cells, std::size_t row, const TableColumns &columns,
                       const Source &source);

/// \throws InputError where a row of words above, among or below the table says that values are cumulative,
/// as `Results are cumulative`, and no header does
void check_words_of_sums(const Cells &cells, const TableColumns &columns, const Source &source);

/// \throws InputError where a sentence above or below the table gives its sizes another unit than their header
void check_words_of_units(const Cells &cells, const TableColumns &columns, const Source &source);

/// \throws InputError where a comment says of the table's masses what would be read without its #
void check_comments(const Cells &cells, const TableColumns &columns, const Source &source);

} // namespace mdm

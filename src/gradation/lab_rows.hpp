#pragma once
/// \file
/// The rows of a laboratory's table: which is a sieve, which the pan, a loss or a sum, which only words.

#include "gradation/account_rows.hpp"
#include "gradation/table.hpp"
#include "gradation/value_columns.hpp"
#include "text/short_list.hpp"

namespace mdm {

/// What was read of a table and beside it.
struct LabRows {
  TableColumns columns;             ///< of the last header; the values with the unit that their cells have
  Table table;                      ///< sizes, and the values as they stand in the chosen column
  std::vector<ColumnBeside> beside; ///< the other columns of masses
  std::vector<ColumnBeside> unread; ///< columns that are not understood and speak of mass
  std::vector<AccountRow> accounts; ///< rows of the pan, of losses and of sums
  std::vector<StatedNumber> stated; ///< above and below the table
  std::vector<std::size_t> further_headers; ///< lines of headers among the rows
  ShortList left;                           ///< rows that are none of these
  ShortList errors; ///< rows with an error of a spreadsheet in a column that is compared
  std::optional<std::size_t> out_of_order; ///< the line of a sieve that is out of the order of the others
  ShortList hidden;       ///< of a workbook: those that were read, and its sheet does not show
  ShortList long_numbers; ///< of a workbook: those that have no decimal of at most 15 digits
};

/// Reads all rows below the header.
/// \throws InputError with the line where a row is not certain
LabRows read_lab_rows(const Cells &cells, TableColumns columns, const Reading &reading, const Source &source);

} // namespace mdm

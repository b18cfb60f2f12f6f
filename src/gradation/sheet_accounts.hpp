#pragma once
/// \file
/// All that a laboratory's sheet says of one sample's masses, as it was read and in order.

#include "gradation/account_column.hpp"
#include "gradation/account_rows.hpp"
#include "gradation/allowed_loss.hpp"
#include "gradation/stated_masses.hpp"

namespace mdm {

/// What was read of a sheet.
struct SheetAccounts {
  std::vector<AccountColumn> columns; ///< header, meaning and unit; the first is the chosen one
  /// Columns that are not read and speak of mass; their numbers stand behind those of the others in each row.
  std::vector<AccountColumn> unread;
  bool is_asked = false; ///< the first column was chosen by the user
  std::vector<AccountRow> rows;
  std::vector<StatedNumber> stated; ///< above and below the table
  SizeUnit unit = SizeUnit::mm;
  std::size_t header_line = 1;
};

/// The same in order: the columns have the numbers of their sieves and what passes the finest.
struct OrderedAccounts {
  std::vector<AccountColumn> columns;
  std::vector<AccountColumn> unread; ///< with the numbers of the sieves alone
  bool is_asked;
  AccountRows rows;
  StatedMasses stated;
  AllowedLoss loss;
  SizeUnit unit;
  std::size_t header_line;
  bool has_added_wash = false; ///< what is said of washing stands in no row, and was added
};

/// Puts the accounts in order. What was washed out passes the finest sieve, unless the row of the pan has it
/// already, which a line of `notes` says then. A column that may be cumulative, or not, is what agrees with
/// the chosen one.
/// \throws InputError where rows and statements contradict each other, or may mean two things
OrderedAccounts in_order(SheetAccounts sheet, const AllowedLoss &loss, const Source &source,
                         std::vector<std::string> &notes);

} // namespace mdm

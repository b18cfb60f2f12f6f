#pragma once
/// \file
/// The accounts of a laboratory's sheet: all that it says of one sample's masses, compared.

#include "gradation/sheet_accounts.hpp"

namespace mdm {

/// What the gradation is of.
struct SettledAccounts {
  std::size_t column = 0; ///< the one that decides
  /// What this column has, or would have, in the row of the pan, washed fines included.
  std::optional<PrintedNumber> pan;
  bool is_confirmed = false; ///< by another column or a sum that the sheet states
  std::vector<std::string> notes;
};

/// Compares every column with every other, with totals and with what is said above and below the table,
/// within the rounding of the printed digits. Masses without a row of what passes the finest sieve give way
/// to a column of percent that has it.
/// \throws InputError where they differ, with both readings and the option that chooses
SettledAccounts settle_accounts(SheetAccounts sheet, const Reading &reading, const Source &source);

} // namespace mdm

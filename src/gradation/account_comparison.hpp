#pragma once
/// \file
/// The columns of a laboratory's sheet compared with each other, and the one that decides.

#include "gradation/sheet_accounts.hpp"

namespace mdm {

/// What the comparison of all columns says.
struct ColumnsCompared {
  std::size_t deciding = 0;           ///< the column that the gradation is of
  bool some_agree = false;            ///< with the chosen one
  std::optional<Interval> whole = {}; ///< of masses without a row of the pan, by shares that have it
};

/// Compares every column with every other within the rounding of the printed digits. Masses without a row of
/// what passes the finest sieve give way to a column of percent that has it. What agrees and what decides is
/// added to `notes`; what differs too, where the user chose the column.
/// \throws InputError where columns differ, with both readings and the option that chooses
ColumnsCompared compare_columns(const OrderedAccounts &accounts, const Source &source,
                                std::vector<std::string> &notes);

} // namespace mdm

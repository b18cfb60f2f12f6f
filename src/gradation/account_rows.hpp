#pragma once
/// \file
/// The rows of a laboratory's table: sieves, and what else is summed up.

#include "gradation/printed_number.hpp"
#include "gradation/row_words.hpp"
#include "text/source.hpp"

#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// What to do where rows may be of a part of the sample.
std::string split_remedy();

/// A row of a sieve, or of what else a table sums up.
struct AccountRow {
  RowMeaning meaning = RowMeaning::none; ///< none: a sieve
  Rational size = {};                    ///< of the sieve; of another row the sieve that it names, if it does
  bool names_sieve = false;
  std::string label = {};
  std::size_t line = 1;
  std::vector<std::optional<PrintedNumber>> numbers = {}; ///< one a column
};

/// The rows of one table in order.
struct AccountRows {
  std::vector<AccountRow> sieves; ///< from the coarsest on
  std::vector<AccountRow> others; ///< one of a kind, in the order of the table

  /// The row of that kind; null where there is none.
  const AccountRow *pan() const { return other(RowMeaning::pan); }
  const AccountRow *wash() const { return other(RowMeaning::wash_loss); }
  const AccountRow *all_fines() const { return other(RowMeaning::pan_and_wash); }
  const AccountRow *total() const { return other(RowMeaning::total); }
  const AccountRow *loss() const { return other(RowMeaning::sieve_loss); }

  /// True where a row says what passes the finest sieve, or a part of it.
  bool have_fines() const { return pan() != nullptr || have_wash(); }
  /// True where a row has what was washed out.
  bool have_wash() const { return wash() != nullptr || all_fines() != nullptr; }

private:
  const AccountRow *other(RowMeaning kind) const;
};

/// Puts the rows of a table in order.
/// \param unit  of the sizes
/// \throws InputError where two rows say the same, a row names another sieve than the finest, or sieves stand
/// above and below a row
AccountRows rows_in_order(std::vector<AccountRow> rows, SizeUnit unit, const Source &source);

/// The number of a row, which may be null, in a column; nothing where there is none.
std::optional<PrintedNumber> number_of(const AccountRow *row, std::size_t column);

} // namespace mdm

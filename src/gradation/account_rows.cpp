#include "gradation/account_rows.hpp"

#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// What passes a sieve in whichever way is pan and wash loss.
RowMeaning kind_of_row(const AccountRow &row) {
  return row.meaning == RowMeaning::passing ? RowMeaning::pan_and_wash : row.meaning;
}

void check_single(const AccountRow &row, const std::vector<AccountRow> &before, const Source &source) {
  for (const AccountRow &other : before)
    if (kind_of_row(other) == kind_of_row(row))
      source.refuse(row.line,
                    fmt::format("the row {} says the same as {} in line {}: leave one out; {}",
                                in_quotes(row.label), in_quotes(other.label), other.line, split_remedy()));
}

/// What passes the finest sieve is of no other sieve.
void check_named_sieves(const AccountRows &rows, SizeUnit unit, const Source &source) {
  for (const AccountRow *row : {rows.pan(), rows.wash(), rows.all_fines()})
    if (row != nullptr && row->names_sieve && !rows.sieves.empty() && row->size != rows.sieves.back().size)
      source.refuse(row->line, fmt::format("the row {} is of what passes {}, and the finest sieve is {}: "
                                           "give the row of that sieve; {}",
                                           in_quotes(row->label), shown(row->size, unit),
                                           shown(rows.sieves.back().size, unit), split_remedy()));
}

/// What passes the finest sieve, and a sum, stand at an end of the table.
void check_places(const AccountRows &rows, const Source &source) {
  for (const AccountRow &row : rows.others) {
    const auto is_above = [&row](const AccountRow &sieve) { return sieve.line < row.line; };
    const auto above = std::count_if(rows.sieves.begin(), rows.sieves.end(), is_above);
    if (above != 0 && above != std::ssize(rows.sieves))
      source.refuse(row.line, fmt::format("sieves stand above and below the row {}: {}", in_quotes(row.label),
                                          split_remedy()));
  }
}

} // namespace

std::string split_remedy() {
  return fmt::format(
      "a part that was sieved for the whole is no table by itself: write the two into files of their own for "
      "mdm convert {}, or give percent passing of the whole",
      option("split", OptionSpelling::program));
}

const AccountRow *AccountRows::other(RowMeaning kind) const {
  const auto found = std::find_if(others.begin(), others.end(),
                                  [kind](const AccountRow &row) { return kind_of_row(row) == kind; });
  return found == others.end() ? nullptr : &*found;
}

AccountRows rows_in_order(std::vector<AccountRow> rows, SizeUnit unit, const Source &source) {
  AccountRows in_order;
  for (AccountRow &row : rows) {
    if (row.meaning != RowMeaning::none)
      check_single(row, in_order.others, source);
    (row.meaning == RowMeaning::none ? in_order.sieves : in_order.others).push_back(std::move(row));
  }
  std::stable_sort(in_order.sieves.begin(), in_order.sieves.end(),
                   [](const AccountRow &a, const AccountRow &b) { return a.size > b.size; });
  check_named_sieves(in_order, unit, source);
  check_places(in_order, source);
  return in_order;
}

std::optional<PrintedNumber> number_of(const AccountRow *row, std::size_t column) {
  return row == nullptr ? std::nullopt : row->numbers[column];
}

} // namespace mdm

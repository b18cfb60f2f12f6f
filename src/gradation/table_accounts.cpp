#include "gradation/table_accounts.hpp"

#include "gradation/account_sums.hpp"
#include "gradation/shown.hpp"
#include "gradation/unread_columns.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// True for a mass of a part that is not what passes the finest sieve.
bool is_of_other_part(const StatedNumber &stated, const AccountColumn &masses) {
  const MassStatement &s = stated.statement;
  return s.meaning == RowMeaning::none && s.grams != 0 && speaks_of_part(s.label) &&
         !(masses.below && agree(*masses.below, stated.number * ratio(s.grams, std::max(masses.grams, 1U))));
}

/// Words of a split beside a number are harmless only where all else adds up.
void check_words_of_splitting(const OrderedAccounts &accounts, const std::vector<StatedNumber> &stated,
                              const ColumnsCompared &compared, const Source &source) {
  if (accounts.columns[compared.deciding].is_share() || accounts.stated.initial || compared.some_agree)
    return;
  for (const StatedNumber &number : stated)
    if (const MassStatement &s = number.statement;
        speaks_of_splitting(s.label + " " + s.digits) ||
        is_of_other_part(number, accounts.columns[compared.deciding]))
      source.refuse(s.line,
                    fmt::format("{} may be of a part of the sample: {}", in_quotes(s.label), split_remedy()));
}

/// A row of what passes the finest sieve must have its number in a column of masses that decides.
void check_rows_of_fines(const OrderedAccounts &accounts, std::size_t deciding, const Source &source) {
  if (accounts.columns[deciding].is_share() ||
      accounts.columns[deciding].meaning.meaning == ColumnMeaning::passing ||
      number_of(accounts.rows.all_fines(), deciding))
    return;
  for (const AccountRow *row : {accounts.rows.all_fines(), accounts.rows.pan(), accounts.rows.wash()})
    for (std::size_t c = 0; row != nullptr && c < accounts.columns.size(); ++c)
      if (const std::optional<PrintedNumber> number = number_of(row, c);
          number && number->value > 0 && !number_of(row, deciding) &&
          accounts.columns[c].meaning.meaning != ColumnMeaning::passing)
        source.refuse(row->line,
                      fmt::format("the row {} has {} in the column {}, and nothing in {}: write it "
                                  "there too",
                                  in_quotes(row->label), shown(number->value),
                                  in_quotes(accounts.columns[c].header),
                                  in_quotes(accounts.columns[deciding].header)));
}

/// What a column has, or would have, in the row of the pan.
std::optional<PrintedNumber> pan_of(const OrderedAccounts &accounts, std::size_t c) {
  const AccountColumn &column = accounts.columns[c];
  const std::optional<PrintedNumber> row = number_of(accounts.rows.pan(), c);
  if (column.is_retained())
    return column.below;
  if (column.meaning.meaning == ColumnMeaning::passing)
    return row ? std::optional(PrintedNumber{0, 0}) : std::nullopt;
  if (column.is_share())
    return row;
  return column.below ? std::optional(*column.sieves.back() + *column.below) : std::nullopt;
}

/// The parts of what passes the finest sieve, where they are more than a row of the pan.
void describe_fines(const OrderedAccounts &accounts, std::size_t c, std::vector<std::string> &notes) {
  const AccountColumn &column = accounts.columns[c];
  const AccountRows &rows = accounts.rows;
  ShortList parts;
  const auto add = [&parts](const std::string &label, const std::optional<PrintedNumber> &number) {
    if (number)
      parts.add(label + " " + shown(number->value));
  };
  if (number_of(rows.all_fines(), c))
    add(rows.all_fines()->label, number_of(rows.all_fines(), c));
  else
    for (const AccountRow *row : {rows.pan(), rows.wash()})
      if (row != nullptr)
        add(row->label, number_of(row, c));
  if (accounts.has_added_wash)
    add(accounts.stated.wash_loss->label, in_unit_of(column, accounts.stated.wash_loss));
  if (parts.size() > 1 || rows.have_wash() || accounts.has_added_wash)
    notes.push_back(fmt::format("What passes the finest sieve, {}, is {}: {}.",
                                shown(rows.sieves.back().size, accounts.unit), shown(column.below->value),
                                parts.text()));
}

void describe_initial(const OrderedAccounts &accounts, std::size_t c, std::vector<std::string> &notes) {
  const std::optional<PrintedNumber> initial = in_unit_of(accounts.columns[c], accounts.stated.initial),
                                     whole = accounts.columns[c].whole();
  if (!initial || !whole || !agree(*whole, *initial))
    return;
  const std::string label = in_quotes(accounts.stated.initial->label);
  notes.push_back(whole->value == initial->value
                      ? fmt::format("The masses add up to {} as {} says.", shown(initial->value), label)
                      : fmt::format("The masses add up to {}, {} says {}: their rounding may account for it.",
                                    shown(whole->value), label, shown(initial->value)));
}

} // namespace

SettledAccounts settle_accounts(SheetAccounts sheet, const Reading &reading, const Source &source) {
  SettledAccounts settled;
  const std::vector<StatedNumber> stated = sheet.stated;
  const OrderedAccounts accounts = in_order(std::move(sheet), AllowedLoss(reading), source, settled.notes);
  const ColumnsCompared compared = compare_columns(accounts, source, settled.notes);
  check_unread(accounts, compared.deciding, source, settled.notes);
  const bool adds_up = check_sums(accounts, compared, source, settled.notes);
  check_words_of_splitting(accounts, stated, compared, source);
  check_rows_of_fines(accounts, compared.deciding, source);
  settled.column = compared.deciding;
  settled.pan = pan_of(accounts, compared.deciding);
  settled.is_confirmed = adds_up || compared.some_agree;
  if (!accounts.columns[compared.deciding].is_share()) {
    describe_fines(accounts, compared.deciding, settled.notes);
    describe_initial(accounts, compared.deciding, settled.notes);
  }
  if (!accounts.stated.left.empty())
    settled.notes.push_back(
        fmt::format("Masses beside the table that were not compared: {}.", accounts.stated.left.text()));
  return settled;
}

} // namespace mdm

#include "gradation/lab_accounts.hpp"

#include "gradation/table_accounts.hpp"

namespace mdm {
namespace {

/// Percent or fractions where the whole is there as 100 or 1 and no unit says so.
void find_share(HeaderMeaning &meaning, const std::vector<std::optional<PrintedNumber>> &numbers) {
  if (meaning.unit != ColumnUnit::none || meaning.meaning == ColumnMeaning::retained)
    return;
  Rational largest = 0;
  for (const std::optional<PrintedNumber> &number : numbers)
    largest = number ? std::max(largest, number->value) : largest;
  if (largest == 100)
    meaning.unit = ColumnUnit::percent;
  else if (largest == 1)
    meaning.unit = ColumnUnit::fraction;
}

/// \param grams  in one of its unit of mass, if it has one
AccountColumn account_column(const std::string &header, HeaderMeaning meaning, unsigned grams) {
  return {header, meaning, meaning.unit == ColumnUnit::mass ? grams : 0, {}, {}};
}

/// Shares are compared as percent.
Rational scale(const HeaderMeaning &meaning) {
  return meaning.unit == ColumnUnit::fraction ? 100 : 1;
}

std::vector<AccountColumn> account_columns(LabRows &rows) {
  std::vector<std::optional<PrintedNumber>> chosen;
  for (const Rational &value : rows.table.values)
    chosen.emplace_back(PrintedNumber{value, 0});
  HeaderMeaning meaning = rows.columns.values;
  find_share(meaning, chosen);
  std::vector<AccountColumn> columns = {account_column(rows.columns.value_name, meaning, rows.columns.grams)};
  for (ColumnBeside &beside : rows.beside) {
    find_share(beside.column.meaning, beside.numbers);
    columns.push_back(
        account_column(beside.column.name, beside.column.meaning, grams_in(beside.column.name)));
  }
  return columns;
}

/// Numbers without a unit may be shares or masses.
std::vector<AccountColumn> unread_columns(const LabRows &rows) {
  std::vector<AccountColumn> columns;
  for (const ColumnBeside &unread : rows.unread)
    columns.push_back(
        account_column(unread.column.name, unread.column.meaning, grams_in(unread.column.name)));
  return columns;
}

/// The sieves, and what else there is.
std::vector<AccountRow> account_rows(const LabRows &rows) {
  const Table &table = rows.table;
  std::vector<AccountRow> all;
  for (std::size_t i = 0; i < table.sizes.size(); ++i) {
    AccountRow row{RowMeaning::none,
                   table.sizes[i],
                   false,
                   {},
                   table.lines[i],
                   {PrintedNumber{table.values[i], table.roundings[i]}}};
    for (const std::vector<ColumnBeside> *columns :
         {&rows.beside, &rows.unread}) // the top of ranges has no row
      for (const ColumnBeside &column : *columns)
        row.numbers.push_back(i < column.numbers.size() ? column.numbers[i] : std::nullopt);
    all.push_back(std::move(row));
  }
  all.insert(all.end(), rows.accounts.begin(), rows.accounts.end());
  return all;
}

SheetAccounts accounts_of(LabRows &rows, bool is_asked) {
  SheetAccounts sheet{account_columns(rows), unread_columns(rows),  is_asked, account_rows(rows), rows.stated,
                      rows.table.unit,       rows.table.header_line};
  for (AccountRow &row : sheet.rows)
    for (std::size_t c = 0; c < std::min(row.numbers.size(), sheet.columns.size()); ++c)
      if (row.numbers[c])
        row.numbers[c] = *row.numbers[c] * scale(sheet.columns[c].meaning);
  return sheet;
}

/// Makes a column beside the chosen one that of the values. \pre it has a number in each row
void take_column(LabRows &rows, const ColumnBeside &column) {
  rows.columns.values = column.column.meaning;
  rows.columns.value_name = column.column.name;
  for (std::size_t i = 0; i < rows.table.values.size(); ++i) {
    rows.table.values[i] = column.numbers[i]->value;
    rows.table.roundings[i] = column.numbers[i]->half;
  }
}

void add_pan(LabRows &rows, const PrintedNumber &pan) {
  Table &table = rows.table;
  table.sizes.emplace_back(0);
  table.values.push_back(pan.value / scale(rows.columns.values));
  table.roundings.push_back(pan.half / scale(rows.columns.values));
  table.lines.push_back(rows.accounts.empty() ? table.header_line : rows.accounts.back().line);
}

} // namespace

ComparedValues settle_values(LabRows &rows, const Reading &reading, const Source &source) {
  SettledAccounts settled =
      settle_accounts(accounts_of(rows, reading.columns || reading.kind), reading, source);
  if (settled.column != 0)
    take_column(rows, rows.beside[settled.column - 1]);
  if (settled.pan)
    add_pan(rows, *settled.pan);
  return {settled.is_confirmed, std::move(settled.notes)};
}

} // namespace mdm

#include "gradation/decimal_commas.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/sheet_remarks.hpp"
#include "gradation/unread_columns.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view comma_remedy = "put ; between cells where numbers have decimal commas";

/// True where a number of the row has a decimal point, so that no comma between cells is a decimal sign.
bool has_point(const CellRow &row) {
  return std::any_of(row.cells.begin(), row.cells.end(), [](const std::string &cell) {
    return number_cell(cell) && cell.find('.') != std::string::npos;
  });
}

bool has_unused_number(const CellRow &row, const TableColumns &columns) {
  return std::any_of(columns.others.begin(), columns.others.end(), [&row](const UnusedColumn &column) {
    return number_cell(row.cell(column.place)).has_value();
  });
}

bool are_digits(std::string_view cell) {
  constexpr std::size_t most_decimals = 3;
  return cell.size() <= most_decimals && std::all_of(cell.begin(), cell.end(), is_digit);
}

/// The rows with what may be decimals in that column; none where another cell of it cannot be. Below words of
/// remarks decimals may differ in length, in a column of numbers they do not.
std::vector<const CellRow *> rows_with_decimals(const std::vector<const CellRow *> &sieves,
                                                const UnusedColumn &column) {
  const bool is_of_remarks = heads_remarks(column.name);
  std::vector<const CellRow *> rows;
  for (const CellRow *sieve : sieves) {
    const std::string_view cell = sieve->cell(column.place);
    if (cell.empty())
      continue;
    const bool has_other_length = !rows.empty() && cell.size() != rows.back()->cell(column.place).size();
    if (!are_digits(cell) || (has_other_length && !is_of_remarks))
      return {};
    rows.push_back(sieve);
  }
  return rows;
}

bool retains_mass(const CellRow &row, const TableColumns &columns) {
  return row.cell(columns.value).find_first_of("123456789") != std::string_view::npos;
}

} // namespace

void check_commas(const CellRow &row, const TableColumns &columns, const Source &source) {
  const std::string_view value = row.cell(columns.value);
  if (row.cell(columns.size) == "0" && has_unused_number(row, columns) && !has_point(row))
    source.refuse(row.line, fmt::format("0 and {} may be a size with a decimal comma: {}", in_quotes(value),
                                        comma_remedy));
  if (value.size() > 1 && value.front() == '0' && is_digit(value[1]))
    source.refuse(row.line, fmt::format("{} begins with 0, as behind a decimal comma: {}", in_quotes(value),
                                        comma_remedy));
}

void check_last_column(const std::vector<const CellRow *> &sieves, const TableColumns &columns,
                       const Source &source) {
  const auto last =
      std::find_if(columns.others.begin(), columns.others.end(), [&columns](const UnusedColumn &c) {
        return c.place == columns.value + 1 && c.place + 1 == columns.width && !may_hold_values(c.name);
      });
  if (last == columns.others.end() ||
      std::any_of(sieves.begin(), sieves.end(), [](const CellRow *row) { return has_point(*row); }))
    return;
  const std::vector<const CellRow *> rows = rows_with_decimals(sieves, *last);
  const auto masses = std::count_if(sieves.begin(), sieves.end(),
                                    [&columns](const CellRow *row) { return retains_mass(*row, columns); });
  if (rows.size() < 2 || 2 * std::ssize(rows) < masses)
    return;
  const CellRow &row = *rows.back();
  source.refuse(
      row.line,
      fmt::format("{} and {} in the columns {} and {} may be one number with a decimal comma: {}, or "
                  "choose the columns with {} SIZE,VALUE",
                  in_quotes(row.cell(columns.value)), in_quotes(row.cell(last->place)),
                  in_quotes(columns.value_name), in_quotes(last->name), comma_remedy, option("columns")));
}

} // namespace mdm

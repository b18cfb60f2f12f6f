#include "gradation/table_sign.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/row_ranges.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace mdm {
namespace {

bool is_text_file(const Cells &cells) {
  return cells.delimiter != '\0';
}

void see_number(DecimalSign &sign, std::string_view cell) {
  if (const std::optional<NumberCell> number = number_cell(cell))
    sign.see(number->digits);
}

/// Numbers that were typed, in the columns that are read.
void see_columns(DecimalSign &sign, const Cells &cells, const TableColumns &columns) {
  std::vector<std::size_t> places = {columns.size, columns.value};
  for (const FurtherColumn &further : columns.further) {
    places.push_back(further.place);
    if (further.less)
      places.push_back(*further.less);
  }
  for (std::size_t i = columns.first_row; i < cells.rows.size(); ++i)
    for (const std::size_t place : places) {
      const CellRow &row = cells.rows[i];
      if (!is_text_file(cells) && !std::binary_search(row.texts.begin(), row.texts.end(), place))
        continue;
      const auto ends = range_ends(row.cell(place));
      see_number(sign, ends ? ends->first : row.cell(place));
      see_number(sign, ends ? ends->second : std::string_view());
    }
}

/// Numbers beside known words have the decimal sign of the table.
void see_statements(DecimalSign &sign, const Cells &cells, const TableColumns &columns,
                    std::vector<MassStatement> statements) {
  for (std::size_t i = columns.first_row; i < cells.rows.size(); ++i)
    add_statements(cells.rows[i], nullptr, statements);
  for (const MassStatement &s : statements)
    if (s.meaning != RowMeaning::none && (is_text_file(cells) || s.is_text))
      sign.see(s.digits);
}

} // namespace

Rational TableSign::decimal(std::string_view digits) const {
  return parse_decimal(digits, in(digits));
}

TableSign table_sign(const Cells &cells, const TableColumns &columns, std::vector<MassStatement> above) {
  DecimalSign sign(cells.delimiter == ';', cells.delimiter == ',');
  see_columns(sign, cells, columns);
  see_statements(sign, cells, columns, std::move(above));
  return {sign.sign(), !is_text_file(cells)};
}

} // namespace mdm

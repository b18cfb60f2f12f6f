#include "gradation/value_columns.hpp"

#include "gradation/cell_numbers.hpp"
#include "number/decimal_exponent.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

std::optional<NumberCell> cell_of(const ColumnBeside &column, const CellRow &row) {
  return column.place ? number_cell(row.cell(*column.place)) : std::nullopt;
}

/// `#DIV/0!`, `#NV`, `Err:502`: what a spreadsheet shows of a formula that has no value.
bool is_error(std::string_view cell) {
  constexpr std::array errors = {"#REF!",  "#DIV/0!", "#N/A",   "#VALUE!", "#NAME?", "#NUM!",
                                 "#NULL!", "#BEZUG!", "#WERT!", "#NV",     "#ZAHL!"};
  return cell.starts_with("Err:") || std::find(errors.begin(), errors.end(), cell) != errors.end();
}

bool has_error(const std::vector<ColumnBeside> &columns, const CellRow &row) {
  return std::any_of(columns.begin(), columns.end(), [&row](const ColumnBeside &column) {
    return column.place && is_error(row.cell(*column.place));
  });
}

bool mean_one(const FurtherColumn &a, const FurtherColumn &b) {
  return a.meaning.meaning == b.meaning.meaning && a.meaning.unit == b.meaning.unit &&
         a.less.has_value() == b.less.has_value();
}

} // namespace

PrintedNumber ChosenColumn::read(std::string_view cell) {
  const std::optional<NumberCell> number = number_cell(cell);
  if (!number)
    refuse(cell);
  if (number->unit != ColumnUnit::none && number->unit != meaning_.unit)
    take_unit(cell, number->unit);
  if (number->unit == ColumnUnit::mass)
    check_kilograms(cell);
  const PrintedNumber printed{sign_.decimal(number->digits),
                              last_digit_unit(number->digits, sign_.in(number->digits)) / 2};
  has_plain_ |= number->unit == ColumnUnit::none && printed.value != 0;
  has_percent_ |= number->unit == ColumnUnit::percent;
  if ((unit_is_of_cells_ || has_percent_) && has_plain_)
    throw InputError(fmt::format(
        "some values in the column {} have a unit, as {} or others above, and some have none: write all "
        "alike",
        in_quotes(header_), in_quotes(cell)));
  return printed;
}

void ChosenColumn::refuse(std::string_view cell) const {
  throw InputError(fmt::format(
      "{} in the column {} is not a number: write a decimal{}", in_quotes(cell), in_quotes(header_),
      meaning_.meaning == ColumnMeaning::retained ? ", or 0 where nothing was retained" : ""));
}

/// The unit of a cell is that of the column where the header has none.
void ChosenColumn::take_unit(std::string_view cell, ColumnUnit unit) {
  if (meaning_.unit != ColumnUnit::none || (unit != ColumnUnit::percent && unit != ColumnUnit::mass))
    throw InputError(fmt::format("{} has another unit than the column {}: say what it is with {}",
                                 in_quotes(cell), in_quotes(header_), option("kind")));
  meaning_.unit = unit;
  unit_is_of_cells_ = true;
}

/// Masses in g and in kg do not stand in one column.
void ChosenColumn::check_kilograms(std::string_view cell) {
  const bool here = names_kilograms(cell);
  if (!in_kilograms_)
    in_kilograms_ = unit_is_of_cells_ ? here : grams_ > 1;
  if (*in_kilograms_ != here)
    throw InputError(
        fmt::format("{} is in another unit of mass than the column {} or the values above: write all alike",
                    in_quotes(cell), in_quotes(header_)));
}

ColumnsBeside::ColumnsBeside(const std::vector<FurtherColumn> &columns, const TableSign &sign) : sign_(sign) {
  for (const FurtherColumn &column : columns)
    all_.push_back({column, column.place, {}});
}

bool ColumnsBeside::have(const FurtherColumn &column) const {
  return std::any_of(all_.begin(), all_.end(),
                     [&column](const ColumnBeside &c) { return mean_one(c.column, column); });
}

void ColumnsBeside::go_on(const std::vector<FurtherColumn> &next) {
  for (ColumnBeside &column : all_) {
    const auto found = std::find_if(next.begin(), next.end(),
                                    [&column](const FurtherColumn &c) { return mean_one(column.column, c); });
    column.place = found == next.end() ? std::nullopt : std::optional(found->place);
    if (column.place)
      column.column.less = found->less;
  }
}

bool ColumnsBeside::have_number(const CellRow &row) const {
  return std::any_of(all_.begin(), all_.end(),
                     [this, &row](const ColumnBeside &column) { return number(column, row).has_value(); });
}

std::vector<std::optional<PrintedNumber>> ColumnsBeside::numbers(const CellRow &row) const {
  std::vector<std::optional<PrintedNumber>> numbers;
  for (const ColumnBeside &column : all_)
    numbers.push_back(number(column, row));
  return numbers;
}

void ColumnsBeside::take(const CellRow &row) {
  if (has_error(all_, row))
    errors_.add(row.first());
  for (ColumnBeside &column : all_) {
    column.numbers.push_back(number(column, row));
    const std::optional<NumberCell> cell = cell_of(column, row);
    if (cell && cell->unit == ColumnUnit::percent && column.column.meaning.unit == ColumnUnit::none)
      column.column.meaning.unit = ColumnUnit::percent;
  }
}

std::optional<PrintedNumber> ColumnsBeside::number(const ColumnBeside &column, const CellRow &row) const {
  const std::optional<NumberCell> cell = cell_of(column, row);
  const std::optional<NumberCell> less =
      column.column.less ? number_cell(row.cell(*column.column.less)) : std::nullopt;
  if (!cell || less.has_value() != column.column.less.has_value())
    return std::nullopt;
  try {
    const PrintedNumber number = printed_number(cell->digits, sign_.in(cell->digits));
    if (number.value < 0)
      throw InputError(in_quotes(cell->digits) + " is negative: correct it, or leave the column out");
    return less ? number - printed_number(less->digits, sign_.in(less->digits)) : number;
  } catch (const InputError &error) {
    throw InputError(fmt::format("the column {} is compared with the others: {}",
                                 in_quotes(column.column.name), error.what()));
  }
}

} // namespace mdm

#include "gradation/unused_columns.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/corrected_values.hpp"
#include "gradation/limit_columns.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_words.hpp"
#include "gradation/unread_columns.hpp"
#include "gradation/weighed_sieves.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// True where two numbers differ: a constant is no gradation.
bool have_two_values(const std::vector<std::optional<PrintedNumber>> &numbers) {
  const auto first =
      std::find_if(numbers.begin(), numbers.end(), [](const auto &n) { return n.has_value(); });
  return std::any_of(first, numbers.end(),
                     [&first](const auto &n) { return n && n->value != (*first)->value; });
}

/// The values where each row has one.
std::optional<std::vector<Rational>>
full(const std::optional<std::vector<std::optional<PrintedNumber>>> &numbers) {
  if (!numbers)
    return std::nullopt;
  std::vector<Rational> values;
  for (const std::optional<PrintedNumber> &number : *numbers) {
    if (!number)
      return std::nullopt;
    values.push_back(number->value);
  }
  return values;
}

/// `Retained on (mm)`, `Lower size (um)`: the other sieve of a class.
bool names_other_end(std::string_view header) {
  return is_of_sizes(unit_in_header(header)) &&
         has_any_word("retained on lower to bottom below untere bis inferieur inferior inferiore",
                      words_of(header));
}

/// The unit that a header names with any of its words.
ColumnUnit share_or_mass(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
  for (const ColumnUnit unit : {ColumnUnit::percent, ColumnUnit::mass})
    if (std::any_of(words.begin(), words.end(),
                    [unit](const std::string &word) { return unit_of_words(word) == unit; }))
      return unit;
  return ColumnUnit::none;
}

} // namespace

bool UnusedColumns::names_mass(std::string_view cell) {
  const RowMeaning meaning = row_words(cell).meaning;
  return meaning != RowMeaning::none && meaning != RowMeaning::moist_mass && meaning != RowMeaning::total;
}

void UnusedColumns::go_on(const std::vector<UnusedColumn> &next) {
  here_ = next;
  std::erase_if(common_, [&next](const UnusedColumn &column) { return !is_among(column, next); });
  for (const UnusedColumn &column : next)
    if (!is_among(column, all_))
      all_.push_back(column);
}

void UnusedColumns::check_sieve(const CellRow &row, std::size_t rows, bool is_alone) const {
  if (are_chosen_)
    return;
  for (const auto &[place, name] : here_) {
    const std::string_view cell = row.cell(place);
    const bool has_number = number_cell(cell).has_value();
    const bool counts_rows = place == 0 && (cell == std::to_string(rows) || cell == std::to_string(rows + 1));
    if (name.empty() && (has_number || names_mass(cell)) && !counts_rows)
      refuse(row,
             fmt::format(
                 "{} is in a column without a name: name it in the header, or choose the columns with {} "
                 "SIZE,VALUE",
                 in_quotes(cell), option("columns")));
    if (!name.empty() && has_number)
      check_named(row, name, cell, is_alone);
    const RowMeaning meaning = row_words(cell).meaning;
    if (!name.empty() && (meaning == RowMeaning::pan || meaning == RowMeaning::pan_and_wash) &&
        !may_be_remark(cell))
      refuse(row, fmt::format(
                      "{} is in the column {}, which is not read: write a second part of the table below the "
                      "first",
                      in_quotes(cell), in_quotes(name)));
  }
}

void UnusedColumns::refuse_number(const CellRow &row, const std::string &name, std::string_view cell) const {
  refuse(row, fmt::format("{} in the column {} is not read: write it in a row of the table", in_quotes(cell),
                          in_quotes(name)));
}

/// \param cell  a number in a column of that name
void UnusedColumns::check_named(const CellRow &row, const std::string &name, std::string_view cell,
                                bool is_alone) const {
  const RowMeaning meaning = row_words(name).meaning;
  if (meaning == RowMeaning::pan || meaning == RowMeaning::wash_loss || meaning == RowMeaning::pan_and_wash)
    refuse_number(row, name, cell);
  if (names_empty_sieves(name) && names_mass_alone(value_name_) && is_alone)
    refuse(row, fmt::format(
                    "{} may be with what is in {}, which is weighed too: give a column of what is retained",
                    in_quotes(value_name_), in_quotes(name)));
}

void UnusedColumns::check_account(const CellRow &row, const std::vector<const CellRow *> &sieves) const {
  if (are_chosen_)
    return;
  for (const auto &[place, name] : here_) {
    const auto has_number = [column = place](const CellRow *r) {
      return number_cell(r->cell(column)).has_value();
    };
    const RowMeaning meaning = row_words(name).meaning;
    const bool is_of_fines = meaning == RowMeaning::wash_loss || meaning == RowMeaning::pan_and_wash ||
                             speaks_of_washing(name) || may_be_fines(name);
    const bool is_mass =
        unit_in_header(name) == ColumnUnit::mass && std::none_of(sieves.begin(), sieves.end(), has_number);
    if (!name.empty() && has_number(&row) && (is_of_fines || is_mass))
      refuse_number(row, name, row.cell(place));
  }
}

void UnusedColumns::check_unit(const CellRow &row) {
  if (are_chosen_)
    return;
  for (const UnusedColumn &column : here_) {
    const std::string_view cell = row.cell(column.place);
    if (unit_of_words(cell) != ColumnUnit::mass)
      continue;
    const std::string unit = plain_words(cell);
    std::string &before = units_[column.place];
    const bool is_others = grams_ != 0 && grams_in(cell) != grams_;
    if (is_others || (!before.empty() && before != unit))
      refuse(row, fmt::format("the mass in {} is in {}, and others are not: write all alike",
                              in_quotes(value_name_), in_quotes(cell)));
    before = unit;
  }
}

/// Its numbers beside the sieves, none in empty cells; nothing where a cell has anything else, such as a
/// range or a date.
std::optional<std::vector<std::optional<PrintedNumber>>>
UnusedColumns::numbers_in(const UnusedColumn &column, const std::vector<const CellRow *> &sieves) const {
  std::vector<std::optional<PrintedNumber>> numbers;
  for (const CellRow *row : sieves) {
    const std::string_view cell = row->cell(column.place);
    const std::optional<NumberCell> number = number_cell(cell);
    if (!number && !cell.empty())
      return std::nullopt;
    try {
      numbers.push_back(number ? std::optional(printed_number(number->digits, sign_.in(number->digits)))
                               : std::nullopt);
    } catch (const InputError &) {
      return std::nullopt;
    }
  }
  return numbers;
}

std::vector<ColumnBeside> UnusedColumns::speaking_of_mass(const std::vector<const CellRow *> &sieves) const {
  std::vector<ColumnBeside> columns;
  for (const UnusedColumn &column : common_) {
    std::optional<std::vector<std::optional<PrintedNumber>>> numbers = numbers_in(column, sieves);
    if (are_chosen_ || !numbers || !may_hold_values(column.name) || !have_two_values(*numbers))
      continue;
    const HeaderMeaning unit{ColumnMeaning::retained, share_or_mass(column.name)};
    columns.push_back({{column.place, column.name, unit}, column.place, std::move(*numbers)});
  }
  return columns;
}

bool UnusedColumns::has_two_numbers(const UnusedColumn &column,
                                    const std::vector<const CellRow *> &sieves) const {
  const std::optional<std::vector<std::optional<PrintedNumber>>> numbers = numbers_in(column, sieves);
  return numbers && have_two_values(*numbers);
}

void UnusedColumns::check_corrected(const Table &table, const std::vector<const CellRow *> &sieves,
                                    ColumnMeaning values) const {
  if (are_chosen_)
    return;
  const bool are_retained = values == ColumnMeaning::retained;
  for (const UnusedColumn &column : common_) {
    const bool has_number = std::any_of(sieves.begin(), sieves.end(), [&column](const CellRow *row) {
      return number_cell(row->cell(column.place)).has_value();
    });
    if (are_retained && speaks_of_splitting(column.name) && has_number)
      source_.refuse(
          table.header_line,
          fmt::format(
              "the column {} may be of a part of the sample that was sieved for the whole: choose the "
              "masses of the whole with {} SIZE,VALUE, or leave it out",
              in_quotes(column.name), option("columns")));
    if (names_other_end(column.name) && has_two_numbers(column, sieves))
      source_.refuse(
          table.header_line,
          fmt::format("the column {} has sizes too, and may be where {} was retained: give the size "
                      "of the sieve alone, or choose the columns with {} SIZE,VALUE",
                      in_quotes(column.name), in_quotes(value_name_), option("columns")));
    if (may_hold_values(column.name) || is_limit(column.name))
      continue; // compared in every reading, or of a specification
    if (are_retained && changes_masses(column.name) && has_two_numbers(column, sieves))
      source_.refuse(
          table.header_line,
          fmt::format("the column {} may change what is in {}, and differs from row to row: give the dry "
                      "masses of the whole sample, or choose the columns with {} SIZE,VALUE",
                      in_quotes(column.name), in_quotes(value_name_), option("columns")));
    const std::optional<std::vector<Rational>> numbers = full(numbers_in(column, sieves));
    if (numbers && (are_retained ? are_corrected_masses(table.values, *numbers)
                                 : are_corrected_percents(table.sizes, table.values, *numbers)))
      source_.refuse(
          table.header_line,
          fmt::format(
              "the column {} has the numbers of {} in some rows, and others in the rest: choose one with "
              "{} SIZE,VALUE",
              in_quotes(column.name), in_quotes(value_name_), option("columns")));
  }
}

void UnusedColumns::check_samples(const std::vector<const CellRow *> &sieves, ColumnMeaning values) const {
  for (const UnusedColumn &column : common_) {
    const bool may_be_parts = values == ColumnMeaning::retained &&
                              has_word("test part portion stage stack set", plain_words(column.name));
    if (!names_samples(column.name) && plain_words(column.name) != "id" && !may_be_parts)
      continue;
    std::map<std::string, std::size_t> rows;
    for (const CellRow *sieve : sieves)
      ++rows[std::string(sieve->cell(column.place))];
    if (rows.size() < 2 || rows.size() == sieves.size())
      continue;
    source_.refuse(
        sieves.front()->line,
        fmt::format("the column {} names several samples or parts, {} and {}: give each a file of its own",
                    in_quotes(column.name), in_quotes(rows.begin()->first),
                    in_quotes(std::next(rows.begin())->first)));
  }
}

} // namespace mdm

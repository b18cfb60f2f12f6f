#include "gradation/lab_table.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/csv_rows.hpp"
#include "gradation/lab_values.hpp"
#include "gradation/phi.hpp"
#include "gradation/sieve_name.hpp"
#include "gradation/table_columns.hpp"
#include "text/lines.hpp"
#include "text/short_list.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view options =
    "say which columns they are with --columns SIZE,VALUE (names or numbers), "
    "--kind passing|retained|cumulative, --unit mm and --skip N";

/// mm in one of a length unit.
Rational in_mm(ColumnUnit unit) {
  switch (unit) {
  case ColumnUnit::um:
    return ratio(1, 1000);
  case ColumnUnit::m:
    return 1000;
  case ColumnUnit::inch:
    return ratio(254, 10);
  default:
    return 1;
  }
}

class LabTable {
public:
  LabTable(const Cells &cells, TableColumns columns, const Source &source, const std::string &id,
           const Reading &reading)
      : cells_(cells), columns_(std::move(columns)), source_(source), reading_(reading) {
    table_.id = id;
    table_.unit = columns_.sizes.unit == ColumnUnit::um  ? SizeUnit::um
                  : columns_.sizes.unit == ColumnUnit::m ? SizeUnit::m
                                                         : SizeUnit::mm;
    unit_in_mm_ = in_mm(columns_.sizes.unit == ColumnUnit::inch ? ColumnUnit::mm : columns_.sizes.unit);
    table_.header_line = line_of(columns_.first_row == 0 ? 0 : columns_.first_row - 1);
  }

  Table read() {
    find_decimal_sign();
    for (row_ = columns_.first_row; row_ < cells_.rows.size(); ++row_)
      read_row();
    if (table_.sizes.empty())
      source_.refuse(table_.header_line,
                     fmt::format("there is no row with a size and a number below {} and {}: {}",
                                 in_quotes(columns_.size_name), in_quotes(columns_.value_name), options));
    settle_lab_values(table_, {columns_.values, columns_.value_name, total_}, reading_, source_);
    describe();
    return std::move(table_);
  }

private:
  std::size_t line_of(std::size_t row) const {
    return cells_.rows.empty() ? 1 : cells_.rows[std::min(row, cells_.rows.size() - 1)].line;
  }
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(line_of(row_), what); }

  /// The row's first cell that has something in it.
  std::string_view first_cell() const {
    const std::vector<std::string> &cells = cells_.rows[row_].cells;
    return *std::find_if(cells.begin(), cells.end(), [](const std::string &c) { return !c.empty(); });
  }
  /// The size; a pan may stand in another column, that of the sieves' names.
  std::string_view size_cell() const {
    const std::string_view cell = cells_.rows[row_].cell(columns_.size);
    return cell.empty() && is_pan_word(first_cell()) ? first_cell() : cell;
  }
  std::string_view value_cell() const { return cells_.rows[row_].cell(columns_.value); }

  void find_decimal_sign() {
    DecimalSign sign(cells_.delimiter == ';', cells_.delimiter == ',' || cells_.delimiter == '\0');
    for (std::size_t i = columns_.first_row; i < cells_.rows.size(); ++i)
      for (const std::size_t column : {columns_.size, columns_.value})
        if (const std::optional<NumberCell> number = number_cell(cells_.rows[i].cell(column)))
          sign.see(number->digits);
    try {
      decimal_sign_ = sign.sign();
    } catch (const InputError &error) {
      source_.refuse(table_.header_line, error.what());
    }
  }

  void read_row() {
    if (cells_.rows[row_].below_gap && !table_.sizes.empty())
      below_gap_ = true;
    if (value_cell().empty() && number_cell(size_cell()))
      return read_unvalued();
    if (take_second_header() || take_total() || take_bare_pan() || take_text())
      return;
    if (table_.sizes.size() == max_gradation_rows)
      refuse(fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    if (other_header_)
      refuse(fmt::format(
          "the row of {} is below words that may begin another table: leave out what is none of the "
          "curve",
          in_quotes(size_cell())));
    check_width();
    const Rational size = row_size();
    table_.lines.push_back(line_of(row_));
    table_.sizes.push_back(size);
    read_value();
    for (const std::size_t column : {columns_.size, columns_.value})
      if (std::binary_search(cells_.long_numbers.begin(), cells_.long_numbers.end(),
                             std::pair(line_of(row_), column)))
        long_numbers_.add(cells_.rows[row_].cell(column));
  }

  /// A cell beyond the header is of no column: the row may be split in wrong places.
  void check_width() const {
    const std::vector<std::string> &cells = cells_.rows[row_].cells;
    for (std::size_t i = columns_.width; columns_.width != 0 && i < cells.size(); ++i)
      if (!cells[i].empty())
        refuse(fmt::format(
            "the row has more cells than the header, {}: {} is beyond: name its column, or put ; between "
            "cells where numbers have decimal commas",
            columns_.width, in_quotes(cells[i])));
  }

  /// A size without a value.
  void read_unvalued() {
    if (below_gap_)
      return leave();
    refuse(
        fmt::format("the size {} has no value in the column {}: write 0 where nothing was retained, or leave "
                    "the row out",
                    in_quotes(size_cell()), in_quotes(columns_.value_name)));
  }

  /// A header of the same kind below, such as that of a hydrometer's rows.
  bool take_second_header() {
    if (number_cell(value_cell()) || size_cell().empty())
      return false;
    const std::optional<TableColumns> next = columns_of_row(cells_, row_, further_reading(), source_);
    if (!next || reading_.columns)
      return false;
    if (next->values.meaning != columns_.values.meaning || next->values.unit != columns_.values.unit)
      refuse(fmt::format("a second table begins, with {} where the first has {}: leave one of them out",
                         in_quotes(next->value_name), in_quotes(columns_.value_name)));
    columns_.size = next->size;
    columns_.value = next->value;
    columns_.sizes = next->sizes;
    columns_.width = next->width;
    row_ = next->first_row - 1;
    below_gap_ = other_header_ = false;
    return true;
  }

  /// The unit that was asked for is that of the first header.
  Reading further_reading() const {
    Reading reading = reading_;
    if (!table_.sizes.empty())
      reading.unit.reset();
    return reading;
  }

  bool take_total() {
    if (!is_total_word(size_cell()) && !(size_cell().empty() && is_total_word(first_cell())))
      return false;
    if (const std::optional<NumberCell> number = number_cell(value_cell()))
      total_ = decimal(*number);
    leave();
    return true;
  }

  /// A pan without a value: nothing passes it, and all is retained down to it.
  bool take_bare_pan() {
    if (!is_pan_word(size_cell()) || !value_cell().empty() ||
        columns_.values.meaning == ColumnMeaning::retained)
      return false;
    leave();
    return true;
  }

  /// A size, or what looks like one and must not be overlooked: `<0.063`, `0.02*`.
  bool may_be_size() const {
    const std::string_view cell = size_cell();
    return is_range(cell) || (!cell.empty() && is_digit(cell.front())) || number_cell(cell) ||
           is_pan_word(cell) || is_sieve(cell);
  }

  static bool is_range(std::string_view cell) {
    return cell.starts_with('<') || cell.starts_with('>') || cell.starts_with("\u2264") ||
           cell.starts_with("\u2265");
  }

  /// A row that is none of the curve: words without a value, or anything below an empty row that has no size.
  bool take_text() {
    const bool is_size = may_be_size();
    if (is_size && number_cell(value_cell()))
      return false;
    if (!below_gap_ && (is_size || !value_cell().empty()))
      return false;
    other_header_ |= !size_cell().empty() && !value_cell().empty() && !number_cell(value_cell());
    leave();
    return true;
  }

  void leave() { left_.add(first_cell()); }

  bool is_sieve(std::string_view cell) const {
    try {
      sieve_opening(cell, decimal_sign_);
      return true;
    } catch (const InputError &) {
      return false;
    }
  }

  Rational decimal(const NumberCell &number) const {
    try {
      return parse_decimal(number.digits, decimal_sign_);
    } catch (const InputError &error) {
      refuse(error.what());
    }
  }

  /// The row's size in the unit of the table.
  Rational row_size() {
    const std::string_view cell = size_cell();
    if (is_pan_word(cell))
      return 0;
    if (is_range(cell))
      refuse(fmt::format(
          "the size {} is a range: write pan for what passes the finest sieve, and the opening of "
          "the sieve for what stays on it",
          in_quotes(cell)));
    const std::optional<NumberCell> number = number_cell(cell);
    if (number && number->unit == ColumnUnit::none)
      return plain_size(*number) / unit_in_mm_;
    try {
      return sieve_opening(cell, decimal_sign_) / unit_in_mm_;
    } catch (const InputError &error) {
      refuse(fmt::format("{}, or leave the row out", error.what()));
    }
  }

  /// mm of a size whose unit the header says.
  Rational plain_size(const NumberCell &number) {
    const ColumnUnit unit = columns_.sizes.unit;
    if (unit == ColumnUnit::none && columns_.sizes.meaning == ColumnMeaning::sieve)
      refuse(fmt::format(
          "the sieve {} is a number alone: write No. {} if it is one of ASTM, or say its unit with "
          "--unit mm (um, m, in, phi)",
          in_quotes(number.digits), printable(number.digits)));
    if (unit == ColumnUnit::none)
      refuse(fmt::format(
          "the size {} has no unit, and neither has the column {}: say it with --unit mm (um, m, in, "
          "phi)",
          in_quotes(number.digits), in_quotes(columns_.size_name)));
    const Rational size = decimal(number);
    if (unit != ColumnUnit::phi)
      return size * in_mm(unit);
    if (denominator(size) != 1 && reading_.phi == PhiReading::exact)
      refuse(fmt::format("phi {} is no whole number: {}, or write a canonical file with the column size_phi",
                         in_quotes(number.digits), convert_remedy));
    try {
      return phi_size(size);
    } catch (const InputError &error) {
      refuse(error.what());
    }
  }

  void read_value() {
    const std::optional<NumberCell> number = number_cell(value_cell());
    if (!number)
      refuse(
          fmt::format("{} in the column {} is not a number: write a decimal, or 0 where nothing was retained",
                      in_quotes(value_cell()), in_quotes(columns_.value_name)));
    if (number->unit != ColumnUnit::none && number->unit != columns_.values.unit) {
      if (columns_.values.unit != ColumnUnit::none ||
          (number->unit != ColumnUnit::percent && number->unit != ColumnUnit::mass))
        refuse(fmt::format("{} has another unit than the column {}: say what it is with --kind",
                           in_quotes(value_cell()), in_quotes(columns_.value_name)));
      columns_.values.unit = number->unit;
      unit_is_of_cells_ = true;
    }
    table_.values.push_back(decimal(*number));
    has_plain_ |= number->unit == ColumnUnit::none && table_.values.back() != 0;
    if (unit_is_of_cells_ && has_plain_)
      refuse(fmt::format(
          "some values in the column {} have a unit, as {} or others above, and some have none: write all "
          "alike",
          in_quotes(columns_.value_name), in_quotes(value_cell())));
    table_.roundings.push_back(last_digit_unit(number->digits, decimal_sign_) / 2);
  }

  void describe() {
    table_.format = cells_.format;
    table_.sizes_from = fmt::format("column {}, in {}", in_quotes(columns_.size_name), name(table_.unit));
    table_.masses_from = fmt::format("column {}: {}", in_quotes(columns_.value_name), table_.column->words);
    table_.is_canonical = false;
    table_.notes.insert(table_.notes.begin(),
                        fmt::format("Read as {}: sizes from {}; masses from {}.", table_.format,
                                    table_.sizes_from, table_.masses_from));
    if (columns_.sizes.unit == ColumnUnit::inch)
      table_.notes.emplace_back("Sizes in inches were converted to mm.");
    if (!columns_.others.empty()) {
      ShortList others;
      for (const std::string &other : columns_.others)
        others.add(other);
      table_.notes.push_back(
          fmt::format("Columns that were not used: {}; --columns chooses others.", others.text()));
    }
    if (!long_numbers_.empty())
      table_.notes.push_back(
          fmt::format("Cells that have no decimal of at most 15 digits were read as they are stored: "
                      "{}; see --round.",
                      long_numbers_.text()));
    if (!left_.empty())
      table_.notes.push_back(fmt::format("Rows that are no sizes were left out: {}.", left_.text()));
  }

  const Cells &cells_;
  TableColumns columns_;
  const Source &source_;
  const Reading &reading_;
  char decimal_sign_ = '.';
  Table table_;
  Rational unit_in_mm_ = 1;
  std::size_t row_ = 0;
  bool below_gap_ = false;
  bool other_header_ = false; ///< words below a gap, in both columns
  bool unit_is_of_cells_ = false;
  bool has_plain_ = false; ///< a value above 0 without a unit
  std::optional<Rational> total_;
  ShortList left_;
  ShortList long_numbers_; ///< of a workbook
};

} // namespace

void refuse_table(const Cells &cells, const Reading &reading, const Source &source) {
  const std::size_t line = cells.rows.empty() ? 1 : cells.rows.front().line;
  const std::string first = cells.rows.empty() ? "" : std::string(cells.rows.front().cell(0));
  if (reading.columns)
    source.refuse(
        line,
        fmt::format("--columns: no header has {}, and no row has numbers there; the file begins {}: give "
                    "names as they stand in the header, or numbers from 1 on{}",
                    in_quotes(*reading.columns), beginning_of(cells), cells.hint));
  source.refuse(line, fmt::format("{}; the file begins {}: {}{}",
                                  unknown_size_column(first, "size_mm,passing_percent"), beginning_of(cells),
                                  options, cells.hint));
}

Table read_lab_table(const Cells &cells, const Source &source, const std::string &id,
                     const Reading &reading) {
  std::optional<TableColumns> columns = find_columns(cells, reading, source);
  if (!columns)
    refuse_table(cells, reading, source);
  return LabTable(cells, std::move(*columns), source, id, reading).read();
}

} // namespace mdm

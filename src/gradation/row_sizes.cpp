#include "gradation/row_sizes.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/phi.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/shown.hpp"
#include "gradation/sieve_name.hpp"
#include "gradation/sieve_spelling.hpp"
#include "gradation/unit_break.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The unit that the table is kept in.
SizeUnit table_unit(ColumnUnit unit) {
  const SizeUnit length = length_of(unit).value_or(SizeUnit::mm);
  return length == SizeUnit::in ? SizeUnit::mm : length;
}

/// `> 4.75`: what stays on that sieve, where the other rows are ranges.
bool is_above(std::string_view cell) {
  return cell.starts_with('>') || cell.starts_with("\u2265");
}

bool is_above_or_below(std::string_view cell) {
  return is_above(cell) || cell.starts_with('<') || cell.starts_with("\u2264");
}

/// The digits of a number alone.
std::optional<std::string_view> plain_digits(std::string_view cell) {
  const std::optional<NumberCell> number = number_cell(cell);
  return number && number->unit == ColumnUnit::none ? std::optional(number->digits) : std::nullopt;
}

ColumnUnit unit_behind(std::string_view cell) {
  const std::optional<NumberCell> number = number_cell(cell);
  return number ? number->unit : ColumnUnit::none;
}

/// True for `No. 10`, `#10` and `10 mesh`.
bool is_numbered(std::string_view cell) {
  const std::string words = plain_words(cell);
  return cell.starts_with('#') || words.starts_with("no ") || words.starts_with("nr ") ||
         words.find("mesh") != std::string::npos;
}

/// True for a header of ASTM's sieves.
bool names_astm(std::string_view header) {
  return has_any_word("us usa astm e11", words_of(header)) || has_two_words("u", "s", words_of(header));
}

/// True for a header that speaks of sieves whose numbers are others than those of ASTM.
bool names_other_series(std::string_view header) {
  return has_any_word("bs british is indian nf afnor tyler din", words_of(header));
}

/// The same of sieves in a text beside the table: `Tyler standard screen scale`, `B.S. sieves`.
bool tells_other_sieves(const std::vector<std::string> &words) {
  return (has_any_word("bs british indian nf afnor tyler din bss imm", words) ||
          has_two_words("b", "s", words) || has_two_words("i", "m", words)) &&
         has_any_word("sieve sieves mesh screen screens scale series sieving tamis siebe siebsatz tamices",
                      words);
}

/// A series, or a standard that has one, in such a text: `Tyler`, `BS 1377`.
bool tells_other_series(const std::vector<std::string> &words) {
  const auto is_standard_of_bs = [](const std::string &word) {
    return word.size() > 2 && word.starts_with("bs") && is_digit(word[2]);
  };
  return has_any_word("tyler bss imm", words) || words == std::vector<std::string>{"bs"} ||
         has_two_words("bs", "410 812 1377 1796", words) ||
         std::any_of(words.begin(), words.end(), is_standard_of_bs);
}

/// `3/4`, `1-1/2`.
bool is_fraction(std::string_view cell) {
  return cell.find('/') != std::string_view::npos &&
         cell.find_first_not_of("0123456789/ -") == std::string_view::npos;
}

/// `Size range (mm)`, `Kornklasse [mm]`: of such a column a single size may be either end.
bool names_classes(std::string_view header) {
  return has_any_word(
      "range ranges class classes kornfraktion kornfraktionen kornklasse kornklassen korngruppe "
      "korngruppen",
      words_of(header));
}

std::string single_size_refusal(std::string_view cell) {
  return fmt::format("the size {} is a range: write pan for what passes the finest sieve, and the opening of "
                     "the sieve for what stays on it",
                     in_quotes(cell));
}

/// Sieves whose order breaks as where mm become um without a word.
void check_unit_break(const std::vector<Rational> &sizes, const std::vector<std::size_t> &lines,
                      const TableColumns &columns, const Source &source) {
  const ColumnUnit unit = columns.sizes.unit;
  const std::optional<std::size_t> at =
      unit == ColumnUnit::mm || unit == ColumnUnit::um ? unit_break(sizes) : std::nullopt;
  if (at)
    source.refuse(lines[*at],
                  fmt::format("the sizes {} and {} follow each other in the column {}: if some are um and "
                              "others mm, write the unit behind each, else put the rows in order",
                              shown(sizes[*at - 1]), shown(sizes[*at]), in_quotes(columns.size_name)));
}

} // namespace

RowSizes::RowSizes(const Cells &cells, const TableColumns &columns, const Reading &reading,
                   const TableSign &sign)
    : columns_(columns), reading_(reading), sign_(sign), unit_(table_unit(columns.sizes.unit)) {
  if (!names_astm(columns.size_name))
    find_series(cells);
  if (columns.sizes.unit == ColumnUnit::inch)
    for (std::size_t i = columns.first_row; i < cells.rows.size(); ++i) {
      const std::string_view cell = cells.rows[i].cell(columns.size);
      names_inches_ |= is_fraction(cell) || is_numbered(cell);
    }
}

/// Comments, lines above the table, and words below its header may tell it.
void RowSizes::find_series(const Cells &cells) {
  const auto look = [this](const CellRow &row, bool has_sizes) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string &cell = row.cells[i];
      const bool is_size = has_sizes && i == columns_.size && is_numbered(cell) && has_digit(cell);
      if (is_size || number_cell(cell))
        continue;
      const std::vector<std::string> words = words_of(cell);
      const bool is_of_sieves = tells_other_sieves(words);
      if (is_of_sieves || (!is_of_sieves_ && tells_other_series(words)))
        series_ = cell;
      is_of_sieves_ |= is_of_sieves;
    }
  };
  for (const CellRow &comment : cells.comments)
    look(comment, false);
  for (std::size_t i = 0; i < cells.rows.size(); ++i)
    if (i < columns_.above || i >= columns_.first_row)
      look(cells.rows[i], i >= columns_.first_row);
}

std::string RowSizes::file_unit() const {
  return columns_.sizes.unit == ColumnUnit::inch  ? "inches"
         : columns_.sizes.unit == ColumnUnit::phi ? "phi"
                                                  : "";
}

bool RowSizes::may_be_size(std::string_view cell) const {
  return is_above_or_below(cell) || (!cell.empty() && is_digit(cell.front())) || number_cell(cell) ||
         is_sieve(cell);
}

bool RowSizes::is_size(std::string_view cell) const {
  try {
    size_of(cell, ColumnUnit::none);
    return true;
  } catch (const InputError &) {
    return false;
  }
}

Rational RowSizes::next(const CellRow &row) {
  const Rational size = row_size(row.cell(columns_.size));
  check_names(row, size);
  ++rows_;
  return size;
}

Rational RowSizes::named(std::string_view sieve) const {
  return size_of(sieve, ColumnUnit::none);
}

void RowSizes::settle(Table &table, bool are_retained, const Source &source) const {
  std::vector<std::size_t> lines;
  for (const std::size_t row : plain_rows_)
    lines.push_back(table.lines[row]);
  check_unit_break(plain_sizes_, lines, columns_, source);
  if (columns_.sizes.unit == ColumnUnit::mm && !reading_.unit && may_be_micrometres(plain_sizes_))
    source.refuse(lines.front(),
                  fmt::format("the column {} is in mm, and its sizes are those of sieves in um: say {} mm "
                              "if they are mm, else correct the header",
                              in_quotes(columns_.size_name), option("unit")));
  if (columns_.sizes.unit == ColumnUnit::inch)
    table.notes.emplace_back(names_inches_ ? "Sizes in inches are the openings of ASTM's sieves of that "
                                             "name: 1 in is 25 mm; others were converted to mm."
                                           : "Sizes in inches were converted to mm.");
  if (above_ && ranges_.empty())
    source.refuse(table.lines[above_->row], single_size_refusal(above_->cell));
  if (names_classes(columns_.size_name) && ranges_.empty())
    source.refuse(
        table.header_line,
        fmt::format("the column {} is of classes, and its cells are single sizes: write both ends of "
                    "each, or 'Sieve size' with the unit for the sieves on which the masses stay",
                    in_quotes(columns_.size_name)));
  ranges_.settle(table, are_retained, source);
}

Rational RowSizes::row_size(std::string_view cell) {
  if (cell == date_cell)
    throw InputError("a date stands where a sieve belongs, as a spreadsheet makes one of 3/8: make the cell "
                     "text and write it again, 3/8 in");
  const bool passes = cell.size() > 1 && cell.front() == '-' && (is_digit(cell[1]) || cell[1] == '.');
  const std::size_t behind_sign = cell.find_first_not_of(">=\u2265");
  if (is_above(cell) && behind_sign != std::string_view::npos && !above_) {
    above_ = Above{rows_, std::string(cell)};
    return size_of(without_spaces(cell.substr(behind_sign)), ColumnUnit::none);
  }
  if (is_above_or_below(cell) || (passes && columns_.sizes.unit != ColumnUnit::phi))
    throw InputError(single_size_refusal(cell));
  if (const auto ends = range_ends(cell); ends && !is_sieve(cell) && columns_.sizes.unit != ColumnUnit::phi) {
    const Rational second = size_of(ends->second, ColumnUnit::none);
    ranges_.add(rows_, size_of(ends->first, unit_behind(ends->second)), second);
    return ranges_.lower();
  }
  const Rational size = size_of(cell, ColumnUnit::none);
  if (const std::optional<std::string_view> digits = plain_digits(cell); digits && !has_own_unit_) {
    plain_rows_.push_back(rows_);
    plain_sizes_.push_back(sign_.decimal(*digits));
  }
  return size;
}

/// `unit` is that of the other end of a range.
Rational RowSizes::size_of(std::string_view cell, ColumnUnit unit) const {
  if (const std::optional<std::string_view> digits = plain_digits(cell))
    return unit == ColumnUnit::none ? plain_size(*digits) : in_unit(*digits, unit);
  if (is_fraction(cell) && columns_.sizes.unit == ColumnUnit::inch)
    return opening(std::string(cell) + " in");
  try {
    return opening(cell);
  } catch (const InputError &error) {
    throw InputError(
        fmt::format("{}, or {}", error.what(),
                    has_digit(cell) ? "leave the row out" : "Pan for what passed the finest sieve"));
  }
}

/// A size whose unit the header says.
Rational RowSizes::plain_size(std::string_view digits) const {
  const ColumnUnit unit = columns_.sizes.unit;
  if (unit == ColumnUnit::none && columns_.sizes.meaning == ColumnMeaning::sieve)
    throw InputError(
        fmt::format("the sieve {} is a number alone: write No. {} if it is one of ASTM, or say its unit with "
                    "{} mm (um, m, in, phi)",
                    in_quotes(digits), printable(digits), option("unit")));
  if (unit == ColumnUnit::none)
    throw InputError(
        fmt::format("the size {} has no unit, and neither has the column {}: say it with {} mm (um, m, "
                    "in, phi)",
                    in_quotes(digits), in_quotes(columns_.size_name), option("unit")));
  if (names_inches_ && unit == ColumnUnit::inch)
    if (const std::optional<std::string> name = astm_inch_name(sign_.decimal(digits)))
      return opening(*name);
  if (unit != ColumnUnit::phi)
    return in_unit(digits, unit);
  const Rational phi = sign_.decimal(digits);
  if (denominator(phi) != 1 && reading_.phi == PhiReading::exact)
    throw InputError(
        fmt::format("phi {} is no whole number: {}, or write a canonical file with the column size_phi",
                    in_quotes(digits), convert_remedy));
  return phi_size(phi) / in_mm(unit_);
}

/// The size in another column must be of the same sieve: within what nominal openings and inches differ.
void RowSizes::check_names(const CellRow &row, const Rational &size) const {
  for (const FurtherColumn &column : columns_.names) {
    const std::string_view cell = row.cell(column.place);
    const std::optional<Rational> other = other_size(cell, column.meaning.unit);
    if (other && size > 0 && abs(Rational(*other - size)) > size * ratio(3, 100))
      throw InputError(fmt::format("{} in the column {} is another sieve than {} in {}: correct one of them",
                                   in_quotes(cell), in_quotes(column.name),
                                   in_quotes(row.cell(columns_.size)), in_quotes(columns_.size_name)));
  }
}

/// Nothing where the cell says no size.
std::optional<Rational> RowSizes::other_size(std::string_view cell, ColumnUnit unit) const {
  try {
    const std::optional<std::string_view> digits = plain_digits(cell);
    if (!digits)
      return other_opening(cell);
    if (unit == ColumnUnit::none && cell != std::to_string(rows_ + 1)) // which counts the rows
      return other_opening("No. " + std::string(*digits));
    if (unit == ColumnUnit::phi)
      return phi_size(sign_.decimal(*digits)) / in_mm(unit_);
    if (is_of_sizes(unit))
      return in_unit(*digits, unit);
  } catch (const InputError &) { // a name that is not known says nothing else
  }
  return std::nullopt;
}

bool RowSizes::is_sieve(std::string_view cell) const {
  try {
    opening(cell);
    return true;
  } catch (const InputError &) {
    return false;
  }
}

/// The opening of a sieve by its name; a number that stands with its opening must be the one of ASTM.
Rational RowSizes::opening(std::string_view cell) const {
  const std::string &series = names_other_series(columns_.size_name) ? columns_.size_name : series_;
  if (is_numbered(cell) && !series.empty() && !has_any_word("mm um micron microns", words_of(cell)))
    throw InputError(fmt::format("{} beside {} may not be a sieve of ASTM, whose numbers are known: "
                                 "write its opening with its unit",
                                 in_quotes(cell), in_quotes(series)));
  return spelled_sieve_opening(cell, sign_.in(cell)) / in_mm(unit_);
}

/// The same of a sieve beside the size: a standard's number above says nothing of it.
Rational RowSizes::other_opening(std::string_view cell) const {
  const bool is_known = is_of_sieves_ || names_other_series(columns_.size_name);
  return is_known ? opening(cell) : spelled_sieve_opening(cell, sign_.in(cell)) / in_mm(unit_);
}

/// So many of a unit of length.
Rational RowSizes::in_unit(std::string_view digits, ColumnUnit unit) const {
  return sign_.decimal(digits) * in_mm(length_of(unit).value_or(SizeUnit::mm)) / in_mm(unit_);
}

} // namespace mdm

#include "gradation/lab_table.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/csv_rows.hpp"
#include "gradation/lab_accounts.hpp"
#include "gradation/lab_values.hpp"
#include "gradation/number_shares.hpp"
#include "gradation/shown.hpp"
#include "gradation/weighed_sieves.hpp"
#include "gradation/words_above.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// A column by its header, or by its number where it has none.
std::string shown_column(const std::string &header, std::size_t place) {
  return header.empty() ? std::to_string(place + 1) : in_quotes(header);
}

/// What was read, with the names of the columns.
void describe_columns(Table &table, const TableColumns &columns, const std::string &format) {
  table.format = format;
  table.sizes_from =
      fmt::format("column {}, in {}", shown_column(columns.size_name, columns.size),
                  table.file_unit.empty() ? name(table.unit) : std::string_view(table.file_unit));
  table.masses_from =
      fmt::format("column {}: {}", shown_column(columns.value_name, columns.value), table.column->words);
  table.is_canonical = false;
  table.notes.insert(table.notes.begin(), fmt::format("Read as {}: sizes from {}; masses from {}.",
                                                      table.format, table.sizes_from, table.masses_from));
}

/// Sieves have no openings of metres, and no stone for which there is a class has a size of so many.
void check_coarsest_opening(const Table &table, const TableColumns &columns, const Reading &reading,
                            const Source &source) {
  const Rational limit = 2500; // mm
  if (reading.unit || table.root != 1)
    return;
  const auto coarsest = std::max_element(table.sizes.begin(), table.sizes.end());
  if (coarsest == table.sizes.end() || *coarsest * in_mm(table.unit) <= limit)
    return;
  source.refuse(
      table.lines[static_cast<std::size_t>(coarsest - table.sizes.begin())],
      fmt::format("the header {} gives an opening of {}: correct the unit in it, or say {} {} if it "
                  "is right",
                  in_quotes(columns.size_name), shown(*coarsest, table.unit), option("unit"),
                  name(table.unit)));
}

/// Columns, cells and rows that were not read, or not as they are shown.
void describe_rest(Table &table, const LabRows &rows) {
  ShortList others;
  for (const FurtherColumn &column : rows.columns.names)
    others.add(column.name);
  for (const UnusedColumn &other : rows.columns.others)
    if (!other.name.empty())
      others.add(other.name);
  if (!others.empty())
    table.notes.push_back(
        fmt::format("Columns that were not used: {}; {} chooses others.", others.text(), option("columns")));
  for (const std::size_t line : rows.further_headers)
    table.notes.push_back(fmt::format(
        "The rows below a second header, in line {}, were read as those of the same sample.", line));
  if (!rows.long_numbers.empty())
    table.notes.push_back(
        fmt::format("Cells that have no decimal of at most 15 digits were read as they are stored: "
                    "{}; see {}.",
                    rows.long_numbers.text(), option("round")));
  if (!rows.hidden.empty())
    table.notes.push_back(fmt::format("Rows that the sheet hides were read too: {}.", rows.hidden.text()));
  if (!rows.errors.empty())
    table.notes.push_back(fmt::format(
        "Cells with an error of the spreadsheet were not compared, in the rows {}.", rows.errors.text()));
  if (rows.out_of_order)
    table.notes.push_back(fmt::format("The sieve in line {} is out of the order of the others: look whether "
                                      "its size is right.",
                                      *rows.out_of_order));
  if (!rows.left.empty())
    table.notes.push_back(fmt::format("Rows that are no sizes were left out: {}.", rows.left.text()));
}

/// A column of sizes in a row of headers.
struct SizeHeader {
  std::size_t place;
  bool is_known; ///< by its words; else its unit alone says that it may be one, beside a column of values
};

/// The column of sizes in a row of headers, or one in a unit of sizes beside one of values; nothing where it
/// has none, or those of canonical CSV are meant.
std::optional<SizeHeader> size_header(const CellRow &row) {
  std::optional<std::size_t> size, in_unit;
  bool has_values = false;
  std::size_t words = 0;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const std::string &cell = row.cells[i];
    if (number_cell(cell) || cell.find('_') != std::string::npos)
      return std::nullopt;
    words += cell.empty() ? 0U : 1U;
    const std::optional<HeaderMeaning> meaning = header_meaning(cell);
    if (meaning && holds_sizes(*meaning))
      size = i;
    else if (meaning)
      has_values = true;
    else if (!in_unit && is_of_sizes(unit_in_header(cell)))
      in_unit = i;
  }
  const std::optional<std::size_t> place = size ? size : has_values ? in_unit : std::nullopt;
  return words > 1 && place ? std::optional(SizeHeader{*place, size.has_value()}) : std::nullopt;
}

/// `Refus (g)` of old sheets is cumulative, of newer ones not.
void refuse_unclear_column(const CellRow &header, const Source &source) {
  for (const std::string &cell : header.cells)
    if (const std::optional<HeaderMeaning> meaning = header_meaning(cell); meaning && meaning->is_unclear)
      source.refuse(header.line,
                    fmt::format("{} may be what each sieve retains, or what all coarser ones retain "
                                "too: say {} retained or {} cumulative",
                                in_quotes(cell), option("kind"), option("kind")));
}

/// A table above the one that is read must not be passed over.
void refuse_table_above(const Cells &cells, const TableColumns &columns, const Source &source) {
  for (std::size_t i = 0; i < columns.above; ++i)
    if (const std::optional<SizeHeader> size = size_header(cells.rows[i]))
      for (std::size_t below = i + 1; below < columns.above && !cells.rows[below].below_gap; ++below)
        if (number_cell(cells.rows[below].cell(size->place)))
          source.refuse(
              cells.rows[i].line,
              fmt::format("a table with {} begins here and is not read, as its header is not known: correct "
                          "the header, or leave the table out for that of line {}",
                          in_quotes(cells.rows[i].cells[size->place]), cells.rows[columns.above].line));
}

} // namespace

void refuse_table(const Cells &cells, const Reading &reading, const Source &source) {
  if (reading.skip && cells.rows.empty())
    source.refuse(1, fmt::format("{} {} leaves out all that is written in the file: give fewer lines",
                                 option("skip"), *reading.skip));
  const std::size_t line = cells.rows.empty() ? 1 : cells.rows.front().line;
  const std::string first = cells.rows.empty() ? "" : std::string(cells.rows.front().cell(0));
  if (reading.columns)
    source.refuse(
        line, fmt::format("{}: no header has {}, and no row has numbers there; the file begins {}: give "
                          "names as they stand in the header, or numbers from 1 on{}",
                          option("columns"), in_quotes(*reading.columns), beginning_of(cells), cells.hint));
  for (const CellRow &row : cells.rows)
    if (const std::optional<WeighedSieves> sieves = weighed_sieves(row))
      source.refuse(row.line,
                    fmt::format("{} and {} are the sieves with what they retain and empty, and no column has "
                                "what they retain: add one with the difference",
                                in_quotes(row.cells[sieves->full]), in_quotes(row.cells[sieves->empty])));
  for (const CellRow &row : cells.rows)
    if (const std::optional<SizeHeader> size = size_header(row)) {
      refuse_unclear_column(row, source);
      if (!size->is_known)
        source.refuse(
            row.line,
            fmt::format("{} is not known to be a column of sieves: write 'Sieve size' with the unit "
                        "in brackets, or {}{}",
                        in_quotes(row.cells[size->place]), column_options(), cells.hint));
      source.refuse(row.line,
                    fmt::format("beside {} no column is known to hold what is retained or passes: {}{}",
                                in_quotes(row.cells[size->place]), column_options(), cells.hint));
    }
  source.refuse(line, fmt::format("{}; the file begins {}: {}{}",
                                  unknown_size_column(first, "size_mm,passing_percent"), beginning_of(cells),
                                  column_options(), cells.hint));
}

Table read_lab_table(const Cells &cells, const Source &source, const std::string &id,
                     const Reading &reading) {
  std::optional<TableColumns> columns = find_columns(cells, reading, source);
  if (!columns)
    refuse_table(cells, reading, source);
  refuse_number_shares(cells, columns->above, source);
  check_comments(cells, *columns, source);
  check_words_of_units(cells, *columns, source);
  if (!reading.columns && !reading.kind)
    check_words_of_sums(cells, *columns, source);
  if (!reading.columns)
    refuse_table_above(cells, *columns, source);
  LabRows rows = read_lab_rows(cells, std::move(*columns), reading, source);
  const ComparedValues compared = settle_values(rows, reading, source);
  Table &table = rows.table;
  table.id = id;
  check_coarsest_opening(table, rows.columns, reading, source);
  settle_lab_values(table, {rows.columns.values, rows.columns.value_name, compared.are_confirmed}, reading,
                    source);
  describe_columns(table, rows.columns, cells.format);
  table.notes.insert(table.notes.end(), compared.notes.begin(), compared.notes.end());
  describe_rest(table, rows);
  return std::move(rows.table);
}

} // namespace mdm

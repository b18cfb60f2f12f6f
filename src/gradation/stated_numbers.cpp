#include "gradation/stated_numbers.hpp"

#include "gradation/header_words.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// Units below labels go to them: `Dry mass,Wash loss` above `(g),(g)`. Nothing where the row below has none.
std::optional<CellRow> with_units_below(const CellRow &row, const CellRow &below) {
  CellRow labels = row;
  bool has_units = false;
  for (std::size_t i = 0; i < below.cells.size(); ++i) {
    const std::string &unit = below.cells[i];
    if (unit.empty())
      continue;
    if (unit_of_words(unit) == ColumnUnit::none || row.cell(i).empty())
      return std::nullopt;
    labels.cells[i] += " " + unit;
    has_units = true;
  }
  return has_units ? std::optional(std::move(labels)) : std::nullopt;
}

/// True for words that may be about what passes the finest sieve, and are not known.
bool may_pass_finest(const MassStatement &s) {
  return s.meaning == RowMeaning::none &&
         (s.is_sentence || (speaks_of_washing(s.label) && !names_washed_part(s.label)) ||
          may_be_fines(s.label));
}

/// Refuses what may be a mass of the table.
void check_outside(const MassStatement &s, const Source &source) {
  const bool is_washed_fines = speaks_of_washing(s.label) && may_be_fines(s.label) && !s.is_percent;
  if (may_pass_finest(s) && (s.grams != 0 || s.is_sentence || is_washed_fines))
    source.refuse(s.line,
                  fmt::format("{} may be what passes the finest sieve: write Wash loss, or a row Pan, if "
                              "it is, else leave it out",
                              in_quotes(s.label)));
  if (s.meaning == RowMeaning::none && s.grams != 0 && speaks_of_retaining(s.label))
    source.refuse(s.line,
                  fmt::format("{} is a mass on a sieve, outside the table: write it as a row of the table, "
                              "or leave it out",
                              in_quotes(s.label)));
}

} // namespace

CellRow beside_columns(CellRow row, const TableColumns &columns) {
  std::vector<std::size_t> known{columns.size, columns.value};
  for (const std::vector<FurtherColumn> *list : {&columns.further, &columns.names})
    for (const FurtherColumn &column : *list)
      known.push_back(column.place);
  for (const std::size_t place : known)
    if (place < row.cells.size())
      row.cells[place].clear();
  return row;
}

std::vector<MassStatement> statements_above(const Cells &cells, const TableColumns &columns) {
  std::vector<MassStatement> statements;
  for (std::size_t i = 0; i < columns.above; ++i) {
    const CellRow *const next = i + 1 < columns.above ? &cells.rows[i + 1] : nullptr;
    const std::optional<CellRow> labels = next ? with_units_below(cells.rows[i], *next) : std::nullopt;
    if (labels && i + 2 < columns.above)
      add_statements(*labels, &cells.rows[i + 2], statements);
    else
      add_statements(cells.rows[i], next, statements);
  }
  for (std::size_t i = columns.above; i < columns.first_row; ++i)
    add_statements(beside_columns(cells.rows[i], columns), nullptr, statements);
  return statements;
}

std::vector<StatedNumber> stated_numbers(const std::vector<MassStatement> &statements, const TableSign &sign,
                                         std::size_t header_line, ShortList &left, const Source &source) {
  std::vector<StatedNumber> numbers;
  for (const MassStatement &s : statements) {
    check_outside(s, source);
    if (s.meaning != RowMeaning::none && names_other_mass(s.label))
      source.refuse(s.line, fmt::format("{} is in a unit of mass that is not read: write it in g or kg",
                                        in_quotes(s.label)));
    if (!s.further_digits.empty())
      source.refuse(s.line,
                    fmt::format("{} has the numbers {} and {}, which may be one: write it without a "
                                "comma, or leave one out",
                                in_quotes(s.label), in_quotes(s.digits), in_quotes(s.further_digits)));
    if (may_pass_finest(s) && !s.is_percent && s.line < header_line)
      left.add(s.label);
    try {
      numbers.push_back({s, printed_number(s.digits, sign.in(s.digits))});
    } catch (const InputError &error) {
      if (s.meaning != RowMeaning::none || speaks_of_washing(s.label))
        source.refuse(s.line, fmt::format("{}: {}", in_quotes(s.label), error.what()));
    }
  }
  return numbers;
}

} // namespace mdm

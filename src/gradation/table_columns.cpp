#include "gradation/table_columns.hpp"

#include "gradation/cell_numbers.hpp"
#include "text/lines.hpp"
#include "text/nearest_name.hpp"

#include <mdm/number/integer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

struct Kind {
  std::string_view name;
  HeaderMeaning meaning;
};
constexpr std::array<Kind, 10> kinds = {{
    {"passing", {ColumnMeaning::passing, ColumnUnit::none}},
    {"retained", {ColumnMeaning::retained, ColumnUnit::none}},
    {"cumulative", {ColumnMeaning::cumulative, ColumnUnit::none}},
    {"mass", {ColumnMeaning::retained, ColumnUnit::mass}},
    {"retained_g", {ColumnMeaning::retained, ColumnUnit::mass}},
    {"retained_percent", {ColumnMeaning::retained, ColumnUnit::percent}},
    {"retained_fraction", {ColumnMeaning::retained, ColumnUnit::fraction}},
    {"cumulative_retained_percent", {ColumnMeaning::cumulative, ColumnUnit::percent}},
    {"passing_percent", {ColumnMeaning::passing, ColumnUnit::percent}},
    {"passing_fraction", {ColumnMeaning::passing, ColumnUnit::fraction}},
}};
constexpr std::array<Kind, 6> size_units = {{
    {"mm", {ColumnMeaning::size, ColumnUnit::mm}},
    {"um", {ColumnMeaning::size, ColumnUnit::um}},
    {"m", {ColumnMeaning::size, ColumnUnit::m}},
    {"in", {ColumnMeaning::size, ColumnUnit::inch}},
    {"phi", {ColumnMeaning::size, ColumnUnit::phi}},
    {"sieve", {ColumnMeaning::sieve, ColumnUnit::none}},
}};

template <std::size_t n>
std::optional<HeaderMeaning> asked(const std::string &option, const std::optional<std::string> &text,
                                   const std::array<Kind, n> &table) {
  if (!text)
    return std::nullopt;
  std::vector<std::string_view> names;
  for (const Kind &kind : table) {
    if (kind.name == *text)
      return kind.meaning;
    names.push_back(kind.name);
  }
  throw InputError(fmt::format("{}: {} is none of {}", option, in_quotes(*text), fmt::join(names, ", ")));
}

/// The two names or numbers of `--columns`.
std::array<std::string_view, 2> asked_names(const std::string &columns) {
  const std::size_t comma = columns.find(',');
  if (comma == std::string::npos || columns.find(',', comma + 1) != std::string::npos)
    throw InputError("--columns: " + in_quotes(columns) +
                     " is not two columns with a comma between them: give names, or numbers such as 1,3");
  const std::string_view all = columns;
  return {without_spaces(all.substr(0, comma)), without_spaces(all.substr(comma + 1))};
}

/// The place of a column of that number, from 1 on.
std::optional<std::size_t> numbered_place(std::string_view name) {
  const std::optional<Integer> number = parse_natural(name);
  if (!number || *number < 1 || *number > max_fields)
    return std::nullopt;
  return static_cast<std::size_t>(*number) - 1;
}

std::optional<std::size_t> named_place(const CellRow &row, std::string_view name) {
  const auto found = std::find(row.cells.begin(), row.cells.end(), name);
  if (found == row.cells.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - row.cells.begin());
}

/// How far a column of that meaning is from what is best taken; the smallest is.
unsigned rank(const HeaderMeaning &m) {
  switch (m.meaning) {
  case ColumnMeaning::size:
    return m.unit == ColumnUnit::inch || m.unit == ColumnUnit::phi ? 2 : m.unit == ColumnUnit::none ? 3 : 0;
  case ColumnMeaning::sieve:
    return m.unit == ColumnUnit::none ? 4 : 1;
  case ColumnMeaning::retained:
    return m.unit == ColumnUnit::percent || m.unit == ColumnUnit::fraction ? 3 : 0;
  case ColumnMeaning::passing:
    return 1;
  case ColumnMeaning::cumulative:
    return 2;
  }
  return 0;
}

bool holds_sizes(const HeaderMeaning &m) {
  return m.meaning == ColumnMeaning::size || m.meaning == ColumnMeaning::sieve;
}

/// A column that a header gives a meaning.
struct Known {
  std::size_t place;
  HeaderMeaning meaning;
};

/// Adds the names of the columns that are not used. \pre size and value are set
void add_others(TableColumns &columns, const CellRow &header) {
  for (std::size_t i = 0; i < header.cells.size(); ++i)
    if (i != columns.size && i != columns.value && !header.cells[i].empty())
      columns.others.push_back(header.cells[i]);
}

/// The best of several columns with one purpose; its place in `all` is moved to the front.
void bring_best_to_front(std::vector<Known> &all, const CellRow &row, const Source &source) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Known &a, const Known &b) { return rank(a.meaning) < rank(b.meaning); });
  if (all.size() > 1 && rank(all[0].meaning) == rank(all[1].meaning))
    source.refuse(row.line,
                  fmt::format("the columns {} and {} have one meaning: choose with --columns SIZE,VALUE",
                              in_quotes(row.cell(all[0].place)), in_quotes(row.cell(all[1].place))));
}

/// True for a row of units below a header.
bool is_unit_row(const CellRow &row, std::size_t size, std::size_t value) {
  return (unit_of_words(row.cell(size)) != ColumnUnit::none ||
          unit_of_words(row.cell(value)) != ColumnUnit::none) &&
         !number_cell(row.cell(size)) && !number_cell(row.cell(value));
}

/// Takes the units of the row below a header, if there is such a row.
void take_unit_row(const Cells &cells, TableColumns &columns) {
  if (columns.first_row >= cells.rows.size() ||
      !is_unit_row(cells.rows[columns.first_row], columns.size, columns.value))
    return;
  const CellRow &row = cells.rows[columns.first_row];
  if (columns.sizes.unit == ColumnUnit::none)
    columns.sizes.unit = unit_of_words(row.cell(columns.size));
  if (columns.values.unit == ColumnUnit::none)
    columns.values.unit = unit_of_words(row.cell(columns.value));
  ++columns.first_row;
}

/// What the options say in place of the header.
void apply_options(TableColumns &columns, const Reading &reading) {
  if (const std::optional<HeaderMeaning> kind = asked_kind(reading)) {
    if (kind->unit != ColumnUnit::none)
      columns.values.unit = kind->unit;
    columns.values.meaning = kind->meaning;
  }
  if (const std::optional<HeaderMeaning> unit = asked_unit(reading))
    columns.sizes = *unit;
}

/// What an asked column holds: what its header says, or else the option.
HeaderMeaning meaning_of(std::string_view header, bool sizes, const std::optional<HeaderMeaning> &asked,
                         std::string_view option) {
  const std::optional<HeaderMeaning> words = header_meaning(header);
  if (words && holds_sizes(*words) == sizes)
    return *words;
  if (asked)
    return *asked;
  if (const ColumnUnit unit = unit_in_header(header); sizes && is_of_sizes(unit))
    return {ColumnMeaning::size, unit};
  throw InputError(fmt::format("--columns: {} does not say what the column of {} holds: add {}",
                               header.empty() ? "no header" : in_quotes(header), sizes ? "sizes" : "masses",
                               option));
}

TableColumns asked_columns(const CellRow *header, std::size_t size, std::size_t value,
                           const Reading &reading) {
  TableColumns columns;
  columns.size = size;
  columns.value = value;
  if (size == value)
    throw InputError("--columns: " + in_quotes(*reading.columns) + " names one column twice");
  if (header != nullptr) {
    columns.size_name = header->cell(size);
    columns.value_name = header->cell(value);
    columns.width = header->cells.size();
    add_others(columns, *header);
  }
  columns.sizes =
      meaning_of(columns.size_name, true, asked_unit(reading), "--unit mm, or um, m, in, phi, sieve");
  columns.values =
      meaning_of(columns.value_name, false, asked_kind(reading),
                 "--kind passing, or retained, cumulative, or the name of a column of canonical CSV");
  return columns;
}

/// The columns that --columns names, where `row` is their header; or, by numbers, the first row of the table,
/// of which the row above may be the header.
std::optional<TableColumns> asked_columns(const Cells &cells, std::size_t row, const Reading &reading) {
  const CellRow &here = cells.rows[row];
  const auto [size_name, value_name] = asked_names(*reading.columns);
  const std::optional<std::size_t> first = numbered_place(size_name), second = numbered_place(value_name);
  if (first && second) {
    if (!number_cell(here.cell(*second)) || here.cell(*first).empty())
      return std::nullopt;
    std::size_t above = row;
    while (above > 0 && is_unit_row(cells.rows[above - 1], *first, *second))
      --above;
    TableColumns columns =
        asked_columns(above > 0 ? &cells.rows[above - 1] : nullptr, *first, *second, reading);
    columns.first_row = above;
    return columns;
  }
  const std::optional<std::size_t> size = first ? first : named_place(here, size_name);
  const std::optional<std::size_t> value = second ? second : named_place(here, value_name);
  if (!size || !value)
    return std::nullopt;
  TableColumns columns = asked_columns(&here, *size, *value, reading);
  columns.first_row = row + 1;
  return columns;
}

/// The columns by their words; with --kind, a second column of any name may hold the values.
std::optional<TableColumns> known_columns(const CellRow &row, const Reading &reading, const Source &source) {
  std::vector<Known> sizes, values;
  for (std::size_t i = 0; i < row.cells.size(); ++i)
    if (const std::optional<HeaderMeaning> meaning = header_meaning(row.cells[i]))
      (holds_sizes(*meaning) ? sizes : values).push_back({i, *meaning});
  const std::optional<HeaderMeaning> kind = asked_kind(reading);
  if (kind)
    values.erase(std::remove_if(values.begin(), values.end(),
                                [&kind](const Known &k) { return k.meaning.meaning != kind->meaning; }),
                 values.end());
  if (kind && values.empty() && sizes.size() == 1 && row.cells.size() == 2)
    values.push_back({1 - sizes[0].place, *kind});
  if (sizes.empty() || values.empty())
    return std::nullopt;
  bring_best_to_front(sizes, row, source);
  bring_best_to_front(values, row, source);
  TableColumns columns;
  columns.size = sizes[0].place;
  columns.value = values[0].place;
  columns.sizes = sizes[0].meaning;
  columns.values = values[0].meaning;
  columns.size_name = row.cell(columns.size);
  columns.value_name = row.cell(columns.value);
  columns.width = row.cells.size();
  add_others(columns, row);
  return columns;
}

} // namespace

std::optional<HeaderMeaning> asked_kind(const Reading &reading) {
  return asked("--kind", reading.kind, kinds);
}

std::optional<HeaderMeaning> asked_unit(const Reading &reading) {
  return asked("--unit", reading.unit, size_units);
}

std::optional<TableColumns> columns_of_row(const Cells &cells, std::size_t row, const Reading &reading,
                                           const Source &source) {
  std::optional<TableColumns> columns;
  if (reading.columns) {
    columns = asked_columns(cells, row, reading);
  } else {
    columns = known_columns(cells.rows[row], reading, source);
    if (columns)
      columns->first_row = row + 1;
  }
  if (!columns)
    return std::nullopt;
  take_unit_row(cells, *columns);
  apply_options(*columns, reading);
  return columns;
}

std::optional<TableColumns> find_columns(const Cells &cells, const Reading &reading, const Source &source) {
  asked_kind(reading); // what is wrong with the options comes first
  asked_unit(reading);
  for (std::size_t row = 0; row < cells.rows.size(); ++row)
    if (std::optional<TableColumns> columns = columns_of_row(cells, row, reading, source))
      return columns;
  return std::nullopt;
}

} // namespace mdm

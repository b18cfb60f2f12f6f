#include "gradation/table_columns.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/column_words.hpp"
#include "gradation/limit_columns.hpp"
#include "gradation/mass_statements.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_words.hpp"
#include "gradation/unread_columns.hpp"
#include "gradation/weighed_sieves.hpp"
#include "gradation/words_above.hpp"
#include "text/lines.hpp"
#include "text/nearest_name.hpp"
#include "text/option_name.hpp"

#include <mdm/number/integer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

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
std::optional<HeaderMeaning> asked(std::string_view name, const std::optional<std::string> &text,
                                   const std::array<Kind, n> &table) {
  if (!text)
    return std::nullopt;
  std::vector<std::string_view> names;
  for (const Kind &kind : table) {
    if (kind.name == *text)
      return kind.meaning;
    names.push_back(kind.name);
  }
  throw InputError(
      fmt::format("{}: {} is none of {}", option(name), in_quotes(*text), fmt::join(names, ", ")));
}

/// The two names or numbers of `--columns`.
std::array<std::string_view, 2> asked_names(const std::string &columns) {
  const std::size_t comma = columns.find(',');
  if (comma == std::string::npos || columns.find(',', comma + 1) != std::string::npos)
    throw InputError(option("columns") + ": " + in_quotes(columns) +
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

bool is_share(ColumnUnit unit) {
  return unit == ColumnUnit::percent || unit == ColumnUnit::fraction;
}

/// How far a column of that meaning is from what is best taken; the smallest is.
unsigned rank(const HeaderMeaning &m) {
  switch (m.meaning) {
  case ColumnMeaning::size:
    return m.unit == ColumnUnit::inch || m.unit == ColumnUnit::phi ? 2 : m.unit == ColumnUnit::none ? 3 : 0;
  case ColumnMeaning::sieve:
    return m.unit == ColumnUnit::none ? 4 : 1;
  case ColumnMeaning::retained:
    return is_share(m.unit) ? 4 : 0;
  case ColumnMeaning::passing:
    return m.unit == ColumnUnit::mass ? 5 : 1;
  case ColumnMeaning::cumulative:
    return is_share(m.unit) ? 3 : 2;
  }
  return 0;
}

/// A column that a header gives a meaning.
struct Known {
  std::size_t place;
  HeaderMeaning meaning;
};

/// Adds the columns beside size and value. \pre these are set
void add_others(TableColumns &columns, const CellRow &header) {
  const std::optional<WeighedSieves> sieves = weighed_sieves(header);
  if (sieves)
    columns.further.push_back({sieves->full,
                               header.cells[sieves->full] + " less " + header.cells[sieves->empty],
                               {ColumnMeaning::retained, ColumnUnit::mass, true},
                               sieves->empty});
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    if (i == columns.size || i == columns.value || (sieves && (i == sieves->full || i == sieves->empty)))
      continue;
    const std::optional<HeaderMeaning> meaning = header_meaning(header.cells[i]);
    if (meaning && !holds_sizes(*meaning))
      columns.further.push_back({i, header.cells[i], *meaning});
    else if (meaning)
      columns.names.push_back({i, header.cells[i], *meaning});
    else
      columns.others.push_back({i, header.cells[i]});
  }
  std::stable_sort(
      columns.further.begin(), columns.further.end(),
      [](const FurtherColumn &a, const FurtherColumn &b) { return rank(a.meaning) < rank(b.meaning); });
}

/// The best of several columns with one purpose; its place in `all` is moved to the front.
void bring_best_to_front(std::vector<Known> &all, const CellRow &row, const Source &source) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Known &a, const Known &b) { return rank(a.meaning) < rank(b.meaning); });
  if (all.size() > 1 && rank(all[0].meaning) == rank(all[1].meaning))
    source.refuse(row.line, fmt::format("the columns {} and {} have one meaning: choose with {} SIZE,VALUE",
                                        in_quotes(row.cell(all[0].place)), in_quotes(row.cell(all[1].place)),
                                        option("columns")));
}

/// True for a row of units below a header.
bool is_unit_row(const CellRow &row, std::size_t size, std::size_t value) {
  return (unit_of_words(row.cell(size)) != ColumnUnit::none ||
          unit_of_words(row.cell(value)) != ColumnUnit::none) &&
         !number_cell(row.cell(size)) && !number_cell(row.cell(value));
}

/// True for a row of units in which the two columns have nothing else: `Size (um),Grams` is a header.
bool has_units_alone(const CellRow &row, std::size_t size, std::size_t value) {
  const auto is_unit = [&row](std::size_t column) {
    return row.cell(column).empty() || unit_of_words(row.cell(column)) != ColumnUnit::none;
  };
  return is_unit_row(row, size, value) && is_unit(size) && is_unit(value);
}

/// What the option says of a column whose words are not known, with the unit that the header has.
HeaderMeaning with_unit_of(std::string_view header, HeaderMeaning asked) {
  if (const ColumnUnit unit = unit_in_header(header); unit != ColumnUnit::none && !is_of_sizes(unit))
    asked.unit = unit;
  return asked;
}

std::string_view unit_name(ColumnUnit unit) {
  switch (unit) {
  case ColumnUnit::mm:
    return "mm";
  case ColumnUnit::um:
    return "um";
  case ColumnUnit::m:
    return "m";
  case ColumnUnit::inch:
    return "in";
  case ColumnUnit::phi:
    return "phi";
  case ColumnUnit::percent:
    return "percent";
  case ColumnUnit::fraction:
    return "fractions";
  case ColumnUnit::mass:
    return "a mass";
  case ColumnUnit::none:
    break;
  }
  return "no unit";
}

std::string_view meaning_name(ColumnMeaning meaning) {
  switch (meaning) {
  case ColumnMeaning::retained:
    return "what each sieve retains";
  case ColumnMeaning::cumulative:
    return "what is retained cumulatively";
  case ColumnMeaning::passing:
    return "what passes";
  default:
    return "sizes";
  }
}

/// The unit in a cell below a header, which must not have another.
void take_unit_below(const CellRow &row, std::size_t column, const std::string &name, ColumnUnit &unit,
                     const Source &source) {
  const ColumnUnit below = unit_of_words(row.cell(column));
  if (below == ColumnUnit::none)
    return;
  if (unit != ColumnUnit::none && unit != below)
    source.refuse(row.line,
                  fmt::format("below the header {} stands {}, which is another unit: correct one of them",
                              in_quotes(name), in_quotes(row.cell(column))));
  unit = below;
}

/// What stands below a header is a unit, or says no more than the header: `by mass`.
void check_words_below(const CellRow &row, std::size_t column, const std::string &name,
                       const HeaderMeaning &meaning, const Source &source) {
  const std::string cell(row.cell(column));
  if (cell.empty() || unit_of_words(cell) != ColumnUnit::none)
    return;
  const std::optional<HeaderMeaning> with = header_meaning(name + " " + cell);
  if (!with || with->meaning != meaning.meaning)
    source.refuse(row.line,
                  fmt::format("below the header {} stands {}, which is no unit that is known: write "
                              "the whole header into one cell",
                              in_quotes(name), in_quotes(cell)));
}

/// Takes the units of the row below a header, if there is such a row.
void take_unit_row(const Cells &cells, TableColumns &columns, const Source &source) {
  if (columns.first_row >= cells.rows.size() ||
      !is_unit_row(cells.rows[columns.first_row], columns.size, columns.value))
    return;
  const CellRow &row = cells.rows[columns.first_row];
  check_words_below(row, columns.size, columns.size_name, columns.sizes, source);
  check_words_below(row, columns.value, columns.value_name, columns.values, source);
  take_unit_below(row, columns.size, columns.size_name, columns.sizes.unit, source);
  take_unit_below(row, columns.value, columns.value_name, columns.values.unit, source);
  if (columns.grams == 0)
    columns.grams = grams_in(row.cell(columns.value));
  for (FurtherColumn &further : columns.further) {
    check_words_below(row, further.place, further.name, further.meaning, source);
    take_unit_below(row, further.place, further.name, further.meaning.unit, source);
  }
  ++columns.first_row;
}

/// True for a column that --kind may mean; what is retained may be cumulative, unless the header denies it.
bool may_be(const HeaderMeaning &column, const HeaderMeaning &asked) {
  const bool same_unit =
      column.unit == ColumnUnit::none || asked.unit == ColumnUnit::none || column.unit == asked.unit;
  return same_unit && (column.meaning == asked.meaning ||
                       (column.meaning == ColumnMeaning::retained && !column.is_individual &&
                        asked.meaning == ColumnMeaning::cumulative));
}

/// What --unit says where the header says none.
void apply_unit(TableColumns &columns, const HeaderMeaning &asked, const std::string &word, std::size_t line,
                const Source &source) {
  const ColumnUnit stated = columns.sizes.unit;
  if (stated != ColumnUnit::none && stated != asked.unit)
    source.refuse(
        line, fmt::format(
                  "{} {}: the column {} is in {}: leave the option out, or correct the header if it is wrong",
                  option("unit"), word, in_quotes(columns.size_name), unit_name(stated)));
  columns.sizes = asked;
}

/// What --kind says where the header says none.
void apply_kind(TableColumns &columns, const HeaderMeaning &asked, const std::string &word, std::size_t line,
                const Source &source) {
  if (!may_be(columns.values, asked))
    source.refuse(line,
                  fmt::format("{} {}: the column {} is {}, in {}: leave the option out, or choose another "
                              "column with {} SIZE,VALUE",
                              option("kind"), word, in_quotes(columns.value_name),
                              meaning_name(columns.values.meaning), unit_name(columns.values.unit),
                              option("columns")));
  columns.values.meaning = asked.meaning;
  if (asked.unit != ColumnUnit::none)
    columns.values.unit = asked.unit;
}

/// What the options say beside the header, which stands in that line.
/// \throws InputError where they contradict it
void apply_options(TableColumns &columns, const Reading &reading, std::size_t line, const Source &source) {
  if (const std::optional<HeaderMeaning> kind = asked_kind(reading))
    apply_kind(columns, *kind, *reading.kind, line, source);
  if (const std::optional<HeaderMeaning> unit = asked_unit(reading))
    apply_unit(columns, *unit, *reading.unit, line, source);
}

/// What an asked column holds: what its header says, or else the option with the unit of the header.
HeaderMeaning meaning_of(std::string_view header, bool sizes, const std::optional<HeaderMeaning> &asked,
                         const std::string &remedy) {
  const std::optional<HeaderMeaning> words = header_meaning(header);
  if (words && !words->is_unclear && holds_sizes(*words) == sizes)
    return *words;
  const ColumnUnit unit = unit_in_header(header);
  if (sizes && is_of_sizes(unit))
    return {ColumnMeaning::size, unit};
  if (asked)
    return sizes ? *asked : with_unit_of(header, *asked);
  const std::string says =
      header.empty() ? "no header says" : in_quotes(header) + " does not say in known words";
  throw InputError(fmt::format("{}: {} what the column of {} holds: add {}", option("columns"), says,
                               sizes ? "sizes" : "masses", remedy));
}

TableColumns asked_columns(const CellRow *header, std::size_t size, std::size_t value,
                           const Reading &reading) {
  TableColumns columns;
  columns.size = size;
  columns.value = value;
  if (size == value)
    throw InputError(option("columns") + ": " + in_quotes(*reading.columns) + " names one column twice");
  if (header != nullptr) {
    columns.size_name = header->cell(size);
    columns.value_name = header->cell(value);
    columns.width = header->cells.size();
    add_others(columns, *header);
  }
  columns.sizes = meaning_of(columns.size_name, true, asked_unit(reading),
                             option("unit") + " mm, or um, m, in, phi, sieve");
  columns.values = meaning_of(
      columns.value_name, false, asked_kind(reading),
      option("kind") + " passing, or retained, cumulative, or the name of a column of canonical CSV");
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
    while (above > 1 && has_units_alone(cells.rows[above - 1], *first, *second))
      --above;
    TableColumns columns =
        asked_columns(above > 0 ? &cells.rows[above - 1] : nullptr, *first, *second, reading);
    columns.above = above > 0 ? above - 1 : 0;
    columns.first_row = above;
    return columns;
  }
  const std::optional<std::size_t> size = first ? first : named_place(here, size_name);
  const std::optional<std::size_t> value = second ? second : named_place(here, value_name);
  if (!size || !value)
    return std::nullopt;
  TableColumns columns = asked_columns(&here, *size, *value, reading);
  columns.above = row;
  columns.first_row = row + 1;
  return columns;
}

/// Leaves the columns that --kind means, those first that say so themselves. Where none is left, all stay,
/// and apply_kind refuses.
void choose_kind(std::vector<Known> &values, const HeaderMeaning &asked) {
  const auto keep = [&values](const auto &is_meant) {
    std::vector<Known> kept;
    std::copy_if(values.begin(), values.end(), std::back_inserter(kept), is_meant);
    if (!kept.empty())
      values = std::move(kept);
  };
  keep([&asked](const Known &k) { return may_be(k.meaning, asked); });
  keep([&asked](const Known &k) { return may_be(k.meaning, asked) && k.meaning.meaning == asked.meaning; });
}

/// The columns by their words; with --kind, a second column of any name may hold the values.
/// \param below  the row below the header, which may have its units; null where there is none
std::optional<TableColumns> known_columns(const CellRow &row, const CellRow *below, const Reading &reading,
                                          const Source &source) {
  const std::optional<HeaderMeaning> kind = asked_kind(reading);
  std::vector<Known> sizes, values;
  for (std::size_t i = 0; i < row.cells.size(); ++i)
    if (std::optional<HeaderMeaning> meaning = header_meaning(row.cells[i]);
        meaning && (!meaning->is_unclear || kind)) {
      if (below != nullptr && meaning->unit == ColumnUnit::none)
        meaning->unit = unit_of_words(below->cell(i));
      (holds_sizes(*meaning) ? sizes : values).push_back({i, *meaning});
    }
  if (kind)
    choose_kind(values, *kind);
  if (kind && values.empty() && sizes.size() == 1 && row.cells.size() == 2) {
    const std::size_t other = 1 - sizes[0].place;
    values.push_back({other, with_unit_of(row.cell(other), *kind)});
  }
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

/// True where the header says with some words less, at its beginning or end, what `meaning` is.
bool has_words_of(std::string_view header, const HeaderMeaning &meaning) {
  constexpr std::size_t longest = 200;
  if (header.size() > longest)
    return false;
  const auto is_it = [&meaning](std::string_view part) {
    const std::optional<HeaderMeaning> found = header_meaning(part);
    return found && !found->is_unclear && found->meaning == meaning.meaning && found->unit == meaning.unit;
  };
  for (std::size_t i = 0; i < header.size(); ++i)
    if (header[i] == ' ' && (is_it(header.substr(0, i)) || is_it(header.substr(i + 1))))
      return true;
  return false;
}

/// The words of a header without letters and numbers that tell samples apart: `Mass retained A (g)`.
std::vector<std::string> common_words(std::string_view header) {
  std::vector<std::string> words = words_of(header);
  std::erase_if(words, [](const std::string &word) {
    return word != "g" && (word.size() == 1 || std::all_of(word.begin(), word.end(), is_digit));
  });
  return words;
}

/// Refuses a second column of the same values, such as those of another sample. None are limits, tares and
/// sums as in `Cum. Mass (g)`, which are compared with the values in every reading.
void refuse_second_sample(const TableColumns &columns, std::size_t line, const Source &source) {
  const auto is_second = [&columns](const std::string &other) {
    return (has_words_of(other, columns.values) && row_words(other).meaning != RowMeaning::container &&
            !is_limit(other) && !(may_hold_values(other) && speaks_of_sums(other))) ||
           (!other.empty() && common_words(other) == common_words(columns.value_name));
  };
  for (const auto &[place, other] : columns.others)
    if (is_second(other))
      source.refuse(line, fmt::format("the columns {} and {} may be of two samples: choose one with {} "
                                      "SIZE,VALUE",
                                      in_quotes(columns.value_name), in_quotes(other), option("columns")));
}

} // namespace

bool is_among(const UnusedColumn &column, const std::vector<UnusedColumn> &others) {
  return std::any_of(others.begin(), others.end(), [&column](const UnusedColumn &other) {
    return other.place == column.place && other.name == column.name;
  });
}

std::string column_options() {
  return fmt::format("say which columns they are with {} SIZE,VALUE (names or numbers), "
                     "{} passing|retained|cumulative, {} mm and {} N",
                     option("columns"), option("kind"), option("unit"), option("skip"));
}

std::optional<HeaderMeaning> asked_kind(const Reading &reading) {
  return asked("kind", reading.kind, kinds);
}

std::optional<HeaderMeaning> asked_unit(const Reading &reading) {
  return asked("unit", reading.unit, size_units);
}

std::optional<TableColumns> columns_of_row(const Cells &cells, std::size_t row, const Reading &reading,
                                           const Source &source) {
  std::optional<TableColumns> columns;
  if (reading.columns) {
    columns = asked_columns(cells, row, reading);
  } else {
    const CellRow *const below = row + 1 < cells.rows.size() ? &cells.rows[row + 1] : nullptr;
    columns = known_columns(cells.rows[row], below, reading, source);
    if (columns) {
      refuse_second_sample(*columns, cells.rows[row].line, source);
      check_words_above(cells, row, *columns, source);
      columns->above = row;
      columns->first_row = row + 1;
    }
  }
  if (!columns)
    return std::nullopt;
  columns->grams = grams_in(columns->value_name);
  take_unit_row(cells, *columns, source);
  apply_options(*columns, reading, cells.rows[row].line, source);
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

#include "gradation/upright.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/header_words.hpp"
#include "gradation/row_words.hpp"
#include "text/lines.hpp"

#include <algorithm>

namespace mdm {
namespace {

bool is_long(const CellRow &row) {
  return row.filled() > 2;
}

/// True for a row with the words of a mass and their number behind its first cell: it is said of the sample.
bool states_mass(const CellRow &row) {
  for (std::size_t i = 1; i + 1 < row.cells.size(); ++i)
    if (row_words(row.cells[i]).meaning != RowMeaning::none && number_cell(row.cells[i + 1]))
      return true;
  return false;
}

/// The meaning of the words that a row of several cells begins with.
std::optional<HeaderMeaning> meaning_of_row(const CellRow &row) {
  return is_long(row) ? header_meaning(row.cell(0)) : std::nullopt;
}

bool begins_with_sizes(const CellRow &row) {
  const std::optional<HeaderMeaning> meaning = meaning_of_row(row);
  return meaning && holds_sizes(*meaning) && std::any_of(row.cells.begin() + 1, row.cells.end(), has_digit);
}

bool begins_with_values(const CellRow &row) {
  const std::optional<HeaderMeaning> meaning = meaning_of_row(row);
  return meaning && !holds_sizes(*meaning);
}

/// Adds the cells of a row as the column of that number.
void add_column(Cells &table, const CellRow &row, std::size_t column) {
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    table.rows[i].cells.resize(column);
    table.rows[i].cells.push_back(row.cells[i]);
  }
  for (const std::size_t i : row.texts)
    table.rows[i].texts.push_back(column);
  for (const std::size_t i : row.long_numbers)
    table.rows[i].long_numbers.push_back(column);
}

} // namespace

std::optional<Cells> upright(const Cells &cells, const Source &source) {
  const auto sizes = std::find_if(cells.rows.begin(), cells.rows.end(), begins_with_sizes);
  if (sizes == cells.rows.end() || std::none_of(sizes, cells.rows.end(), begins_with_values))
    return std::nullopt;
  const auto end = std::find_if_not(sizes, cells.rows.end(),
                                    [](const CellRow &row) { return is_long(row) && !states_mass(row); });
  if (const auto next = std::find_if(end, cells.rows.end(), begins_with_sizes); next != cells.rows.end())
    source.refuse(next->line, "a second table of sieves in a row begins: leave one of them out");
  const std::size_t height = static_cast<std::size_t>(end - sizes);
  std::size_t width = 0;
  for (auto row = sizes; row != end; ++row)
    width = std::max(width, row->cells.size());
  if (height * width > max_cells)
    return std::nullopt;
  Cells turned{
      cells.format + ", sieves in a row", cells.delimiter, {}, cells.hint, cells.sheet, cells.comments};
  turned.rows.resize(width, CellRow{sizes->line, false, {}});
  for (std::size_t column = 0; column < height; ++column)
    add_column(turned, sizes[static_cast<std::ptrdiff_t>(column)], column);
  std::erase_if(turned.rows, [](const CellRow &row) {
    return std::all_of(row.cells.begin(), row.cells.end(), [](const std::string &c) { return c.empty(); });
  });
  turned.rows.insert(turned.rows.begin(), cells.rows.begin(), sizes);
  const std::size_t below = turned.rows.size();
  turned.rows.insert(turned.rows.end(), end, cells.rows.end());
  if (below < turned.rows.size())
    turned.rows[below].below_gap = true;
  return turned;
}

} // namespace mdm

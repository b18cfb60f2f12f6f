#pragma once
/// \file
/// A table as it stands in a file, before it is understood.

#include "text/source.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The most cells of a table; it bounds the memory.
inline constexpr std::size_t max_cells = std::size_t{1} << 21;

/// What stands for a date, which a spreadsheet makes of 3/8.
inline constexpr std::string_view date_cell = "(a date)";

/// A row that has something in it.
struct CellRow {
  std::size_t line;                           ///< of the file, or row of the sheet, from 1 on
  bool below_gap = false;                     ///< an empty row is above
  std::vector<std::string> cells;             ///< without the spaces around them
  std::vector<std::size_t> texts = {};        ///< of a workbook: the columns of texts, in order
  std::vector<std::size_t> long_numbers = {}; ///< those of numbers that have no decimal of at most 15 digits
  bool is_hidden = false;                     ///< of a workbook: its sheet does not show the row

  /// The cell of that column; empty beyond the last.
  std::string_view cell(std::size_t column) const {
    return column < cells.size() ? std::string_view(cells[column]) : std::string_view();
  }
  /// The number of cells that have something in them.
  std::ptrdiff_t filled() const {
    return std::count_if(cells.begin(), cells.end(), [](const std::string &c) { return !c.empty(); });
  }
  /// The first of them.
  std::string_view first() const {
    return *std::find_if(cells.begin(), cells.end(), [](const std::string &c) { return !c.empty(); });
  }
};

/// The rows of a table, from the top.
struct Cells {
  std::string format;    ///< as reports name it
  char delimiter = '\0'; ///< of text; none in a workbook
  std::vector<CellRow> rows;
  std::string hint;                   ///< what else may be done where the table is not understood
  std::string sheet = {};             ///< of a workbook of several, the name of the one that was read
  std::vector<CellRow> comments = {}; ///< of text: the lines that begin with #, without that
};

/// Text cut at tabs, semicolons or commas. Empty rows are left out, and comments kept apart.
/// Where a quoted cell is not closed, the line is one cell.
/// \param skip lines at the top that are left out
/// \throws InputError beyond max_cells
Cells cells_of_text(std::string_view text, char delimiter, std::size_t skip, const Source &source);

/// `text` without the white space around it, spaces that do not break included.
std::string_view without_spaces(std::string_view text);

/// The first rows that have something in them, for a message.
std::string beginning_of(const Cells &cells);

} // namespace mdm

#pragma once
/// \file
/// The columns of a table that hold its gradation.

#include "gradation/cells.hpp"
#include "gradation/header_words.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>

namespace mdm {

/// What to do where the columns are not certain.
std::string column_options();

/// A column of values beside the chosen one, or the difference of two.
struct FurtherColumn {
  std::size_t place;
  std::string name;
  HeaderMeaning meaning;
  std::optional<std::size_t> less = {}; ///< the column whose numbers are taken off: of empty sieves
};

/// A column that is not used. Without a name it may hold anything.
struct UnusedColumn {
  std::size_t place;
  std::string name;
};

/// True where one of them has its place and name.
bool is_among(const UnusedColumn &column, const std::vector<UnusedColumn> &others);

/// The two columns, and the place of the rows below their header.
struct TableColumns {
  std::size_t size = 0, value = 0;   ///< columns
  std::string size_name, value_name; ///< their headers
  HeaderMeaning sizes{ColumnMeaning::size};
  HeaderMeaning values{ColumnMeaning::retained};
  std::size_t width = 0;              ///< cells of the header; 0 where there is none
  std::size_t above = 0;              ///< rows above the header
  std::size_t first_row = 0;          ///< of Cells::rows
  std::vector<FurtherColumn> further; ///< that speak of mass too, the best first
  std::vector<FurtherColumn> names;   ///< other columns of sizes
  std::vector<UnusedColumn> others;   ///< those that are not used
  unsigned grams = 0;                 ///< in one of the unit of the values; 0 where that is not said
};

/// What --kind and --unit say.
std::optional<HeaderMeaning> asked_kind(const Reading &reading);
std::optional<HeaderMeaning> asked_unit(const Reading &reading);

/// The columns of a header in that row; nothing if it is none. Of several columns of values the first of mass
/// retained, passing, cumulative and percent retained is taken, of several of sizes one with metric openings.
/// \throws InputError where two columns have one meaning, or `--columns` does not name what is there
std::optional<TableColumns> columns_of_row(const Cells &cells, std::size_t row, const Reading &reading,
                                           const Source &source);

/// The columns of the first header; nothing if there is none.
/// \throws InputError as above
std::optional<TableColumns> find_columns(const Cells &cells, const Reading &reading, const Source &source);

} // namespace mdm

#pragma once
/// \file
/// The sizes of a table's rows: numbers in the unit of their column, numbers with units, names of sieves,
/// ranges between two sieves.

#include "gradation/row_ranges.hpp"
#include "gradation/table_sign.hpp"

namespace mdm {

/// Reads the sizes of the rows of one table, all in its unit. Errors of single cells have no line.
class RowSizes {
public:
  /// \param columns  kept by reference: those of the header above the row that is read
  RowSizes(const Cells &cells, const TableColumns &columns, const Reading &reading, const TableSign &sign);

  /// The unit of the table: that of its first header.
  SizeUnit unit() const { return unit_; }
  /// As in Gradation::Data.
  std::string file_unit() const;
  /// True for a size, or what looks like one and must not be overlooked: `<0.063`, `0.02*`.
  bool may_be_size(std::string_view cell) const;
  /// True for what is certainly a size.
  bool is_size(std::string_view cell) const;
  /// The size of the table's next row. Other columns of sizes must name the same sieve.
  /// \throws InputError where the cell is no size, or its unit is not certain
  Rational next(const CellRow &row);
  /// The sizes below are in another unit than those above, as their header says.
  void begin_unit() { has_own_unit_ = true; }
  /// The size of the sieve that words name.
  /// \throws InputError as above
  Rational named(std::string_view sieve) const;
  /// Turns ranges into sieves, once all rows are read.
  /// \throws InputError, with the line, where sizes may be in another unit, or ranges do not fit each other
  void settle(Table &table, bool are_retained, const Source &source) const;

private:
  void find_series(const Cells &cells);
  Rational row_size(std::string_view cell);
  Rational size_of(std::string_view cell, ColumnUnit unit) const;
  Rational plain_size(std::string_view digits) const;
  void check_names(const CellRow &row, const Rational &size) const;
  std::optional<Rational> other_size(std::string_view cell, ColumnUnit unit) const;
  bool is_sieve(std::string_view cell) const;
  Rational opening(std::string_view cell) const;
  Rational other_opening(std::string_view cell) const;
  Rational in_unit(std::string_view digits, ColumnUnit unit) const;

  const TableColumns &columns_;
  const Reading &reading_;
  TableSign sign_;
  SizeUnit unit_;
  std::string series_;        ///< what beside the table names other sieves than those of ASTM; mostly empty
  bool is_of_sieves_ = false; ///< and says that the sieves are these
  std::size_t rows_ = 0;
  struct Above {
    std::size_t row;
    std::string cell;
  };
  SizeRanges ranges_;
  std::optional<Above> above_; ///< the row of what is coarser than all ranges
  bool has_own_unit_ = false;
  bool names_inches_ = false;           ///< in a column of inches some sieves are named: 3/4, No. 4
  std::vector<std::size_t> plain_rows_; ///< below the first unit, with sizes that are numbers alone ...
  std::vector<Rational> plain_sizes_;   ///< ... and these numbers
};

} // namespace mdm

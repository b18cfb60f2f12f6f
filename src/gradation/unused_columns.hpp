#pragma once
/// \file
/// The columns of a sheet that are not read, in which nothing must be overlooked.

#include "gradation/mass_statements.hpp"
#include "gradation/table.hpp"
#include "gradation/table_columns.hpp"
#include "gradation/value_columns.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Looks through the cells of such columns, row by row. Where the user has chosen the columns, nothing is
/// refused. All members throw an InputError with the line.
class UnusedColumns {
public:
  /// \param columns  of the first header; \param source  is kept by reference
  UnusedColumns(const TableColumns &columns, bool are_chosen, const TableSign &sign, const Source &source)
      : value_name_(columns.value_name), grams_(columns.grams), here_(columns.others),
        common_(columns.others), all_(columns.others), are_chosen_(are_chosen), sign_(sign), source_(source) {
  }

  /// Those below any header.
  const std::vector<UnusedColumn> &all() const { return all_; }
  /// Goes on below another header, which has these.
  void go_on(const std::vector<UnusedColumn> &next);

  /// What stands below no name, in a column whose mass belongs to the table, or is the pan of a block beside
  /// it.
  /// \param rows  read so far; \param is_alone  no other column of masses is read
  void check_sieve(const CellRow &row, std::size_t rows, bool is_alone) const;
  /// What stands beside the pan, or a sum, in a column of what was washed out, or in no row of a sieve.
  void check_account(const CellRow &row, const std::vector<const CellRow *> &sieves) const;
  /// Units beside the masses must be one.
  void check_unit(const CellRow &row);
  /// A column that has the values in some rows and others in the rest has those of the whole, or of a part.
  /// \param sieves  the rows of the table's sizes
  void check_corrected(const Table &table, const std::vector<const CellRow *> &sieves,
                       ColumnMeaning values) const;

  /// Rows of several samples, one below the other, are no stack of sieves.
  void check_samples(const std::vector<const CellRow *> &sieves, ColumnMeaning values) const;
  /// Those that speak of the sample's mass, with a number or nothing in each row of the table's sizes, and
  /// not one number alone.
  std::vector<ColumnBeside> speaking_of_mass(const std::vector<const CellRow *> &sieves) const;

  /// True for words of a mass of the table or its sample; `wet` and `total` may be remarks.
  static bool names_mass(std::string_view cell);
  /// True for a statement of one, or of what may be one in a sentence.
  static bool states_mass(const MassStatement &statement) {
    return statement.is_sentence || names_mass(statement.label);
  }

private:
  [[noreturn]] void refuse(const CellRow &row, const std::string &what) const {
    source_.refuse(row.line, what);
  }
  [[noreturn]] void refuse_number(const CellRow &row, const std::string &name, std::string_view cell) const;
  void check_named(const CellRow &row, const std::string &name, std::string_view cell, bool is_alone) const;
  bool has_two_numbers(const UnusedColumn &column, const std::vector<const CellRow *> &sieves) const;
  std::optional<std::vector<std::optional<PrintedNumber>>>
  numbers_in(const UnusedColumn &column, const std::vector<const CellRow *> &sieves) const;

  std::string value_name_;                        ///< of the column of values
  unsigned grams_;                                ///< in one of its unit; 0 where that is not said
  std::vector<UnusedColumn> here_, common_, all_; ///< below the last header, below all, and below any
  bool are_chosen_;
  TableSign sign_;
  const Source &source_;
  std::map<std::size_t, std::string> units_; ///< beside the masses, by their column
};

} // namespace mdm

#pragma once
/// \file
/// The numbers in a table's columns of values: in the chosen one, and in those beside it.

#include "gradation/table_sign.hpp"
#include "text/short_list.hpp"

namespace mdm {

/// The chosen column. Its unit may stand behind its numbers alone. Errors have no line.
class ChosenColumn {
public:
  /// \param grams  in one of its unit; 0 where the header does not say it
  ChosenColumn(std::string header, const HeaderMeaning &meaning, unsigned grams, const TableSign &sign)
      : header_(std::move(header)), meaning_(meaning), grams_(grams), sign_(sign) {}

  const std::string &header() const { return header_; }
  /// With the unit that its numbers had so far.
  const HeaderMeaning &meaning() const { return meaning_; }

  /// The number in a cell of it.
  /// \throws InputError where there is none, or its unit is not that of the others
  PrintedNumber read(std::string_view cell);
  [[noreturn]] void refuse(std::string_view cell) const;

private:
  void take_unit(std::string_view cell, ColumnUnit unit);
  void check_kilograms(std::string_view cell);

  std::string header_;
  HeaderMeaning meaning_;
  unsigned grams_;
  TableSign sign_;
  bool unit_is_of_cells_ = false;
  bool has_plain_ = false;           ///< a value above 0 without a unit
  bool has_percent_ = false;         ///< cells have percent signs
  std::optional<bool> in_kilograms_; ///< what cells with a unit of mass are in
};

/// A column beside the chosen one.
struct ColumnBeside {
  FurtherColumn column;
  std::optional<std::size_t> place;                  ///< below the present header
  std::vector<std::optional<PrintedNumber>> numbers; ///< one a row of the table
};

/// All columns of masses beside the chosen one, whose numbers are compared with it.
class ColumnsBeside {
public:
  ColumnsBeside(const std::vector<FurtherColumn> &columns, const TableSign &sign);

  const std::vector<ColumnBeside> &all() const { return all_; }

  /// True where one of them is of the same meaning.
  bool have(const FurtherColumn &column) const;
  /// Goes on below another header, with the columns that it has again.
  void go_on(const std::vector<FurtherColumn> &next);
  /// True where a row has a number in one of them.
  /// \throws InputError where a number has no meaning
  bool have_number(const CellRow &row) const;
  /// The numbers of a row, one a column.
  /// \throws InputError as above
  std::vector<std::optional<PrintedNumber>> numbers(const CellRow &row) const;
  /// Takes the numbers of the table's next row.
  /// \throws InputError as above
  void take(const CellRow &row);
  /// The first cells of rows in which one of them has an error of a spreadsheet instead of a number.
  const ShortList &errors() const { return errors_; }

private:
  std::optional<PrintedNumber> number(const ColumnBeside &column, const CellRow &row) const;

  TableSign sign_;
  std::vector<ColumnBeside> all_;
  ShortList errors_;
};

} // namespace mdm

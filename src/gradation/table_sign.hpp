#pragma once
/// \file
/// The decimal sign of a laboratory's table.

#include "gradation/mass_statements.hpp"
#include "gradation/table_columns.hpp"

namespace mdm {

/// The sign in the numbers of one table.
class TableSign {
public:
  /// \param is_workbook  numbers are stored with a point there, however they are shown; texts have the sign
  /// that was typed
  TableSign(char sign, bool is_workbook) : sign_(sign), is_workbook_(is_workbook) {}

  /// The sign of a number with these digits.
  char in(std::string_view digits) const {
    return is_workbook_ && digits.find('.') != std::string_view::npos ? '.' : sign_;
  }
  /// \throws InputError if the digits are no decimal
  Rational decimal(std::string_view digits) const;

private:
  char sign_;
  bool is_workbook_;
};

/// The sign of all numbers below the header and beside words of masses.
/// \param above  what stands above the header
/// \throws InputError where numbers have both signs, or only signs that may stand between thousands
TableSign table_sign(const Cells &cells, const TableColumns &columns, std::vector<MassStatement> above);

} // namespace mdm

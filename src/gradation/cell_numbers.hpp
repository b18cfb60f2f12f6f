#pragma once
/// \file
/// Numbers in the cells of a table, with decimal points or commas.

#include "gradation/header_words.hpp"

#include <mdm/number/rational.hpp>

namespace mdm {

/// A cell that holds a number, with the unit behind it if there is one: `45%`, `0,063`, `63 µm`.
struct NumberCell {
  std::string_view digits; ///< digits, signs, decimal signs and an exponent
  ColumnUnit unit = ColumnUnit::none;
};

/// The number in a cell; nothing where there is anything else.
std::optional<NumberCell> number_cell(std::string_view cell);
/// True for `0`, `0.00` and the like.
bool is_zero(const NumberCell &number);

/// The decimal sign of all numbers of a table, which are shown to it before the first is read.
class DecimalSign {
public:
  /// \param comma_is_sure  commas are in numbers: semicolons are between cells
  /// \param point_is_sure  points do not stand between thousands: commas are between cells
  DecimalSign(bool comma_is_sure, bool point_is_sure)
      : comma_is_sure_(comma_is_sure), point_is_sure_(point_is_sure) {}

  void see(std::string_view digits);
  /// \throws InputError where numbers have both signs, or only signs that may stand between thousands
  char sign() const;

private:
  bool comma_is_sure_, point_is_sure_;
  std::string point_, comma_, both_;                ///< the first number of each form
  std::string points_thousands_, commas_thousands_; ///< the same, where the sign may stand between thousands
};

} // namespace mdm

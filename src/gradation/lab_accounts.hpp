#pragma once
/// \file
/// The values of a laboratory's table, after all that its sheet says of masses was compared.

#include "gradation/lab_rows.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// What the comparison found.
struct ComparedValues {
  bool are_confirmed = false; ///< by another column, or a sum that the sheet states
  std::vector<std::string> notes;
};

/// Compares the columns, rows and statements of a sheet. The table gets the values of the column that
/// decides, and the row of the pan with all that passes the finest sieve.
/// \throws InputError where they contradict each other
ComparedValues settle_values(LabRows &rows, const Reading &reading, const Source &source);

} // namespace mdm

#pragma once
/// \file
/// What the values of a laboratory's table are, once all of them are read.

#include "gradation/header_words.hpp"
#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// The column of values as the table has it.
struct LabValues {
  HeaderMeaning meaning;
  std::string_view header;
  bool is_confirmed = false; ///< by another column or a sum
};

/// Gives the table the canonical column that its values are. Cumulative masses are taken apart into what each
/// sieve retains, after `--round`.
/// \pre the table has rows
/// \throws InputError where it is not certain whether values are percent or fractions, or cumulative
void settle_lab_values(Table &table, const LabValues &values, const Reading &reading, const Source &source);

} // namespace mdm

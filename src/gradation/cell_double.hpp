#pragma once
/// \file
/// Numbers of spreadsheets, which are doubles.

#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// A double as a decimal.
struct CellDouble {
  std::string text;
  bool is_short = true; ///< of at most 15 digits, which is what a spreadsheet shows and people type
};

/// The shortest decimal that is the same double as `stored`: of at most 15 digits where there is one, else of
/// 16 or
/// 17. Nothing for what is no finite double.
std::optional<CellDouble> cell_double(std::string_view stored);

} // namespace mdm

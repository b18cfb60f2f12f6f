#pragma once
/// \file
/// Tables for people, and fields for CSV.

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Lines of as many cells; columns are as wide as their longest cell, two spaces before each, flush left
/// where `alignment` has `<` and flush right where it has `>`; its last letter stands for all further
/// columns. No line ends with spaces.
std::string text_table(const std::vector<std::vector<std::string>> &lines, std::string_view alignment);

/// Any text as a field of CSV: control characters escaped, in quotes where it needs them.
std::string csv_field(std::string_view text);

} // namespace mdm

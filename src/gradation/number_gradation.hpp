#pragma once
/// \file
/// Gradations by number: the shares that the size classes have of the particles' number.

#include <mdm/gradation/gradation.hpp>

#include <string>
#include <string_view>

namespace mdm {

/// True for canonical CSV with the column number_percent or cumulative_number_percent.
bool is_number_gradation(std::string_view content);

/// Reads such a file. The masses of what is returned are the shares by number: no function that weighs
/// particles may be given it.
/// \throws InputError with the line
Gradation read_number_gradation(std::string_view content, const std::string &file);

} // namespace mdm

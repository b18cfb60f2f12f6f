#pragma once
/// \file
/// Decimals as doubles.

#include <optional>
#include <string_view>

namespace mdm {

/// The double nearest to a decimal, with or without exponent; nothing if the text is no decimal, or out of
/// range.
std::optional<double> nearest_double(std::string_view decimal);
/// The same for floats.
std::optional<float> nearest_float(std::string_view decimal);

} // namespace mdm

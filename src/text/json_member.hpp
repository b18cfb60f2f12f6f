#pragma once
/// \file
/// One member of a JSON text, without the rest.

#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// The string or number of that key in the outermost object of a JSON text; nothing if it has none. What is
/// behind it, or behind an error before it, is not read.
std::optional<std::string> json_member(std::string_view content, std::string_view key);

/// The format that a JSON text says it has, such as `mdm-answer-1`; nothing if it says none, as a gradation
/// does.
inline std::optional<std::string> json_schema(std::string_view content) {
  return json_member(content, "schema");
}

} // namespace mdm

#pragma once
/// \file
/// JSON whose numbers keep their text.

#include <nlohmann/json.hpp>

#include <string_view>

namespace mdm {

/// The value of a JSON text with every number as the string that it is written as, so that it can be read
/// exactly.
/// \throws InputError if it is not JSON, is nested deeper than 64, or has a key twice in one object
nlohmann::json json_tree(std::string_view text);

} // namespace mdm

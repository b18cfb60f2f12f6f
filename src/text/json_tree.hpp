#pragma once
/// \file
/// JSON whose numbers keep their text.

#include <mdm/text/error.hpp>

#include <nlohmann/json.hpp>

#include <string_view>

namespace mdm {

/// Text that json_tree refuses.
class JsonError : public InputError {
public:
  JsonError(std::size_t in_line, const std::string &what) : InputError(what), line(in_line) {}

  std::size_t line; ///< where it is, from 1
};

/// The value of a JSON text with every number as the string that it is written as, so that it can be read
/// exactly.
/// \throws JsonError if it is not JSON, is nested deeper than 64, or has a key twice in one object
nlohmann::json json_tree(std::string_view text);

} // namespace mdm

#pragma once
/// \file
/// JSON written as text.

#include <string>
#include <string_view>

namespace mdm {

/// `text` as a JSON string with its quotes; control characters are escaped, and in text that is no UTF-8
/// every byte above ASCII becomes U+FFFD.
std::string json_string(std::string_view text);

} // namespace mdm

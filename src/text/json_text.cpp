#include "text/json_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

std::string json_string(std::string_view text) {
  std::string out = "\"";
  const bool valid = is_utf8(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    if (text[i] == '"' || text[i] == '\\')
      (out += '\\') += text[i];
    else if (byte(i) < 0x20 || byte(i) == 0x7F)
      out += fmt::format("\\u{:04x}", byte(i));
    else if (byte(i) >= 0x80 && !valid)
      out += "\\ufffd";
    else if (byte(i) == 0xC2 && byte(i + 1) < 0xA0) // a C1 control: U+0080 to U+009F
      out += fmt::format("\\u{:04x}", byte(++i));
    else
      out += text[i];
  }
  return out + "\"";
}

} // namespace mdm

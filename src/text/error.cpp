#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// The first character of a text: its code point and its number of bytes; 0 bytes where it is not
/// well-formed.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// Unicode 15, table 3-7. The least code point of each length excludes overlong forms.
Character first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80)
    return {byte(0), 1};
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (byte(0) < 0xC0 || byte(0) > 0xF7 || text.size() < bytes)
    return {};
  char32_t code = byte(0) & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80)
      return {};
    code = (code << 6) | (byte(i) & 0x3FU);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[bytes] || code > 0x10FFFF || surrogate)
    return {};
  return {code, bytes};
}

/// Invisible characters, line separators and marks of the direction of writing could make a message lie.
bool misleads(char32_t code) {
  return code == 0xAD || code == 0x61C || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x2069) || code == 0xFEFF;
}

/// No C0 control, DEL, C1 control or misleading character.
bool is_printable(char32_t code) {
  return (code >= 0xA0 || (code >= 0x20 && code < 0x7F)) && !misleads(code);
}

/// Moves the first character of `text` to the end of `shown`, escaped where it is no printable one; returns
/// the width of what was added.
std::size_t move_character(std::string_view &text, std::string &shown) {
  const Character character = first_character(text);
  const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
  const std::string_view moved = text.substr(0, bytes);
  text.remove_prefix(bytes);
  if (character.bytes != 0 && is_printable(character.code)) {
    shown += moved;
    return 1;
  }
  for (const char byte : moved)
    shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  return 4 * bytes;
}

} // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty())
    move_character(text, shown);
  return shown;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t limit = 80;
  constexpr std::string_view dots = "...";
  std::string shown = "'";
  std::size_t width = 0;
  std::size_t bytes_before_dots = shown.size();
  while (!text.empty() && width <= limit) {
    width += move_character(text, shown);
    if (width <= limit - dots.size())
      bytes_before_dots = shown.size();
  }
  if (width > limit) {
    shown.resize(bytes_before_dots);
    shown += dots;
  }
  return shown + "'";
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = first_character(text).bytes;
    if (bytes == 0)
      return false;
    text.remove_prefix(bytes);
  }
  return true;
}

} // namespace mdm

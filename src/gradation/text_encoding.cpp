#include "gradation/text_encoding.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// Windows-1252 from 0x80 to 0x9F; 0 where no character is. From 0xA0 on it is Latin-1, which is Unicode.
constexpr std::array<char32_t, 32> windows_1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append_utf8(std::string &text, char32_t c) {
  const auto add = [&text](char32_t bits) { text += static_cast<char>(static_cast<unsigned char>(bits)); };
  const auto add_rest = [&add, c](unsigned shift) { add(0x80 | ((c >> shift) & 0x3F)); };
  if (c < 0x80) {
    add(c);
  } else if (c < 0x800) {
    add(0xC0 | (c >> 6));
    add_rest(0);
  } else if (c < 0x10000) {
    add(0xE0 | (c >> 12));
    add_rest(6);
    add_rest(0);
  } else {
    add(0xF0 | (c >> 18));
    add_rest(12);
    add_rest(6);
    add_rest(0);
  }
}

/// A pass over UTF-16 behind its byte order mark.
class Utf16 {
public:
  Utf16(std::string_view bytes, bool big_endian, const Source &source)
      : bytes_(bytes), high_(big_endian ? 0 : 1), source_(source) {}

  std::string text() {
    std::string text;
    text.reserve(bytes_.size());
    while (at_ < bytes_.size()) {
      const char32_t c = character();
      line_ += c == U'\n' ? 1 : 0;
      append_utf8(text, c);
    }
    return text;
  }

private:
  [[noreturn]] void refuse(const char *what) const {
    source_.refuse(line_, std::string(what) + ": save or copy the file again, as UTF-8 if you can");
  }

  char32_t unit() {
    if (bytes_.size() - at_ < 2)
      refuse("the UTF-16 text ends in the middle of a character");
    const auto byte = [this](std::size_t i) {
      return static_cast<char32_t>(static_cast<unsigned char>(bytes_[at_ + i]));
    };
    const char32_t value = byte(high_) << 8 | byte(1 - high_);
    at_ += 2;
    return value;
  }

  char32_t character() {
    const char32_t first = unit();
    if (first < 0xD800 || first > 0xDFFF)
      return first;
    if (first > 0xDBFF || at_ == bytes_.size())
      refuse("the UTF-16 text has half a character");
    const char32_t second = unit();
    if (second < 0xDC00 || second > 0xDFFF)
      refuse("the UTF-16 text has half a character");
    return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
  }

  std::string_view bytes_;
  std::size_t high_; ///< the place of the high byte in a unit
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  const Source &source_;
};

/// Nothing for a byte that no text in Windows-1252 has.
std::optional<char32_t> windows_1252_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if ((byte < 0x20 && c != '\t' && c != '\r' && c != '\n') || byte == 0x7F)
    return std::nullopt;
  if (byte < 0x80 || byte >= 0xA0)
    return byte;
  const char32_t character = windows_1252[byte - 0x80U];
  return character == 0 ? std::nullopt : std::optional(character);
}

std::optional<DecodedText> decoded_windows_1252(std::string_view bytes) {
  DecodedText decoded{{}, "Windows-1252 (Latin-1)"};
  decoded.text.reserve(bytes.size());
  for (const char byte : bytes) {
    const std::optional<char32_t> c = windows_1252_character(byte);
    if (!c)
      return std::nullopt;
    append_utf8(decoded.text, *c);
  }
  return decoded;
}

} // namespace

std::optional<DecodedText> decoded_text(std::string_view bytes, const Source &source) {
  constexpr std::string_view little = "\xFF\xFE", big = "\xFE\xFF";
  if (bytes.starts_with(little))
    return DecodedText{Utf16(bytes.substr(little.size()), false, source).text(), "UTF-16LE"};
  if (bytes.starts_with(big))
    return DecodedText{Utf16(bytes.substr(big.size()), true, source).text(), "UTF-16BE"};
  if (is_utf8(bytes))
    return std::nullopt;
  return decoded_windows_1252(bytes);
}

} // namespace mdm

#pragma once
/// \file
/// Characters, lines and fields of delimited text.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
inline bool has_digit(std::string_view text) {
  return std::any_of(text.begin(), text.end(), is_digit);
}
inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
/// ASCII only, whatever the locale.
inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The text behind a byte order mark, or all if there is none.
std::string_view without_byte_order_mark(std::string_view content);

/// A file's name without directories and ending.
std::string stem(std::string_view file);

/// `text` without the spaces and tabs around it.
std::string_view trimmed(std::string_view text);

/// The parts of a text between commas, as they are.
std::vector<std::string> between_commas(std::string_view text);

/// True where both are the same but for the case of their letters.
bool are_alike(std::string_view a, std::string_view b);

/// True for `pan` in any case.
bool is_pan(std::string_view text);

/// A pass over the lines of a text. They end with LF or CRLF.
class Lines {
public:
  explicit Lines(std::string_view content) : rest_(content) {}

  /// Moves on to the next line; false at the end.
  bool next();
  std::string_view text() const { return text_; }
  /// Counted from 1; 0 before the first.
  std::size_t number() const { return number_; }

private:
  std::string_view rest_;
  std::string_view text_;
  std::size_t number_ = 0;
};

/// The most fields of a line that are looked at: more than any header that is read has. It bounds the memory.
inline constexpr std::size_t max_fields = 1000;

/// The text between the quotes that `field` begins and ends with, two quotes in it being one, unless a quote
/// in it stands alone; `field` itself where there are no such quotes.
std::string unquoted(std::string_view field);

/// Splits a line into fields without the spaces and tabs around them. A field that begins with `"` ends at
/// the next
/// `"` that is not doubled, and only spaces and tabs may follow it up to the delimiter.
/// \return false where a quoted field does not end so
bool split_fields(std::string_view line, char delimiter, std::vector<std::string> &fields);

} // namespace mdm

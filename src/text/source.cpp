#include "text/source.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace mdm {
namespace {

/// A C0 control other than tab, CR and LF, or DEL.
bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\r' && c != '\n') || byte == 0x7F;
}

/// The first control character of a UTF-8 text, or an empty text. C1 controls are the bytes C2 80 to C2 9F.
std::string_view find_control(std::string_view text) {
  const auto is_c1 = [](char first, char second) {
    return first == '\xC2' && static_cast<unsigned char>(second) < 0xA0;
  };
  const auto c0 = std::find_if(text.begin(), text.end(), is_control);
  const auto c1 = std::adjacent_find(text.begin(), c0, is_c1);
  const auto position = static_cast<std::size_t>(c1 - text.begin());
  return text.substr(position, c1 == c0 ? 1 : 2);
}

/// A line separator or a mark of the direction of writing, for which an editor may show a line of its own, or
/// another order, where there is none: the bytes of U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to
/// U+2069. An empty text without.
std::string_view find_rearranging(std::string_view text) {
  for (std::size_t at = text.find_first_of("\xD8\xE2"); at != std::string_view::npos;
       at = text.find_first_of("\xD8\xE2", at + 1)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("\xD8\x9C"))
      return rest.substr(0, 2);
    const auto third = static_cast<unsigned char>(rest.size() > 2 ? rest[2] : '\0');
    if ((rest.starts_with("\xE2\x80") &&
         (third == 0x8E || third == 0x8F || (third >= 0xA8 && third <= 0xAE))) ||
        (rest.starts_with("\xE2\x81") && third >= 0xA6 && third <= 0xA9))
      return rest.substr(0, 3);
  }
  return {};
}

/// True only if all characters are printable ASCII. Eight at a time: it goes over every line of a batch run.
bool is_plain(std::string_view text) {
  constexpr std::uint64_t ones = 0x0101010101010101;
  for (; text.size() >= sizeof(std::uint64_t); text.remove_prefix(sizeof(std::uint64_t))) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data(), sizeof word);
    // The top bit of a byte is set in the first if the byte is below 0x20, in the second if it is 0x7F, in
    // the third if it is no ASCII. A borrow or carry comes only from such bytes.
    if ((((word - 0x20 * ones) | (word + ones) | word) & (0x80 * ones)) != 0)
      return false;
  }
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
}
} // namespace

void Source::refuse(std::size_t line, const std::string &what) const {
  if (has_lines_)
    throw InputError(fmt::format("{}:{}: {}", printable(name_), line, what));
  throw InputError(fmt::format("{}: {}", printable(name_), what));
}

void Source::check_length(std::string_view content, std::size_t most) const {
  if (content.size() > most)
    refuse(1, fmt::format("the gradation has more than {} MiB: give fewer sieves", most >> 20));
}

void Source::check_line_ends(std::string_view content) const {
  for (std::size_t at = content.find('\r'); at != std::string_view::npos; at = content.find('\r', at + 1))
    if (!content.substr(at + 1).starts_with('\n'))
      refuse(line_number(content, at), "a carriage return (CR) is there that no line feed (LF) follows: end "
                                       "lines with LF or CR LF");
}

void Source::check_text(std::string_view content, std::size_t most) const {
  check_length(content, most);
  if (is_plain(content))
    return;
  if (!is_utf8(content)) {
    // A line feed is a character of its own, so the first bad line is bad by itself.
    std::size_t line = 1;
    for (std::string_view rest = content; is_utf8(rest.substr(0, rest.find('\n'))); ++line)
      rest.remove_prefix(rest.find('\n') + 1);
    refuse(line, "the text is not UTF-8: save the file in that encoding");
  }
  const auto line_of = [content](std::string_view part) {
    return line_number(content, static_cast<std::size_t>(part.data() - content.data()));
  };
  if (const std::string_view control = find_control(content); !control.empty())
    refuse(line_of(control),
           fmt::format("the control character {} does not belong in a gradation: save the file as plain text",
                       in_quotes(control)));
  if (const std::string_view mark = find_rearranging(content); !mark.empty())
    refuse(line_of(mark),
           fmt::format("the character {} separates lines or turns the direction of writing, so "
                       "that editors show other lines than there are: remove it",
                       in_quotes(mark)));
  check_line_ends(content);
}

std::size_t line_number(std::string_view content, std::size_t position) {
  const std::string_view before = content.substr(0, position);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

} // namespace mdm

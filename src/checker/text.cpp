#include "text.hpp"

#include <algorithm>
#include <cstdint>

namespace mdm_check {
namespace {

struct Character {
  std::uint32_t code;
  std::size_t bytes; ///< 0: no valid UTF-8 begins here
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80)
    return {lead, 1};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length)
    return {0, 0};
  std::uint32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U)
      return {0, 0};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (overlong || surrogate || code > 0x10FFFF)
    return {0, 0};
  return {code, length};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

/// Invisible characters, line separators and marks of the direction of writing could make a message lie.
bool misleads(std::uint32_t code) {
  return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x2069) || code == 0xFEFF;
}

std::string escaped(std::string_view text, std::size_t most_characters) {
  static const char digits[] = "0123456789ABCDEF";
  std::string out;
  std::size_t characters = 0;
  while (!text.empty()) {
    const Character c = first_character(text);
    std::string piece(text.substr(0, std::max<std::size_t>(c.bytes, 1)));
    text.remove_prefix(piece.size());
    if (c.bytes == 0 || is_control(c.code) || misleads(c.code)) {
      std::string hex;
      for (const char byte : piece) {
        const unsigned value = static_cast<unsigned char>(byte);
        hex += {'\\', 'x', digits[value >> 4U], digits[value & 15U]};
      }
      piece = hex;
    }
    characters += c.bytes == piece.size() ? 1 : piece.size();
    if (characters > most_characters)
      return out + "...";
    out += piece;
  }
  return out;
}

} // namespace

std::string printable(std::string_view text) {
  return escaped(text, std::string::npos);
}

std::string quoted(std::string_view text) {
  return "'" + escaped(text, 80) + "'";
}

void demand_text(std::string_view text) {
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = first_character(text.substr(at));
    if (c.bytes == 0)
      throw Malformed(line, "not valid UTF-8: save the file as UTF-8 text");
    if (is_control(c.code) && c.code != '\t' && c.code != '\r' && c.code != '\n')
      throw Malformed(line, "a control character: give a text file without them");
    line += c.code == '\n' ? 1 : 0;
    at += c.bytes;
  }
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

mpz_class power(const mpz_class &base, unsigned long exponent) {
  mpz_class result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

mpq_class ten_to(long exponent) {
  const mpz_class magnitude = power(10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? mpq_class(1, magnitude) : mpq_class(magnitude);
}

mpq_class read_decimal(std::string_view text, char point, std::size_t line) {
  constexpr std::size_t most_digits = 1000;
  constexpr long most_exponent = 400;
  std::size_t at = 0;
  const auto is_at = [&](std::string_view set) {
    return at < text.size() && set.find(text[at]) != std::string_view::npos;
  };
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at]))
      ++at;
    return text.substr(begin, at - begin);
  };
  const bool negative = is_at("-");
  if (is_at("+-"))
    ++at;
  const std::string_view whole = digits();
  std::string_view fraction;
  if (is_at({&point, 1})) {
    ++at;
    fraction = digits();
  }
  bool well_formed = !whole.empty() || !fraction.empty();
  bool negative_exponent = false;
  std::string_view exponent_digits;
  if (well_formed && is_at("eE")) {
    ++at;
    negative_exponent = is_at("-");
    if (is_at("+-"))
      ++at;
    exponent_digits = digits();
    well_formed = !exponent_digits.empty();
  }
  if (!well_formed || at != text.size())
    throw Malformed(line, quoted(text) + " is not a number: write a decimal such as 0.075");
  if (whole.size() + fraction.size() > most_digits)
    throw Malformed(line, quoted(text) + " has more than 1000 digits: shorten it");
  long exponent = 0;
  for (const char c : exponent_digits)
    exponent = std::min(10 * exponent + (c - '0'), most_exponent + 1);
  if (exponent > most_exponent)
    throw Malformed(line, quoted(text) + " has an exponent beyond 400: choose another unit");

  mpz_class value(std::string(whole) + std::string(fraction), 10);
  if (negative)
    value = -value;
  exponent = (negative_exponent ? -exponent : exponent) - static_cast<long>(fraction.size());
  return value * ten_to(exponent);
}

} // namespace mdm_check

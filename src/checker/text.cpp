#include "text.hpp"

#include <algorithm>

namespace mdm_check {
namespace {

struct Character {
  std::uint32_t code;
  std::size_t bytes; ///< 0: no valid UTF-8 begins here
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80)
    return {lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  std::uint32_t code = lead & (0x7FU >> bytes);
  bool valid = lead >= 0xC2 && lead <= 0xF4;
  for (std::size_t i = 1; i < bytes; ++i) {
    valid = valid && (byte(i) & 0xC0U) == 0x80;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return valid && !overlong && !surrogate && code <= 0x10FFFF ? Character{code, bytes} : Character{0, 0};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

/// Invisible characters, line separators and marks of the direction of writing could make a message lie.
bool misleads(std::uint32_t code) {
  return (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x2069) || code == 0xFEFF;
}

} // namespace

void demand_form(bool holds, std::string_view place, const char *what) {
  if (!holds)
    throw Malformed(place, what);
}

std::string printable(std::string_view text, std::size_t most_characters) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (std::size_t characters = 0; !text.empty();) {
    const Character c = first_character(text);
    const std::string_view raw = text.substr(0, std::max<std::size_t>(c.bytes, 1));
    const bool plain = c.bytes > 0 && !is_control(c.code) && !misleads(c.code);
    characters += plain ? 1 : 4 * raw.size();
    if (characters > most_characters)
      return out + "...";
    for (const char byte : raw) {
      const auto value = static_cast<unsigned char>(byte);
      out += plain ? std::string{byte} : std::string{'\\', 'x', digits[value / 16], digits[value % 16]};
    }
    text.remove_prefix(raw.size());
  }
  return out;
}

std::string quoted(std::string_view text) {
  return "'" + printable(text, 80) + "'";
}

void demand_text(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    const bool space = c.code == '\t' || c.code == '\r' || c.code == '\n';
    demand_form(c.bytes > 0, text, "not valid UTF-8: save the file as UTF-8 text");
    demand_form(space || !is_control(c.code), text, "a control character: give a text file without them");
    text.remove_prefix(c.bytes);
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

Decimal split_decimal(std::string_view text, char point) {
  const auto take = [&](std::string_view set, std::size_t most) {
    const std::string_view taken = text.substr(0, std::min(text.find_first_not_of(set), most));
    text.remove_prefix(taken.size());
    return taken;
  };
  constexpr std::string_view digits = "0123456789";
  Decimal d;
  d.sign = take("+-", 1);
  d.whole = take(digits, text.size());
  d.point = take({&point, 1}, 1);
  d.fraction = take(digits, d.point.empty() ? 0 : text.size());
  d.e = take("eE", 1);
  d.exponent_sign = take("+-", d.e.size());
  d.exponent = take(digits, d.e.empty() ? 0 : text.size());
  d.rest = text;
  return d;
}

mpq_class read_decimal(std::string_view text, char point, std::string_view place) {
  const Decimal d = split_decimal(text, point);
  const std::size_t digits = d.whole.size() + d.fraction.size();
  if (digits == 0 || !d.rest.empty() || d.e.empty() != d.exponent.empty())
    throw Malformed(place, quoted(text) + " is not a number: write a decimal such as 0.075");
  if (digits > limit::decimal_digits)
    throw Malformed(place, quoted(text) + " has more than 1000 digits: shorten it");
  long exponent = 0;
  for (const char c : d.exponent)
    exponent = std::min(10 * exponent + (c - '0'), limit::exponent + 1);
  if (exponent > limit::exponent)
    throw Malformed(place, quoted(text) + " has an exponent beyond 400: choose another unit");
  exponent = (d.exponent_sign == "-" ? -exponent : exponent) - static_cast<long>(d.fraction.size());
  const mpz_class value(std::string(d.whole) + std::string(d.fraction), 10);
  return (d.sign == "-" ? mpz_class(-value) : value) * ten_to(exponent);
}

} // namespace mdm_check

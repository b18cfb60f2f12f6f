#include "text.hpp"

#include <algorithm>
#include <bit>

namespace mdm::checker {
namespace {

/// The character that a text begins with.
struct Character {
  std::size_t bytes; ///< 0: no valid UTF-8 begins here
  std::uint32_t code;

  bool is_control() const { return code < 0x20 || (code >= 0x7F && code < 0xA0); }
  /// Invisible characters, line separators and marks of the direction of writing could make a message lie.
  bool misleads() const {
    return code == 0xAD || code == 0x61C || (code >= 0x200B && code <= 0x200F) ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x2069) || code == 0xFEFF;
  }
  /// An editor may show a line of its own, or another order, where there is none.
  bool rearranges() const {
    return code == 0x61C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
  }
};

Character first_character(std::string_view text) {
  constexpr std::uint32_t least_code[] = {0, 0, 0x80, 0x800, 0x10000}; // in so many bytes
  const auto lead = static_cast<unsigned char>(text[0]);
  const auto bytes = static_cast<std::size_t>(std::countl_one(lead)); // 0 for ASCII
  bool valid = bytes != 1 && bytes <= 4 && bytes <= text.size();
  std::uint32_t code = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; valid && i < bytes; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    valid = byte >> 6U == 2;
    code = code << 6U | (byte & 0x3FU);
  }
  valid = valid && code >= least_code[bytes] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
  return valid ? Character{std::max<std::size_t>(bytes, 1), code} : Character{0, 0};
}

} // namespace

void demand_form(bool holds, std::string_view place, const char *what, std::string_view culprit) {
  if (!holds)
    throw Malformed(place, culprit.data() == nullptr ? what : quoted(culprit) + " " + what);
}

void demand_text(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_character(text);
    const bool space = c.code == '\t' || c.code == '\r' || c.code == '\n';
    demand_form(c.bytes > 0, text, "not valid UTF-8: save the file as UTF-8 text");
    demand_form(space || !c.is_control(), text, "a control character: give a text file without them");
    demand_form(!c.rearranges(), text,
                "a line separator or a mark of the direction of writing, which editors show as other lines "
                "than there are: remove it");
    demand_form(c.code != '\r' || text.substr(1).starts_with('\n'), text,
                "a carriage return without a line feed: end lines with LF or CRLF");
    text.remove_prefix(c.bytes);
  }
}

std::string printable(std::string_view text, std::size_t most_characters) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (std::size_t characters = 0; !text.empty();) {
    const Character c = first_character(text);
    const std::string_view raw = text.substr(0, std::max<std::size_t>(c.bytes, 1));
    const bool plain = c.bytes > 0 && !c.is_control() && !c.misleads();
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

std::string quoted_name(std::string_view name) {
  std::string out = "\"";
  while (!name.empty()) {
    const std::size_t plain = std::min(name.find_first_of("\"\\"), name.size());
    out += printable(name.substr(0, plain));
    name.remove_prefix(plain);
    if (!name.empty())
      out += std::string{'\\', name[0]};
    name.remove_prefix(name.empty() ? 0 : 1);
  }
  return out + "\"";
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

mpz_class power(const mpz_class &base, unsigned long exponent) {
  mpz_class result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

std::uint64_t bits(const mpq_class &value) {
  return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2), mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

mpq_class raised(const mpq_class &base, unsigned long exponent) {
  mpq_class result; // in lowest terms, as the base is
  result.get_num() = power(base.get_num(), exponent);
  result.get_den() = power(base.get_den(), exponent);
  return result;
}

mpq_class ten_to(long exponent) {
  const mpz_class magnitude = power(10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? mpq_class(1, magnitude) : mpq_class(magnitude);
}

Decimal split_decimal(std::string_view text) {
  const auto take = [&](std::size_t size) {
    const std::string_view taken = text.substr(0, size);
    text.remove_prefix(size);
    return taken;
  };
  const auto one_of = [&](const char *set) {
    return take(text.substr(0, 1).find_first_of(set) == 0 ? 1 : 0);
  };
  const auto digits = [&] {
    return take(
        static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin()));
  };
  Decimal d;
  d.sign = one_of("+-");
  d.whole = digits();
  d.point = one_of(".");
  d.fraction = d.point.empty() ? std::string_view() : digits();
  d.e = one_of("eE");
  d.exponent_sign = d.e.empty() ? std::string_view() : one_of("+-");
  d.exponent = d.e.empty() ? std::string_view() : digits();
  d.rest = text;
  return d;
}

mpq_class read_decimal(std::string_view text, std::string_view place, std::size_t most_digits) {
  const Decimal d = split_decimal(text);
  const std::string digits = std::string(d.whole) + std::string(d.fraction);
  demand_form(!digits.empty() && d.rest.empty() && d.e.empty() == d.exponent.empty(), place,
              "is not a number: write a decimal such as 0.075", text);
  demand_form(digits.size() <= most_digits, place, "has too many digits: shorten it", text);
  constexpr long most = 400;
  long exponent = 0;
  for (const char c : d.exponent)
    exponent = std::min(10 * exponent + (c - '0'), most + 1);
  demand_form(exponent <= most, place, "has an exponent beyond 400: choose another unit", text);
  exponent = (d.exponent_sign == "-" ? -exponent : exponent) - static_cast<long>(d.fraction.size());
  const mpz_class value(digits, 10);
  return (d.sign == "-" ? mpz_class(-value) : value) * ten_to(exponent);
}

mpq_class read_canonical(std::string_view text, std::string_view place, bool may_be_decimal) {
  const Decimal d = split_decimal(text);
  const bool whole = d.whole == "0" || (!d.whole.empty() && d.whole[0] != '0');
  const bool fraction =
      d.point.empty() || (may_be_decimal && !d.fraction.empty() && d.fraction.back() != '0');
  demand_form(whole && fraction && text.size() == d.whole.size() + d.point.size() + d.fraction.size(), place,
              "is no number of a certificate: write it like 75, or 0.75 where decimals may be", text);
  return read_decimal(text, place, 100'000);
}

mpq_class read_rational(std::string_view text, std::string_view place) {
  const std::size_t slash = text.find('/');
  const mpz_class numerator = read_canonical(text.substr(0, slash), place, false).get_num();
  if (slash == std::string_view::npos)
    return numerator;
  const mpz_class denominator = read_canonical(text.substr(slash + 1), place, false).get_num();
  demand_form(denominator >= 2 && gcd(numerator, denominator) == 1, place,
              "is not in lowest terms: write it like 3/2", text);
  return {numerator, denominator};
}

std::string plain_decimal(const mpq_class &value) {
  mpz_class rest;
  const mpz_class five = 5;
  const std::size_t twos = mpz_scan1(value.get_den_mpz_t(), 0);
  const std::size_t fives = mpz_remove(rest.get_mpz_t(), value.get_den_mpz_t(), five.get_mpz_t());
  const std::size_t places = std::max(twos, fives);
  const mpz_class scaled(abs(value) * ten_to(static_cast<long>(places)));
  std::string digits = scaled.get_str();
  if (digits.size() <= places)
    digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0)
    digits.insert(digits.size() - places, ".");
  return (value < 0 ? "-" : "") + digits;
}

} // namespace mdm::checker

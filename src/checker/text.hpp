#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

// Sections that comments name are those of proofs/certificate-format.md, theorems those of proofs/README.md.
namespace mdm_check {

/// What would take hours or gigabytes is malformed.
namespace limit {
constexpr std::size_t gradation_bytes = std::size_t{64} << 20U, certificate_bytes = std::size_t{256} << 20U;
constexpr std::size_t rows = std::size_t{1} << 20U, tree = std::size_t{1} << 22U;
constexpr std::size_t decimal_digits = 1000, certificate_digits = 100'000;
constexpr long exponent = 400;
constexpr std::uint64_t power_bits = std::uint64_t{1} << 20U, work_of_steps = std::uint64_t{1} << 34U,
                        work_of_scales = std::uint64_t{1} << 32U;
} // namespace limit

/// A file that is not what it should be, and the place in its text where that shows.
struct Malformed : std::runtime_error {
  Malformed(std::string_view place, const std::string &what) : std::runtime_error(what), at(place.data()) {}
  const char *at;
};

/// Throws Malformed unless the text is as it should be.
void demand_form(bool holds, std::string_view place, const char *what);

/// A certificate that is well formed, and does not prove its claim.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file to be judged, and the name under which messages speak of it.
struct Input {
  std::string name, text;
};

/// The text as valid UTF-8 without control characters, cut; whatever else it holds is escaped as \xNN.
std::string printable(std::string_view text, std::size_t most_characters = std::string::npos);

/// The text printable, cut to 80 characters, in single quotes.
std::string quoted(std::string_view text);

/// Demands valid UTF-8 without control characters other than tab, CR and LF.
void demand_text(std::string_view text);

/// The parts of `[+-]? D* [. D*] [(e|E) [+-]? D*]`, of which each may be empty, and the rest of the text.
struct Decimal {
  std::string_view sign, whole, point, fraction, e, exponent_sign, exponent, rest;
};
Decimal split_decimal(std::string_view text, char point);

/// The exact value of a decimal of section 4, whose point is the character `point`. The place is for
/// messages.
mpq_class read_decimal(std::string_view text, char point, std::string_view place);

bool is_digit(char c);
mpz_class power(const mpz_class &base, unsigned long exponent);
mpq_class ten_to(long exponent);

} // namespace mdm_check

#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

// Sections that comments name are those of proofs/certificate-format.md, theorems those of proofs/README.md.
namespace mdm::checker {

/// A file that is not what it should be, and the place in its text where that shows.
struct Malformed : std::runtime_error {
  Malformed(std::string_view place, const std::string &what) : std::runtime_error(what), at(place.data()) {}
  const char *at;
};

/// Throws Malformed unless the text is as it should be. What is wrong is said of the culprit, if one is
/// given.
void demand_form(bool holds, std::string_view place, const char *what, std::string_view culprit = {});

/// Demands valid UTF-8 without control characters other than tab, LF and CR before LF, and without line
/// separators and marks of the direction of writing (section 4).
void demand_text(std::string_view text);

/// The text as valid UTF-8 without control characters, cut; whatever else it holds is escaped as \xNN.
std::string printable(std::string_view text, std::size_t most_characters = std::string::npos);

/// The text printable, cut to 80 characters, in single quotes.
std::string quoted(std::string_view text);

/// A file's name printable, in double quotes, which a backslash precedes in it, as it does a backslash.
std::string quoted_name(std::string_view name);

/// The parts of `[+-]? D* [. D*] [(e|E) [+-]? D*]`, of which each may be empty, and the rest of the text.
struct Decimal {
  std::string_view sign, whole, point, fraction, e, exponent_sign, exponent, rest;
};
Decimal split_decimal(std::string_view text);

/// The exact value of a decimal of section 4. The place is for messages.
mpq_class read_decimal(std::string_view text, std::string_view place, std::size_t most_digits = 1000);

/// An integer of section 1, or also a decimal. The place is for messages.
mpq_class read_canonical(std::string_view text, std::string_view place, bool may_be_decimal);
/// A rational of section 1.
mpq_class read_rational(std::string_view text, std::string_view place);

/// A decimal fraction in its only form without an exponent: 75, 0.75, -1.5.
std::string plain_decimal(const mpq_class &value);

/// The bits of the longer of numerator and denominator.
std::uint64_t bits(const mpq_class &value);
bool is_digit(char c);
mpz_class power(const mpz_class &base, unsigned long exponent);
mpq_class raised(const mpq_class &base, unsigned long exponent);
mpq_class ten_to(long exponent);

} // namespace mdm::checker

#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mdm_check {

/// A file that is not what it should be: says what is wrong and what to do. Sections that comments name are
/// those of proofs/certificate-format.md, theorems those of proofs/README.md.
struct Malformed : std::runtime_error {
  Malformed(std::size_t at_line, const std::string &what) : std::runtime_error(what), line(at_line) {}
  std::size_t line;
};

/// A file to be judged, and the name under which messages speak of it.
struct Input {
  std::string name;
  std::string text;
};

/// The text as valid UTF-8 without control characters; whatever else it holds is escaped as \xNN.
std::string printable(std::string_view text);

/// The text printable, cut to 80 characters, in single quotes.
std::string quoted(std::string_view text);

/// Demands valid UTF-8 without control characters other than tab, CR and LF.
void demand_text(std::string_view text);

/// The exact value of a decimal of section 4, whose point is the character `point`.
mpq_class read_decimal(std::string_view text, char point, std::size_t line);

bool is_digit(char c);
mpz_class power(const mpz_class &base, unsigned long exponent);
mpq_class ten_to(long exponent);

} // namespace mdm_check

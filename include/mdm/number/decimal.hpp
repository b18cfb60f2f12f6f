#pragma once
/// \file
/// Decimals, read and printed exactly.

#include <mdm/number/rational.hpp>

namespace mdm {

/// Limits on decimals in input: what is longer is refused with a message.
inline constexpr std::size_t max_decimal_digits = 1000;
/// The greatest absolute value of an exponent.
inline constexpr unsigned max_decimal_exponent = 400;

/// The value of a decimal such as `3.86`, `+.5` or `1.2e-3`, exactly; `point` is the decimal sign.
/// \throws InputError if `text` is anything else or passes the limits.
Rational parse_decimal(std::string_view text, char point = '.');

/// One unit of the last digit of such a decimal: 1/100 for `3.80`.
/// \throws InputError as parse_decimal
Rational last_digit_unit(std::string_view text, char point = '.');

/// digits * 10^-places in plain notation with exactly so many places, for example `0.0380`.
std::string fixed_decimal(const Integer &digits, unsigned places);

/// digits * 10^-places in plain notation without trailing zeros, for example `0.038`.
std::string decimal_string(const Integer &digits, unsigned places);

/// The value of r in plain notation; nothing if r is no decimal (1/3).
std::optional<std::string> exact_decimal(const Rational &r);

/// The value of a decimal in plain notation.
/// \pre r is a decimal
std::string to_decimal(const Rational &r);

/// r cut towards zero to `digits` significant digits, with an exponent when |r| < 1e-6: for people, not for
/// proofs.
std::string approximate(const Rational &r, unsigned digits);

} // namespace mdm

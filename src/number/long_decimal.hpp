#pragma once
/// \file
/// The decimals of answers, which can be longer than those of the user.

#include <mdm/number/rational.hpp>

namespace mdm {

/// Limit on the decimals of an answer: mdm writes as many digits as lie inside a class, and a narrow class
/// takes several times max_decimal_digits.
inline constexpr std::size_t max_long_decimal_digits = 100'000;

/// The value of a decimal of an answer: what parse_decimal reads, and plain notation up to that many digits.
/// \throws InputError if `text` is anything else
Rational parse_long_decimal(std::string_view text);

} // namespace mdm

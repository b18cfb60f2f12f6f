#pragma once
/// \file
/// Numbers as people type them in options: `10000`, `1e4` and `10_000` are the same.

#include <mdm/number/rational.hpp>

namespace mdm {

/// A decimal as parse_decimal reads it, also with an underscore between two digits.
/// \throws InputError if `text` is anything else or passes the limits
Rational parse_typed_decimal(std::string_view text);

/// The whole number from 0 on that is so written, also with an exponent; nothing of anything else.
std::optional<Integer> parse_typed_natural(std::string_view text);

} // namespace mdm

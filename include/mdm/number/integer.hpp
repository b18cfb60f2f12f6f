#pragma once
/// \file
/// Integers of any length.

#include <boost/multiprecision/gmp.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// An integer of any length. Expression templates are off: an expression is a value and `auto` cannot dangle.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Largest integer <= n / d, for d > 0.
Integer floor_div(const Integer &n, const Integer &d);

/// Least integer >= n / d, for d > 0.
Integer ceil_div(const Integer &n, const Integer &d);

/// base^exponent.
Integer power(const Integer &base, unsigned exponent);

/// 10^exponent.
Integer power_of_ten(unsigned exponent);

/// Largest integer y with y^degree <= n, for n >= 0 and degree >= 1.
Integer floor_root(const Integer &n, unsigned degree);

/// Number of binary digits of |n|; 1 for 0.
std::size_t bit_length(const Integer &n);

/// The integer that `text` writes in decimal digits (at most 1000, no sign); nothing else is accepted.
std::optional<Integer> parse_natural(std::string_view text);

/// Decimal digits of n.
std::string to_string(const Integer &n);

} // namespace mdm

#pragma once
/// \file
/// Enclosures in JSON and in words.

#include "answer/json_values.hpp"

#include <mdm/number/interval.hpp>

namespace mdm {

/// `p/q` where the number is known; else decimals around it that differ from it by no more than 10^-30.
void write_number(JsonWriter &json, const Interval &y);

/// Six digits of a number, or a range where it is not known so well.
std::string interval_text(const Interval &y);

/// 100 y cut to so many significant digits, or a range where that does not tell it.
std::string percent_text(const Interval &y, unsigned digits);
/// As many digits, `digits` or more, as tell the two shares apart in percent; some that do not, where they
/// are nearer than 10^-100 to each other.
unsigned digits_apart(const Rational &a, const Rational &b, unsigned digits);

} // namespace mdm

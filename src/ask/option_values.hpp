#pragma once
/// \file
/// Values of options, read exactly. All take the name of the option, without hyphens before it, and throw an
/// InputError that names it.

#include "gradation/length.hpp"
#include "text/option_name.hpp"

#include <mdm/number/rational.hpp>
#include <mdm/text/error.hpp>

#include <chrono>
#include <string>
#include <vector>

namespace mdm {

/// Calls read(text) and names the option in what it throws.
template <class Read>
auto named(const std::string &name, const std::string &text, Read read) {
  try {
    return read(text);
  } catch (const InputError &e) {
    throw InputError(option(name) + ": " + e.what());
  }
}

/// A decimal.
Rational number(const std::string &name, const std::string &text);
/// A whole number from `least` on.
Integer natural(const std::string &name, const std::string &text, const Integer &least);
/// The same from 0 on; what is beyond 2^64 - 1 counts as that.
std::uint64_t natural64(const std::string &name, const std::string &text);
/// The same; what is beyond 2^64 - 1 is refused.
std::uint64_t seed64(const std::string &name, const std::string &text);
/// A whole number from `least` to `most`.
unsigned small_natural(const std::string &name, const std::string &text, unsigned least, unsigned most);
/// A decimal above 0.
Rational positive(const std::string &name, const std::string &text);
/// A decimal from 0 on.
Rational not_negative(const std::string &name, const std::string &text);
/// Percent, a decimal from 0 to 100, with the sign or without.
Rational percent_of(const std::string &name, const std::string &text);
/// Seconds, a decimal from 0 on, cut to milliseconds; at most some thirty years.
std::chrono::milliseconds duration(const std::string &name, const std::string &text);
/// Significant digits, 1 to 1000.
unsigned digits_of(const std::string &name, const std::string &text);
/// Numbers above 0 as `1,2,5` or `FROM:TO:STEP`, ascending, each once; at most 1000.
std::vector<Rational> number_list(const std::string &name, const std::string &text);

/// A length above 0, with a unit or without one.
Length length(const std::string &name, const std::string &text);
/// The sides of a box, `AxB` or `AxBxC`. \param unit  of lengths without one, and of the result
std::vector<Rational> box_sides(const std::string &name, const std::string &text, SizeUnit unit);
/// \throws InputError naming the option if it is no unit of length
SizeUnit size_unit_of(const std::string &name, const std::string &text);

} // namespace mdm

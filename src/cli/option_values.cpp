#include "cli/option_values.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <limits>

namespace mdm::cli {
namespace {

/// Digits beyond this are of no use, and cost.
constexpr unsigned most_digits = 1000;

Rational decimal(const std::string &option, const std::string &text) {
  return named(option, text, [](const std::string &t) { return parse_decimal(t); });
}

} // namespace

Integer natural(const std::string &option, const std::string &text, const Integer &least) {
  const std::optional<Integer> n = parse_natural(text);
  if (!n || *n < least)
    throw InputError(option + ": " + in_quotes(text) + " is not a whole number from " + to_string(least) +
                     " on (at most 1000 digits)");
  return *n;
}

std::uint64_t natural64(const std::string &option, const std::string &text) {
  const Integer n = natural(option, text, 0);
  const Integer most = std::numeric_limits<std::uint64_t>::max();
  return n > most ? std::numeric_limits<std::uint64_t>::max() : static_cast<std::uint64_t>(n);
}

std::uint64_t seed64(const std::string &option, const std::string &text) {
  const Integer n = natural(option, text, 0);
  if (n > std::numeric_limits<std::uint64_t>::max())
    throw InputError(option + ": at most 18446744073709551615 (64 bits)");
  return static_cast<std::uint64_t>(n);
}

Rational positive(const std::string &option, const std::string &text) {
  const Rational r = decimal(option, text);
  if (r <= 0)
    throw InputError(option + ": " + in_quotes(text) + " is not positive: write a number above 0");
  return r;
}

Rational not_negative(const std::string &option, const std::string &text) {
  const Rational r = decimal(option, text);
  if (r < 0)
    throw InputError(option + ": " + in_quotes(text) + " is negative: write a number from 0 on");
  return r;
}

std::chrono::milliseconds duration(const std::string &option, const std::string &text) {
  const Rational seconds = not_negative(option, text);
  const Integer thirty_years = 1'000'000'000'000;
  const Integer milliseconds = std::min(floor(Rational(seconds * 1000)), thirty_years);
  return std::chrono::milliseconds(static_cast<std::int64_t>(milliseconds));
}

unsigned digits_of(const std::string &option, const std::string &text) {
  const Integer n = natural(option, text, 1);
  if (n > most_digits)
    throw InputError(option + ": " + in_quotes(text) + " is above 1000: write a number up to that");
  return static_cast<unsigned>(n);
}

Length length(const std::string &option, const std::string &text) {
  return named(option, text, parse_length);
}

std::vector<Rational> box_sides(const std::string &option, const std::string &text, SizeUnit unit) {
  std::vector<Rational> sides;
  for (const Length &side : named(option, text, parse_lengths))
    sides.push_back(side.in(unit));
  if (sides.size() < 2 || sides.size() > 3)
    throw InputError(option + ": " + in_quotes(text) + " is neither AxB nor AxBxC: write for example 50x50");
  return sides;
}

LengthUnit length_unit_of(const std::string &option, const std::string &text) {
  const std::optional<LengthUnit> unit = parse_length_unit(text);
  if (!unit)
    throw InputError(option + ": " + in_quotes(text) + " is unknown: use mm, um, m or in");
  return *unit;
}

} // namespace mdm::cli

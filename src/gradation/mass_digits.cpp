#include "gradation/mass_digits.hpp"

#include "gradation/shown.hpp"
#include "number/decimal_exponent.hpp"
#include "text/option_name.hpp"
#include "text/short_list.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

constexpr unsigned double_digits = 15; ///< every decimal of so many digits survives a double

/// r to a whole number of `unit`s.
Rational to_units(const Rational &r, const Rational &unit) {
  const Integer n = floor(Rational(abs(r) / unit + ratio(1, 2)));
  const Rational size = Rational(n) * unit;
  return r < 0 ? Rational(-size) : size;
}

/// The significant digits of a decimal that is no integer; 0 of what is no decimal.
std::size_t significant_digits(const Rational &r) {
  const std::string text = exact_decimal(r).value_or("");
  const std::size_t first = std::min(text.find_first_of("123456789"), text.size());
  const std::string digits = text.substr(first);
  return digits.size() - (digits.find('.') == std::string::npos ? 0 : 1);
}

/// False for all decimals of at most nine places. Without a copy: it looks at every mass of a batch.
bool has_many_places(const Rational &mass) {
  constexpr std::size_t short_bits = 30; // of 10^9
  return mpz_sizeinbase(mpq_denref(mass.backend().data()), 2) > short_bits;
}

/// The short decimal that a mass stands beside: at most nine places behind the point, and no farther than the
/// errors of a difference or sum of doubles up to `largest`. Nothing for most numbers of 16 digits, too.
std::optional<Rational> short_neighbour(const Rational &mass, const Rational &largest) {
  const std::size_t digits = significant_digits(mass);
  if (digits < double_digits || digits > 17)
    return std::nullopt;
  const Rational error = largest / Rational(Integer(1) << 50);
  for (unsigned places = 0; places <= 9; ++places) {
    const Rational near = to_units(mass, ten_to(-static_cast<long>(places)));
    if (abs(Rational(mass - near)) <= error)
      return near;
  }
  return std::nullopt;
}

} // namespace

Rational digit_unit(const Rational &r, unsigned digits) {
  assert(digits > 0);
  return r == 0 ? Rational(0) : ten_to(decimal_exponent(r) - static_cast<long>(digits) + 1);
}

Rational to_digits(const Rational &r, unsigned digits) {
  return r == 0 ? r : to_units(r, digit_unit(r, digits));
}

std::optional<std::string> float_dust_note(const std::vector<Rational> &masses) {
  if (std::none_of(masses.begin(), masses.end(), has_many_places))
    return std::nullopt;
  Rational largest = 100; // what percents were differences of
  for (const Rational &mass : masses)
    largest = std::max(largest, mass);
  ShortList pairs;
  unsigned digits = double_digits;
  bool has_zero = false;
  for (const Rational &mass : masses) {
    const std::optional<Rational> near =
        has_many_places(mass) ? short_neighbour(mass, largest) : std::nullopt;
    if (!near)
      continue;
    pairs.add(fmt::format("{} beside {}", to_decimal(mass), to_decimal(*near)));
    has_zero |= *near == 0;
    while (*near != 0 && digits > 1 && to_digits(mass, digits) != *near)
      --digits;
  }
  if (pairs.empty())
    return std::nullopt;
  return fmt::format("Masses look like floating point: {}. They are taken as written; {} {} takes the "
                     "short ones{}.",
                     pairs.text(), option("round"), digits,
                     has_zero ? ", but for 0: write that yourself" : "");
}

std::optional<std::string> settle_digits(std::vector<Rational> &masses, std::optional<unsigned> round,
                                         std::string_view of) {
  if (!round)
    return float_dust_note(masses);
  for (Rational &mass : masses)
    mass = to_digits(mass, *round);
  const std::string digits =
      *round == 1 ? "1 significant digit" : fmt::format("{} significant digits", *round);
  return of.empty()
             ? fmt::format("All masses were taken to {}.", digits)
             : fmt::format("All {} values were taken to {}; classes have their differences.", of, digits);
}

std::optional<unsigned> digits_that_give(const Rational &value, const Rational &whole) {
  for (unsigned digits = double_digits; digits >= 3; --digits)
    if (to_digits(value, digits) == whole)
      return digits;
  return std::nullopt;
}

} // namespace mdm

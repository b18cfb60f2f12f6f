// Proved decimals around roots (Theorem 9). What comes in is n / d, a degree and a number of digits; what
// goes out are lo 10^-places <= y <= hi 10^-places, one unit apart, or equal where y is that decimal.
//
// lo = floor of the root of floor(n 10^(places degree) / d), in integers, so nothing is rounded unseen.
// Whether y is a decimal is asked of the fraction: n / d must be the power of one, and that a decimal. For
// cube roots of few digits pairs of doubles are tried first (quick_cube_root.cpp); where they do not
// decide, integers do.

#include "number/quick_cube_root.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>

#include <cassert>

namespace mdm {
namespace {

/// Least number of decimal places with which the decimal r is an integer; nothing if r is no decimal.
std::optional<unsigned> decimal_places(const Rational &r) {
  const std::optional<std::string> text = exact_decimal(r);
  if (!text)
    return std::nullopt;
  const std::size_t point = text->find('.');
  return point == std::string::npos ? 0 : static_cast<unsigned>(text->size() - point - 1);
}

/// True if n / d is a decimal: without its factors 2 and 5, d divides n.
bool terminates(const Integer &n, const Integer &d) {
  Integer rest;
  mpz_tdiv_q_2exp(rest.backend().data(), d.backend().data(), mpz_scan1(d.backend().data(), 0));
  for (const unsigned long five : {15625UL, 5UL}) // 5^6, then what is left
    while (mpz_divisible_ui_p(rest.backend().data(), five) != 0)
      mpz_divexact_ui(rest.backend().data(), rest.backend().data(), five);
  return mpz_divisible_p(n.backend().data(), rest.backend().data()) != 0;
}

/// The root of n / d, if it is a decimal.
std::optional<Enclosure> decimal_root(const Integer &n, const Integer &d, unsigned degree) {
  if (!terminates(n, d))
    return std::nullopt;
  const std::optional<Rational> root = exact_root(ratio(n, d), degree);
  if (!root)
    return std::nullopt;
  // Powers of decimals are decimals, and so are their roots if they are fractions.
  const unsigned places = decimal_places(*root).value();
  const Integer value = numerator(*root) * power_of_ten(places) / denominator(*root);
  return Enclosure{value, value, places};
}

/// Decimal places that give (n/d)^(1/degree) `digits` significant digits or one more.
unsigned places_for(const Integer &n, const Integer &d, unsigned degree, unsigned digits) {
  // y^degree = n/d has some (bits of n/d) / degree bits before the point. log10(2) < 0.30103 and > 0.30102;
  // the estimate of the leading digit's place is never too high, and one too low at most.
  const auto bits = static_cast<std::int64_t>(bit_length(n)) - static_cast<std::int64_t>(bit_length(d)) - 1;
  const std::int64_t degree_bits = bits >= 0 ? bits / degree : -((-bits - 1) / degree) - 1;
  const std::int64_t leading =
      degree_bits >= 0 ? degree_bits * 30102 / 100000 : -((-degree_bits * 30103 - 1) / 100000) - 1;
  const std::int64_t wanted = std::int64_t{digits} - 1 - leading;
  return wanted > 0 ? static_cast<unsigned>(wanted) : 0;
}

/// floor(10^places (n/d)^(1/degree)).
Integer floor_of_root(const Integer &n, const Integer &d, unsigned degree, unsigned places) {
  if (degree == 3)
    if (std::optional<Integer> root = quick_cube_root(n, d, places))
      return std::move(*root);
  Integer scaled = power_of_ten(places * degree);
  mpz_mul(scaled.backend().data(), scaled.backend().data(), n.backend().data());
  mpz_fdiv_q(scaled.backend().data(), scaled.backend().data(), d.backend().data());
  return floor_root(scaled, degree);
}

} // namespace

Rational Enclosure::lower() const {
  return ratio(lo, power_of_ten(places));
}
Rational Enclosure::upper() const {
  return ratio(hi, power_of_ten(places));
}
std::string Enclosure::lower_text() const {
  return decimal_string(lo, places);
}
std::string Enclosure::upper_text() const {
  return decimal_string(hi, places);
}
std::string Enclosure::text() const {
  return is_point() ? lower_text() : "[" + fixed_decimal(lo, places) + ", " + fixed_decimal(hi, places) + "]";
}

Enclosure enclose_root(const Integer &n, const Integer &d, unsigned degree, unsigned digits) {
  assert(n > 0 && d > 0 && degree >= 1 && digits >= 1);
  const bool is_power = degree != 3 || may_be_cube(n, d);
  if (is_power)
    if (std::optional<Enclosure> exact = decimal_root(n, d, degree))
      return std::move(*exact);
  unsigned places = places_for(n, d, degree, digits);
  Integer lo = floor_of_root(n, d, degree, places);
  if (places > 0 && lo >= power_of_ten(digits)) {
    lo = floor_div(lo, 10);
    --places;
  }
  Integer hi = lo + 1;
  return {std::move(lo), std::move(hi), places};
}

Enclosure enclose_interval(const Integer &lo, const Integer &hi, const Integer &d, unsigned digits) {
  assert(lo > 0 && lo <= hi && d > 0 && digits >= 1);
  unsigned places = places_for(lo, d, 1, digits);
  const Integer unit = power_of_ten(places);
  Integer below = floor_div(lo * unit, d);
  Integer above = ceil_div(hi * unit, d);
  if (places > 0 && below >= power_of_ten(digits)) {
    below = floor_div(below, 10);
    above = ceil_div(above, 10);
    --places;
  }
  return {std::move(below), std::move(above), places};
}

} // namespace mdm

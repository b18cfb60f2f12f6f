#include "particles/written_number.hpp"

#include "gradation/law_inverse.hpp"
#include "number/nearest_double.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace mdm {
namespace {

/// Every double, or float, is the one nearest to one of its decimals of so many digits.
constexpr unsigned digits_of_double = std::numeric_limits<double>::max_digits10;
constexpr unsigned digits_of_float = std::numeric_limits<float>::max_digits10;

/// The double, or float, nearest to a decimal; 0 if it is not normal.
double normal(const std::string &decimal, bool is_float) {
  const auto normal_or_0 = [](auto value) { return value && std::isnormal(*value) ? double{*value} : 0; };
  return is_float ? normal_or_0(nearest_float(decimal)) : normal_or_0(nearest_double(decimal));
}

/// Nothing if the number or its double is not allowed.
std::optional<WrittenNumber> written(const SizeToWrite &size, std::string text) {
  WrittenNumber n{std::move(text), 0};
  n.value = normal(n.text, size.is_float);
  if (n.value == 0 || !size.allows(n.decimal()) || !size.allows(exact_value(n.value)))
    return std::nullopt;
  return n;
}

/// The one with the smaller error, of those that are there.
std::optional<WrittenNumber> closer(const SizeToWrite &size, std::optional<WrittenNumber> a,
                                    std::optional<WrittenNumber> b) {
  if (!a || !b)
    return a ? a : b;
  return size.error(b->decimal()) < size.error(a->decimal()) ? b : a;
}

/// Around x there may be a double, or float, that no decimal next to x leads to.
template <class Number>
std::optional<WrittenNumber> neighbour(const SizeToWrite &size, std::optional<Number> around) {
  constexpr Number above = std::numeric_limits<Number>::infinity();
  std::optional<WrittenNumber> best;
  if (around)
    for (const Number value : {*around, std::nextafter(*around, Number(0)), std::nextafter(*around, above)})
      best = closer(size, std::move(best), written(size, fmt::to_string(value)));
  return best;
}

} // namespace

Rational WrittenNumber::decimal() const {
  return parse_decimal(text);
}

Rational exact_value(double value) {
  Rational r;
  mpq_set_d(r.backend().data(), value);
  return r;
}

std::string short_decimal(Integer digits, int places) {
  if (digits == 0)
    return "0";
  while (digits % 10 == 0) {
    digits /= 10;
    --places;
  }
  const std::string figures = to_string(digits);
  const std::string plain = places >= 0 ? decimal_string(digits, static_cast<unsigned>(places))
                                        : figures + std::string(static_cast<std::size_t>(-places), '0');
  const int exponent = static_cast<int>(figures.size()) - 1 - places;
  const std::string scientific = figures.substr(0, 1) + (figures.size() > 1 ? "." + figures.substr(1) : "") +
                                 "e" + std::to_string(exponent);
  return scientific.size() < plain.size() ? scientific : plain;
}

std::string short_decimal(const Rational &r) {
  for (unsigned places = 0; places <= max_decimal_exponent; ++places) {
    const Rational shifted = r * power_of_ten(places);
    if (denominator(shifted) == 1 && numerator(shifted) < power_of_ten(digits_of_double))
      return short_decimal(numerator(shifted), static_cast<int>(places));
    if (shifted >= Rational(power_of_ten(digits_of_double)))
      break;
  }
  return fmt::to_string(mpq_get_d(r.backend().data()));
}

Rational SizeToWrite::error(const Rational &y) const {
  const Rational off = (law.is_power() ? power(y, degree) : law.powered(y)) / powered - 1;
  return off < 0 ? Rational(-off) : off;
}

bool SizeToWrite::allows(const Rational &y) const {
  return y > lower && y <= upper && error(y) <= most_error;
}

std::optional<WrittenNumber> shortest_number(const SizeToWrite &size) {
  const Enclosure x = enclose_inverse(size.law, numerator(size.powered), denominator(size.powered),
                                      size.degree, digits_of_double + 3);
  const unsigned known = static_cast<unsigned>(to_string(x.hi).size());
  // Of a power |y^a / x^a - 1| >= |y / x - 1|: what is farther from x than this, in its last places, has too
  // large an error.
  const Integer most_off = floor(Rational(size.most_error * x.hi));
  const unsigned most_digits = size.is_float ? digits_of_float : digits_of_double;
  for (unsigned digits = 1; digits <= std::min(known, most_digits); ++digits) {
    const unsigned cut = known - digits;
    const Integer unit = power_of_ten(cut);
    const int places = static_cast<int>(x.places) - static_cast<int>(cut);
    const Integer below = floor_div(x.lo, unit);
    const Integer above = ceil_div(x.hi, unit);
    std::optional<WrittenNumber> best =
        closer(size,
               below > 0 && x.lo - below * unit <= most_off ? written(size, short_decimal(below, places))
                                                            : std::nullopt,
               above * unit - x.hi <= most_off ? written(size, short_decimal(above, places)) : std::nullopt);
    if (best)
      return best;
  }
  const std::string near = short_decimal(x.lo, static_cast<int>(x.places));
  return size.is_float ? neighbour(size, nearest_float(near)) : neighbour(size, nearest_double(near));
}

} // namespace mdm

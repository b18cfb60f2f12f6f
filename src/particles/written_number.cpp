#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/particles/written_number.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace mdm {
namespace {

/// Every double is the one nearest to one of its decimals of so many digits.
constexpr unsigned digits_of_double = std::numeric_limits<double>::max_digits10;

/// The double nearest to a decimal; infinite or 0 where it is out of range.
double nearest_double(const std::string &decimal) {
  double value = 0;
  std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  return value;
}

/// Nothing if the number or its double is not allowed.
std::optional<WrittenNumber> written(const SizeToWrite &size, std::string text) {
  WrittenNumber n{std::move(text), 0};
  n.value = nearest_double(n.text);
  if (!std::isnormal(n.value) || !size.allows(n.decimal()) || !size.allows(exact_value(n.value)))
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

/// Around x there may be a double that no decimal next to x leads to.
std::optional<WrittenNumber> neighbour(const SizeToWrite &size, double around) {
  constexpr double above = std::numeric_limits<double>::infinity();
  std::optional<WrittenNumber> best;
  for (const double value : {around, std::nextafter(around, 0.0), std::nextafter(around, above)}) {
    std::array<char, 64> buffer{};
    const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    best = closer(size, std::move(best), written(size, std::string(buffer.data(), end.ptr)));
  }
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
  std::array<char, 64> buffer{};
  const std::to_chars_result end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), mpq_get_d(r.backend().data()));
  return std::string(buffer.data(), end.ptr);
}

Rational SizeToWrite::error(const Rational &y) const {
  const Rational off = power(y, degree) / powered - 1;
  return off < 0 ? Rational(-off) : off;
}

bool SizeToWrite::allows(const Rational &y) const {
  return y > lower && y <= upper && error(y) <= most_error;
}

std::optional<WrittenNumber> shortest_number(const SizeToWrite &size) {
  const Enclosure x =
      enclose_root(numerator(size.powered), denominator(size.powered), size.degree, digits_of_double + 3);
  const unsigned known = static_cast<unsigned>(to_string(x.hi).size());
  // |y^a / x^a - 1| >= |y / x - 1|: what is farther from x than this, in its last places, has too large an
  // error.
  const Integer most_off = floor(Rational(size.most_error * x.hi));
  for (unsigned digits = 1; digits <= std::min(known, digits_of_double); ++digits) {
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
  return neighbour(size, nearest_double(short_decimal(x.lo, static_cast<int>(x.places))));
}

} // namespace mdm

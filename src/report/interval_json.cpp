#include "report/interval_json.hpp"

#include "number/real.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

void write_number(JsonWriter &json, const Interval &y) {
  // Enough digits for a reader who computes on with an enclosure.
  constexpr unsigned enclosure_digits = 30;
  if (y.is_point()) {
    write(json, y.lo);
    return;
  }
  const Rational unit(power_of_ten(enclosure_digits));
  const auto outer = [](const Integer &n) {
    return n < 0 ? "-" + decimal_string(Integer(-n), enclosure_digits) : decimal_string(n, enclosure_digits);
  };
  json.bounds(outer(floor(Rational(y.lo * unit))), outer(ceil(Rational(y.hi * unit))));
}

std::string interval_text(const Interval &y) {
  constexpr unsigned digits = 6;
  const Rational middle = (y.lo + y.hi) / 2, half = (y.hi - y.lo) / 2;
  if (half == 0 || half * Rational(2 * power_of_ten(digits)) <= abs(middle))
    return middle == 0 ? "0" : rounded(Real(middle), digits);
  return "[" + approximate(y.lo, digits) + ", " + approximate(y.hi, digits) + "]";
}

unsigned digits_apart(const Rational &a, const Rational &b, unsigned digits) {
  constexpr unsigned most = 100;
  while (a != b && digits < most && percent_text(Interval(a), digits) == percent_text(Interval(b), digits))
    ++digits;
  return digits;
}

std::string percent_text(const Interval &y, unsigned digits) {
  const std::string lo = approximate(Rational(100 * y.lo), digits);
  if (y.is_point())
    return lo;
  const std::string hi = approximate(Rational(100 * y.hi), digits);
  return lo == hi ? lo : "[" + lo + ", " + hi + "]";
}

} // namespace mdm

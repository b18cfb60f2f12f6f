#include <mdm/gradation/root_size.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>

#include <cassert>
#include <numeric>

namespace mdm {
namespace {

constexpr long shown_digits = 15;

/// Sign of x^degree - y^degree for x and the fraction y >= 0.
int compare_to(const RootSize &x, const Rational &y) {
  return x.power.compare(power(y, x.degree));
}

/// 10^exponent.
Rational power_of_ten_at(long exponent) {
  const Rational scale(power_of_ten(static_cast<unsigned>(exponent < 0 ? -exponent : exponent)));
  return exponent < 0 ? Rational(1 / scale) : scale;
}

/// A decimal as digits * 10^exponent, the last digit not 0; nothing if it is none.
struct Digits {
  Integer digits;
  long exponent;
};
std::optional<Digits> digits_of(const Rational &r) {
  const std::optional<std::string> text = exact_decimal(r);
  if (!text)
    return std::nullopt;
  std::string all = *text;
  long exponent = 0;
  if (const std::size_t point = all.find('.'); point != std::string::npos) {
    exponent = -static_cast<long>(all.size() - point - 1);
    all.erase(point, 1);
  }
  while (all.size() > 1 && all.back() == '0') {
    all.pop_back();
    ++exponent;
  }
  Integer digits;
  mpz_set_str(digits.backend().data(), all.c_str(), 10);
  return Digits{digits, exponent};
}

/// The decimal of 15 significant digits that is nearest to x > 0, which may be a fraction without an end.
Rational rounded(const RootSize &x) {
  const Enclosure e =
      enclose_root(numerator(x.power), denominator(x.power), x.degree, static_cast<unsigned>(shown_digits));
  const auto length = static_cast<long>(to_string(e.lo).size());
  const long surplus = length > shown_digits ? length - shown_digits : 0;
  const Rational unit = power_of_ten_at(surplus - static_cast<long>(e.places));
  const Rational below = Rational(floor_div(e.lo, power_of_ten(static_cast<unsigned>(surplus)))) * unit;
  return compare_to(x, Rational(below + unit / 2)) > 0 ? Rational(below + unit) : below;
}

} // namespace

std::optional<Rational> RootSize::fraction() const {
  return degree == 1 ? power : exact_root(power, degree);
}

bool RootSize::is(const Rational &other, unsigned of_degree) const {
  return compare(*this, RootSize{other, of_degree}) == 0;
}

std::string RootSize::text() const {
  const std::optional<Rational> exact = fraction();
  const std::optional<std::string> decimal = exact ? exact_decimal(*exact) : std::nullopt;
  return decimal ? *decimal : to_decimal(rounded(*this));
}

bool RootSize::is_named_by(const Rational &size) const {
  if (compare_to(*this, size) == 0)
    return true;
  if (size <= 0 || power == 0 || fraction())
    return false;
  const std::optional<Digits> written = digits_of(size);
  if (!written)
    return false;
  const auto length = static_cast<long>(to_string(written->digits).size());
  if (length > shown_digits)
    return false;
  const Rational half_unit = power_of_ten_at(written->exponent + length - shown_digits) / 2;
  return compare_to(*this, Rational(size - half_unit)) > 0 &&
         compare_to(*this, Rational(size + half_unit)) < 0;
}

int compare(const RootSize &x, const RootSize &y) {
  if (x.degree == y.degree)
    return x.power.compare(y.power);
  const unsigned common = std::gcd(x.degree, y.degree);
  const unsigned to_x = y.degree / common, to_y = x.degree / common;
  return (to_x == 1 ? x.power : power(x.power, to_x)).compare(to_y == 1 ? y.power : power(y.power, to_y));
}

Rational nearest_decimal(const RootSize &x) {
  assert(x.power > 0 && !x.fraction());
  return rounded(x);
}

Rational drawn_size(const RootSize &x) {
  const std::optional<Rational> exact = x.fraction();
  return exact ? *exact : nearest_decimal(x);
}

Interval bounds(const RootSize &x) {
  constexpr unsigned digits = 31;
  if (const std::optional<Rational> exact = x.fraction())
    return {*exact, *exact};
  const Enclosure e = enclose_root(numerator(x.power), denominator(x.power), x.degree, digits);
  return {e.lower(), e.upper()};
}

} // namespace mdm

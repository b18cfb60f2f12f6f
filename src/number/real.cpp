// Real numbers to any precision. A Real is a computation: asked for so many bits it gives a ball that
// contains the number. Comparisons ask for 128, 256, ... bits until the balls do not meet. Two equal
// numbers would be refined for ever, so from some point on the exact values are asked, where they are
// known; at most_bits, some 1,200 digits, what is not told is undecided. Every caller has an answer for
// that. Whatever is decided is certain, since balls never lose the number.

#include "number/real.hpp"

#include "number/decimal_exponent.hpp"
#include "number/power_product.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/interval.hpp>

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace mdm {
namespace {

/// Decimal places of `digits` significant digits of the number of largest magnitude in i.
long places_for(const Interval &i, unsigned digits) {
  const Rational largest = std::max(abs(i.lo), abs(i.hi));
  return largest == 0 ? 0 : static_cast<long>(digits) - 1 - decimal_exponent(largest);
}

/// Goes through ever smaller intervals around y until `decides` takes one; the last it is given is either the
/// value of y or what most_bits tell, with `final` true.
template <class Decides>
void refine(const Real &y, unsigned first_bits, Decides decides) {
  if (y.fraction()) {
    decides(Interval{*y.fraction(), *y.fraction()}, true);
    return;
  }
  bool asked = false;
  for (unsigned bits = std::min(first_bits, most_bits);; bits = std::min(2 * bits, most_bits)) {
    const Ball ball = y.ball(bits);
    if (ball.is_finite() && decides(Interval{ball.lower(), ball.upper()}, false))
      return;
    if (const std::optional<Rational> value = asked ? std::nullopt : y.exact()) {
      decides(Interval{*value, *value}, true);
      return;
    }
    asked = true;
    if (bits == most_bits) {
      if (!ball.is_finite())
        throw std::logic_error("a real number without a finite enclosure");
      decides(Interval{ball.lower(), ball.upper()}, true);
      return;
    }
  }
}

/// Bits with which most numbers are decided at once.
unsigned bits_for(unsigned digits) {
  return digits < most_bits / 4 ? 64 + 4 * digits : most_bits;
}

Enclosure around(const Interval &i, unsigned digits) {
  if (i.is_point())
    if (const std::optional<std::string> text = exact_decimal(i.lo)) {
      const std::size_t point = text->find('.');
      const unsigned places =
          point == std::string::npos ? 0 : static_cast<unsigned>(text->size() - point - 1);
      const Integer value = numerator(Rational(i.lo * Rational(power_of_ten(places))));
      return {value, value, places};
    }
  const unsigned places = static_cast<unsigned>(std::max(places_for(i, digits), 0L));
  const Rational scale(power_of_ten(places));
  return {floor(Rational(i.lo * scale)), Integer(floor(Rational(i.hi * scale)) + 1), places};
}

/// A decimal n * 10^-places.
struct Decimal {
  Integer n;
  long places = 0;
  Rational value() const { return Rational(n) * ten_to(-places); }
};

/// From here on, and for what starts after more than so many zeros, decimals have an exponent.
constexpr long most_before_point = 15;
constexpr long most_zeros = 6;

/// The decimal of `digits` digits nearest to every number of i; nothing if that differs. Digits before the
/// point are not cut unless there are too many.
std::optional<Decimal> nearest(const Interval &i, unsigned digits) {
  static const Rational half(1, 2);
  const bool negative = i.hi < 0;
  long places = places_for(i, digits);
  if (places < 0 && places > static_cast<long>(digits) - 1 - most_before_point)
    places = 0;
  const Rational scale = ten_to(places);
  const auto round = [&](const Rational &r) {
    return negative ? Integer(-floor(Rational(-r * scale + half))) : floor(Rational(r * scale + half));
  };
  Integer n = round(i.lo);
  if (n != round(i.hi))
    return std::nullopt;
  if (places != 0 && abs(n) == power_of_ten(digits)) // 9.996 is 10.0
    return Decimal{Integer(n / 10), places - 1};
  return Decimal{std::move(n), places};
}

std::string text(const Decimal &d, bool exact) {
  const auto written = [exact](const Integer &n, long places) {
    const unsigned at = static_cast<unsigned>(places);
    return exact ? decimal_string(n, at) : fixed_decimal(n, at);
  };
  const long digits = static_cast<long>(to_string(Integer(abs(d.n))).size());
  const long exponent = digits - 1 - d.places;
  if (d.n == 0 || (exponent >= -most_zeros && d.places >= 0))
    return written(d.n, d.places);
  return written(d.n, digits - 1) + "e" + std::to_string(exponent);
}

/// a (op) b, exact where both are.
template <class Operation>
Real combined(const Real &a, const Real &b, Operation operation) {
  if (a.fraction() && b.fraction())
    return Real(operation(*a.fraction(), *b.fraction()));
  return Real([=](unsigned bits) { return operation(a.ball(bits), b.ball(bits)); },
              [=]() -> std::optional<Rational> {
                const std::optional<Rational> x = a.exact();
                const std::optional<Rational> y = x ? b.exact() : std::nullopt;
                return y ? std::optional<Rational>(operation(*x, *y)) : std::nullopt;
              });
}

} // namespace

Real::Real(Rational value)
    : node_(std::make_shared<const Node>(
          Node{value, [value](unsigned bits) { return Ball(value, bits); }, [value] { return value; }})) {}

Real::Real(Enclose enclose, Exact exact)
    : node_(std::make_shared<const Node>(Node{std::nullopt, std::move(enclose), std::move(exact)})) {}

Real operator+(const Real &a, const Real &b) {
  return combined(a, b, std::plus<>());
}

Real operator-(const Real &a, const Real &b) {
  return combined(a, b, std::minus<>());
}

Real operator*(const Real &a, const Real &b) {
  return combined(a, b, std::multiplies<>());
}

Real operator/(const Real &a, const Real &b) {
  assert(!b.fraction() || *b.fraction() != 0);
  return combined(a, b, std::divides<>());
}

Real pow(const Real &y, const Rational &exponent) {
  assert(!y.fraction() || *y.fraction() > 0);
  constexpr int short_exponent = 8;
  if (y.fraction() && denominator(exponent) == 1 && exponent >= 0 && exponent <= short_exponent)
    return Real(power(*y.fraction(), static_cast<unsigned>(numerator(exponent))));
  return Real([=](unsigned bits) { return pow(y.ball(bits), exponent); },
              [=]() -> std::optional<Rational> {
                const std::optional<Rational> value = y.exact();
                return value ? PowerProduct(*value, exponent).exact() : std::nullopt;
              });
}

IntegerBounds floor_of(const Real &y, const std::function<bool(const Integer &k)> &is_exactly) {
  constexpr unsigned first_bits = 128;
  IntegerBounds result;
  bool asked = !is_exactly;
  refine(y, first_bits, [&](const Interval &i, bool) {
    result = {floor(i.lo), floor(i.hi)};
    if (!asked && result.hi - result.lo == 1) {
      asked = true;
      if (is_exactly(result.hi))
        result.lo = result.hi;
    }
    return result.is_point();
  });
  return result;
}

Order compare(const Real &a, const Real &b) {
  constexpr unsigned first_bits = 128;
  Order order = Order::undecided;
  refine(a - b, first_bits, [&order](const Interval &difference, bool) {
    if (difference.lo > 0)
      order = Order::greater;
    else if (difference.hi < 0)
      order = Order::less;
    else if (difference.is_point())
      order = Order::equal;
    return order != Order::undecided;
  });
  return order;
}

Enclosure enclose(const Real &y, unsigned digits) {
  Enclosure result;
  refine(y, bits_for(digits), [&](const Interval &i, bool final) {
    result = around(i, digits);
    // Around a decimal of that length the exact value may be asked for.
    const bool may_be_decimal = Rational(result.lower()) >= i.lo;
    return final || i.is_point() || (!may_be_decimal && result.hi - result.lo == 1);
  });
  return result;
}

std::string rounded(const Real &y, unsigned digits) {
  std::string result;
  refine(y, bits_for(digits), [&](const Interval &i, bool final) {
    std::optional<Decimal> d = nearest(i, digits);
    for (unsigned fewer = digits; final && !d && fewer > 1;)
      d = nearest(i, --fewer);
    if (!d && !final)
      return false;
    if (!d)
      d = Decimal{0, 0};
    const Rational value = d->value();
    const bool may_be_decimal = i.lo <= value && value <= i.hi;
    result = text(*d, i.is_point() && may_be_decimal);
    return final || i.is_point() || !may_be_decimal;
  });
  return result;
}

} // namespace mdm

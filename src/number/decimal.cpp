// Decimals, read and printed exactly. What comes in is text such as `+.5` or `1.2e-3`; what goes out is a
// fraction over a power of ten. Only one form is accepted, and digits and exponents are limited before any
// power is computed, so that a short text cannot ask for a long number. Printing goes the other way without
// rounding; where a number is shown to people and cut, the function says so.

#include "number/short_digits.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <bit>
#include <cassert>

namespace mdm {
namespace {

/// A decimal's text taken apart: the digits `whole` and `fraction`, one behind the other, times 10^exponent.
struct Parts {
  bool negative = false;
  std::string_view whole, fraction;
  long exponent = 0;

  std::size_t digits() const { return whole.size() + fraction.size(); }
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

[[noreturn]] void refuse(std::string_view text, const char *why) {
  throw InputError(in_quotes(text) + " " + why);
}

/// Removes the digits at the front of `rest`.
std::string_view take_digits(std::string_view &rest) {
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_digit);
  const std::string_view digits = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  rest.remove_prefix(digits.size());
  return digits;
}

bool take_sign(std::string_view &rest) {
  const bool negative = !rest.empty() && rest.front() == '-';
  if (negative || (!rest.empty() && rest.front() == '+'))
    rest.remove_prefix(1);
  return negative;
}

/// The exponent behind e or E; its size is limited.
long take_exponent(std::string_view text, std::string_view &rest) {
  rest.remove_prefix(1);
  const bool negative = take_sign(rest);
  std::string_view digits = take_digits(rest);
  if (digits.empty())
    refuse(text, "is not a number: write a decimal such as 3.86");
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  unsigned value = 0;
  if (digits.size() > 6 ||
      std::from_chars(digits.data(), digits.data() + digits.size(), value).ec != std::errc{} ||
      value > max_decimal_exponent)
    refuse(text, "has an exponent beyond 400: choose another unit");
  return negative ? -static_cast<long>(value) : static_cast<long>(value);
}

Parts take_apart(std::string_view text, char point) {
  Parts parts;
  std::string_view rest = text;
  parts.negative = take_sign(rest);
  parts.whole = take_digits(rest);
  if (!rest.empty() && rest.front() == point) {
    rest.remove_prefix(1);
    parts.fraction = take_digits(rest);
    parts.exponent = -static_cast<long>(parts.fraction.size());
  }
  if (parts.digits() == 0)
    refuse(text, "is not a number: write a decimal such as 3.86");
  if (!rest.empty() && (rest.front() == 'e' || rest.front() == 'E'))
    parts.exponent += take_exponent(text, rest);
  if (rest == "%")
    refuse(text, "is not a number: leave out the %, and divide by 100 where no percentage is asked for");
  if (!rest.empty())
    refuse(text, "is not a number: write a decimal such as 3.86");
  if (parts.digits() > max_decimal_digits)
    refuse(text, "has more than 1000 digits: round it");
  return parts;
}

/// The common case without arbitrary precision: at most 18 digits and 18 places.
Rational small_decimal(const Parts &parts) {
  std::uint64_t n = 0;
  for (const std::string_view digits : {parts.whole, parts.fraction})
    for (const char c : digits)
      n = 10 * n + static_cast<std::uint64_t>(c - '0');
  // n / (2^twos 5^fives) in lowest terms.
  const auto places = static_cast<unsigned>(-parts.exponent);
  const unsigned common_twos = n == 0 ? places : std::min(places, static_cast<unsigned>(std::countr_zero(n)));
  n >>= common_twos;
  unsigned fives = places;
  for (; fives > 0 && n % 5 == 0; --fives)
    n /= 5;
  std::uint64_t d = std::uint64_t{1} << (places - common_twos);
  for (unsigned i = 0; i < fives; ++i)
    d *= 5;
  Rational r;
  set_word(mpq_numref(r.backend().data()), n);
  set_word(mpq_denref(r.backend().data()), d);
  if (parts.negative)
    mpq_neg(r.backend().data(), r.backend().data());
  return r;
}

/// Exponent of the prime p in n; n is divided by that power.
unsigned long remove_factor(Integer &n, unsigned long p) {
  const Integer prime = p;
  return mpz_remove(n.backend().data(), n.backend().data(), prime.backend().data());
}

/// digits * 10^-places in plain notation without trailing zeros, `digits` being decimal digits.
std::string placed(std::string_view digits, unsigned places) {
  const std::size_t fraction = std::min<std::size_t>(places, digits.size());
  const std::string_view whole = digits.substr(0, digits.size() - fraction);
  std::string_view tail = digits.substr(whole.size());
  while (places > 0 && !tail.empty() && tail.back() == '0')
    tail.remove_suffix(1);
  std::string text;
  text.reserve(digits.size() + places + 2);
  text.append(whole.empty() ? "0" : whole);
  if (!tail.empty())
    text.append(1, '.').append(places - fraction, '0').append(tail);
  return text;
}

/// exact_decimal of n / d in machine words, the common case; nothing if it is no decimal or does not fit.
std::optional<std::string> exact_short_decimal(std::uint64_t n, std::uint64_t d) {
  constexpr unsigned most_places = 18;
  unsigned places = 0;
  std::uint64_t scale = 1;
  for (; places <= most_places && scale % d != 0; ++places)
    scale *= 10;
  if (places > most_places || __builtin_mul_overflow(n, scale / d, &n))
    return std::nullopt;
  return placed(ShortDigits(n).text(), places);
}

} // namespace

Rational parse_decimal(std::string_view text, char point) {
  const Parts parts = take_apart(text, point);
  if (parts.digits() <= 18 && parts.exponent <= 0 && parts.exponent >= -18)
    return small_decimal(parts);
  Integer n;
  mpz_set_str(n.backend().data(), std::string(parts.whole).append(parts.fraction).c_str(), 10);
  if (parts.negative)
    n = -n;
  if (parts.exponent >= 0)
    return Rational(Integer(n * power_of_ten(static_cast<unsigned>(parts.exponent))));
  return ratio(n, power_of_ten(static_cast<unsigned>(-parts.exponent)));
}

Rational last_digit_unit(std::string_view text, char point) {
  const long exponent = take_apart(text, point).exponent;
  const Rational unit(power_of_ten(static_cast<unsigned>(exponent < 0 ? -exponent : exponent)));
  return exponent < 0 ? Rational(1 / unit) : unit;
}

std::string fixed_decimal(const Integer &digits, unsigned places) {
  if (digits < 0)
    return "-" + fixed_decimal(Integer(-digits), places);
  std::string text = to_string(digits);
  if (text.size() <= places)
    text.insert(0, places + 1 - text.size(), '0');
  if (places > 0)
    text.insert(text.size() - places, 1, '.');
  return text;
}

std::string decimal_string(const Integer &digits, unsigned places) {
  if (digits < 0)
    return "-" + decimal_string(Integer(-digits), places);
  if (const std::optional<ShortDigits> text = short_digits(digits))
    return placed(text->text(), places);
  return placed(to_string(digits), places);
}

std::optional<std::string> exact_decimal(const Rational &r) {
  const mpz_srcptr n = mpq_numref(r.backend().data());
  const mpz_srcptr d = mpq_denref(r.backend().data());
  if (mpz_fits_ulong_p(n) != 0 && mpz_fits_ulong_p(d) != 0)
    if (std::optional<std::string> text = exact_short_decimal(mpz_get_ui(n), mpz_get_ui(d)))
      return text;
  Integer rest = denominator(r);
  if (rest == 1)
    return to_string(Integer(numerator(r)));
  const unsigned long places = std::max(remove_factor(rest, 2), remove_factor(rest, 5));
  if (rest != 1)
    return std::nullopt;
  const unsigned digits = static_cast<unsigned>(places);
  return decimal_string(Integer(numerator(r) * power_of_ten(digits) / denominator(r)), digits);
}

std::string to_decimal(const Rational &r) {
  const std::optional<std::string> text = exact_decimal(r);
  assert(text);
  return text.value();
}

std::string approximate(const Rational &r, unsigned digits) {
  if (r == 0)
    return "0";
  if (r < 0)
    return "-" + approximate(Rational(-r), digits);
  // Estimate of the decimal exponent from the lengths, then corrected by at most one step.
  const auto length = [](const Integer &n) { return static_cast<long>(to_string(n).size()); };
  long exponent = length(numerator(r)) - length(denominator(r));
  const auto shifted = [&r](long by) {
    return by >= 0 ? Rational(r * Rational(power_of_ten(static_cast<unsigned>(by))))
                   : Rational(r / Rational(power_of_ten(static_cast<unsigned>(-by))));
  };
  if (shifted(-exponent) < 1)
    --exponent;
  const long places = static_cast<long>(digits) - 1 - exponent;
  const Integer cut = floor(shifted(places));
  if (exponent < -6)
    return decimal_string(cut, digits - 1) + "e" + std::to_string(exponent);
  if (places >= 0)
    return decimal_string(cut, static_cast<unsigned>(places));
  return to_string(Integer(cut * power_of_ten(static_cast<unsigned>(-places))));
}

} // namespace mdm

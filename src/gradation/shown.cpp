#include "gradation/shown.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace mdm {

std::string shown(const Rational &r) {
  constexpr std::size_t short_bits = 128;
  if (bit_length(numerator(r)) <= short_bits && bit_length(denominator(r)) <= short_bits) {
    const std::optional<std::string> exact = exact_decimal(r);
    if (exact && exact->size() <= 40)
      return *exact;
  }
  const std::string text = approximate(r, 12);
  if (text.size() <= 40)
    return text;
  // An integer in full length: its first digits and its exponent.
  const std::size_t first = text.front() == '-' ? 1 : 0;
  return fmt::format("{}.{}e{}", text.substr(0, first + 1), text.substr(first + 1, 11),
                     text.size() - first - 1);
}

std::string shown(const RootSize &x) {
  const std::optional<Rational> exact = x.fraction();
  return shown(exact ? *exact : nearest_decimal(x));
}

std::string shown(const Rational &size, SizeUnit unit) {
  return fmt::format("{} {}", shown(size), name(unit));
}

std::string shown_hundredths(const Rational &r) {
  return shown(Rational(Rational(floor(Rational(r * 100 + ratio(1, 2)))) / 100));
}

} // namespace mdm

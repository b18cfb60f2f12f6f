#include "number/decimal_exponent.hpp"

#include <mdm/number/decimal.hpp>

#include <cassert>

namespace mdm {

Rational ten_to(long exponent) {
  return exponent >= 0 ? Rational(power_of_ten(static_cast<unsigned>(exponent)))
                       : ratio(1, power_of_ten(static_cast<unsigned>(-exponent)));
}

long decimal_exponent(const Rational &r) {
  assert(r != 0);
  const Rational size = abs(r);
  // The bits give it but for one: 30103 / 100000 is log10(2) + 4.4e-9.
  const std::int64_t bits = static_cast<std::int64_t>(bit_length(numerator(size))) -
                            static_cast<std::int64_t>(bit_length(denominator(size)));
  auto e = static_cast<long>(bits * 30103 / 100000);
  while (size < ten_to(e))
    --e;
  while (size >= ten_to(e + 1))
    ++e;
  return e;
}

} // namespace mdm

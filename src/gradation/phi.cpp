#include "gradation/phi.hpp"

#include "gradation/shown.hpp"
#include "number/ball.hpp"
#include "number/decimal_exponent.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <cassert>

namespace mdm {
namespace {

constexpr int max_phi = 1000;
constexpr int phi_digits = 15;

/// The integer nearest to 2^-phi * scale, for a phi that is no integer. There is no tie, because 2^-phi is
/// irrational: once the ball is small enough, the floor of 2^-phi * scale + 1/2 is the same for all of it.
Integer nearest(const Rational &phi, const Rational &scale) {
  for (unsigned bits = 128;; bits *= 2) {
    const Ball y = pow(Ball(2, bits), Rational(-phi)) * Ball(scale, bits) + Ball(ratio(1, 2), bits);
    const Integer result = floor(y.lower());
    if (result == floor(y.upper()))
      return result;
  }
}

} // namespace

void check_phi(const Rational &phi) {
  if (phi > max_phi || phi < -max_phi)
    throw InputError(fmt::format("phi {} is beyond {}: give the size in mm", shown(phi), max_phi));
}

Rational phi_power(const Rational &phi, unsigned root) {
  assert(abs(phi) <= max_phi && denominator(Rational(phi * root)) == 1);
  const Rational exponent = phi * root;
  const auto bits = static_cast<unsigned>(abs(Integer(numerator(exponent))));
  const Integer two_to = Integer(1) << bits;
  return exponent > 0 ? ratio(1, two_to) : Rational(two_to);
}

Rational phi_size(const Rational &phi) {
  check_phi(phi);
  if (denominator(phi) == 1)
    return phi_power(phi, 1);
  // 30103 / 100000 is log10(2) + 4.4e-9, so this starts below the exponent e of 10^e <= 2^-phi < 10^(e+1), at
  // most two too low. The first whose mantissa is at most 10^15 is e, or, where 2^-phi rounds down to 10^e,
  // one less: the value is the same.
  const Integer limit = power_of_ten(phi_digits);
  int exponent = floor(Rational(-phi * Rational(30103, 100000))).convert_to<int>() - 1;
  Integer mantissa = nearest(phi, ten_to(phi_digits - 1 - exponent));
  while (mantissa > limit)
    mantissa = nearest(phi, ten_to(phi_digits - 1 - ++exponent));
  return Rational(mantissa) * ten_to(exponent + 1 - phi_digits);
}

} // namespace mdm

#include "gradation/phi.hpp"

#include "gradation/shown.hpp"
#include "number/decimal_exponent.hpp"

#include <mdm/text/error.hpp>

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <fmt/core.h>

#include <cassert>

namespace mdm {
namespace {

constexpr int max_phi = 1000;
constexpr int phi_digits = 15;

/// Arb's and FLINT's numbers, freed at the end of their scope.
struct Ball {
  arb_t value;
  Ball() { arb_init(value); }
  ~Ball() { arb_clear(value); }
  Ball(const Ball &) = delete;
  Ball &operator=(const Ball &) = delete;
};
struct FlintInteger {
  fmpz_t value;
  FlintInteger() { fmpz_init(value); }
  ~FlintInteger() { fmpz_clear(value); }
  FlintInteger(const FlintInteger &) = delete;
  FlintInteger &operator=(const FlintInteger &) = delete;
};

/// ball := r.
void set(Ball &ball, const Rational &r, slong bits) {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, r.backend().data());
  arb_set_fmpq(ball.value, fraction, bits);
  fmpq_clear(fraction);
}

/// 2^-phi.
void power_of_two(Ball &ball, const Rational &phi, slong bits) {
  Ball exponent;
  set(exponent, Rational(-phi), bits);
  arb_set_ui(ball.value, 2);
  arb_pow(ball.value, ball.value, exponent.value, bits);
}

/// The integer nearest to 2^-phi * scale, for a phi that is no integer. There is no tie, because 2^-phi is
/// irrational: once the ball is small enough, the floor of 2^-phi * scale + 1/2 is the same for all of it.
Integer nearest(const Rational &phi, const Rational &scale) {
  Ball ball, factor, half;
  FlintInteger floor;
  for (slong bits = 128;; bits *= 2) {
    power_of_two(ball, phi, bits);
    set(factor, scale, bits);
    set(half, ratio(1, 2), bits);
    arb_mul(ball.value, ball.value, factor.value, bits);
    arb_add(ball.value, ball.value, half.value, bits);
    arb_floor(ball.value, ball.value, bits);
    if (arb_get_unique_fmpz(floor.value, ball.value) != 0)
      break;
  }
  Integer result;
  fmpz_get_mpz(result.backend().data(), floor.value);
  return result;
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

// pi between two decimals, one unit apart. MPFR rounds pi to so many bits downwards and upwards; both are
// cut to the decimal places that are asked for. If these agree, pi is between that decimal and the next
// one. If not, more bits are taken; that ends, because pi is irrational and so at some distance from every
// decimal. The checkers have a pi of their own, by Machin's formula, so that nothing rests on this one.

#include "number/pi.hpp"

#include <mpfr.h>

namespace mdm {
namespace {

/// The floor of pi * 10^places, from pi rounded to `bits` binary digits.
Integer scaled_pi(unsigned places, long bits, mpfr_rnd_t rounding) {
  mpfr_t pi;
  mpfr_init2(pi, bits);
  mpfr_const_pi(pi, rounding);
  Rational value;
  mpfr_get_q(value.backend().data(), pi);
  mpfr_clear(pi);
  return floor(Rational(value * power_of_ten(places)));
}

} // namespace

Enclosure enclose_pi(unsigned places) {
  // Enough bits make the floors of both roundings the same, because pi * 10^places is no integer.
  for (long bits = 64 + 4 * static_cast<long>(places);; bits *= 2) {
    const Integer digits = scaled_pi(places, bits, MPFR_RNDD);
    if (digits != scaled_pi(places, bits, MPFR_RNDU))
      continue;
    // MPFR keeps pi for the thread, and nobody would free it at the thread's end.
    mpfr_free_cache();
    return {digits, Integer(digits + 1), places};
  }
}

} // namespace mdm

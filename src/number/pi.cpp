#include "number/pi.hpp"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

namespace mdm {

Enclosure enclose_pi(unsigned places) {
  const Integer ten = power_of_ten(places);
  Integer digits;
  arb_t ball;
  arb_init(ball);
  fmpz_t scale, floor;
  fmpz_init(scale);
  fmpz_init(floor);
  fmpz_set_mpz(scale, ten.backend().data());
  // Enough bits make the floor of the ball unique, because pi * 10^places is no integer.
  for (long bits = 64 + 4 * static_cast<long>(places);; bits *= 2) {
    arb_const_pi(ball, bits);
    arb_mul_fmpz(ball, ball, scale, bits);
    arb_floor(ball, ball, bits);
    if (arb_get_unique_fmpz(floor, ball) != 0)
      break;
  }
  fmpz_get_mpz(digits.backend().data(), floor);
  fmpz_clear(floor);
  fmpz_clear(scale);
  arb_clear(ball);
  // Arb keeps pi for the thread, and nobody would free it at the thread's end.
  flint_cleanup();
  return {digits, Integer(digits + 1), places};
}

} // namespace mdm

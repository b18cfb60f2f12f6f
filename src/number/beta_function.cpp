// The beta functions by Arb, whose balls are a midpoint and a radius: what comes in is put into a ball, and
// the interval of the ball that comes out is handed back.

#include "number/ball.hpp"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#include <flint/arb_hypgeom.h>
#else
#include <arb.h>
#include <arb_hypgeom.h>
#endif

namespace mdm {
namespace {

/// FLINT and Arb keep memory and constants for each thread; a thread that uses them frees these at its end.
struct ThreadCleanup {
  ThreadCleanup() = default;
  ~ThreadCleanup() { flint_cleanup(); }
  ThreadCleanup(const ThreadCleanup &) = delete;
  ThreadCleanup &operator=(const ThreadCleanup &) = delete;
};

/// A fraction as FLINT has it.
struct Fraction {
  fmpq_t value;

  explicit Fraction(const Rational &r) {
    fmpq_init(value);
    fmpq_set_mpq(value, r.backend().data());
  }
  ~Fraction() { fmpq_clear(value); }
  Fraction(const Fraction &) = delete;
  Fraction &operator=(const Fraction &) = delete;
};

/// A ball of Arb.
struct ArbBall {
  arb_t value;

  ArbBall() {
    thread_local const ThreadCleanup cleanup;
    static_cast<void>(cleanup);
    arb_init(value);
  }
  ArbBall(const Rational &r, unsigned bits) : ArbBall() { arb_set_fmpq(value, Fraction(r).value, bits); }
  ~ArbBall() { arb_clear(value); }
  ArbBall(const ArbBall &) = delete;
  ArbBall &operator=(const ArbBall &) = delete;

  /// The interval of it, whose ends are lo * 2^exponent and hi * 2^exponent.
  Ball interval(unsigned bits) const {
    if (arb_is_finite(value) == 0)
      return log(Ball(-1, bits)); // nothing is known
    fmpz_t lo, hi, exponent;
    fmpz_init(lo);
    fmpz_init(hi);
    fmpz_init(exponent);
    arb_get_interval_fmpz_2exp(lo, hi, exponent, value);
    const slong by = fmpz_get_si(exponent);
    const auto end = [by](const fmpz_t digits) {
      Integer n;
      fmpz_get_mpz(n.backend().data(), digits);
      Rational r(n);
      if (by >= 0)
        mpq_mul_2exp(r.backend().data(), r.backend().data(), static_cast<mp_bitcnt_t>(by));
      else
        mpq_div_2exp(r.backend().data(), r.backend().data(), static_cast<mp_bitcnt_t>(-by));
      return r;
    };
    Ball all = hull(Ball(end(lo), bits), Ball(end(hi), bits));
    fmpz_clear(exponent);
    fmpz_clear(hi);
    fmpz_clear(lo);
    return all;
  }
};

} // namespace

Ball incomplete_beta(const Ball &x, const Rational &a, const Rational &b) {
  const unsigned bits = x.bits_;
  if (!x.is_finite())
    return x;
  ArbBall result, all(x.lower(), bits);
  arb_union(all.value, all.value, ArbBall(x.upper(), bits).value, bits);
  arb_hypgeom_beta_lower(result.value, ArbBall(a, bits).value, ArbBall(b, bits).value, all.value, 1, bits);
  return result.interval(bits);
}

Ball beta_function(const Rational &a, const Rational &b, unsigned bits) {
  const auto gamma = [bits](const Rational &r) {
    ArbBall result;
    arb_gamma_fmpq(result.value, Fraction(r).value, bits);
    return result.interval(bits);
  };
  return gamma(a) * gamma(b) / gamma(a + b);
}

} // namespace mdm

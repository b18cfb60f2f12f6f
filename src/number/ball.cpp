// Enclosures of real numbers by Arb. A ball is a midpoint and a radius; every operation gives a ball that
// contains the results for all numbers of its arguments. Where an operation has no value for some of them
// the result is not finite, and every comparison with it is undecided: a caller asks again with more bits.
// ball_mpfr.cpp does the same for some functions where there is no Arb.

#include "number/ball.hpp"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#include <flint/arb_hypgeom.h>
#else
#include <arb.h>
#include <arb_hypgeom.h>
#endif

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// FLINT and Arb keep memory and constants for each thread; a thread that uses them frees these at its end.
struct ThreadCleanup {
  ThreadCleanup() = default;
  ~ThreadCleanup() { flint_cleanup(); }
  ThreadCleanup(const ThreadCleanup &) = delete;
  ThreadCleanup &operator=(const ThreadCleanup &) = delete;
};

void clean_up_at_thread_end() {
  thread_local const ThreadCleanup cleanup;
  static_cast<void>(cleanup);
}

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

/// An interval [lo, hi] * 2^exponent.
struct Interval {
  fmpz_t lo, hi, exponent;

  explicit Interval(const arb_t ball) {
    clean_up_at_thread_end();
    fmpz_init(lo);
    fmpz_init(hi);
    fmpz_init(exponent);
    arb_get_interval_fmpz_2exp(lo, hi, exponent, ball);
  }
  ~Interval() {
    fmpz_clear(exponent);
    fmpz_clear(hi);
    fmpz_clear(lo);
  }
  Interval(const Interval &) = delete;
  Interval &operator=(const Interval &) = delete;

  Rational scaled(const fmpz_t end) const {
    Integer n;
    fmpz_get_mpz(n.backend().data(), end);
    Rational r(n);
    const slong by = fmpz_get_si(exponent);
    if (by >= 0)
      mpq_mul_2exp(r.backend().data(), r.backend().data(), static_cast<mp_bitcnt_t>(by));
    else
      mpq_div_2exp(r.backend().data(), r.backend().data(), static_cast<mp_bitcnt_t>(-by));
    return r;
  }
};

} // namespace

struct Ball::Value {
  arb_t ball;

  Value() {
    clean_up_at_thread_end();
    arb_init(ball);
  }
  ~Value() { arb_clear(ball); }
  Value(const Value &) = delete;
  Value &operator=(const Value &) = delete;
};

Ball::Ball(unsigned bits) : value_(std::make_unique<Value>()), bits_(bits) {}

Ball::Ball(const Rational &r, unsigned bits) : Ball(bits) {
  arb_set_fmpq(value_->ball, Fraction(r).value, bits);
}

Ball::Ball(const Ball &other) : Ball(other.bits_) {
  arb_set(value_->ball, other.value_->ball);
}

Ball::Ball(Ball &&other) noexcept = default;
Ball::~Ball() = default;

Ball operator+(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  arb_add(result.value_->ball, a.value_->ball, b.value_->ball, result.bits_);
  return result;
}

Ball operator-(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  arb_sub(result.value_->ball, a.value_->ball, b.value_->ball, result.bits_);
  return result;
}

Ball operator*(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  arb_mul(result.value_->ball, a.value_->ball, b.value_->ball, result.bits_);
  return result;
}

Ball operator/(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  arb_div(result.value_->ball, a.value_->ball, b.value_->ball, result.bits_);
  return result;
}

Ball log(const Ball &y) {
  Ball result(y.bits_);
  arb_log(result.value_->ball, y.value_->ball, y.bits_);
  return result;
}

Ball exp(const Ball &y) {
  Ball result(y.bits_);
  arb_exp(result.value_->ball, y.value_->ball, y.bits_);
  return result;
}

Ball pow(const Ball &y, const Rational &exponent) {
  Ball result(y.bits_);
  arb_pow_fmpq(result.value_->ball, y.value_->ball, Fraction(exponent).value, y.bits_);
  return result;
}

Ball erf(const Ball &y) {
  Ball result(y.bits_);
  arb_hypgeom_erf(result.value_->ball, y.value_->ball, y.bits_);
  return result;
}

Ball incomplete_beta(const Ball &x, const Rational &a, const Rational &b) {
  Ball result(x.bits_);
  arb_hypgeom_beta_lower(result.value_->ball, Ball(a, x.bits_).value_->ball, Ball(b, x.bits_).value_->ball,
                         x.value_->ball, 1, x.bits_);
  return result;
}

Ball beta_function(const Rational &a, const Rational &b, unsigned bits) {
  const auto gamma = [bits](const Rational &r) {
    Ball result(bits);
    arb_gamma_fmpq(result.value_->ball, Fraction(r).value, bits);
    return result;
  };
  return gamma(a) * gamma(b) / gamma(a + b);
}

Ball hull(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  arb_union(result.value_->ball, a.value_->ball, b.value_->ball, result.bits_);
  return result;
}

Order compare(const Ball &a, const Ball &b) {
  if (arb_lt(a.value_->ball, b.value_->ball) != 0)
    return Order::less;
  if (arb_gt(a.value_->ball, b.value_->ball) != 0)
    return Order::greater;
  return arb_eq(a.value_->ball, b.value_->ball) != 0 ? Order::equal : Order::undecided;
}

bool Ball::is_finite() const {
  return arb_is_finite(value_->ball) != 0;
}

Rational Ball::lower() const {
  assert(is_finite());
  const Interval i(value_->ball);
  return i.scaled(i.lo);
}

Rational Ball::upper() const {
  assert(is_finite());
  const Interval i(value_->ball);
  return i.scaled(i.hi);
}

} // namespace mdm

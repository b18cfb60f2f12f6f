// Enclosures of real numbers: intervals of MPFR's numbers, whose ends are rounded outwards. Every operation
// gives an interval that contains the results for all numbers of its arguments. Where an operation has no
// value for some of them the result is not finite, and every comparison with it is undecided: a caller asks
// again with more bits. The beta functions, which MPFR does not have, are in beta_function.cpp.

#include "number/ball.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
using Function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

/// ln 2 and the like, kept by MPFR for the thread.
struct ThreadCleanup {
  ThreadCleanup() = default;
  ~ThreadCleanup() { mpfr_free_cache(); }
  ThreadCleanup(const ThreadCleanup &) = delete;
  ThreadCleanup &operator=(const ThreadCleanup &) = delete;
};

} // namespace

/// [lo, hi]; both are no numbers where nothing is known.
struct Ball::Value {
  /// A number with so many binary digits.
  struct Float {
    mpfr_t value;

    explicit Float(unsigned bits) { mpfr_init2(value, static_cast<mpfr_prec_t>(bits)); }
    ~Float() { mpfr_clear(value); }
    Float(const Float &) = delete;
    Float &operator=(const Float &) = delete;

    Rational fraction() const {
      Rational r;
      mpfr_get_q(r.backend().data(), value);
      return r;
    }
  };

  Float lo, hi;

  explicit Value(unsigned bits) : lo(bits), hi(bits) {}

  void set_unknown() {
    mpfr_set_nan(lo.value);
    mpfr_set_nan(hi.value);
  }
  bool has_zero() const { return mpfr_sgn(lo.value) <= 0 && mpfr_sgn(hi.value) >= 0; }
  bool is_known() const { return mpfr_number_p(lo.value) != 0 && mpfr_number_p(hi.value) != 0; }

  /// The hull of x (op) y over the ends x, y of two intervals, for an operation that is monotone in each.
  void set_hull(const Value &a, const Value &b, Operation operation) {
    const auto bits = static_cast<unsigned>(mpfr_get_prec(lo.value));
    Float end(bits);
    bool first = true;
    for (const Float *const x : {&a.lo, &a.hi})
      for (const Float *const y : {&b.lo, &b.hi}) {
        operation(end.value, x->value, y->value, MPFR_RNDD);
        if (first || mpfr_less_p(end.value, lo.value) != 0)
          mpfr_set(lo.value, end.value, MPFR_RNDD);
        operation(end.value, x->value, y->value, MPFR_RNDU);
        if (first || mpfr_greater_p(end.value, hi.value) != 0)
          mpfr_set(hi.value, end.value, MPFR_RNDU);
        first = false;
      }
  }

  /// f of an interval, for a function that rises.
  void set_risen(const Value &y, Function f) {
    thread_local const ThreadCleanup cleanup;
    static_cast<void>(cleanup);
    f(lo.value, y.lo.value, MPFR_RNDD);
    f(hi.value, y.hi.value, MPFR_RNDU);
  }
};

Ball::Ball(unsigned bits) : value_(std::make_unique<Value>(bits)), bits_(bits) {}

Ball::Ball(const Rational &r, unsigned bits) : Ball(bits) {
  mpfr_set_q(value_->lo.value, r.backend().data(), MPFR_RNDD);
  mpfr_set_q(value_->hi.value, r.backend().data(), MPFR_RNDU);
}

Ball::Ball(const Ball &other) : Ball(other.bits_) {
  mpfr_set(value_->lo.value, other.value_->lo.value, MPFR_RNDD);
  mpfr_set(value_->hi.value, other.value_->hi.value, MPFR_RNDU);
}

Ball::Ball(Ball &&other) noexcept = default;
Ball::~Ball() = default;

Ball operator+(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  mpfr_add(result.value_->lo.value, a.value_->lo.value, b.value_->lo.value, MPFR_RNDD);
  mpfr_add(result.value_->hi.value, a.value_->hi.value, b.value_->hi.value, MPFR_RNDU);
  return result;
}

Ball operator-(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  mpfr_sub(result.value_->lo.value, a.value_->lo.value, b.value_->hi.value, MPFR_RNDD);
  mpfr_sub(result.value_->hi.value, a.value_->hi.value, b.value_->lo.value, MPFR_RNDU);
  return result;
}

Ball operator*(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  if (a.is_finite() && b.is_finite())
    result.value_->set_hull(*a.value_, *b.value_, mpfr_mul);
  else
    result.value_->set_unknown();
  return result;
}

Ball operator/(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  if (a.is_finite() && b.is_finite() && !b.value_->has_zero())
    result.value_->set_hull(*a.value_, *b.value_, mpfr_div);
  else
    result.value_->set_unknown();
  return result;
}

Ball log(const Ball &y) {
  Ball result(y.bits_);
  if (y.is_finite() && mpfr_sgn(y.value_->lo.value) > 0)
    result.value_->set_risen(*y.value_, mpfr_log);
  else
    result.value_->set_unknown();
  return result;
}

Ball exp(const Ball &y) {
  Ball result(y.bits_);
  result.value_->set_risen(*y.value_, mpfr_exp);
  return result;
}

// A root of a power, of which each is rounded once: what is exact stays a point. Where that would be a long
// computation, by logarithms.
Ball pow(const Ball &y, const Rational &exponent) {
  constexpr unsigned most = 1000;
  const Integer p = abs(numerator(exponent)), q = denominator(exponent);
  if (!y.is_finite() || mpfr_sgn(y.value_->lo.value) < 0 || p > most || q > most)
    return exp(log(y) * Ball(exponent, y.bits_));
  if (exponent < 0)
    return Ball(1, y.bits_) / pow(y, -exponent);
  Ball result(y.bits_);
  const auto power = [&p, &q](Ball::Value::Float &end, const Ball::Value::Float &of, mpfr_rnd_t rounding) {
    mpfr_pow_ui(end.value, of.value, static_cast<unsigned long>(p), rounding);
    mpfr_rootn_ui(end.value, end.value, static_cast<unsigned long>(q), rounding);
  };
  power(result.value_->lo, y.value_->lo, MPFR_RNDD);
  power(result.value_->hi, y.value_->hi, MPFR_RNDU);
  return result;
}

Ball erf(const Ball &y) {
  Ball result(y.bits_);
  result.value_->set_risen(*y.value_, mpfr_erf);
  return result;
}

Ball hull(const Ball &a, const Ball &b) {
  Ball result(std::max(a.bits_, b.bits_));
  mpfr_min(result.value_->lo.value, a.value_->lo.value, b.value_->lo.value, MPFR_RNDD);
  mpfr_max(result.value_->hi.value, a.value_->hi.value, b.value_->hi.value, MPFR_RNDU);
  if (!a.is_finite() || !b.is_finite())
    result.value_->set_unknown();
  return result;
}

Order compare(const Ball &a, const Ball &b) {
  if (!a.is_finite() || !b.is_finite())
    return Order::undecided;
  const Ball::Value &x = *a.value_, &y = *b.value_;
  if (mpfr_less_p(x.hi.value, y.lo.value) != 0)
    return Order::less;
  if (mpfr_greater_p(x.lo.value, y.hi.value) != 0)
    return Order::greater;
  const bool are_points =
      mpfr_equal_p(x.lo.value, x.hi.value) != 0 && mpfr_equal_p(y.lo.value, y.hi.value) != 0;
  return are_points ? Order::equal : Order::undecided;
}

bool Ball::is_finite() const {
  return value_->is_known();
}

Rational Ball::lower() const {
  assert(is_finite());
  return value_->lo.fraction();
}

Rational Ball::upper() const {
  assert(is_finite());
  return value_->hi.fraction();
}

} // namespace mdm

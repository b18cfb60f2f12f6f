#pragma once
/// \file
/// Rigorous enclosures of real numbers.

#include <mdm/number/rational.hpp>

#include <memory>

namespace mdm {

/// The certain order of two numbers.
enum class Order { less, equal, greater, undecided };

/// A real number y, known to lie in a ball: an interval of MPFR's numbers. Whatever is done with balls, the
/// result's ball contains the result; where an operation has no value for all of its ball (log of what may be
/// 0), the result is not finite and every comparison with it is undecided.
class Ball {
public:
  /// r, rounded to `bits` binary digits, which is also the precision of what is computed from it.
  Ball(const Rational &r, unsigned bits);
  Ball(const Ball &other);
  Ball(Ball &&other) noexcept;
  Ball &operator=(Ball other) noexcept {
    value_.swap(other.value_);
    bits_ = other.bits_;
    return *this;
  }
  ~Ball();

  /// The results have the higher precision of the two.
  friend Ball operator+(const Ball &a, const Ball &b);
  friend Ball operator-(const Ball &a, const Ball &b);
  friend Ball operator*(const Ball &a, const Ball &b);
  friend Ball operator/(const Ball &a, const Ball &b);
  friend Ball log(const Ball &y);
  friend Ball exp(const Ball &y);
  friend Ball pow(const Ball &y, const Rational &exponent);
  /// 2 / sqrt(pi) times the integral of exp(-t^2) from 0 to y.
  friend Ball erf(const Ball &y);
  /// I_x(a, b), the regularised incomplete beta function, for 0 <= x <= 1 and a, b > 0.
  friend Ball incomplete_beta(const Ball &x, const Rational &a, const Rational &b);
  /// B(a, b) = Gamma(a) Gamma(b) / Gamma(a + b), for a, b > 0.
  friend Ball beta_function(const Rational &a, const Rational &b, unsigned bits);
  /// A ball around both, and thus around all between them.
  friend Ball hull(const Ball &a, const Ball &b);

  /// less or greater where the balls do not meet; equal only for two points; else undecided.
  friend Order compare(const Ball &a, const Ball &b);

  bool is_finite() const;
  /// The ends of an interval around y. \pre is_finite()
  Rational lower() const;
  Rational upper() const;

private:
  struct Value; // its library's header is not needed here
  explicit Ball(unsigned bits);

  std::unique_ptr<Value> value_;
  unsigned bits_;
};

/// Encloses I_x(a, b), the integral of t^(a-1) (1-t)^(b-1) from 0 to x over that from 0 to 1, for 0 <= x
/// <= 1. \throws InputError, as beta_function, where there is no Arb
Ball incomplete_beta(const Ball &x, const Rational &a, const Rational &b);
/// Encloses B(a, b), the integral from 0 to 1, with a precision of `bits`.
Ball beta_function(const Rational &a, const Rational &b, unsigned bits);
/// A ball that holds both.
Ball hull(const Ball &a, const Ball &b);

} // namespace mdm

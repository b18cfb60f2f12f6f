#pragma once
/// \file
/// Products of rational powers: positive numbers about which everything can be decided.

#include "number/real.hpp"

#include <map>

namespace mdm {

/// b_1^e_1 * ... * b_n^e_n, bases b_i > 0 and exponents e_i rational. Over integers p_1, ..., p_m > 1 without
/// common factors of which all numerators and denominators of the b_i are products, it is
/// p_1^r_1 * ... * p_m^r_m, and since powers of different p_k share no prime, it is 1 only if all r_k = 0,
/// and a fraction only if each p_k^r_k is one.
class PowerProduct {
public:
  /// The number 1.
  PowerProduct() = default;
  /// base^exponent. \pre base > 0
  explicit PowerProduct(const Rational &base, const Rational &exponent = 1);

  PowerProduct &operator*=(const PowerProduct &b);
  friend PowerProduct operator*(PowerProduct a, const PowerProduct &b) { return a *= b; }
  friend PowerProduct operator/(const PowerProduct &a, const PowerProduct &b);
  friend PowerProduct pow(const PowerProduct &a, const Rational &exponent);

  /// The value, if it is a fraction (of at most some 100,000 binary digits).
  /// Cost: greatest common divisors of all pairs; it gives up with more than 1,000 bases.
  std::optional<Rational> exact() const;
  Real real() const;
  friend Ball log(const PowerProduct &a, unsigned bits);

  /// log a / log b, for rational exponents and b != 1. It is a fraction only if the exponents of a and b over
  /// common p_k are in that ratio.
  friend Real log_ratio(const PowerProduct &a, const PowerProduct &b);

private:
  void multiply(const Rational &base, const Rational &exponent);
  friend std::optional<Rational> exact_log_ratio(const PowerProduct &a, const PowerProduct &b);

  std::map<Rational, Rational> powers_; // base -> exponent, neither 1 nor 0
};

} // namespace mdm

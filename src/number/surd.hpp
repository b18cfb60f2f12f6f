#pragma once
/// \file
/// Exact arithmetic with one irrational root.

#include "number/power_product.hpp"

#include <map>

namespace mdm {

/// c_0 + c_1 t + ... + c_{m-1} t^{m-1} with fractions c_k and t = base^(1/m), where base > 0 is no p-th power
/// for any prime p that divides m. Then x^m - base is irreducible (Capelli), and such a number is 0 only if
/// all c_k are. Only those that are not 0 are kept. A fraction has m = 1. Numbers with m > 1 can be combined
/// if they have the same base and m.
class Surd {
public:
  Surd(const Rational &r = 0) { add(0, r); }
  Surd(int n) : Surd(Rational(n)) {}
  /// r^(n/degree), for r > 0 and degree >= 1; equal r and degree give numbers that can be combined.
  static Surd root_power(const Rational &r, unsigned n, unsigned degree);

  friend Surd operator+(const Surd &a, const Surd &b);
  friend Surd operator-(const Surd &a, const Surd &b);
  /// Cost: a product of fractions for each pair of terms.
  friend Surd operator*(const Surd &a, const Surd &b);
  /// \pre a is some c t^k, c != 0
  friend Surd inverse(const Surd &a);

  /// The value, if it is a fraction.
  std::optional<Rational> exact() const;
  Real real() const;
  /// The value, if it is some c t^k, c > 0.
  std::optional<PowerProduct> product() const;
  /// m
  unsigned degree() const { return degree_; }

private:
  /// Adds r t^k.
  void add(unsigned k, const Rational &r);

  std::map<unsigned, Rational> c_; // c_k != 0
  unsigned degree_ = 1;
  Rational base_ = 1;
};

/// a^exponent.
Surd power(const Surd &a, unsigned exponent);

} // namespace mdm

#pragma once
/// \file
/// Sizes that are roots of fractions.

#include <mdm/number/interval.hpp>

#include <string>

namespace mdm {

/// The size x >= 0 with x^degree = power: the opening 2^-phi mm of a phi that is no whole number, or a
/// particle of an exact match. Known exactly, whether x is a fraction or not.
struct RootSize {
  Rational power;
  unsigned degree = 1;

  /// x, if it is a fraction.
  std::optional<Rational> fraction() const;
  /// True if x^of_degree = other.
  bool is(const Rational &other, unsigned of_degree) const;
  /// x as a decimal: exactly, or, if x is none, the nearest of 15 significant digits.
  std::string text() const;
  /// True if `size` is x, or, for an irrational x, a decimal of at most 15 significant digits that is less
  /// than half a unit of the 15th away from x: text() names x.
  bool is_named_by(const Rational &size) const;
};

/// Sign of x - y. Cost: powers of degree / gcd of the degrees.
int compare(const RootSize &x, const RootSize &y);

/// The decimal of 15 significant digits that is nearest to x. \pre x > 0 is no fraction
Rational nearest_decimal(const RootSize &x);

/// x if it is a fraction, else nearest_decimal: for pictures.
Rational drawn_size(const RootSize &x);

/// Fractions with lo < x < hi that differ from x by 1e-30 of it at most; lo = x = hi if x is a fraction.
Interval bounds(const RootSize &x);

} // namespace mdm

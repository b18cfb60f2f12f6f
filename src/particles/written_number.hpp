#pragma once
/// \file
/// Numbers as files carry them: a decimal, and the double that programs make of it.

#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/rational.hpp>

#include <optional>
#include <string>

namespace mdm {

/// A decimal above 0 and the double, or the float, that is nearest to it.
struct WrittenNumber {
  std::string text;
  double value = 0; ///< what a program reads

  /// The number in `text`, exactly.
  Rational decimal() const;
};

/// The value of a finite double, exactly.
Rational exact_value(double value);

/// digits * 10^-places in plain notation or with an exponent, whichever is shorter; digits >= 0.
std::string short_decimal(Integer digits, int places);

/// A number that is not a size: the shortest decimal of r >= 0 itself up to 17 digits, else of a double next
/// to it.
std::string short_decimal(const Rational &r);

/// A size, and how far from it the number in a file may be.
struct SizeToWrite {
  Rational powered;      ///< x^degree for the size x > 0, or f(x) under a law by table or sum
  unsigned degree = 3;   ///< a of the law x^(a/b)
  Rational lower;        ///< of the class, exclusive
  Rational upper;        ///< of the class, inclusive
  Rational most_error;   ///< > 0: greatest relative error of x^degree, and so of the mass x^(a/b)
  bool is_float = false; ///< programs read floats, not doubles
  MassLaw law = {};      ///< in the unit of the size; of a power the degree says all

  /// |y^degree / x^degree - 1|.
  Rational error(const Rational &y) const;
  /// True if y is in the class and its error is small enough.
  bool allows(const Rational &y) const;
};

/// The decimal of fewest digits, next to x on one of its sides, such that `allows` both the decimal and its
/// double (or float); of two the closer one. Where 17 (or 9) digits do not do (x is within an ulp of an
/// opening), one of the doubles around x. Decided exactly. Nothing if none serves: no such double is in the
/// class. Cost: one integer root, some powers.
std::optional<WrittenNumber> shortest_number(const SizeToWrite &size);

} // namespace mdm

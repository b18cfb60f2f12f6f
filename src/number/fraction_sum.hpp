#pragma once
/// \file
/// Sums of very many fractions.

#include <mdm/number/rational.hpp>

namespace mdm {

/// A sum of fractions over a common denominator that grows as needed: nothing is reduced before the sum is
/// asked for. Decimals of so many places keep a denominator of so many digits, however many are added.
class FractionSum {
public:
  /// Adds n / d, d > 0, in lowest terms or not. Cost: two products and a division of integers.
  void add(const Integer &n, const Integer &d);

  Rational value() const { return ratio(numerator_, denominator_); }

private:
  Integer numerator_ = 0;
  Integer denominator_ = 1;
};

} // namespace mdm

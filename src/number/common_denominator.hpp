#pragma once
/// \file
/// Fractions brought over one denominator.

#include <mdm/number/rational.hpp>

#include <vector>

namespace mdm {

/// Fractions as numerators[i] / denominator, the denominator the least common one.
struct CommonDenominator {
  std::vector<Integer> numerators;
  Integer denominator = 1;

  explicit CommonDenominator(const std::vector<Rational> &fractions);
};

/// Sum of fractions. Cheaper than adding one by one: a single reduction.
Rational sum(const std::vector<Rational> &fractions);

} // namespace mdm

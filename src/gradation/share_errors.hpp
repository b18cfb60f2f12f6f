#pragma once
/// \file
/// The distance of shares of the mass from those of a gradation.

#include <mdm/number/rational.hpp>

#include <vector>

namespace mdm {

/// Parts of 1; 0 for an exact match.
struct ShareErrors {
  Rational retained = 0; ///< greatest difference of a class's share
  Rational passing = 0;  ///< greatest difference of what passes a sieve
  Rational total = 0;    ///< sum of the differences of all classes
};

/// \param asked,found  shares that sum to 1, as many of each, ascending by size
ShareErrors share_errors(const std::vector<Rational> &asked, const std::vector<Rational> &found);

} // namespace mdm

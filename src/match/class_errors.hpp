#pragma once
/// \file
/// The differences of the masses in the classes from those of a gradation.

#include <mdm/number/rational.hpp>

#include <vector>

namespace mdm {

/// Error of a sample (Arnold, Eq. 13), both sides normalised by their totals: m_j / sum m - t_j / sum t for
/// the mass t_j that the sample has in class j, so positive where mass is missing.
struct ClassErrors {
  std::vector<Rational> of_class;
  Rational total = 0;    ///< sum of |of_class|
  Rational maximum = 0;  ///< largest |of_class|
  std::size_t worst = 0; ///< the finest class that has it
};

/// \param held    t_j, in any unit; their sum is positive
/// \param target  m_j, in any unit; their sum is positive
ClassErrors class_errors(const std::vector<Integer> &held, const std::vector<Integer> &target);

} // namespace mdm

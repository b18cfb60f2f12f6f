#pragma once
/// \file
/// Gradations of numbers.

#include <mdm/gradation/gradation.hpp>

#include <utility>
#include <vector>

/// Openings, ascending, and the masses on them, in mm and whatever unit.
inline mdm::Gradation gradation(std::vector<mdm::Rational> sizes, std::vector<mdm::Rational> masses) {
  mdm::Gradation::Data data;
  data.sizes = std::move(sizes);
  data.masses = std::move(masses);
  return mdm::Gradation(std::move(data));
}

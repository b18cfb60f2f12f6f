#pragma once
/// \file
/// Gradations as a test writes them.

#include "soil/grading_curve.hpp"

#include <mdm/number/decimal.hpp>

#include <string>
#include <utility>
#include <vector>

namespace grading_test {

/// The gradation through (size in mm, percent passing), ascending; the first passes 0, the last 100.
inline mdm::Gradation soil(const std::vector<std::pair<std::string, std::string>> &points) {
  mdm::Gradation::Data data;
  std::vector<mdm::Rational> passing;
  for (const auto &[size, percent] : points) {
    data.sizes.push_back(mdm::parse_decimal(size));
    passing.push_back(mdm::parse_decimal(percent));
  }
  for (std::size_t i = 0; i + 1 < passing.size(); ++i)
    data.masses.push_back(passing[i + 1] - passing[i]);
  data.masses.emplace_back(0);
  return mdm::Gradation(std::move(data));
}

inline mdm::GradingCurve curve(const std::vector<std::pair<std::string, std::string>> &points) {
  return mdm::GradingCurve(soil(points));
}

inline mdm::Rational decimal(const char *text) {
  return mdm::parse_decimal(text);
}

} // namespace grading_test

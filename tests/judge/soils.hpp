#pragma once
/// Soils for the rules of practice, and a second way to read their curves: in double, point by point.

#include <mdm/gradation/read_gradation.hpp>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace judge_test {

using Points = std::vector<std::pair<double, double>>; // size, percent passing

/// A report of percents passing; `sizes` descend.
inline mdm::UnderstoodGradation soil(const std::vector<std::string> &sizes,
                                     const std::vector<std::string> &passing) {
  std::string text = "size_mm,passing_percent\n";
  for (std::size_t i = 0; i < sizes.size(); ++i)
    text += sizes[i] + "," + passing[i] + "\n";
  return mdm::understand_gradation(text, "soil.csv");
}

inline double percent_at(const Points &ascending, double size) {
  if (size >= ascending.back().first)
    return 100;
  for (std::size_t i = ascending.size() - 1; i-- > 0;)
    if (ascending[i].first <= size) {
      const auto &[x, p] = ascending[i];
      const auto &[y, q] = ascending[i + 1];
      return p + (q - p) * std::log(size / x) / std::log(y / x);
    }
  return 0;
}

/// By bisection.
inline double size_at(const Points &ascending, double percent) {
  double lo = std::log(ascending.front().first), hi = std::log(ascending.back().first);
  for (int i = 0; i < 100; ++i) {
    const double mid = (lo + hi) / 2;
    (percent_at(ascending, std::exp(mid)) < percent ? lo : hi) = mid;
  }
  return std::exp(hi);
}

/// Percents of tenths that fall from 100 at 64 mm to `last` at 0.0625 mm or so, with flat stretches.
inline std::vector<int> random_tenths(std::mt19937 &random, std::size_t n, int last) {
  std::vector<int> tenths = {1000};
  while (tenths.size() < n) {
    const int before = tenths.back();
    const bool flat = random() % 4 == 0;
    tenths.push_back(flat ? before
                          : last + static_cast<int>(random() % static_cast<unsigned>(before - last + 1)));
  }
  return tenths;
}

inline std::string of_tenths(int tenths) {
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

} // namespace judge_test

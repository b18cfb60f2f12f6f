#pragma once
/// \file
/// Parts of the studies' figures.

#include "number/real.hpp"
#include "plot/figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdm {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

inline double to_double(const Rational &r) {
  return r.convert_to<double>();
}

inline double to_double(const Real &y) {
  return to_double(enclose(y, 15).lower());
}

/// Ends of a set of numbers.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void cover(double at) {
    low = std::min(low, at);
    high = std::max(high, at);
  }
  /// All of another.
  void cover(const Range &other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
  bool empty() const { return low > high; }
};

/// A logarithmic axis out to the next powers of ten.
inline Axis decades_axis(const std::string &title, const Range &range) {
  if (range.empty())
    return log_axis(title, 0, 1);
  const double low = std::floor(range.low);
  return log_axis(title, low, std::max(std::ceil(range.high), low + 1));
}

inline Axis plain_axis(const std::string &title, const Range &range) {
  return range.empty() ? linear_axis(title, 0, 1) : linear_axis(title, range.low, range.high);
}

} // namespace mdm

#pragma once
/// \file
/// Least squares, enclosed.

#include "number/ball.hpp"

#include <mdm/number/interval.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// The line of least squares through points.
struct FittedLine {
  std::size_t points;
  Interval slope;
  Interval correlation; ///< Pearson's r
};

/// Through (x_i, y_i); nothing where the x, or the y, are not certainly different, or there are fewer than
/// three.
std::optional<FittedLine> fitted_line(const std::vector<Ball> &x, const std::vector<Ball> &y);

} // namespace mdm

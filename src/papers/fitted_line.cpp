#include "papers/fitted_line.hpp"

#include <cassert>

namespace mdm {
namespace {

constexpr unsigned sum_bits = 192;
constexpr std::size_t fewest_points = 3;

/// n sum a b - sum a sum b: n^2 times a covariance.
Ball spread_of(const std::vector<Ball> &a, const std::vector<Ball> &b) {
  Ball products(0, sum_bits), sum_a(0, sum_bits), sum_b(0, sum_bits);
  for (std::size_t i = 0; i < a.size(); ++i) {
    products = products + a[i] * b[i];
    sum_a = sum_a + a[i];
    sum_b = sum_b + b[i];
  }
  return Ball(Rational(a.size()), sum_bits) * products - sum_a * sum_b;
}

bool is_positive(const Ball &y) {
  return compare(y, Ball(0, sum_bits)) == Order::greater;
}

Interval ends(const Ball &y) {
  return {y.lower(), y.upper()};
}

} // namespace

std::optional<FittedLine> fitted_line(const std::vector<Ball> &x, const std::vector<Ball> &y) {
  assert(x.size() == y.size());
  if (x.size() < fewest_points)
    return std::nullopt;
  const Ball xx = spread_of(x, x), xy = spread_of(x, y), yy = spread_of(y, y);
  if (!is_positive(xx) || !is_positive(yy))
    return std::nullopt;
  return FittedLine{x.size(), ends(xy / xx), ends(xy / pow(xx * yy, ratio(1, 2)))};
}

} // namespace mdm

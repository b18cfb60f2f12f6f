// The point of a polytope nearest to the origin (Wolfe, "Finding the nearest point in a polytope", 1976), in
// fractions. Corners of the polytope come in, and a point between few of them goes out. Invariant: the point
// is the nearest one of the affine hull of its corners, all of which it needs. A corner that lies nearer in
// the point's direction is added; the nearest point of the new hull is taken if it lies between its corners,
// else the way to it is gone until a corner is needed no more, which is dropped. If no corner lies nearer,
// the point is the nearest of all. It ends because the distance falls with each round, and there are finitely
// many sets of corners.

#include "blend/nearest_point.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace mdm {
namespace {

/// The solution of positive definite equations: no pivot is 0.
std::vector<Rational> solution(std::vector<std::vector<Rational>> matrix, std::vector<Rational> right) {
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t r = i + 1; r < n; ++r) {
      const Rational factor = matrix[r][i] / matrix[i][i];
      for (std::size_t c = i; c < n; ++c)
        matrix[r][c] -= factor * matrix[i][c];
      right[r] -= factor * right[i];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c)
      right[i] -= matrix[i][c] * right[c];
    right[i] /= matrix[i][i];
  }
  return right;
}

/// The weights, of sum 1, of the nearest point of the affine hull of independent corners.
std::vector<Rational> nearest_weights(const std::vector<PlacedPoint> &corners) {
  const std::size_t n = corners.size();
  std::vector<std::vector<Rational>> matrix(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      matrix[i][j] = 1 + scalar_product(corners[i].place, corners[j].place);
  std::vector<Rational> weights = solution(std::move(matrix), std::vector<Rational>(n, 1));
  const Rational sum = std::accumulate(weights.begin(), weights.end(), Rational(0));
  for (Rational &w : weights)
    w /= sum;
  return weights;
}

/// How far one may go from weights to others until one of them is 0; 1 at most.
Rational way_to(const std::vector<Rational> &from, const std::vector<Rational> &to) {
  Rational way = 1;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (to[i] < 0)
      way = std::min(way, Rational(from[i] / (from[i] - to[i])));
  return way;
}

PlacedPoint point_between(const std::vector<PlacedPoint> &corners, const std::vector<Rational> &weights) {
  PlacedPoint point{std::vector<Rational>(corners.front().shares.size()),
                    std::vector<Rational>(corners.front().place.size())};
  for (std::size_t c = 0; c < corners.size(); ++c) {
    for (std::size_t i = 0; i < point.shares.size(); ++i)
      point.shares[i] += weights[c] * corners[c].shares[i];
    for (std::size_t i = 0; i < point.place.size(); ++i)
      point.place[i] += weights[c] * corners[c].place[i];
  }
  return point;
}

/// Goes to the nearest point of the hull, or until a corner is dropped, as often as one is.
void approach(std::vector<PlacedPoint> &corners, std::vector<Rational> &weights) {
  for (bool is_there = false; !is_there;) {
    const std::vector<Rational> to = nearest_weights(corners);
    const Rational way = way_to(weights, to);
    is_there = way == 1;
    for (std::size_t i = corners.size(); i-- > 0;) {
      weights[i] += way * (to[i] - weights[i]);
      if (weights[i] > 0)
        continue;
      weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(i));
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

} // namespace

Rational scalar_product(const std::vector<Rational> &a, const std::vector<Rational> &b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), Rational(0));
}

PlacedPoint nearest_point(PlacedPoint corner, const LeastCorner &least_corner) {
  std::vector<PlacedPoint> corners = {corner};
  std::vector<Rational> weights = {1};
  for (PlacedPoint point = std::move(corner);; point = point_between(corners, weights)) {
    PlacedPoint next = least_corner(point.place);
    if (scalar_product(next.place, point.place) >= scalar_product(point.place, point.place))
      return point;
    corners.push_back(std::move(next));
    weights.emplace_back(0);
    approach(corners, weights);
  }
}

} // namespace mdm

#pragma once
/// \file
/// The point of a polytope that lies nearest to the origin.

#include <mdm/number/rational.hpp>

#include <functional>
#include <vector>

namespace mdm {

/// A point by its shares, and where these place it. The place is an affine map of the shares.
struct PlacedPoint {
  std::vector<Rational> shares, place;
};

/// The corner of a polytope at which the scalar product of its place with a direction is least.
using LeastCorner = std::function<PlacedPoint(const std::vector<Rational> &direction)>;

/// The point whose place is nearest to the origin.
/// Cost: a call of least_corner and the solution of linear equations a round; there are finitely many.
PlacedPoint nearest_point(PlacedPoint corner, const LeastCorner &least_corner);

/// The scalar product.
Rational scalar_product(const std::vector<Rational> &a, const std::vector<Rational> &b);

} // namespace mdm

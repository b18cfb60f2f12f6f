#pragma once
/// \file
/// The circle on which the centres of discs lie that touch a disc, and where another one is met on it.
///
/// Only + - * / and square roots, so that results are the same on every machine.

#include <cmath>

namespace mdm::packing {

/// A vector; of length 1 where it is a direction.
struct Vector {
  double x, y;
};

/// Where the circle of radius a around the origin meets that of radius b around `centre`; of the two points
/// the one to the left of the line to `centre`. \pre the circles meet
inline Vector meeting(Vector centre, double a, double b) {
  const double d2 = centre.x * centre.x + centre.y * centre.y;
  const double along = (d2 + (a - b) * (a + b)) / (2 * d2);
  const double across2 = a * a / d2 - along * along;
  const double across = across2 > 0 ? std::sqrt(across2) : 0;
  return {along * centre.x - across * centre.y, along * centre.y + across * centre.x};
}

/// The same point, computed from the smaller circle: the error is then some d^2 / 2^52 / a.
inline Vector accurate_meeting(Vector centre, double a, double b) {
  if (a <= b)
    return meeting(centre, a, b);
  // From the other centre the point is to the right: turn the picture over.
  const Vector mirrored = meeting({centre.x, -centre.y}, b, a);
  return {centre.x - mirrored.x, centre.y + mirrored.y};
}

/// The other side of a right triangle: sqrt(c^2 - a^2), |a| <= c.
inline double leg(double c, double a) {
  const double square = (c - a) * (c + a);
  return square > 0 ? std::sqrt(square) : 0;
}

/// Clockwise order of directions from one of them: which comes first.
class Clockwise {
public:
  explicit Clockwise(Vector from) : from_(from) {}

  /// True if a comes before b.
  bool operator()(Vector a, Vector b) const {
    const int part_a = part(a), part_b = part(b);
    return part_a != part_b ? part_a < part_b : cross(a, b) < 0;
  }

private:
  static double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

  /// 0 here, up to rounding on either side; 1 within the first half turn; 2 beyond.
  int part(Vector v) const {
    constexpr double here = 1e-9;
    const double c = cross(from_, v);
    if (std::fabs(c) <= here && from_.x * v.x + from_.y * v.y > 0)
      return 0;
    return c < 0 ? 1 : 2;
  }

  Vector from_;
};

} // namespace mdm::packing

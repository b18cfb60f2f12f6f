// The part of a sphere that lies on one side of up to three planes at right angles, as needed where the
// inner space cuts it. What comes in are the depths of the planes in radii; what goes out is an enclosure
// of the part's share of the volume.
//
// A plane beyond the centre is replaced by its mirror image: the whole less what is beyond that. What is
// left are caps, wedges and corners with all distances from 0 to 1. A cap is a polynomial; the others
// integrate the area of a slice over its height, which has an antiderivative of roots and angles. All is
// computed in balls, so that the result encloses it whatever cancels.

#include "packing/cut_sphere.hpp"

#include "number/ball.hpp"
#include "number/pi.hpp"

#include <algorithm>
#include <vector>

namespace mdm::packing {
namespace {

constexpr unsigned bits_of_share = 96;

Ball cut_ball(const Rational &r) {
  return {r, bits_of_share};
}

const Ball &cut_pi() {
  static const Ball pi = [] {
    const Enclosure e = enclose_pi(40);
    return hull(cut_ball(e.lower()), cut_ball(e.upper()));
  }();
  return pi;
}

/// The angle from 0 to pi / 2 whose sine has that square: pi / 2 I_y(1/2, 1/2). By that of the cosine above a
/// half, so that no ball holds what is more than 1.
Ball angle_of(const Rational &sine2) {
  if (sine2 > ratio(1, 2))
    return cut_pi() * cut_ball(ratio(1, 2)) - angle_of(1 - sine2);
  return cut_pi() * cut_ball(ratio(1, 2)) * incomplete_beta(cut_ball(sine2), ratio(1, 2), ratio(1, 2));
}

Ball sqrt_of(const Rational &r) {
  return r == 0 ? cut_ball(0) : pow(cut_ball(r), ratio(1, 2));
}

/// Twice the antiderivative, at z and for the side a, of the part that a has of the area
/// {x > a, y > b, x^2 + y^2 < 1 - z^2}, which is
/// ((acos(a/R) + acos(b/R) - pi/2) R^2 - a sqrt(R^2 - a^2) - b sqrt(R^2 - b^2)) / 2 + ab with R^2 = 1 - z^2:
/// of acos(a/R) R^2 - a sqrt(R^2 - a^2). \param z2  its square \pre a^2 + z^2 <= 1, a < 1, z < 1
Ball side_integral(const Rational &a, const Ball &z, const Rational &z2) {
  const Rational a2 = a * a, k2 = 1 - a2, rho2 = 1 - z2;
  const Ball angle_a = cut_pi() * cut_ball(ratio(1, 2)) - angle_of(a2 / rho2);
  const Ball angle_z = angle_of(z2 / k2);
  const Ball both = angle_of(a2 * z2 / (k2 * rho2)); // atan(a z / sqrt(R^2 - a^2))
  const Ball leg = sqrt_of(k2 - z2);
  return (z - z * cut_ball(z2 / 3)) * angle_a - cut_ball(a * (k2 + 2) / 3) * angle_z -
         cut_ball(a * ratio(2, 3)) * z * leg + cut_ball(ratio(2, 3)) * both;
}

/// Volume of the cap x > a, 0 <= a <= 1, by pi.
Rational cap_by_pi(const Rational &a) {
  return (1 - a) * (1 - a) * (2 + a) / 3;
}

/// Volume with x > a, y > b, z > c, for 0 <= a, b, c < 1: the integral of the area above from c to
/// h = sqrt(1 - a^2 - b^2).
Ball corner(const Rational &a, const Rational &b, const Rational &c) {
  if (a == 0 && b == 0)
    return cut_pi() * cut_ball(cap_by_pi(c) / 4);
  const Rational h2 = 1 - a * a - b * b, c2 = c * c;
  if (h2 <= c2)
    return cut_ball(0);
  const Ball h = sqrt_of(h2), low = cut_ball(c);
  const auto between = [&](const Rational &side) {
    return side_integral(side, h, h2) - side_integral(side, low, c2);
  };
  const auto cubic = [](const Ball &z, const Rational &z2) { return z - z * cut_ball(z2 / 3); };
  return (between(a) + between(b)) * cut_ball(ratio(1, 2)) -
         cut_pi() * cut_ball(ratio(1, 4)) * (cubic(h, h2) - cubic(low, c2)) + cut_ball(a * b) * (h - low);
}

/// Volume beyond the planes at these distances, of one to three directions, -1 < distance < 1: beyond a
/// plane on the other side of the centre is all but what is beyond its mirror image.
Ball beyond(std::vector<Rational> planes) {
  if (planes.empty())
    return cut_pi() * cut_ball(ratio(4, 3));
  const auto negative = std::find_if(planes.begin(), planes.end(), [](const Rational &p) { return p < 0; });
  if (negative != planes.end()) {
    std::vector<Rational> others = planes;
    others.erase(others.begin() + (negative - planes.begin()));
    *negative = -*negative;
    return beyond(others) - beyond(planes);
  }
  if (planes.size() == 1)
    return cut_pi() * cut_ball(cap_by_pi(planes[0]));
  if (planes.size() == 2)
    return cut_ball(2) * corner(planes[0], planes[1], 0);
  return corner(planes[0], planes[1], planes[2]);
}

} // namespace

Interval kept_share(const std::array<Rational, 3> &depth) {
  std::vector<Rational> planes; // what is below a depth is beyond a plane at the other side
  for (const Rational &t : depth)
    if (t < 1)
      planes.push_back(-t);
  if (planes.empty())
    return Rational(1);
  if (planes.size() == 1) {
    const Rational &t = planes[0];
    return Rational((2 - 3 * t + t * t * t) / 4);
  }
  const Ball share = beyond(planes) / (cut_pi() * cut_ball(ratio(4, 3)));
  return {std::max(Rational(0), share.lower()), std::min(Rational(1), share.upper())};
}

} // namespace mdm::packing

// The share of a window that discs cover. What comes in is a packing without overlaps and a rectangle; what
// goes out is a real number that is enclosed as closely as is asked for.
//
// Discs inside of the window count r^2, an integer, together times pi. Of a disc that a side cuts, the part
// inside is had from areas beyond corners: A(left, bottom) - A(right, bottom) - A(left, top) + A(right,
// top), where A(a, b) is the area with x >= a and y >= b, a sector and two triangles, or segments. Which of
// these it is depends on integers alone; the angles are computed in balls, by the incomplete beta function.

#include "packing/packing_fraction.hpp"

#include "number/ball.hpp"
#include "number/pi.hpp"

namespace mdm {
namespace {

/// A disc that a window cuts, and the window's sides seen from its centre.
struct CutDisc {
  std::int64_t r, left, bottom, right, top;
};

/// Areas of parts of a disc of radius r around the origin, in squares of units.
class DiscArea {
public:
  DiscArea(std::int64_t r, const Ball &pi, unsigned bits)
      : r_(r), bits_(bits), pi_(pi), whole_(pi * ball(Integer(r) * r)) {}

  /// Of the part with x >= a.
  Ball beyond(std::int64_t a) const {
    if (a >= r_)
      return ball(0);
    if (a <= -r_)
      return whole_;
    return angle(a) * ball(Integer(r_) * r_) - ball(a) * leg(a);
  }

  /// Of the part with x >= a and y >= b.
  Ball beyond(std::int64_t a, std::int64_t b) const {
    if (a >= r_ || b >= r_)
      return ball(0);
    if (a <= -r_ || b <= -r_)
      return beyond(a <= -r_ ? b : a);
    if (Integer(a) * a + Integer(b) * b < Integer(r_) * r_) {
      // A sector between the ends of the two sides, and two triangles at its corner.
      const Ball sector = (angle(a) + angle(b) - pi_ / ball(2)) * ball(Integer(r_) * r_);
      const Ball triangles = ball(2 * Integer(a) * b) - ball(a) * leg(a) - ball(b) * leg(b);
      return (sector + triangles) / ball(2);
    }
    if (a >= 0 && b >= 0)
      return ball(0);
    if (a >= 0)
      return beyond(a);
    if (b >= 0)
      return beyond(b);
    return beyond(a) + beyond(b) - whole_;
  }

private:
  Ball ball(const Integer &n) const { return {Rational(n), bits_}; }

  /// r^2 - a^2.
  Integer leg2(std::int64_t a) const { return (Integer(r_) - a) * (Integer(r_) + a); }
  /// sqrt(r^2 - a^2).
  Ball leg(std::int64_t a) const { return pow(ball(leg2(a)), ratio(1, 2)); }

  /// From the direction of x to the end of the chord x = a: arccos(a / r), |a| < r. The angle up to pi / 2
  /// with the sine s is pi / 2 I_y(1/2, 1/2), y = s^2.
  Ball angle(std::int64_t a) const {
    const Ball sine2(ratio(leg2(a), Integer(r_) * r_), bits_);
    const Ball acute = pi_ / ball(2) * incomplete_beta(sine2, ratio(1, 2), ratio(1, 2));
    return a >= 0 ? acute : pi_ - acute;
  }

  std::int64_t r_;
  unsigned bits_;
  Ball pi_, whole_;
};

/// Encloses pi.
Ball pi(unsigned bits) {
  // A digit has more than three bits.
  const Enclosure e = enclose_pi(bits / 3);
  return hull(Ball(e.lower(), bits), Ball(e.upper(), bits));
}

Ball area(const CutDisc &d, const Ball &pi, unsigned bits) {
  const DiscArea disc(d.r, pi, bits);
  return disc.beyond(d.left, d.bottom) - disc.beyond(d.right, d.bottom) - disc.beyond(d.left, d.top) +
         disc.beyond(d.right, d.top);
}

} // namespace

Real packing_fraction(const Packing &p, const PackingWindow &w) {
  Integer squares = 0;
  std::vector<CutDisc> cut;
  for (const PackedDisc &d : p.discs) {
    CutDisc c{d.r, w.x_min - d.x, w.y_min - d.y, w.x_max - d.x, w.y_max - d.y};
    if (p.periodic) {
      // What sticks out on one side comes in on the other.
      c.left = -d.r;
      c.right = d.r;
    }
    if (c.left >= d.r || c.right <= -d.r || c.bottom >= d.r || c.top <= -d.r)
      continue;
    if (c.left <= -d.r && c.right >= d.r && c.bottom <= -d.r && c.top >= d.r)
      squares += Integer(d.r) * d.r;
    else
      cut.push_back(c);
  }
  const Integer window = Integer(w.x_max - w.x_min) * Integer(w.y_max - w.y_min);
  return Real([squares, cut, window](unsigned bits) {
    const Ball circle = pi(bits);
    Ball sum = Ball(Rational(squares), bits) * circle;
    for (const CutDisc &d : cut)
      sum = sum + area(d, circle, bits);
    return sum / Ball(Rational(window), bits);
  });
}

} // namespace mdm

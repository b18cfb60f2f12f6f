#pragma once
/// \file
/// A walk over the circles of an Apollonian gasket.

#include "packing/apollonian.hpp"

#include <cmath>

namespace mdm::packing {

/// Decides whether p + q sqrt 3 is at most a bound: in doubles, or in whole numbers where they do not tell.
class CurvatureBound {
public:
  explicit CurvatureBound(Rational most) : most_(std::move(most)), near_(most_.convert_to<double>()) {}

  static double value(std::int64_t p, std::int64_t q) {
    return static_cast<double>(p) + static_cast<double>(q) * sqrt3;
  }
  /// What rounding can make of the value.
  static double error(std::int64_t p, std::int64_t q) {
    constexpr double unit = 0x1p-51;
    return unit * (std::fabs(static_cast<double>(p)) + 2 * std::fabs(static_cast<double>(q)));
  }

  bool holds(std::int64_t p, std::int64_t q) const {
    const double below = near_ - value(p, q), doubt = error(p, q) + 0x1p-51 * near_;
    if (std::fabs(below) > doubt)
      return below > 0;
    return holds_exactly(p, q);
  }

private:
  static constexpr double sqrt3 = 1.7320508075688772;

  bool holds_exactly(std::int64_t p, std::int64_t q) const {
    const Rational rest = most_ - Rational(p); // q sqrt 3 <= rest
    const Rational squares = rest * rest - 3 * Rational(q) * Rational(q);
    return q <= 0 ? rest >= 0 || squares <= 0 : rest >= 0 && squares >= 0;
  }

  Rational most_;
  double near_;
};

/// Four circles that touch each other; the last one came last.
template <class Circle>
struct Quadruple {
  std::array<Circle, 4> circles;
  int last; ///< the place of the circle that came last; -1 at the root
};

/// Calls take(circle) for each circle that follows from the root and is within bounds, the root's not among
/// them. A word of reflections without repetitions leads to each circle once. Circles beyond the bounds have
/// none within them behind.
template <class Circle, class Within, class Take>
void each_reflected(const std::array<Circle, 4> &root, const Within &within, const Take &take) {
  std::vector<Quadruple<Circle>> open{{root, -1}};
  while (!open.empty()) {
    const Quadruple<Circle> at = open.back();
    open.pop_back();
    const Circle sum = at.circles[0] + at.circles[1] + at.circles[2] + at.circles[3];
    for (int i = 0; i < 4; ++i) {
      if (i == at.last)
        continue;
      const auto place = static_cast<std::size_t>(i);
      const Circle reflected = sum.twice_without(at.circles[place]);
      if (!within(reflected))
        continue;
      take(reflected);
      open.push_back({at.circles, i});
      open.back().circles[place] = reflected;
    }
  }
}

} // namespace mdm::packing

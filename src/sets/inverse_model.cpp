// Branch and prune for the shapes (a, b) of the beta curve with given C_u and C_c at a span. With x_p the
// size below which the share p lies, reduced, and w = 2 s / (1 - s), the sizes are d_p = 1 + w x_p in d_min,
// and what is asked for is d_60 = C_u d_10 and d_30 = K d_10, K = sqrt(C_u C_c). All d_p grow with a and fall
// with b, so that over a box of shapes two corners bound them (Theorem 25 a). A box on which an equation
// cannot hold is left out; others are halved until they are narrow. What is left is joined to boxes that do
// not meet, and in each a shape is looked for by Miranda's theorem (Theorem 25 c): the two equations,
// combined by fractions so that each changes with one parameter alone, must have certain and opposite signs
// on opposite sides of a box around it. Doubles choose where to halve, which widths are narrow, and how to
// combine; signs are decided in fractions. It ends because boxes are narrow after so many halvings.

#include "sets/inverse_model.hpp"

#include "sets/beta_curve.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>

namespace mdm {
namespace {

constexpr unsigned size_bits = 72;
/// Of the logarithms of a and b in the last boxes.
constexpr double narrow = 3e-5;
constexpr std::uint64_t most_examined = 200000;
constexpr std::size_t most_left = 4000;
constexpr unsigned most_pieces = 4096;

/// d_10, d_30 and d_60 in d_min.
using InverseSizes = std::array<Interval, 3>;

/// Ends of a box; both corners of it are shapes.
struct Corners {
  double a1, a2, b1, b2;
};

/// A multiple of 2^-size_bits on either side.
Interval outward(const Rational &lo, const Rational &hi) {
  const Integer unit = Integer(1) << size_bits;
  return {ratio(floor(Rational(lo * Rational(unit))), unit),
          ratio(ceil(Rational(hi * Rational(unit))), unit)};
}

/// An interval times one of numbers from 0 on.
Interval product_of(const Interval &c, const Interval &y) {
  return {c.lo >= 0 ? Rational(c.lo * y.lo) : Rational(c.lo * y.hi),
          c.hi >= 0 ? Rational(c.hi * y.hi) : Rational(c.hi * y.lo)};
}

double middle_of(const Interval &y) {
  return Rational((y.lo + y.hi) / 2).convert_to<double>();
}

/// A linear combination of sizes that is to be 0.
using Equation = std::array<Interval, 3>;

class InverseSearch {
public:
  explicit InverseSearch(const InverseQuestion &q)
      : question_(q), width_(2 * q.span / (1 - q.span)), c_u_(q.c_u),
        k_(root(Rational(q.c_u.lo * q.c_c.lo), 2, size_bits).lo,
           root(Rational(q.c_u.hi * q.c_c.hi), 2, size_bits).hi) {}

  InverseShapes run() {
    InverseShapes found;
    // 1 < d_30 / d_10 < d_60 / d_10 for every shape.
    if (k_.hi <= 1 || k_.lo >= c_u_.hi)
      return found;
    const std::vector<Corners> boxes = joined(left(found));
    for (const Corners &c : boxes)
      found.boxes.push_back({{Rational(c.a1), Rational(c.a2)},
                             {Rational(c.b1), Rational(c.b2)},
                             found.complete && holds_one(c, boxes)});
    std::sort(found.boxes.begin(), found.boxes.end(),
              [](const ShapeBox &x, const ShapeBox &y) { return x.a.lo < y.a.lo; });
    return found;
  }

private:
  /// Boxes that are narrow and not excluded.
  std::vector<Corners> left(InverseShapes &found) {
    const double from = outer_end(question_.within.lo, false), to = outer_end(question_.within.hi, true);
    std::vector<Corners> boxes = {{from, to, from, to}};
    for (;;) {
      std::vector<Corners> kept;
      for (const Corners &c : boxes)
        if (!is_excluded(c))
          kept.push_back(c);
      found.examined += boxes.size();
      boxes.clear();
      bool all_narrow = true;
      for (const Corners &c : kept) {
        const double a = std::log(c.a2 / c.a1), b = std::log(c.b2 / c.b1);
        if (std::max(a, b) <= narrow) {
          boxes.push_back(c);
          continue;
        }
        all_narrow = false;
        halve(c, a >= b, boxes);
      }
      if (all_narrow)
        return boxes;
      if (found.examined > most_examined || boxes.size() > most_left) {
        found.complete = false;
        return kept;
      }
    }
  }

  /// The double at or outside the end of the range.
  static double outer_end(const Rational &end, bool is_upper) {
    double y = end.convert_to<double>();
    while (is_upper ? Rational(y) < end : Rational(y) > end)
      y = std::nextafter(y, is_upper ? HUGE_VAL : 0.0);
    return y;
  }

  static void halve(const Corners &c, bool in_a, std::vector<Corners> &boxes) {
    const double middle = in_a ? std::sqrt(c.a1 * c.a2) : std::sqrt(c.b1 * c.b2);
    Corners low = c, high = c;
    (in_a ? low.a2 : low.b2) = middle;
    (in_a ? high.a1 : high.b1) = middle;
    boxes.push_back(low);
    boxes.push_back(high);
  }

  const InverseSizes &sizes(double a, double b) {
    const auto at = sizes_.find({a, b});
    if (at != sizes_.end())
      return at->second;
    InverseSizes all;
    static const Rational shares[] = {ratio(1, 10), ratio(3, 10), ratio(6, 10)};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Ball x = inverse_incomplete_beta(shares[i], Rational(a), Rational(b), size_bits);
      all.at(i) = outward(Rational(1 + width_ * x.lower()), Rational(1 + width_ * x.upper()));
    }
    return sizes_.emplace(std::pair(a, b), all).first->second;
  }

  /// The sizes over a box: they grow with a and fall with b.
  InverseSizes over(const Corners &c) {
    const InverseSizes least = sizes(c.a1, c.b2), most = sizes(c.a2, c.b1);
    InverseSizes all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all.at(i) = {least.at(i).lo, most.at(i).hi};
    return all;
  }

  /// True if d' = r d is certain to fail.
  static bool is_impossible(const Interval &larger, const Interval &r, const Interval &smaller) {
    return larger.hi < r.lo * smaller.lo || larger.lo > r.hi * smaller.hi;
  }

  bool is_excluded(const Corners &c) {
    const auto [d10, d30, d60] = over(c);
    return is_impossible(d60, c_u_, d10) || is_impossible(d30, k_, d10) || is_impossible(d60, c_u_ / k_, d30);
  }

  static bool meet(const Corners &x, const Corners &y) {
    return x.a1 <= y.a2 && y.a1 <= x.a2 && x.b1 <= y.b2 && y.b1 <= x.b2;
  }

  /// Boxes around those that touch each other, until none of them meet.
  static std::vector<Corners> joined(std::vector<Corners> boxes) {
    std::vector<Corners> all;
    for (Corners c : boxes) {
      for (std::size_t i = 0; i < all.size();) {
        if (!meet(all[i], c)) {
          ++i;
          continue;
        }
        c = {std::min(c.a1, all[i].a1), std::max(c.a2, all[i].a2), std::min(c.b1, all[i].b1),
             std::max(c.b2, all[i].b2)};
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0; // what was looked at may meet the larger box
      }
      all.push_back(c);
    }
    return all;
  }

  /// d_60 - C_u d_10 and d_30 - K d_10 in doubles.
  std::array<double, 2> residues(double a, double b) {
    const auto &[d10, d30, d60] = sizes(a, b);
    return {middle_of(d60) - middle_of(c_u_) * middle_of(d10),
            middle_of(d30) - middle_of(k_) * middle_of(d10)};
  }

  /// The two equations combined so that the first changes by 1 with a, and the second with b, over half a
  /// box; nothing if they change alike.
  std::optional<std::array<Equation, 2>> combined(const Corners &c) {
    const double a = std::sqrt(c.a1 * c.a2), b = std::sqrt(c.b1 * c.b2);
    const auto along_a = difference(residues(c.a2, b), residues(c.a1, b)),
               along_b = difference(residues(a, c.b2), residues(a, c.b1));
    const double det = along_a[0] * along_b[1] - along_b[0] * along_a[1];
    const std::array<std::array<double, 2>, 2> inverse = {
        {{along_b[1] / det, -along_b[0] / det}, {-along_a[1] / det, along_a[0] / det}}};
    std::array<Equation, 2> equations;
    std::array<std::array<Rational, 2>, 2> exact;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!std::isfinite(inverse.at(i)[0]) || !std::isfinite(inverse.at(i)[1]))
        return std::nullopt;
      const Rational first(inverse.at(i)[0]), second(inverse.at(i)[1]);
      exact.at(i) = {first, second};
      const Interval of_10 = scaled(c_u_, Rational(-first)) + scaled(k_, Rational(-second));
      equations.at(i) = {of_10, Interval(second), Interval(first)};
    }
    if (exact[0][0] * exact[1][1] == exact[0][1] * exact[1][0])
      return std::nullopt;
    return equations;
  }

  static std::array<double, 2> difference(const std::array<double, 2> &x, const std::array<double, 2> &y) {
    return {(x[0] - y[0]) / 2, (x[1] - y[1]) / 2};
  }

  static Interval scaled(const Interval &y, const Rational &c) {
    return c >= 0 ? Interval(Rational(c * y.lo), Rational(c * y.hi))
                  : Interval(Rational(c * y.hi), Rational(c * y.lo));
  }

  /// True if the equation has this sign on all of a side, which is a box without width.
  bool has_sign(const Equation &equation, const Corners &side, bool positive) {
    for (unsigned pieces = 1; pieces <= most_pieces; pieces *= 4) {
      bool all = true;
      for (unsigned i = 0; i < pieces && all; ++i) {
        const InverseSizes d = over(piece(side, i, pieces));
        const Interval value =
            product_of(equation[0], d[0]) + product_of(equation[1], d[1]) + product_of(equation[2], d[2]);
        all = positive ? value.lo > 0 : value.hi < 0;
      }
      if (all)
        return true;
    }
    return false;
  }

  static Corners piece(const Corners &side, unsigned i, unsigned pieces) {
    const auto at = [&](double from, double to, unsigned k) {
      return k == 0 ? from : k == pieces ? to : from + (to - from) * k / pieces;
    };
    return {at(side.a1, side.a2, i), at(side.a1, side.a2, i + 1), at(side.b1, side.b2, i),
            at(side.b1, side.b2, i + 1)};
  }

  /// Miranda's theorem on the box, widened by its own width. A shape that it finds solves the equations, so
  /// it lies in one of the boxes: in this one, as the wider one lies in the range and meets no other.
  bool holds_one(const Corners &box, const std::vector<Corners> &all) {
    const double in_a = box.a2 / box.a1, in_b = box.b2 / box.b1;
    const Corners c = {box.a1 / in_a, box.a2 * in_a, box.b1 / in_b, box.b2 * in_b};
    if (Rational(c.a1) < question_.within.lo || Rational(c.b1) < question_.within.lo ||
        Rational(c.a2) > question_.within.hi || Rational(c.b2) > question_.within.hi)
      return false;
    if (std::count_if(all.begin(), all.end(), [&](const Corners &other) { return meet(c, other); }) > 1)
      return false;
    const auto equations = combined(c);
    if (!equations)
      return false;
    const auto &[of_a, of_b] = *equations;
    return has_sign(of_a, {c.a1, c.a1, c.b1, c.b2}, false) &&
           has_sign(of_a, {c.a2, c.a2, c.b1, c.b2}, true) &&
           has_sign(of_b, {c.a1, c.a2, c.b1, c.b1}, false) && has_sign(of_b, {c.a1, c.a2, c.b2, c.b2}, true);
  }

  const InverseQuestion &question_;
  Rational width_; ///< w
  Interval c_u_, k_;
  std::map<std::pair<double, double>, InverseSizes> sizes_;
};

} // namespace

bool InverseShapes::is_certain() const {
  return complete &&
         std::all_of(boxes.begin(), boxes.end(), [](const ShapeBox &box) { return box.holds_one; });
}

InverseShapes inverse_shapes(const InverseQuestion &question) {
  assert(question.c_u.lo >= 1 && question.c_c.lo > 0);
  return InverseSearch(question).run();
}

} // namespace mdm

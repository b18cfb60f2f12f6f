// Whether one curve of a box keeps all limits together. What comes in are the box, narrowed, and limits at
// sieves or between them; what goes out is yes or no, and a curve.
//
// From the finest sieve up: R_i is the set of what may pass sieve i on a curve that keeps everything up to
// there. Conditions tie x at sieve i with y at the next one alone, so R_{i+1} is the projection of a
// polygon: each pair of a lower and an upper bound on x gives a bound on y (Fourier, Motzkin). R_i is an
// interval, since all conditions are linear. If none is empty there is a curve; it is chosen from the
// coarsest sieve down, in short decimals near the report, where each choice is certain to have one below
// it. Bounds with logarithms are compared by refining.

#include "judge/curve_within.hpp"

#include "judge/decided.hpp"
#include "number/decimal_exponent.hpp"

#include <algorithm>

namespace mdm {
namespace {

constexpr long most_places = 40;

/// A range of percents that bounds make narrower.
struct Range {
  Real lo, hi;

  void raise(const Real &bound) {
    if (certainly_less(lo, bound))
      lo = bound;
  }
  void lower(const Real &bound) {
    if (certainly_less(bound, hi))
      hi = bound;
  }
  bool is_empty() const { return certainly_less(hi, lo); }
};

/// The least decimal of so many places that is not below y.
Rational decimal_not_below(const Real &y, long places) {
  const Real units = y * Real(ten_to(places));
  const IntegerBounds n = floor_of(Real(0) - units);
  if (!n.is_point())
    throw NotAvailable{"1,200 digits do not tell it from a decimal", true};
  return Rational(Integer(-n.lo)) * ten_to(-places);
}

/// `wish`, or a short decimal of the range near it.
std::optional<Rational> decimal_in(const Range &range, const Rational &wish) {
  const bool is_low = certainly_less(Real(wish), range.lo);
  if (!is_low && !certainly_less(range.hi, Real(wish)))
    return wish;
  const Real &end = is_low ? range.lo : range.hi;
  if (const std::optional<Rational> value = end.exact())
    return value;
  for (long places = 0; places <= most_places; ++places) {
    const Rational near = is_low ? decimal_not_below(range.lo, places)
                                 : Rational(-decimal_not_below(Real(0) - range.hi, places));
    if (!certainly_less(Real(near), range.lo) && !certainly_less(range.hi, Real(near)))
      return near;
  }
  return std::nullopt;
}

/// The search, sieve by sieve.
class Search {
public:
  Search(const CurveBox &box, const std::vector<PlacedLimits> &limits)
      : box_(box), between_(box.openings.size()) {
    for (const Interval &p : box.passing)
      ranges_.push_back({Real(p.lo), Real(p.hi)});
    for (const PlacedLimits &l : limits)
      if (l.place.way) {
        between_[l.place.i].push_back(&l);
      } else {
        ranges_[l.place.i].raise(Real(l.least));
        ranges_[l.place.i].lower(Real(l.most));
      }
  }

  CurveWithin run() {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      if (i > 0)
        reach(i - 1);
      if (ranges_[i].is_empty())
        return {};
    }
    return {true, curve()};
  }

private:
  /// Narrows the range y of sieve i + 1 to what can follow one of the range x of sieve i. Each pair of a
  /// lower and an upper bound on x is one on y; t y + (1 - t) x is what passes on the way t between the
  /// sieves.
  void reach(std::size_t i) {
    const Range &x = ranges_[i];
    Range &y = ranges_[i + 1];
    const Interval &step = box_.retained[i];
    y.raise(x.lo + Real(step.lo));
    y.lower(x.hi + Real(step.hi));
    for (const PlacedLimits *const l : between_[i]) {
      const Real &t = *l->place.way;
      const Real least(l->least), most(l->most), rest = Real(1) - t;
      y.raise(x.hi + divided(least - x.hi, t));
      y.lower(x.lo + divided(most - x.lo, t));
      y.raise(least + scaled(Real(step.lo), rest));
      y.lower(most + scaled(Real(step.hi), rest));
      for (const PlacedLimits *const other : between_[i])
        if (other != l)
          reach_by(*l, *other, y);
    }
  }

  /// By the least of one and the most of another sieve between the same two.
  static void reach_by(const PlacedLimits &floor, const PlacedLimits &ceiling, Range &y) {
    const Real distance = *ceiling.place.way - *floor.place.way;
    const Real bound =
        Real(floor.least) + scaled(Real(ceiling.most - floor.least), (Real(1) - *floor.place.way) / distance);
    if (certainly_less(Real(0), distance))
      y.lower(bound);
    else
      y.raise(bound);
  }

  static Real divided(const Real &c, const Real &t) { return scaled(c, Real(1) / t); }

  /// A curve, from the largest sieve down: what can precede each is certain to reach it.
  std::optional<CurvePercents> curve() const {
    CurvePercents p = box_.reported;
    for (std::size_t i = p.size(); i-- > 0;) {
      Range x = ranges_[i];
      if (i + 1 < p.size())
        precede(i, p[i + 1], x);
      const std::optional<Rational> chosen = decimal_in(x, p[i]);
      if (!chosen)
        return std::nullopt;
      p[i] = *chosen;
    }
    return p;
  }

  void precede(std::size_t i, const Rational &next, Range &x) const {
    const Real y(next);
    x.raise(Real(next - box_.retained[i].hi));
    x.lower(Real(next - box_.retained[i].lo));
    for (const PlacedLimits *const l : between_[i]) {
      const Real rest = Real(1) - *l->place.way;
      x.raise(y + divided(Real(l->least - next), rest));
      x.lower(y + divided(Real(l->most - next), rest));
    }
  }

  const CurveBox &box_;
  std::vector<Range> ranges_;
  std::vector<std::vector<const PlacedLimits *>> between_;
};

} // namespace

Available<CurveWithin> curve_within(const CurveBox &box, const std::vector<PlacedLimits> &limits) {
  try {
    return Search(box, limits).run();
  } catch (const NotAvailable &why) {
    return why;
  }
}

} // namespace mdm

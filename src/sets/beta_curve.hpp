#pragma once
/// \file
/// The cumulative beta model of a grading curve.

#include "sets/model_curve.hpp"

namespace mdm {

/// I_x(a, b) for 0 <= x <= 1 and a, b > 0 where it is known to be a fraction: for an integer b it is x^a
/// sum_{j<b} (a)_j / j! (1 - x)^j, for an integer a it follows from I_x(a, b) = 1 - I_{1-x}(b, a), and there
/// are I_{1/2}(a, a) = 1/2 and I_{1/4}(1/2, 1/2) = 1/3. Nothing where that would take too long.
std::optional<Rational> exact_incomplete_beta(const Rational &x, const Rational &a, const Rational &b);

/// Encloses the x with I_x(a, b) = y, 0 <= y <= 1, in an interval of some 2^-bits: bisection, near 0
/// and 1 of the exponent, and interval Newton steps. Cost: some ten incomplete betas, some tens where the
/// density is 0 or infinite nearby.
Ball inverse_incomplete_beta(const Rational &y, const Rational &a, const Rational &b, unsigned bits);

/// h(d) = I_{d_r}(a, b), d_r = (d - d_min) / (d_max - d_min) (Voivret, Delenne, Radjai, Eq. 12-16).
class BetaCurve : public ModelCurve {
public:
  /// The least and the largest a and b.
  static const Rational &least_parameter();
  static const Rational &largest_parameter();

  /// \throws InputError if a or b is out of bounds or not 0 < d_min < d_max
  BetaCurve(Rational a, Rational b, Rational d_min, Rational d_max);

  const Rational &a() const { return a_; }
  const Rational &b() const { return b_; }
  Rational d_min() const override { return d_min_; }
  Rational d_max() const override { return d_min_ + width_; }
  /// s = (d_max - d_min) / (d_max + d_min) (Eq. 17).
  Rational span() const { return width_ / (width_ + 2 * d_min_); }

  Real passing(const CurveSize &d) const override;
  Real between(const CurveSize &lower, const CurveSize &upper) const override;
  std::optional<Surd> exact_between(const Surd &lower, const Surd &upper) const override;
  Real diameter(const Rational &p) const override;

  /// The shape of the volume density h' in words: the table of the paper (section 2.1), which says them of
  /// grading curves.
  std::string shape() const;
  /// That of the grading curve h itself: where it is convex and where concave. h' changes its course once at
  /// most, at its extreme (a - 1) / (a + b - 2) where that is between 0 and 1.
  std::string course() const;

private:
  /// d_r.
  CurveSize reduced(const CurveSize &d) const;
  /// I_x(a, b) in the field of x, where it is known there.
  std::optional<Surd> exact_passing(const Surd &x) const;

  Rational a_, b_, d_min_, width_;
};

} // namespace mdm

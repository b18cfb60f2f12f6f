#pragma once
/// \file
/// Grading curves from which particles are generated.

#include "number/surd.hpp"

namespace mdm {

/// A size, and its exact form where it has one.
struct CurveSize {
  Real real;
  std::optional<Surd> exact;

  CurveSize(const Surd &s) : real(s.real()), exact(s) {}
  CurveSize(Real r) : real(std::move(r)) {
    if (real.fraction())
      exact = Surd(*real.fraction());
  }
};

/// The grading curve h on [d_min, d_max], 0 < d_min < d_max: the cumulative volume fraction, h(d_min) = 0 (or
/// more, for a stair) and h(d_max) = 1.
class ModelCurve {
public:
  virtual ~ModelCurve() = default;

  virtual Rational d_min() const = 0;
  virtual Rational d_max() const = 0;

  /// h(d).
  virtual Real passing(const CurveSize &d) const = 0;
  /// f_v = h(upper) - h(lower) (Eq. 6).
  virtual Real between(const CurveSize &lower, const CurveSize &upper) const {
    return passing(upper) - passing(lower);
  }
  /// f_v in the field of the bounds, where it is known there.
  virtual std::optional<Surd> exact_between(const Surd &lower, const Surd &upper) const = 0;
  /// h^-1(p): the least size with h(d) >= p, 0 < p <= 1.
  virtual Real diameter(const Rational &p) const = 0;
};

/// C_u = d_60 / d_10 (Eq. 18-19).
Real uniformity(const ModelCurve &curve);

/// C_c = d_30^2 / (d_60 d_10) (Eq. 18, 20).
Real curvature(const ModelCurve &curve);

} // namespace mdm

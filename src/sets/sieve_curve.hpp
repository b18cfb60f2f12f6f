#pragma once
/// \file
/// A measured grading curve as a model.

#include "sets/model_curve.hpp"
#include "soil/grading_curve.hpp"

namespace mdm {

/// The course of the curve between two sieves.
enum class Interpolation {
  log,    ///< linear in log size
  linear, ///< linear in size
  stair   ///< constant: the mass retained on a sieve lies at the next larger one
};

/// The gradation with the volumes m_j / c_j as masses and no factors. Whether c is a density or a shape
/// factor, a particle's share of them goes with x^D.
Gradation by_volume(const Gradation &g);

/// The curve through the points (x_i, P_i) of a gradation, sizes in mm.
class SieveCurve : public ModelCurve {
public:
  /// \throws InputError if the finest sieve is a pan at size 0
  SieveCurve(GradingCurve curve, Interpolation interpolation);

  const std::vector<Rational> &sieves() const { return curve_.sizes(); }
  Interpolation interpolation() const { return interpolation_; }
  Rational d_min() const override { return curve_.sizes().front(); }
  Rational d_max() const override { return curve_.sizes().back(); }
  Real passing(const CurveSize &d) const override;
  std::optional<Surd> exact_between(const Surd &lower, const Surd &upper) const override;
  Real diameter(const Rational &p) const override;

private:
  /// The i with x_i <= d < x_{i+1}, counted from 0; n - 1 from x_n on.
  std::size_t piece(const CurveSize &d) const;

  GradingCurve curve_;
  Interpolation interpolation_;
};

} // namespace mdm

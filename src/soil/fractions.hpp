#pragma once
/// \file
/// Gravel, sand, fines: the shares of the size bands of the classification systems.

#include "soil/grading_curve.hpp"

namespace mdm {

/// A size band and the share of the mass in it, above < x <= up_to.
struct Fraction {
  std::string_view name;         ///< for example `coarse sand`
  bool main = true;              ///< false for a part of the main band after which it stands
  Rational above;                ///< mm
  std::optional<Rational> up_to; ///< mm; nothing: no end
  Available<Real> share;         ///< 0 to 1; linear in log size at bounds that are no sieve
};

/// The share of the mass above < x <= up_to (mm; nothing: no end).
Available<Real> share_between(const GradingCurve &curve, const Rational &above,
                              const std::optional<Rational> &up_to);

/// Boulders, cobbles, gravel, sand, fines of ASTM D2487 (300, 75, 4.75, 0.075 mm), with the parts of gravel
/// and sand (19, 2, 0.425 mm).
std::vector<Fraction> uscs_fractions(const GradingCurve &curve);

/// The fractions of ISO 14688-1, from large boulders (630 mm) to clay (0.002 mm), with their parts.
std::vector<Fraction> iso_14688_fractions(const GradingCurve &curve);

/// Gravel, sand and mud of Wentworth (1922), bounds at whole phi, with their parts.
std::vector<Fraction> wentworth_fractions(const GradingCurve &curve);

/// The bounds of the fractions at which the curve is interpolated, in mm, descending.
std::vector<Rational> interpolated_bounds(const GradingCurve &curve, const std::vector<Fraction> &fractions);

} // namespace mdm

#pragma once
/// \file
/// The fineness modulus of an aggregate.

#include "soil/grading_curve.hpp"

#include <mdm/soil/fineness_modulus.hpp>

#include <vector>

namespace mdm {

/// The sieves over which the standard adds what is retained, in mm, descending.
/// ASTM C125: 150, 75, 37.5, 19, 9.5, 4.75, 2.36, 1.18, 0.6, 0.3, 0.15. EN 12620: 4, 2, 1, 0.5, 0.25, 0.125.
const std::vector<Rational> &fineness_sieves(FinenessModulus modulus);

/// The modulus of a curve. Between the sieves of the curve those of the standard are interpolated, linear in
/// log size; not available where one is below the finest.
Available<Real> fineness_modulus(const GradingCurve &curve, FinenessModulus modulus);

} // namespace mdm

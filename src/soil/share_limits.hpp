#pragma once
/// \file
/// Shares of the mass beside the limits of names.

#include "soil/grading_curve.hpp"

#include <vector>

namespace mdm {

/// a >= factor b. \throws NotAvailable where no precision tells
bool is_at_least(const Real &a, const Rational &factor, const Real &b);

/// The shares of the mass that pass these sizes in mm. \throws NotAvailable where the curve does not tell
std::vector<Real> shares_passing(const GradingCurve &curve, const std::vector<Rational> &sizes);

} // namespace mdm

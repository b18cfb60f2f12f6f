#pragma once
/// \file
/// All that is told of a soil from its gradation.

#include "soil/fractions.hpp"
#include "soil/indices.hpp"
#include "soil/uscs.hpp"

namespace mdm {

/// The assumptions of describe() beside the curve.
struct DescribeOptions {
  std::optional<AtterbergLimits> limits; ///< of the fines; without them low-plasticity silt (ML)
  bool extrapolate = false;              ///< continue the curve into a pan at size 0
};

/// Index numbers, fractions and groups of a gradation, sizes in mm.
struct SoilDescription {
  std::string id;
  GradingCurve curve;
  Available<PowerProduct> d10, d30, d50, d60;
  Available<PowerProduct> c_u, c_c;
  Available<Real> i_gs, i_c;
  Rational phi_1;
  PowerProduct zeta_1;
  PowerProduct d_max; ///< the upper sieve of the coarsest class with mass
  Fines fines;
  Available<UscsGroup> group;
  std::vector<Fraction> uscs, iso_14688;
  std::vector<std::string> notes; ///< the reader's, what was assumed, and why something is not available

  /// True if a limit of precision was reached before all was decided.
  bool limited() const { return !group && group.why().limited; }
};

/// What was assumed of D10 to D60 and of the group, or why they are not available: of the notes those that
/// are about these.
std::vector<std::string> assumptions(const SoilDescription &d, const DescribeOptions &options);

/// \throws InputError as classify_fines
SoilDescription describe(const Gradation &g, const DescribeOptions &options);

} // namespace mdm

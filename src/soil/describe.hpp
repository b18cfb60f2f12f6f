#pragma once
/// \file
/// All that is told of a soil from its gradation.

#include "soil/aashto.hpp"
#include "soil/fractions.hpp"
#include "soil/indices.hpp"
#include "soil/iso_14688.hpp"
#include "soil/mean_sizes.hpp"

namespace mdm {

/// The assumptions of describe() beside the curve.
struct DescribeOptions {
  std::optional<AtterbergLimits> limits; ///< of the fines; without them low-plasticity silt (ML)
  bool extrapolate = false;              ///< continue the curve into a pan at size 0
  std::vector<Rational> percents;        ///< p of more diameters D_p, above 0 and at most 100
  std::optional<Rational> void_ratio;    ///< e > 0, for the conductivity of Kozeny and Carman
};

/// D_p, the size that p percent of the mass pass, in mm.
struct DiameterAt {
  Rational percent;
  Available<PowerProduct> size;
};

/// Index numbers, fractions and groups of a gradation, sizes in mm.
struct SoilDescription {
  std::string id;
  GradingCurve curve;
  Available<PowerProduct> d10, d30, d50, d60;
  std::vector<DiameterAt> diameters; ///< those asked for, ascending, but for the four above
  Available<PowerProduct> c_u, c_c;
  Available<Real> span;                                  ///< (D90 - D10) / D50
  Available<RealRange> surface_mean, volume_mean;        ///< D[3,2] and D[4,3]
  Available<Real> fineness_modulus, en_fineness_modulus; ///< of ASTM C125 and of EN 12620
  Available<PowerProduct> hazen;                         ///< m/s
  std::optional<Available<RealRange>> kozeny_carman;     ///< m/s; nothing without a void ratio
  Available<Real> i_gs, i_c;
  Rational phi_1;
  PowerProduct zeta_1;
  PowerProduct d_max; ///< the upper sieve of the coarsest class with mass
  Fines fines;
  Available<UscsGroup> group;
  Available<AashtoGroup> aashto;
  Available<Iso14688Name> iso_name;
  std::vector<Fraction> uscs, iso_14688;
  std::vector<std::string> notes; ///< the reader's, what was assumed, and why something is not available

  /// True if a limit of precision was reached before all was decided.
  bool limited() const {
    return (!group && group.why().limited) || (!aashto && aashto.why().limited) ||
           (!iso_name && iso_name.why().limited);
  }
};

/// What was assumed of D10 to D60 and of the group, or why they are not available: of the notes those that
/// are about these.
std::vector<std::string> assumptions(const SoilDescription &d, const DescribeOptions &options);

/// \throws InputError as classify_fines
SoilDescription describe(const Gradation &g, const DescribeOptions &options);

} // namespace mdm

#include "soil/permeability.hpp"

#include "soil/indices.hpp"

namespace mdm {

Available<PowerProduct> hazen_conductivity(const GradingCurve &curve, bool extrapolate) {
  const Available<PowerProduct> d10 = curve.diameter(ratio(1, 10), extrapolate);
  if (!d10)
    return NotAvailable{"D10 is " + d10.why().reason};
  return pow(*d10, 2) * PowerProduct(ratio(1, 100));
}

bool is_hazen_soil(const GradingCurve &curve, bool extrapolate) {
  const Real d10 = curve.diameter(ratio(1, 10), extrapolate)->real();
  return compare(d10, Real(ratio(1, 10))) != Order::less && compare(d10, Real(3)) != Order::greater &&
         compare(uniformity(curve, extrapolate)->real(), Real(5)) == Order::less;
}

Available<RealRange> kozeny_carman_conductivity(const GradingCurve &curve, const Rational &void_ratio) {
  const Available<RealRange> mean = surface_mean(curve);
  if (!mean)
    return mean.why();
  // D in mm is D / 10 in cm, and k in cm/s is k / 100 in m/s.
  const Rational factor = Rational(99300) / (5 * 36) / 100 / 100 * power(void_ratio, 3) / (1 + void_ratio);
  const auto conductivity = [&factor](const Real &d) { return Real(factor) * d * d; };
  return RealRange{conductivity(mean->lo), conductivity(mean->hi)};
}

} // namespace mdm

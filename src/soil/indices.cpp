#include "soil/indices.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// One stretch of the curve: from (a, at_a) to (b, at_b), a > 0, linear in log size.
struct Stretch {
  PowerProduct a, b;
  Rational at_a, at_b;

  /// Its integral over log size from c to d, a <= c < d <= b: log(d/c) times the mean of the shares at c and
  /// d.
  Ball area(const PowerProduct &c, const PowerProduct &d, unsigned bits) const {
    const Ball middle =
        (log(c / a, bits) + log(d / a, bits)) / (Ball(2, bits) * log(b / a, bits)); // 0 at a, 1 at b
    return log(d / c, bits) * (Ball(at_a, bits) + Ball(at_b - at_a, bits) * middle);
  }
};

} // namespace

Available<PowerProduct> uniformity(const GradingCurve &curve, bool extrapolate) {
  const Available<PowerProduct> fine = curve.diameter(ratio(1, 10), extrapolate);
  const Available<PowerProduct> coarse = curve.diameter(ratio(6, 10), extrapolate);
  if (!fine)
    return NotAvailable{"D10 is " + fine.why().reason};
  if (!coarse)
    return NotAvailable{"D60 is " + coarse.why().reason};
  return *coarse / *fine;
}

Available<PowerProduct> curvature(const GradingCurve &curve, bool extrapolate) {
  const Available<PowerProduct> u = uniformity(curve, extrapolate);
  if (!u)
    return u.why();
  // D30 and D60 are available wherever D10 is: they are coarser.
  const PowerProduct d60 = *curve.diameter(ratio(6, 10), extrapolate);
  const PowerProduct d30 = *curve.diameter(ratio(3, 10), extrapolate);
  return pow(d30, 2) * *u / pow(d60, 2);
}

Available<Real> span(const GradingCurve &curve, bool extrapolate) {
  const Available<PowerProduct> d10 = curve.diameter(ratio(1, 10), extrapolate);
  if (!d10)
    return NotAvailable{"D10 is " + d10.why().reason};
  const PowerProduct d50 = *curve.diameter(ratio(5, 10), extrapolate);
  const PowerProduct d90 = *curve.diameter(ratio(9, 10), extrapolate);
  return (d90 / d50).real() - (*d10 / d50).real();
}

Available<Real> grain_size_index(const GradingCurve &curve) {
  const Rational least = ratio(1, 1000), most = 75;
  const PowerProduct span(Rational(most / least));
  const std::vector<Rational> &p = curve.shares();
  if (curve.finest() == 0 && curve.has_pan())
    return NotAvailable{"the sizes in the pan are not known"};
  const auto order = [&curve](std::size_t i, const Rational &limit) {
    return compare(curve.opening(i), RootSize{limit});
  };
  PowerProduct whole; // its logarithm: the integral over the stretches that lie inside the limits
  Real clipped(0);
  const std::size_t last = p.size() - 1;
  for (std::size_t j = curve.finest(); j < last; ++j) {
    const bool from_sieve = order(j, least) >= 0, to_sieve = order(j + 1, most) <= 0;
    if (order(j, most) >= 0 || order(j + 1, least) <= 0)
      continue;
    const PowerProduct c = from_sieve ? curve.power_of(j) : PowerProduct(least);
    const PowerProduct d = to_sieve ? curve.power_of(j + 1) : PowerProduct(most);
    if ((from_sieve && to_sieve) || p[j] == p[j + 1])
      whole *= pow(d / c, (p[j] + p[j + 1]) / 2);
    else
      clipped = clipped + Real([s = Stretch{curve.power_of(j), curve.power_of(j + 1), p[j], p[j + 1]}, c, d,
                                span](unsigned bits) { return s.area(c, d, bits) / log(span, bits); });
  }
  if (order(last, most) < 0)
    whole *= PowerProduct(most) / (order(last, least) > 0 ? curve.power_of(last) : PowerProduct(least));
  return log_ratio(whole, span) + clipped;
}

Available<Real> curvature_index(const GradingCurve &curve) {
  const std::vector<Rational> &p = curve.shares();
  const Rational above = 1 - p[1];
  if (above == 0)
    return NotAvailable{"everything passes the finest sieve above the pan"};
  const std::size_t last = p.size() - 1;
  PowerProduct area;
  for (std::size_t j = 1; j < last; ++j)
    area *= pow(curve.power_of(j + 1) / curve.power_of(j), (p[j] + p[j + 1] - 2 * p[1]) / above);
  return log_ratio(area, curve.power_of(last) / curve.power_of(1));
}

Rational finest_mass_ratio(const GradingCurve &curve) {
  return curve.mass(curve.finest()) / curve.mass(curve.coarsest());
}

PowerProduct coarsest_volume_ratio(const GradingCurve &curve) {
  return curve.power_of(curve.coarsest() + 1, 3) / curve.power_of(curve.finest() + 1, 3);
}

} // namespace mdm

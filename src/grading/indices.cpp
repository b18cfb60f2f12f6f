#include <mdm/grading/indices.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// One stretch of the curve: from (a, at_a) to (b, at_b), a > 0, linear in log size.
struct Stretch {
  Rational a, b, at_a, at_b;

  /// Its integral over log size from c to d, a <= c < d <= b: log(d/c) times the mean of the shares at c and
  /// d.
  Ball area(const Rational &c, const Rational &d, unsigned bits) const {
    const auto log_of = [bits](const Rational &r) { return log(Ball(r, bits)); };
    const Ball middle = (log_of(c / a) + log_of(d / a)) / (Ball(2, bits) * log_of(b / a)); // 0 at a, 1 at b
    return log_of(d / c) * (Ball(at_a, bits) + Ball(at_b - at_a, bits) * middle);
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

Available<Real> grain_size_index(const GradingCurve &curve) {
  const Rational least = ratio(1, 1000), most = 75;
  const PowerProduct span(Rational(most / least));
  const std::vector<Rational> &x = curve.sizes(), &p = curve.shares();
  if (x[curve.finest()] == 0)
    return NotAvailable{"the sizes in the pan are not known"};
  PowerProduct whole; // its logarithm: the integral over the stretches that lie inside the limits
  Real clipped(0);
  for (std::size_t j = curve.finest(); j < x.size() - 1; ++j) {
    const Rational c = std::max(x[j], least), d = std::min(x[j + 1], most);
    if (c >= d)
      continue;
    if ((c == x[j] && d == x[j + 1]) || p[j] == p[j + 1])
      whole *= PowerProduct(Rational(d / c), (p[j] + p[j + 1]) / 2);
    else
      clipped = clipped + Real([s = Stretch{x[j], x[j + 1], p[j], p[j + 1]}, c, d, span](unsigned bits) {
                  return s.area(c, d, bits) / log(span, bits);
                });
  }
  const Rational top = std::max(x.back(), least);
  if (top < most)
    whole *= PowerProduct(Rational(most / top));
  return log_ratio(whole, span) + clipped;
}

Available<Real> curvature_index(const GradingCurve &curve) {
  const std::vector<Rational> &x = curve.sizes(), &p = curve.shares();
  const Rational above = 1 - p[1];
  if (above == 0)
    return NotAvailable{"everything passes the finest sieve above the pan"};
  PowerProduct area;
  for (std::size_t j = 1; j < x.size() - 1; ++j)
    area *= PowerProduct(Rational(x[j + 1] / x[j]), (p[j] + p[j + 1] - 2 * p[1]) / above);
  return log_ratio(area, PowerProduct(Rational(x.back() / x[1])));
}

Rational finest_mass_ratio(const GradingCurve &curve) {
  return curve.mass(curve.finest()) / curve.mass(curve.coarsest());
}

Rational coarsest_volume_ratio(const GradingCurve &curve) {
  return power(Rational(curve.sizes()[curve.coarsest() + 1] / curve.sizes()[curve.finest() + 1]), 3);
}

} // namespace mdm

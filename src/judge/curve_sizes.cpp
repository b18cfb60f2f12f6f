// Sizes between the sieves of a box. A curve is linear in log size between sieves, so that the size which p
// percent pass is x_i^(1-t) x_{i+1}^t with t = (p - P_i)/(P_{i+1} - P_i): a power product, about which
// everything can be decided. What passes more is finer: of all curves of a box the finest has the least
// diameters, the coarsest the greatest.

#include "judge/curve_sizes.hpp"

#include "judge/decided.hpp"

#include <algorithm>

namespace mdm {
namespace {

PowerProduct sieve(const CurveBox &box, std::size_t i) {
  const RootSize &x = box.openings[i];
  return PowerProduct(x.power, ratio(1, x.degree));
}

std::optional<PowerProduct> interpolated(const CurveBox &box, const CurvePercents &percents, std::size_t i,
                                         const Rational &percent) {
  if (i < 1)
    return std::nullopt;
  const Rational t = (percent - percents[i]) / (percents[i + 1] - percents[i]);
  return pow(sieve(box, i), 1 - t) * pow(sieve(box, i + 1), t);
}

std::size_t index_of(const CurvePercents &percents, CurvePercents::const_iterator at) {
  return static_cast<std::size_t>(at - percents.begin());
}

} // namespace

OuterCurves::OuterCurves(CurveBox curves)
    : box(std::move(curves)), coarse(box.least_curve()), fine(box.greatest_curve()) {}

PowerProduct OuterCurves::finest() const {
  return sieve(box, 1);
}

std::optional<PowerProduct> diameter(const CurveBox &box, const CurvePercents &percents,
                                     const Rational &percent) {
  const std::size_t i = index_of(percents, std::lower_bound(percents.begin(), percents.end(), percent));
  if (i > 0 && percents[i] == percent)
    return sieve(box, i);
  return i > 0 ? interpolated(box, percents, i - 1, percent) : std::nullopt;
}

std::optional<PowerProduct> upper_diameter(const CurveBox &box, const CurvePercents &percents,
                                           const Rational &percent) {
  const std::size_t i = index_of(percents, std::upper_bound(percents.begin(), percents.end(), percent)) - 1;
  if (i > 0 && percents[i] == percent)
    return sieve(box, i);
  return interpolated(box, percents, i, percent);
}

DiameterRange diameters(const OuterCurves &curves, const Interval &percent) {
  const std::optional<PowerProduct> hi = diameter(curves.box, curves.coarse, percent.hi);
  return {diameter(curves.box, curves.fine, percent.lo), hi ? *hi : curves.finest()};
}

std::optional<Real> reported_diameter(const OuterCurves &curves, const Interval &percent) {
  const std::optional<PowerProduct> lo = diameter(curves.box, curves.box.reported, percent.lo);
  if (!lo || percent.is_point())
    return lo ? std::optional(lo->real()) : std::nullopt;
  const std::optional<PowerProduct> hi = diameter(curves.box, curves.box.reported, percent.hi);
  return real_between(lo->real(), hi->real());
}

Real real_between(const Real &lo, const Real &hi) {
  return Real([lo, hi](unsigned bits) { return hull(lo.ball(bits), hi.ball(bits)); });
}

Interval fractions_around(const Real &y) {
  if (const std::optional<Rational> exact = y.exact())
    return *exact;
  constexpr unsigned beyond_print = 1100; // at most 1,000 digits are printed
  const Enclosure digits = enclose(y, beyond_print);
  return {digits.lower(), digits.upper()};
}

bool not_above(const PowerProduct &a, const PowerProduct &b) {
  return !certainly_less(Real(1), (a / b).real());
}

Real passing(const CurveBox &box, const CurvePercents &percents, const PowerProduct &size) {
  std::size_t i = box.openings.size() - 1;
  while (i > 1 && !not_above(sieve(box, i), size))
    --i;
  if (i + 1 == box.openings.size() || percents[i] == percents[i + 1] || not_above(size, sieve(box, i)))
    return Real(percents[i]);
  const PowerProduct lower = sieve(box, i);
  return Real(percents[i]) +
         log_ratio(size / lower, sieve(box, i + 1) / lower) * Real(percents[i + 1] - percents[i]);
}

Interval passing_range(const OuterCurves &curves, const Rational &size) {
  const PowerProduct at(size);
  const bool known = not_above(curves.finest(), at);
  const PowerProduct &from = known ? at : curves.finest();
  const Interval most = fractions_around(passing(curves.box, curves.fine, from));
  return {known ? fractions_around(passing(curves.box, curves.coarse, from)).lo : Rational(0), most.hi};
}

} // namespace mdm

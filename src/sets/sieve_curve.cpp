#include "sets/sieve_curve.hpp"

#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

Real log(const Real &y) {
  return Real([y](unsigned bits) { return log(y.ball(bits)); });
}

} // namespace

Gradation by_volume(const Gradation &g) {
  Gradation::Data data;
  data.id = g.id();
  data.unit = g.unit();
  data.sizes = g.sizes();
  data.notes = g.notes();
  for (std::size_t j = 0; j < g.classes(); ++j)
    data.masses.push_back(g.mass(j) / g.factor(j));
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

SieveCurve::SieveCurve(GradingCurve curve, Interpolation interpolation)
    : curve_(std::move(curve)), interpolation_(interpolation) {
  if (curve_.sizes().front() == 0)
    throw InputError("the finest sieve is a pan at size 0: particles have a size; give the pan one with " +
                     option("pan-size"));
}

std::size_t SieveCurve::piece(const CurveSize &d) const {
  const std::vector<Rational> &x = curve_.sizes();
  const auto after =
      std::upper_bound(x.begin(), x.end(), d, [](const CurveSize &size, const Rational &sieve) {
        // A size without an exact form never is a sieve: it is irrational.
        return compare(size.real, Real(sieve)) == Order::less;
      });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - x.begin() - 1, 0));
}

Real SieveCurve::passing(const CurveSize &d) const {
  const std::vector<Rational> &x = curve_.sizes();
  const std::vector<Rational> &p = curve_.shares();
  const std::size_t i = piece(d);
  if (i + 1 == x.size() || interpolation_ == Interpolation::stair || p[i] == p[i + 1])
    return Real(p[i]);
  if (interpolation_ == Interpolation::linear)
    return Real(p[i]) + (d.real - Real(x[i])) * Real(Rational(curve_.mass(i) / (x[i + 1] - x[i])));
  if (d.real.fraction())
    return *curve_.passing(*d.real.fraction());
  if (const std::optional<PowerProduct> product = d.exact ? d.exact->product() : std::nullopt)
    return Real(p[i]) + log_ratio(*product / PowerProduct(x[i]), PowerProduct(Rational(x[i + 1] / x[i]))) *
                            Real(curve_.mass(i));
  return Real(p[i]) + log(d.real / Real(x[i])) / log(Real(Rational(x[i + 1] / x[i]))) * Real(curve_.mass(i));
}

std::optional<Surd> SieveCurve::exact_between(const Surd &lower, const Surd &upper) const {
  const auto h = [this](const Surd &d) -> std::optional<Surd> {
    const std::vector<Rational> &x = curve_.sizes();
    const std::size_t i = piece(d);
    if (i + 1 < x.size() && interpolation_ == Interpolation::linear)
      return Surd(curve_.shares()[i]) + (d - Surd(x[i])) * Surd(Rational(curve_.mass(i) / (x[i + 1] - x[i])));
    const std::optional<Rational> value = passing(d).exact();
    return value ? std::optional(Surd(*value)) : std::nullopt;
  };
  const std::optional<Surd> l = h(lower);
  const std::optional<Surd> u = l ? h(upper) : std::nullopt;
  return u ? std::optional(*u - *l) : std::nullopt;
}

Real SieveCurve::diameter(const Rational &share) const {
  const std::vector<Rational> &x = curve_.sizes();
  const std::vector<Rational> &p = curve_.shares();
  if (interpolation_ == Interpolation::log) {
    const PowerProduct size = *curve_.diameter(share);
    const std::optional<Rational> value = size.exact();
    return value ? Real(*value) : size.real();
  }
  const auto i = static_cast<std::size_t>(std::lower_bound(p.begin(), p.end(), share) - p.begin());
  if (interpolation_ == Interpolation::stair || p[i] == share)
    return Real(x[i]);
  return Real(Rational(x[i - 1] + (share - p[i - 1]) / curve_.mass(i - 1) * (x[i] - x[i - 1])));
}

} // namespace mdm

#include <mdm/grading/grading_curve.hpp>
#include <mdm/number/common_denominator.hpp>
#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace mdm {
namespace {

std::string below(const Rational &size) {
  return "below " + rounded(Real(size), 6) + " mm, the finest sieve";
}

std::ptrdiff_t distance_to(const std::vector<Rational> &ascending, const Rational &value) {
  return std::lower_bound(ascending.begin(), ascending.end(), value) - ascending.begin();
}

} // namespace

GradingCurve::GradingCurve(const Gradation &g) : sizes_(g.sizes()) {
  const Rational unit = in_mm(g.unit());
  if (unit != 1)
    for (Rational &size : sizes_)
      size *= unit;
  const CommonDenominator masses(g.masses());
  Integer total = 0;
  for (const Integer &m : masses.numerators)
    total += m;
  Integer passed = 0;
  shares_.reserve(sizes_.size());
  for (const Integer &m : masses.numerators) {
    shares_.push_back(ratio(passed, total));
    passed += m;
  }
}

std::size_t GradingCurve::finest() const {
  return static_cast<std::size_t>(std::upper_bound(shares_.begin(), shares_.end(), Rational(0)) -
                                  shares_.begin() - 1);
}

std::size_t GradingCurve::coarsest() const {
  return static_cast<std::size_t>(distance_to(shares_, 1) - 1);
}

Available<Real> GradingCurve::passing(const Rational &size) const {
  const auto i = static_cast<std::size_t>(distance_to(sizes_, size));
  if (i == sizes_.size())
    return Real(1);
  if (sizes_[i] == size)
    return Real(shares_[i]);
  if (i == 0)
    return Real(0);
  if (shares_[i - 1] == shares_[i])
    return Real(shares_[i]);
  if (sizes_[i - 1] == 0)
    return NotAvailable{below(sizes_[i])};
  const Real position = log_ratio(PowerProduct(Rational(size / sizes_[i - 1])),
                                  PowerProduct(Rational(sizes_[i] / sizes_[i - 1])));
  return Real(shares_[i - 1]) + position * mass(i - 1);
}

bool GradingCurve::interpolates(const Rational &size) const {
  const auto i = static_cast<std::size_t>(distance_to(sizes_, size));
  return i > 0 && i < sizes_.size() && sizes_[i] != size && shares_[i - 1] != shares_[i];
}

bool GradingCurve::in_pan(const Rational &p) const {
  return sizes_[0] == 0 && p < shares_[1];
}

Available<PowerProduct> GradingCurve::diameter(const Rational &p, bool extrapolate) const {
  if (in_pan(p))
    return extrapolate ? extrapolated(p) : NotAvailable{below(sizes_[1])};
  const auto i = static_cast<std::size_t>(distance_to(shares_, p));
  if (shares_[i] == p)
    return PowerProduct(sizes_[i]);
  const Rational t = (p - shares_[i - 1]) / mass(i - 1);
  return PowerProduct(sizes_[i - 1], 1 - t) * PowerProduct(sizes_[i], t);
}

Available<PowerProduct> GradingCurve::extrapolated(const Rational &p) const {
  const std::string reason = below(sizes_[1]) + ", and the curve cannot be extrapolated: ";
  if (sizes_.size() < 3)
    return NotAvailable{reason + "there is one class only"};
  if (mass(1) == 0)
    return NotAvailable{reason + "its finest class above the pan is empty"};
  const Rational t = (p - shares_[1]) / mass(1);
  if (t < -100)
    return NotAvailable{reason + "it would go beyond 100 times the width of its finest class"};
  return PowerProduct(sizes_[1], 1 - t) * PowerProduct(sizes_[2], t);
}

Available<GradingCurve> GradingCurve::part_passing(const Rational &size) const {
  if (interpolates(size))
    return NotAvailable{"there is no sieve of " + to_string(size) + " mm"};
  const Available<Real> passed = passing(size);
  const Rational part = passed->exact().value();
  if (part == 0)
    return NotAvailable{"nothing passes " + to_string(size) + " mm"};
  GradingCurve result;
  for (std::size_t i = 0; i < sizes_.size() && shares_[i] <= part; ++i) {
    result.sizes_.push_back(sizes_[i]);
    result.shares_.push_back(shares_[i] / part);
    if (shares_[i] == part)
      break;
  }
  return result;
}

} // namespace mdm

#include "soil/grading_curve.hpp"

#include "number/common_denominator.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

std::string below(const PowerProduct &size) {
  return "below " + rounded(size.real(), 6) + " mm, the finest sieve";
}

std::ptrdiff_t distance_to(const std::vector<Rational> &ascending, const Rational &value) {
  return std::lower_bound(ascending.begin(), ascending.end(), value) - ascending.begin();
}

} // namespace

GradingCurve::GradingCurve(const Gradation &g) : powers_(g.powers()), root_(g.root()) {
  const Rational unit = power(in_mm(g.unit()), root_);
  if (unit != 1)
    for (Rational &size : powers_)
      size *= unit;
  const CommonDenominator masses(g.masses());
  Integer total = 0;
  for (const Integer &m : masses.numerators)
    total += m;
  Integer passed = 0;
  shares_.reserve(powers_.size());
  for (const Integer &m : masses.numerators) {
    shares_.push_back(ratio(passed, total));
    passed += m;
  }
}

const std::vector<Rational> &GradingCurve::sizes() const {
  if (root_ != 1)
    throw InputError(
        "openings of phi that is no whole number are irrational, and here only fractions will do: " +
        std::string(convert_remedy));
  return powers_;
}

std::size_t GradingCurve::first_not_below(const Rational &size) const {
  return static_cast<std::size_t>(distance_to(powers_, power(size, root_)));
}

std::size_t GradingCurve::finest() const {
  return static_cast<std::size_t>(std::upper_bound(shares_.begin(), shares_.end(), Rational(0)) -
                                  shares_.begin() - 1);
}

std::size_t GradingCurve::coarsest() const {
  return static_cast<std::size_t>(distance_to(shares_, 1) - 1);
}

Available<Real> GradingCurve::passing(const Rational &size) const {
  const std::size_t i = first_not_below(size);
  if (i == powers_.size())
    return Real(1);
  if (is_opening(i, size))
    return Real(shares_[i]);
  if (i == 0)
    return Real(0);
  if (shares_[i - 1] == shares_[i])
    return Real(shares_[i]);
  if (powers_[i - 1] == 0)
    return NotAvailable{below(power_of(i))};
  const PowerProduct lower = power_of(i - 1);
  const Real position = log_ratio(PowerProduct(size) / lower, power_of(i) / lower);
  return Real(shares_[i - 1]) + position * mass(i - 1);
}

bool GradingCurve::interpolates(const Rational &size) const {
  const std::size_t i = first_not_below(size);
  return i > 0 && i < powers_.size() && !is_opening(i, size) && shares_[i - 1] != shares_[i];
}

bool GradingCurve::in_pan(const Rational &p) const {
  return has_pan() && p < shares_[1];
}

Available<PowerProduct> GradingCurve::diameter(const Rational &p, bool extrapolate) const {
  if (in_pan(p))
    return extrapolate ? extrapolated(p) : NotAvailable{below(power_of(1))};
  const auto i = static_cast<std::size_t>(distance_to(shares_, p));
  if (shares_[i] == p)
    return power_of(i);
  const Rational t = (p - shares_[i - 1]) / mass(i - 1);
  return power_of(i - 1, 1 - t) * power_of(i, t);
}

Available<PowerProduct> GradingCurve::extrapolated(const Rational &p) const {
  const std::string reason = below(power_of(1)) + ", and the curve cannot be extrapolated: ";
  if (powers_.size() < 3)
    return NotAvailable{reason + "there is one class only"};
  if (mass(1) == 0)
    return NotAvailable{reason + "its finest class above the pan is empty"};
  const Rational t = (p - shares_[1]) / mass(1);
  if (t < -100)
    return NotAvailable{reason + "it would go beyond 100 times the width of its finest class"};
  return power_of(1, 1 - t) * power_of(2, t);
}

Available<GradingCurve> GradingCurve::part_passing(const Rational &size) const {
  if (interpolates(size))
    return NotAvailable{"there is no sieve of " + to_string(size) + " mm"};
  const Available<Real> passed = passing(size);
  const Rational part = passed->exact().value();
  if (part == 0)
    return NotAvailable{"nothing passes " + to_string(size) + " mm"};
  GradingCurve result;
  result.root_ = root_;
  for (std::size_t i = 0; i < powers_.size() && shares_[i] <= part; ++i) {
    result.powers_.push_back(powers_[i]);
    result.shares_.push_back(shares_[i] / part);
    if (shares_[i] == part)
      break;
  }
  return result;
}

} // namespace mdm

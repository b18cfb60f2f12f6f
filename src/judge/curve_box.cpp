// All grading curves that round to one report. What comes in are printed percents with a unit of the last
// digit; what goes out is a box: an interval for what passes each sieve, and one for what each class
// retains.
//
// narrow() makes the intervals as tight as the curves are: upwards, what passes a sieve is at least what
// passes the one below plus the least retained, and so on in both directions. One pass up and one down are
// enough, since the conditions tie neighbours alone; then the lower ends are a curve of the box, and so are
// the upper ends. An interval that is empty shows that no curve rounds to the report.

#include "judge/curve_box.hpp"

#include "soil/grading_curve.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

const Interval any_percent(0, 100);

[[noreturn]] void refuse_sum() {
  throw InputError(
      "the percents retained do not add up to 100, and their rounding does not explain it: correct "
      "them, or take them as they are with " +
      option("rounding") + " none");
}

/// What rounds to `percent`, which is from 0 to 100 or rounds to such a number.
Interval around(const Rational &percent, const Rational &half) {
  return {std::clamp<Rational>(percent - half, 0, 100), std::clamp<Rational>(percent + half, 0, 100)};
}

/// Half a unit of the last digit of each number of the report: of a file, or as the user says.
std::vector<Rational> halves(const std::vector<Rational> &printed, std::size_t n,
                             const std::optional<Rational> &unit) {
  if (unit)
    return std::vector<Rational>(n, *unit / 2);
  return printed.empty() ? std::vector<Rational>(n, 0) : printed;
}

std::vector<Rational> ends_of(const std::vector<Interval> &intervals, Rational Interval::*end) {
  std::vector<Rational> ends;
  for (const Interval &i : intervals)
    ends.push_back(i.*end);
  return ends;
}

/// The box without any roundings.
CurveBox reported_curve(const Gradation &g) {
  const GradingCurve curve(g);
  CurveBox box;
  if (!curve.has_pan()) {
    box.openings.push_back(RootSize{0});
    box.reported.emplace_back(0);
  }
  for (std::size_t i = 0; i < curve.shares().size(); ++i) {
    box.openings.push_back(curve.opening(i));
    box.reported.push_back(curve.shares()[i] * 100);
  }
  box.passing.assign(box.openings.size(), any_percent);
  box.passing.front() = Interval(0);
  box.passing.back() = Interval(100);
  box.retained.assign(box.openings.size() - 1, any_percent);
  return box;
}

/// \param skipped  sieves of the box that the report does not have: the size 0, or none
void take_passing(CurveBox &box, const std::vector<Rational> &half, std::size_t skipped) {
  for (std::size_t i = 1; i + 1 < box.openings.size(); ++i)
    box.passing[i] = around(box.reported[i], half[i - skipped]);
}

/// \param percent  what a unit of mass is in percent
void take_retained(CurveBox &box, const Gradation &g, const std::vector<Rational> &half,
                   const Rational &percent, std::size_t skipped) {
  for (std::size_t i = 0; i < skipped; ++i)
    box.retained[i] = Interval(0); // the report has no pan
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const Rational retained = g.mass(j) * percent, rounding = half[j] * percent;
    if (retained - rounding > 100)
      refuse_sum();
    box.retained[j + skipped] = around(retained, rounding);
  }
}

} // namespace

bool CurveBox::narrow() {
  const std::size_t n = openings.size() - 1;
  std::vector<Rational> lo, hi;
  for (const Interval &p : passing) {
    lo.push_back(p.lo);
    hi.push_back(p.hi);
  }
  for (std::size_t i = 0; i < n; ++i) {
    lo[i + 1] = std::max<Rational>(lo[i + 1], lo[i] + retained[i].lo);
    hi[i + 1] = std::min<Rational>(hi[i + 1], hi[i] + retained[i].hi);
  }
  for (std::size_t i = n; i-- > 0;) {
    lo[i] = std::max<Rational>(lo[i], lo[i + 1] - retained[i].hi);
    hi[i] = std::min<Rational>(hi[i], hi[i + 1] - retained[i].lo);
  }
  for (std::size_t i = 0; i <= n; ++i)
    if (lo[i] > hi[i])
      return false;
  for (std::size_t i = 0; i <= n; ++i)
    passing[i] = {lo[i], hi[i]};
  return true;
}

std::vector<Rational> CurveBox::least_curve() const {
  return ends_of(passing, &Interval::lo);
}

std::vector<Rational> CurveBox::greatest_curve() const {
  return ends_of(passing, &Interval::hi);
}

void CurveBox::add_unmeasured(const Rational &size) {
  // With P_0 = 0, what the first class retains is what passes its upper sieve.
  Interval &first = passing[1];
  first = {std::max(first.lo, retained[0].lo), std::min(first.hi, retained[0].hi)};
  openings.insert(openings.begin() + 1, RootSize{size});
  reported.insert(reported.begin() + 1, Rational(0));
  passing.insert(passing.begin() + 1, any_percent);
  retained.insert(retained.begin(), any_percent);
  retained[1] = any_percent;
}

CurveBox curves_of(const UnderstoodGradation &report, const std::optional<Rational> &unit) {
  const Gradation &g = report.gradation;
  CurveBox box = reported_curve(g);
  const std::size_t n = g.powers().size(), skipped = box.openings.size() - n;
  const bool by_retained = !report.mass_roundings.empty();
  const Rational percent = report.kind == "retained_fraction" ? 100 : 1;
  const std::vector<Rational> half =
      by_retained ? halves(report.mass_roundings, n, unit ? std::optional<Rational>(*unit / percent) : unit)
                  : halves(g.roundings(), n, unit);
  const auto is_zero = [](const Rational &r) { return r == 0; };
  box.is_exact = std::all_of(half.begin(), half.end(), is_zero);
  if (by_retained && !box.is_exact)
    take_retained(box, g, half, percent, skipped);
  else
    take_passing(box, half, skipped);
  if (!box.narrow())
    refuse_sum();
  return box;
}

} // namespace mdm

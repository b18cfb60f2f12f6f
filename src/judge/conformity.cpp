// Whether a sample keeps a specification, whatever was rounded in its report. What comes in are the report
// and limits at sieves; what goes out is a verdict for each sieve and one for all: holds, fails, hangs, or
// undecided.
//
// A report stands for all curves that round to it (curve_box.cpp). At each sieve these pass a least and a
// greatest percent: both within the limits, it holds; both beyond the same limit, it fails; else it hangs
// on digits that were not reported. That every sieve might be kept does not mean that one curve keeps all,
// so a verdict that hangs is decided by curve_within.cpp, and two curves show it: one that keeps all limits
// and one that does not. Comparisons of logarithms are decided by refining; what 1,200 digits do not tell
// is undecided, never guessed.

#include "judge/conformity.hpp"

#include "gradation/shown.hpp"
#include "judge/decided.hpp"
#include "judge/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

/// True if `size` lies strictly between 0 and x_1, and something may pass x_1.
bool is_unmeasured(const CurveBox &box, const Rational &size) {
  return size > 0 && compare(RootSize{size}, box.openings[1]) < 0 && box.passing[1].hi > 0;
}

CurvePercents ends(const CurveBox &box, Rational Interval::*end) {
  CurvePercents percents;
  for (const Interval &p : box.passing)
    percents.push_back(p.*end);
  return percents;
}

/// The work on one sample.
class Judgement {
public:
  Judgement(const UnderstoodGradation &report, const Specification &s,
            const std::optional<Rational> &rounding)
      : box_(curves_of(report, rounding)), finest_(box_.openings[1]) {
    result_.id = report.gradation.id();
    result_.is_exact = box_.is_exact;
    result_.notes = report.gradation.notes();
    // From the coarsest on, so that each lies below the first of the others.
    for (auto limits = s.sieves.rbegin(); limits != s.sieves.rend(); ++limits)
      if (is_unmeasured(box_, limits->size)) {
        box_.add_unmeasured(limits->size);
        unmeasured_.push_back(limits->size);
      }
    box_.narrow();
    least_ = ends(box_, &Interval::lo);
    most_ = ends(box_, &Interval::hi);
    for (const PassingLimits &limits : s.sieves)
      add(limits);
  }

  Conformity run() {
    result_.verdict = verdict();
    result_.notes.push_back(rounding_note(result_.is_exact));
    note_sizes();
    return std::move(result_);
  }

private:
  /// The place of a size; that of the pan where nothing passes the finest sieve.
  CurvePlace place(const Rational &size) const {
    if (size < 0 || compare(RootSize{size}, box_.openings[1]) >= 0)
      return place_of(box_, size);
    return {0, std::nullopt};
  }

  void add(const PassingLimits &limits) {
    const CurvePlace at = place(limits.size);
    placed_.push_back({at, limits.least, limits.most});
    SieveVerdict sieve{
        limits, {}, passing_at(at, least_), passing_at(at, most_), false, Compliance::undecided, {}};
    sieve.is_interpolated = at.way && (least_[at.i] != least_[at.i + 1] || most_[at.i] != most_[at.i + 1]);
    if (std::find(unmeasured_.begin(), unmeasured_.end(), limits.size) == unmeasured_.end()) {
      sieve.passing = passing_at(at, box_.reported);
      sieve.distance = distance(*sieve.passing, limits);
    }
    sieve.verdict = verdict_of(sieve);
    result_.sieves.push_back(std::move(sieve));
  }

  /// Nothing where both limits are those of every curve.
  static std::optional<Real> distance(const Real &passing, const PassingLimits &limits) {
    std::optional<Real> nearest;
    if (limits.least > 0)
      nearest = passing - Real(limits.least);
    if (limits.most < 100) {
      const Real below = Real(limits.most) - passing;
      if (!nearest || compare(below, *nearest) == Order::less)
        nearest = below;
    }
    return nearest;
  }

  static Compliance verdict_of(const SieveVerdict &s) {
    const Real least(s.limits.least), most(s.limits.most);
    try {
      if (certainly_less(s.most, least) || certainly_less(most, s.least))
        return Compliance::fails;
      return certainly_less(s.least, least) || certainly_less(most, s.most) ? Compliance::hangs
                                                                            : Compliance::holds;
    } catch (const NotAvailable &) {
      return Compliance::undecided;
    }
  }

  bool any(Compliance verdict) const {
    return std::any_of(result_.sieves.begin(), result_.sieves.end(),
                       [verdict](const SieveVerdict &s) { return s.verdict == verdict; });
  }

  Compliance verdict() {
    for (const Compliance v : {Compliance::fails, Compliance::undecided})
      if (any(v))
        return v;
    if (!any(Compliance::hangs))
      return Compliance::holds;
    const Available<CurveWithin> within = curve_within(box_, placed_);
    if (!within)
      return Compliance::undecided;
    if (!within->exists) {
      result_.notes.emplace_back(
          "No curve that rounds to the report keeps the limits of all sieves together.");
      return Compliance::fails;
    }
    if (within->curve)
      result_.within = witness(*within->curve);
    result_.outside = witness(breaks(least_) ? least_ : most_);
    return Compliance::hangs;
  }

  /// True if that curve is certain to break a limit.
  bool breaks(const CurvePercents &percents) const {
    return std::any_of(placed_.begin(), placed_.end(), [&percents](const PlacedLimits &l) {
      const Real passing = passing_at(l.place, percents);
      return compare(passing, Real(l.least)) == Order::less ||
             compare(passing, Real(l.most)) == Order::greater;
    });
  }

  WitnessCurve witness(const CurvePercents &percents) const {
    return {{std::next(box_.openings.begin()), box_.openings.end()},
            {std::next(percents.begin()), percents.end()}};
  }

  void note_sizes() {
    std::vector<std::string> interpolated, below;
    for (const SieveVerdict &s : result_.sieves)
      if (s.is_interpolated)
        interpolated.push_back(shown(s.limits.size));
    for (const Rational &size : unmeasured_)
      below.push_back(shown(size));
    if (!interpolated.empty())
      result_.notes.push_back(
          fmt::format("The sample has no sieve of {} mm: what passes is interpolated, linear in "
                      "log size.",
                      fmt::join(interpolated, ", ")));
    if (!below.empty())
      result_.notes.push_back(
          fmt::format("The finest sieve of the sample is {} mm: what passes {} mm may be any part "
                      "of what passes that.",
                      shown(finest_), fmt::join(below, ", ")));
  }

  CurveBox box_;
  RootSize finest_;
  Conformity result_;
  std::vector<Rational> unmeasured_;
  CurvePercents least_, most_;
  std::vector<PlacedLimits> placed_;
};

} // namespace

std::vector<Rational> missed_sizes(const Conformity &sample) {
  std::vector<Rational> sizes;
  for (const SieveVerdict &s : sample.sieves)
    if (s.verdict == Compliance::fails)
      sizes.push_back(s.limits.size);
  return sizes;
}

Conformity judge(const UnderstoodGradation &report, const Specification &specification,
                 const std::optional<Rational> &rounding) {
  return Judgement(report, specification, rounding).run();
}

} // namespace mdm

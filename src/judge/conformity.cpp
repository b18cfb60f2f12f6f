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
#include <cctype>
#include <iterator>
#include <set>

namespace mdm {
namespace {

/// True if `size` lies strictly between 0 and x_1, and something may pass x_1.
bool is_unmeasured(const CurveBox &box, const Rational &size) {
  return size > 0 && compare(RootSize{size}, box.openings[1]) < 0 && box.passing[1].hi > 0;
}

/// The work on one sample.
class Judgement {
public:
  Judgement(const UnderstoodGradation &report, const Specification &s,
            const std::optional<Rational> &rounding, const std::vector<FurtherLimit> &limits)
      : box_(curves_of(report, rounding)), finest_(box_.openings[1]) {
    result_.id = report.gradation.id();
    result_.is_exact = box_.is_exact;
    result_.notes = report.gradation.notes();
    add_unmeasured(s, limits);
    box_.narrow();
    least_ = box_.least_curve();
    most_ = box_.greatest_curve();
    for (const PassingLimits &at_sieve : s.sieves)
      add(at_sieve);
    result_.limits = further_verdicts(box_, s, limits, unmeasured_);
  }

  Conformity run() {
    result_.verdict = verdict();
    result_.notes.push_back(rounding_note(result_.is_exact));
    note_sizes();
    return std::move(result_);
  }

private:
  /// Sieves below the finest of the sample, from the coarsest on, so that each lies below the first of the
  /// others.
  void add_unmeasured(const Specification &s, const std::vector<FurtherLimit> &limits) {
    std::set<Rational, std::greater<>> sizes;
    for (const PassingLimits &at_sieve : s.sieves)
      sizes.insert(at_sieve.size);
    for (const FurtherLimit &limit : limits)
      for (const Rational &size : sizes_of(limit))
        sizes.insert(size);
    for (const Rational &size : sizes)
      if (is_unmeasured(box_, size)) {
        box_.add_unmeasured(size);
        unmeasured_.push_back(size);
      }
  }

  void add(const PassingLimits &limits) {
    const CurvePlace at = place_on(box_, limits.size);
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
    const auto has_it = [verdict](const auto &v) { return v.verdict == verdict; };
    return std::any_of(result_.sieves.begin(), result_.sieves.end(), has_it) || any_limit(verdict);
  }
  bool any_limit(Compliance verdict) const {
    return std::any_of(result_.limits.begin(), result_.limits.end(),
                       [verdict](const LimitVerdict &v) { return v.verdict == verdict; });
  }

  Compliance verdict() {
    for (const Compliance v : {Compliance::fails, Compliance::undecided})
      if (any(v))
        return v;
    if (!any(Compliance::hangs))
      return Compliance::holds;
    const Available<CurveWithin> within = any_limit(Compliance::hangs)
                                              ? curve_within_all(box_, hanging_sieves(), hanging_limits())
                                              : curve_within(box_, placed_);
    if (!within) {
      if (!within.why().limited)
        result_.notes.push_back(sentence(within.why().reason));
      return Compliance::undecided;
    }
    if (!within->exists) {
      result_.notes.emplace_back(
          result_.limits.empty()
              ? "No curve that rounds to the report keeps the limits of all sieves together."
              : "No curve that rounds to the report keeps all limits together.");
      return Compliance::fails;
    }
    if (within->curve)
      result_.within = witness(*within->curve);
    result_.outside = witness(outside());
    return Compliance::hangs;
  }

  std::vector<PlacedLimits> hanging_sieves() const {
    std::vector<PlacedLimits> hanging;
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (result_.sieves[i].verdict == Compliance::hangs)
        hanging.push_back(placed_[i]);
    return hanging;
  }
  std::vector<LimitVerdict> hanging_limits() const {
    std::vector<LimitVerdict> hanging;
    std::copy_if(result_.limits.begin(), result_.limits.end(), std::back_inserter(hanging),
                 [](const LimitVerdict &v) { return v.verdict == Compliance::hangs; });
    return hanging;
  }

  CurvePercents outside() const {
    const std::vector<LimitVerdict> limits = hanging_limits();
    if (hanging_sieves().empty() && !limits.empty())
      return curve_outside(box_, limits.front());
    return breaks(least_) ? least_ : most_;
  }

  static std::string sentence(std::string reason) {
    reason[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(reason[0])));
    return reason + ".";
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
                 const std::optional<Rational> &rounding, const std::vector<FurtherLimit> &limits) {
  return Judgement(report, specification, rounding, limits).run();
}

} // namespace mdm

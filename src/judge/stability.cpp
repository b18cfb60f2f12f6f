// Internal stability by three rules. What comes in is the report of a soil; what goes out is whether the rule
// holds, with the size or the split at which it is nearest to its limit.
//
// Kenney and Lau: with P(D) for what passes, H/F >= 1 is P(4 D) >= 2 P(D). Between the sieves and the
// quarters of sieves both sides are linear in log D, so that the least of P(4 D) - 2 P(D), and as a quotient
// of linear functions that of H/F too, is at one of these sizes or at the end of the range. Kezdi: of a split
// at f/0.85 percent d85 of the fine part is D_f and D15 of the coarse part D_{15 + f}; the logarithm of their
// quotient is linear in f between the percents of the sieves and those less 15. A curve that is flat at a
// percent has two diameters there, the limits from either side.
//
// Of a report that was rounded both sides are taken at the ends of what they may be, each by itself: what
// holds then, holds for every curve, and what fails, fails for every curve.

#include "judge/stability.hpp"

#include "gradation/shown.hpp"
#include "judge/curve_sizes.hpp"
#include "judge/decided.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

struct NamedRule {
  StabilityRule rule;
  std::string_view name, about;
};

constexpr std::array<NamedRule, 3> rules = {{
    {StabilityRule::kenney_lau, "kenney-lau",
     "H/F of at least 1 at every size D with F up to 20 % (30 % where C_u is at most 3): F passes D, H lies "
     "between D and 4 D (Kenney and Lau, 1985 and 1986)"},
    {StabilityRule::kezdi, "kezdi",
     "wherever the soil is split in two, D15 of the coarse part is at most 4 times d85 of the fine part "
     "(Kezdi, "
     "1979)"},
    {StabilityRule::burenkova, "burenkova",
     "0.76 log(d90/d15) + 1 < d90/d60 < 1.86 log(d90/d15) + 1, log to the base 10 (Burenkova, 1993)"},
}};

/// Holds where `certain` is true of all curves, fails where `possible` is false for all.
Compliance three_valued(bool certain, bool possible) {
  return certain ? Compliance::holds : possible ? Compliance::hangs : Compliance::fails;
}

std::string percent_text(const Rational &p) {
  return shown(p) + " %";
}

/// The work on one sample.
class Stability {
public:
  Stability(const UnderstoodGradation &report, const std::optional<Rational> &rounding)
      : curves_(curves_of(report, rounding)) {
    result_.id = report.gradation.id();
    result_.notes = report.gradation.notes();
    result_.notes.push_back(rounding_note(curves_.box.is_exact));
  }

  RuleJudgement run(StabilityRule rule) {
    note_unknown();
    try {
      switch (rule) {
      case StabilityRule::kenney_lau:
        kenney_lau();
        break;
      case StabilityRule::kezdi:
        kezdi();
        break;
      case StabilityRule::burenkova:
        burenkova();
        break;
      }
      result_.verdict = verdict_of(result_.requirements);
    } catch (const NotAvailable &why) {
      result_.verdict = why.limited ? Compliance::undecided : Compliance::hangs;
      result_.notes.push_back("Not judged: " + why.reason + ".");
    }
    return std::move(result_);
  }

private:
  const CurveBox &box() const { return curves_.box; }
  const CurvePercents &reported() const { return curves_.box.reported; }
  const Rational &in_pan() const { return reported()[1]; }

  void note_unknown() {
    const Rational &most = curves_.fine[1];
    if (most > 0)
      result_.notes.push_back(
          fmt::format("Judged from {} mm on, the finest sieve: how the {}{} that pass it are "
                      "graded is not known.",
                      shown(box().openings[1]), box().is_exact ? "" : "up to ", percent_text(most)));
  }

  void number(const char *name, std::optional<Real> value, const char *unit) {
    result_.numbers.push_back({name, std::move(value), unit});
  }

  /// Sieves and quarters of sieves, ascending, from the finest sieve to `end`, and `end` itself.
  std::vector<PowerProduct> turning_sizes(const PowerProduct &end) const {
    std::vector<PowerProduct> sizes;
    for (std::size_t i = 1; i < box().openings.size(); ++i) {
      const PowerProduct x(box().openings[i].power, ratio(1, box().openings[i].degree));
      for (const PowerProduct &size : {x, x / PowerProduct(4)})
        if (not_above(curves_.finest(), size) && not_above(size, end))
          sizes.push_back(size);
    }
    sizes.push_back(end);
    return sizes;
  }

  Real four_times(const CurvePercents &percents, const PowerProduct &size) const {
    return passing(box(), percents, size * PowerProduct(4));
  }

  /// The size up to which the rule looks: that of `most` percent on this curve.
  PowerProduct end_of_range(const CurvePercents &percents, const Rational &most) const {
    const std::optional<PowerProduct> end = diameter(box(), percents, most);
    if (!end)
      throw NotAvailable{fmt::format(
          "more than {} may pass the finest sieve, and the rule looks at what is finer", percent_text(most))};
    return *end;
  }

  void kenney_lau() {
    const DiameterRange d60 = diameters(curves_, Rational(60)), d10 = diameters(curves_, Rational(10));
    const bool surely_wide = d60.lo && !not_above(*d60.lo / d10.hi, PowerProduct(3));
    const bool surely_narrow = d10.lo && not_above(d60.hi / *d10.lo, PowerProduct(3));
    const Rational longest = surely_wide ? 20 : 30, shortest = surely_narrow ? 30 : 20;
    bool certain = true, possible = true;
    for (const PowerProduct &size : turning_sizes(end_of_range(curves_.coarse, longest)))
      certain = certain && !certainly_less(four_times(curves_.coarse, size),
                                           Real(2) * passing(box(), curves_.fine, size));
    if (diameter(box(), curves_.fine, shortest))
      for (const PowerProduct &size : turning_sizes(end_of_range(curves_.fine, shortest)))
        possible = possible && !certainly_less(four_times(curves_.fine, size),
                                               Real(2) * passing(box(), curves_.coarse, size));
    report_least(longest, three_valued(certain, possible));
  }

  /// Of the reported curve: where H/F is least.
  void report_least(const Rational &most, Compliance verdict) {
    std::optional<Real> least, at, fine_part;
    for (const PowerProduct &size : turning_sizes(end_of_range(reported(), most))) {
      const Real f = passing(box(), reported(), size);
      if (f.fraction() && *f.fraction() == 0)
        continue;
      const Real quotient = four_times(reported(), size) / f - Real(1);
      if (!least || compare(quotient, *least) == Order::less) {
        least = quotient;
        at = size.real();
        fine_part = f;
      }
    }
    result_.requirements.push_back({"least H/F",
                                    {"H/F", least, ""},
                                    false,
                                    Real(1),
                                    fmt::format("up to F = {}", percent_text(most)),
                                    verdict});
    number("D", at, "mm");
    number("F", fine_part, "%");
    if (least)
      number("H", *least * *fine_part, "%");
  }

  /// The percents of the sieves and those less 15, from `from` to 85.
  static std::vector<Rational> turning_percents(const CurvePercents &a, const CurvePercents &b,
                                                const Rational &from) {
    std::vector<Rational> percents = {from, Rational(85)};
    for (const CurvePercents *curve : {&a, &b})
      for (const Rational &p : *curve)
        for (const Rational &f : {p, Rational(p - 15)})
          if (from < f && f < 85)
            percents.push_back(f);
    return percents;
  }

  /// D_{15 + f} of one curve over D_f of another, from below or above at f. Where f percent of the other pass
  /// the finest sieve, no curve of which less pass it has a smaller D_f than that sieve.
  PowerProduct split(const CurvePercents &of_coarse, const CurvePercents &of_fine, const Rational &f,
                     bool from_above) const {
    const auto &at = from_above ? upper_diameter : diameter;
    return *at(box(), of_coarse, f + 15) / at(box(), of_fine, f).value_or(curves_.finest());
  }

  /// True if no quotient of the two curves is above 4.
  bool all_at_most_4(const CurvePercents &of_coarse, const CurvePercents &of_fine,
                     const Rational &from) const {
    for (const Rational &f : turning_percents(of_coarse, of_fine, from))
      if ((f > from && !not_above(split(of_coarse, of_fine, f, false), PowerProduct(4))) ||
          (f < 85 && !not_above(split(of_coarse, of_fine, f, true), PowerProduct(4))))
        return false;
    return true;
  }

  void kezdi() {
    if (curves_.fine[1] >= 85)
      throw NotAvailable{"85 % or more may pass the finest sieve"};
    const bool certain = all_at_most_4(curves_.coarse, curves_.fine, curves_.coarse[1]);
    const bool possible = all_at_most_4(curves_.fine, curves_.coarse, curves_.fine[1]);
    std::optional<Real> most, d15, d85;
    Rational at = 0;
    for (const Rational &f : turning_percents(reported(), reported(), in_pan()))
      for (const bool from_above : {false, true}) {
        if (from_above ? f >= 85 : f <= in_pan())
          continue;
        const Real quotient = split(reported(), reported(), f, from_above).real();
        if (!most || compare(*most, quotient) == Order::less) {
          const auto &d = from_above ? upper_diameter : diameter;
          most = quotient;
          at = f;
          d15 = d(box(), reported(), f + 15)->real();
          d85 = d(box(), reported(), f)->real();
        }
      }
    result_.requirements.push_back({"greatest D15/d85 of a split",
                                    {"D15/d85", most, ""},
                                    true,
                                    Real(4),
                                    "4",
                                    three_valued(certain, possible)});
    number("split at", Real(at / ratio(85, 100)), "%");
    number("D15 of the coarse part", d15, "mm");
    number("d85 of the fine part", d85, "mm");
  }

  /// 1 + factor log10(quotient).
  static Real line(const char *factor, const PowerProduct &quotient) {
    return Real(1) + Real(parse_decimal(factor)) * log_ratio(quotient, PowerProduct(10));
  }

  void burenkova() {
    const DiameterRange d90 = diameters(curves_, Rational(90)), d60 = diameters(curves_, Rational(60)),
                        d15 = diameters(curves_, Rational(15));
    if (!d60.lo)
      throw NotAvailable{"60 % or more may pass the finest sieve"};
    const PowerProduct h1_lo = *d90.lo / d60.hi, h1_hi = d90.hi / *d60.lo, h2_lo = *d90.lo / d15.hi;
    const std::optional<PowerProduct> h2_hi = d15.lo ? std::optional(d90.hi / *d15.lo) : std::nullopt;
    const auto below = [](const Real &a, const Real &b) { return certainly_less(a, b); };
    const Compliance above_lower = three_valued(h2_hi && below(line("0.76", *h2_hi), h1_lo.real()),
                                                below(line("0.76", h2_lo), h1_hi.real()));
    const Compliance below_upper = three_valued(below(h1_hi.real(), line("1.86", h2_lo)),
                                                !h2_hi || below(h1_lo.real(), line("1.86", *h2_hi)));

    const std::optional<PowerProduct> r15 = diameter(box(), reported(), 15);
    const PowerProduct r90 = *diameter(box(), reported(), 90), r60 = *diameter(box(), reported(), 60);
    const RuleNumber h1{"d90/d60", (r90 / r60).real(), ""};
    const auto limit = [&](const char *factor) {
      return r15 ? std::optional(line(factor, r90 / *r15)) : std::nullopt;
    };
    result_.requirements.push_back(
        {"d90/d60, above", h1, false, limit("0.76"), "0.76 log(d90/d15) + 1", above_lower});
    result_.requirements.push_back(
        {"d90/d60, below", h1, true, limit("1.86"), "1.86 log(d90/d15) + 1", below_upper});
    number("d90/d15", r15 ? std::optional((r90 / *r15).real()) : std::nullopt, "");
    number("d90", r90.real(), "mm");
    number("d60", r60.real(), "mm");
    number("d15", r15 ? std::optional(r15->real()) : std::nullopt, "mm");
  }

  OuterCurves curves_;
  RuleJudgement result_;
};

} // namespace

std::optional<StabilityRule> stability_rule(std::string_view text) {
  const auto *const found =
      std::find_if(rules.begin(), rules.end(), [text](const NamedRule &r) { return r.name == text; });
  return found == rules.end() ? std::nullopt : std::optional(found->rule);
}

std::string_view name(StabilityRule rule) {
  return rules[static_cast<std::size_t>(rule)].name;
}

std::string_view about(StabilityRule rule) {
  return rules[static_cast<std::size_t>(rule)].about;
}

std::string stability_rule_names() {
  std::vector<std::string_view> names;
  for (const NamedRule &r : rules)
    names.push_back(r.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

RuleJudgement judge_stability(const UnderstoodGradation &report, StabilityRule rule,
                              const std::optional<Rational> &rounding) {
  return Stability(report, rounding).run(rule);
}

} // namespace mdm

// Limits on numbers of a curve: on its fineness modulus, and on what stays between two sieves. What comes in
// are the curves that round to a report (curve_box.cpp); what goes out is a verdict for each number, as at a
// sieve, and whether one curve keeps all limits.
//
// A fineness modulus falls where more passes, so its ends are those of the least and of the greatest curve.
// What stays between two sieves of the box is at most what passes the upper one at most less what passes the
// lower one at least, or the sum of what the classes between them retain at most, whichever is less: both
// bounds together tie neighbours alone, and a curve that starts at one of them meets it. Where one of the two
// sizes is interpolated, the first bound is only one from outside: what it does not decide is undecided.

#include "judge/further_limits.hpp"

#include "gradation/shown.hpp"
#include "judge/decided.hpp"
#include "soil/fineness_modulus.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

std::optional<Rational> limit_number(std::string text, bool is_percent) {
  if (is_percent && text.ends_with('%'))
    text.pop_back();
  try {
    return text.empty() ? std::nullopt : std::optional(parse_decimal(text));
  } catch (const InputError &error) {
    throw InputError(option("limit") + ": " + error.what());
  }
}

CurveNumber modulus_number(const CurveBox &box, FinenessModulus modulus) {
  const std::vector<Rational> &sieves = fineness_sieves(modulus);
  CurveNumber number{std::string(name(modulus)), Rational(sieves.size()), {}};
  for (const Rational &sieve : sieves)
    number.terms.push_back({sieve, place_on(box, sieve), ratio(-1, 100)});
  return number;
}

CurveNumber retained_number(const CurveBox &box, const Rational &finer, const Rational &coarser) {
  return {fmt::format("retained between {} and {} mm", shown(finer), shown(coarser)),
          0,
          {{coarser, place_on(box, coarser), 1}, {finer, place_on(box, finer), -1}}};
}

std::vector<std::pair<FurtherLimit, CurveNumber>> numbers_of(const CurveBox &box, const Specification &s,
                                                             const std::vector<FurtherLimit> &limits) {
  std::vector<std::pair<FurtherLimit, CurveNumber>> numbers;
  for (const FurtherLimit &limit : limits) {
    if (limit.modulus)
      numbers.emplace_back(limit, modulus_number(box, *limit.modulus));
    for (std::size_t i = 1; !limit.modulus && i < s.sieves.size(); ++i)
      numbers.emplace_back(limit, retained_number(box, s.sieves[i - 1].size, s.sieves[i].size));
  }
  return numbers;
}

Real value_on(const CurveNumber &number, const CurvePercents &percents) {
  Real sum(number.constant);
  for (const CurveNumber::Term &t : number.terms)
    sum = sum + Real(t.factor) * passing_at(t.place, percents);
  return sum;
}

bool is_at_sieves(const CurveNumber &number) {
  return std::none_of(number.terms.begin(), number.terms.end(),
                      [](const CurveNumber::Term &t) { return t.place.way.has_value(); });
}

/// Bounds of what stays between two sizes.
void bound_retained(const CurveBox &box, LimitVerdict &v) {
  const CurvePlace &upper = v.number.terms[0].place, &lower = v.number.terms[1].place;
  const CurvePercents least = box.least_curve(), most = box.greatest_curve();
  v.are_met = is_at_sieves(v.number);
  if (!v.are_met) {
    const Real none(0), low = passing_at(upper, least) - passing_at(lower, most);
    v.least = compare(low, none) == Order::less ? none : low;
    v.most = passing_at(upper, most) - passing_at(lower, least);
    return;
  }
  Rational least_kept = 0, most_kept = 0;
  for (std::size_t i = lower.i; i < upper.i; ++i) {
    least_kept += box.retained[i].lo;
    most_kept += box.retained[i].hi;
  }
  v.least = Real(std::max<Rational>(least[upper.i] - most[lower.i], least_kept));
  v.most = Real(std::min<Rational>(most[upper.i] - least[lower.i], most_kept));
}

Compliance verdict_on(const LimitVerdict &v) {
  const auto below = [](const Real &y, const std::optional<Rational> &limit) {
    return limit && certainly_less(y, Real(*limit));
  };
  const auto above = [](const Real &y, const std::optional<Rational> &limit) {
    return limit && certainly_less(Real(*limit), y);
  };
  try {
    if (below(v.most, v.limit.least) || above(v.least, v.limit.most))
      return Compliance::fails;
    if (!below(v.least, v.limit.least) && !above(v.most, v.limit.most))
      return Compliance::holds;
    return v.are_met ? Compliance::hangs : Compliance::undecided;
  } catch (const NotAvailable &) {
    return Compliance::undecided;
  }
}

/// Narrows an interval to the limits; false where nothing is left.
bool cut(Interval &interval, const std::optional<Rational> &least, const std::optional<Rational> &most) {
  if (least)
    interval.lo = std::max<Rational>(interval.lo, *least);
  if (most)
    interval.hi = std::min<Rational>(interval.hi, *most);
  return interval.lo <= interval.hi;
}

const NotAvailable not_told = {
    "whether one curve keeps all limits together is not decided: a sieve that they are about is no sieve of "
    "the sample, or two fineness moduli hang",
    false};

/// What may stay between two sieves of a box.
struct Span {
  std::size_t lower, upper;
  Interval retained;
};

/// Narrows a box to the curves that keep the spans, too; false if there is none. The ends are those of
/// shortest paths along bounds on differences (Bellman and Ford): they need no more rounds than there are
/// sieves.
bool narrow(CurveBox &box, const std::vector<Span> &spans) {
  for (std::size_t round = 0; box.narrow() && round <= box.passing.size(); ++round) {
    bool is_narrower = false;
    const auto raise = [&is_narrower](Rational &end, const Rational &bound) {
      is_narrower |= end < bound;
      end = std::max(end, bound);
    };
    const auto lower = [&is_narrower](Rational &end, const Rational &bound) {
      is_narrower |= bound < end;
      end = std::min(end, bound);
    };
    for (const Span &s : spans) {
      Interval &low = box.passing[s.lower], &high = box.passing[s.upper];
      raise(high.lo, low.lo + s.retained.lo);
      lower(high.hi, low.hi + s.retained.hi);
      raise(low.lo, high.lo - s.retained.hi);
      lower(low.hi, high.hi - s.retained.lo);
      if (low.hi < low.lo || high.hi < high.lo)
        return false;
    }
    if (!is_narrower)
      return true;
  }
  return false;
}

} // namespace

NamedLimits parse_named_limits(const std::string &text, const char *forms) {
  const std::size_t equals = text.find('='), dots = text.find("..");
  if (dots == std::string::npos || equals > dots)
    throw InputError(option("limit") + ": " + in_quotes(text) + " is no limit: write " + forms);
  NamedLimits limits{text.substr(0, equals), std::nullopt, std::nullopt};
  const bool is_percent = !fineness_modulus_named(limits.name);
  limits.least = limit_number(text.substr(equals + 1, dots - equals - 1), is_percent);
  limits.most = limit_number(text.substr(dots + 2), is_percent);
  if (!limits.least && !limits.most)
    throw InputError(option("limit") + ": " + in_quotes(text) +
                     " limits nothing: give a number before or behind the dots");
  if (limits.least && limits.most && *limits.least > *limits.most)
    throw InputError(option("limit") + ": " + in_quotes(text) +
                     ": no number is from the first to the second: exchange them");
  return limits;
}

FurtherLimit parse_further_limit(const std::string &text) {
  constexpr const char *forms = "FM=2.3..3.1, FM-EN=2.4..3.0 or retained=..45%";
  const NamedLimits limits = parse_named_limits(text, forms);
  const std::optional<FinenessModulus> modulus = fineness_modulus_named(limits.name);
  if (!modulus && limits.name != "retained")
    throw InputError(option("limit") + ": " + in_quotes(text) + " is no limit: write " + forms);
  return {modulus, limits.least, limits.most};
}

std::vector<Rational> sizes_of(const FurtherLimit &limit) {
  return limit.modulus ? fineness_sieves(*limit.modulus) : std::vector<Rational>();
}

std::vector<LimitVerdict> further_verdicts(const CurveBox &box, const Specification &specification,
                                           const std::vector<FurtherLimit> &limits,
                                           const std::vector<Rational> &unmeasured) {
  const CurvePercents least = box.least_curve(), most = box.greatest_curve();
  std::vector<LimitVerdict> verdicts;
  for (auto &[limit, number] : numbers_of(box, specification, limits)) {
    LimitVerdict v{limit, std::move(number), std::nullopt, Real(0), Real(0)};
    if (limit.modulus) { // of which more that passes is less
      v.least = value_on(v.number, most);
      v.most = value_on(v.number, least);
    } else {
      bound_retained(box, v);
    }
    const bool is_told =
        std::none_of(v.number.terms.begin(), v.number.terms.end(), [&](const CurveNumber::Term &t) {
          return std::find(unmeasured.begin(), unmeasured.end(), t.size) != unmeasured.end();
        });
    if (is_told)
      v.value = value_on(v.number, box.reported);
    v.verdict = verdict_on(v);
    verdicts.push_back(std::move(v));
  }
  return verdicts;
}

Available<CurveWithin> curve_within_all(CurveBox box, const std::vector<PlacedLimits> &limits,
                                        const std::vector<LimitVerdict> &further) {
  for (const PlacedLimits &l : limits) {
    if (l.place.way)
      return not_told;
    if (!cut(box.passing[l.place.i], l.least, l.most))
      return CurveWithin{};
  }
  const LimitVerdict *modulus = nullptr;
  std::vector<Span> spans;
  for (const LimitVerdict &v : further) {
    if (!is_at_sieves(v.number) || (v.limit.modulus && modulus != nullptr))
      return not_told;
    if (v.limit.modulus) {
      modulus = &v;
      continue;
    }
    spans.push_back({v.number.terms[1].place.i,
                     v.number.terms[0].place.i,
                     {v.limit.least.value_or(Rational(0)), v.limit.most.value_or(Rational(100))}});
  }
  if (!narrow(box, spans))
    return CurveWithin{};
  CurvePercents low = box.least_curve();
  const CurvePercents high = box.greatest_curve();
  if (modulus == nullptr)
    return CurveWithin{true, low};
  const Rational most = *value_on(modulus->number, low).fraction(),
                 least = *value_on(modulus->number, high).fraction();
  const Rational goal = std::min<Rational>(most, modulus->limit.most.value_or(most));
  if (goal < modulus->limit.least.value_or(goal) || goal < least)
    return CurveWithin{};
  const Rational way = most == least ? Rational(0) : Rational((most - goal) / (most - least));
  for (std::size_t i = 0; i < low.size(); ++i)
    low[i] += way * (high[i] - low[i]);
  return CurveWithin{true, low};
}

CurvePercents curve_outside(const CurveBox &box, const LimitVerdict &hanging) {
  const bool is_too_much =
      hanging.limit.most && compare(hanging.most, Real(*hanging.limit.most)) == Order::greater;
  if (hanging.limit.modulus)
    return is_too_much ? box.least_curve() : box.greatest_curve();
  // From the lower sieve on, whose percent is as far from that of the upper one as it can be.
  const std::size_t lower = hanging.number.terms[1].place.i;
  CurvePercents curve(box.passing.size());
  curve[lower] = is_too_much ? box.passing[lower].lo : box.passing[lower].hi;
  for (std::size_t i = lower + 1; i < curve.size(); ++i)
    curve[i] = is_too_much ? std::min<Rational>(box.passing[i].hi, curve[i - 1] + box.retained[i - 1].hi)
                           : std::max<Rational>(box.passing[i].lo, curve[i - 1] + box.retained[i - 1].lo);
  for (std::size_t i = lower; i-- > 0;)
    curve[i] = is_too_much ? std::min<Rational>(box.passing[i].hi, curve[i + 1] - box.retained[i].lo)
                           : std::max<Rational>(box.passing[i].lo, curve[i + 1] - box.retained[i].hi);
  return curve;
}

} // namespace mdm

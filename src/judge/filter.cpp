// Filters by the rules of practice. What comes in are the reports of filters and of a base soil; what goes
// out are requirements on D15 and other sizes of each filter, with verdicts.
//
// Of the base: where the rule regrades, its percents are taken of what passes 4.75 mm; A, the percent finer
// than 0.075 mm, gives its category, and with d85 the greatest D15 that retains it; d15, before regrading,
// the least D15 that lets its water pass. Every number is a range over all curves that round to the report;
// below the finest sieve a size lies between 0 and that sieve. A limit that depends on the category is taken
// over all categories that A may be in. A requirement holds where the ends that are worst for it keep it,
// fails where those that are best do not, and else hangs.

#include "judge/filter.hpp"

#include "gradation/shown.hpp"
#include "judge/curve_sizes.hpp"
#include "judge/decided.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// The numbers in which the rules differ.
struct NamedFilterRule {
  FilterRule rule;
  std::string_view name;
  unsigned permeability; ///< D15 is at least so many times d15 of the base
  unsigned largest;      ///< mm; 0: none, and no categories
  std::string_view about;
};

constexpr std::array<NamedFilterRule, 5> filter_rules = {{
    {FilterRule::terzaghi, "terzaghi", 4, 0,
     "D15 is at most 4 x d85 and at least 4 x d15 of the base (Terzaghi and Peck, Soil Mechanics in "
     "Engineering "
     "Practice, 1948)"},
    {FilterRule::usbr, "usbr", 5, 51,
     "Bureau of Reclamation, Design Standards No. 13, Embankment Dams, chapter 5, Protective Filters, 2011"},
    {FilterRule::nrcs, "nrcs", 5, 75,
     "Natural Resources Conservation Service, National Engineering Handbook, part 633, chapter 26, 2017"},
    {FilterRule::nrcs_1994, "nrcs-1994", 4, 75,
     "Natural Resources Conservation Service, National Engineering Handbook, part 633, chapter 26, 1994"},
    {FilterRule::fema, "fema", 5, 51,
     "Federal Emergency Management Agency, Filters for Embankment Dams, 2011"},
}};

const NamedFilterRule &numbers_of(FilterRule rule) {
  return filter_rules[static_cast<std::size_t>(rule)];
}

Rational decimal(const char *text) {
  return parse_decimal(text);
}

/// A length that is decided as a power product where it is one, so that ties are.
struct FilterSize {
  std::optional<PowerProduct> product;
  Real value;

  FilterSize(const PowerProduct &p) : product(p), value(p.real()) {}
  FilterSize(const Real &r) : value(r) {}
};

/// a <= b. \throws NotAvailable where no precision tells
bool is_at_most(const FilterSize &a, const FilterSize &b) {
  if (a.product && b.product)
    return not_above(*a.product, *b.product);
  return !certainly_less(b.value, a.value);
}

const FilterSize &least_of(const FilterSize &a, const FilterSize &b) {
  return is_at_most(a, b) ? a : b;
}

const FilterSize &greatest_of(const FilterSize &a, const FilterSize &b) {
  return is_at_most(a, b) ? b : a;
}

/// A length between two; without `lo` between 0 and `hi`.
struct LengthRange {
  std::optional<FilterSize> lo;
  FilterSize hi;
};

LengthRange times(unsigned factor, const DiameterRange &d) {
  const PowerProduct k{Rational(factor)};
  return {d.lo ? std::optional<FilterSize>(k * *d.lo) : std::nullopt, FilterSize(k * d.hi)};
}

LengthRange at_least(const LengthRange &r, const PowerProduct &least) {
  return {r.lo ? greatest_of(*r.lo, least) : FilterSize(least), greatest_of(r.hi, least)};
}

/// value <= limit
Compliance at_most(const DiameterRange &value, const LengthRange &limit) {
  try {
    if (limit.lo && is_at_most(value.hi, *limit.lo))
      return Compliance::holds;
    return value.lo && !is_at_most(*value.lo, limit.hi) ? Compliance::fails : Compliance::hangs;
  } catch (const NotAvailable &) {
    return Compliance::undecided;
  }
}

/// value >= limit
Compliance at_least(const DiameterRange &value, const LengthRange &limit) {
  try {
    if (value.lo && is_at_most(limit.hi, *value.lo))
      return Compliance::holds;
    return limit.lo && !is_at_most(*limit.lo, value.hi) ? Compliance::fails : Compliance::hangs;
  } catch (const NotAvailable &) {
    return Compliance::undecided;
  }
}

constexpr int category_count = 4;

/// The least percent finer than 0.075 mm of the categories 4, 3, 2; that of category 1 is above its number.
const Rational &bound_of(int category) {
  static const std::array<Rational, 4> bounds = {85, 40, 15, 0};
  return bounds[static_cast<std::size_t>(category - 1)];
}

bool is_in(const Rational &fines, int category) {
  const bool above = category == 1 ? fines > bound_of(1) : fines >= bound_of(category);
  return above && (category == 1 || (category == 2 ? fines <= bound_of(1) : fines < bound_of(category - 1)));
}

/// Whether some number of the range is in the category.
bool may_be_in(const Interval &fines, int category) {
  const Rational &from = bound_of(category);
  if (category == 1)
    return fines.hi > from;
  const Rational &to = bound_of(category - 1);
  return fines.hi >= from && (category == 2 ? fines.lo <= to : fines.lo < to);
}

/// A base soil by one rule.
class Base {
public:
  Base(const UnderstoodGradation &report, const FilterOptions &options,
       const std::optional<Rational> &rounding)
      : options_(options), curves_(curves_of(report, rounding)) {
    const Interval whole(100);
    const Interval passed = has_categories() && options.regrade ? passing_range(curves_, no_4()) : whole;
    is_regraded_ = passed.lo < 100;
    has_irrational_percents_ = !passed.is_point() && curves_.box.is_exact;
    if (passed.lo == 0)
      throw InputError(report.gradation.id() +
                       ": nothing of the base is known to pass 4.75 mm, to which it is regraded");
    d15_ = diameters(curves_, Rational(15));
    d85_ = diameters(curves_, {part(85, passed.lo), part(85, passed.hi)});
    if (has_categories()) {
      const Interval finer = passing_range(curves_, no_200());
      fines_ = {finer.lo * 100 / passed.hi, std::min<Rational>(100, finer.hi * 100 / passed.lo)};
    }
    note_regrading();
  }

  bool has_categories() const { return numbers_of(options_.rule).largest > 0; }
  const std::vector<std::string> &notes() const { return notes_; }

  /// The greatest D15 of a filter that retains this base.
  LengthRange retention() const {
    if (!has_categories())
      return times(4, d85_);
    std::optional<LengthRange> all;
    for (int category = 1; category <= category_count; ++category)
      if (may_be_in(fines_, category)) {
        const LengthRange one = retention_of(category);
        all = !all ? one
                   : LengthRange{all->lo && one.lo ? std::optional<FilterSize>(least_of(*all->lo, *one.lo))
                                                   : std::nullopt,
                                 greatest_of(all->hi, one.hi)};
      }
    return *all;
  }

  /// The least retention() as it is printed: of a base that is exact both ends are one number.
  std::optional<Real> printed(const LengthRange &retention) const {
    if (!retention.lo)
      return std::nullopt;
    return has_irrational_percents_ ? real_between(retention.lo->value, retention.hi.value)
                                    : retention.lo->value;
  }

  /// The least D15 of a filter that lets the water of this base pass.
  LengthRange permeability() const {
    const LengthRange limit = times(numbers_of(options_.rule).permeability, d15_);
    return has_categories() ? at_least(limit, PowerProduct(decimal("0.1"))) : limit;
  }

  std::string retention_text() const {
    if (!has_categories())
      return "4 x d85 of the base";
    const int category = the_category();
    const char *const rule[] = {"", "0.7 mm", "between 4 x d85 and 0.7 mm by the fines",
                                "4 x d85 of the base"};
    const char *const dispersive[] = {"", "0.5 mm", "between 4 x d85 and 0.5 mm by the fines",
                                      "4 x d85 of the base"};
    if (category == 0)
      return "by the category, which is not certain";
    const std::string words = category == 1 ? fmt::format("{} x d85 of the base, at least 0.2 mm",
                                                          options_.dispersive ? "6.5" : "9")
                                            : (options_.dispersive ? dispersive : rule)[category - 1];
    return fmt::format("{} (category {})", words, category);
  }

  std::string permeability_text() const {
    return fmt::format("{} x d15 of the base{}", numbers_of(options_.rule).permeability,
                       has_categories() ? ", at least 0.1 mm" : "");
  }

  /// Of the reported curve.
  std::vector<RuleNumber> numbers() const {
    const Real passed = is_regraded_ ? reported_passing(no_4()) : Real(100);
    const Interval around = fractions_around(passed);
    std::vector<RuleNumber> all;
    if (has_categories()) {
      const int category = the_category();
      all.push_back({"category of the base", category ? std::optional(Real(category)) : std::nullopt, ""});
      const bool known = not_above(curves_.finest(), PowerProduct(no_200()));
      all.push_back({"finer than 0.075 mm",
                     known ? std::optional(reported_passing(no_200()) * Real(100) / passed) : std::nullopt,
                     "%"});
    }
    all.push_back({is_regraded_ ? "d85, regraded" : "d85",
                   reported_diameter({part(85, around.lo), part(85, around.hi)}), "mm"});
    all.push_back({"d15", reported_diameter(Rational(15)), "mm"});
    return all;
  }

private:
  static const Rational &no_4() {
    static const Rational size = decimal("4.75");
    return size;
  }
  static const Rational &no_200() {
    static const Rational size = decimal("0.075");
    return size;
  }

  /// p percent of `whole` percent.
  static Rational part(const Rational &p, const Rational &whole) { return p * whole / 100; }

  Real reported_passing(const Rational &size) const {
    return passing(curves_.box, curves_.box.reported, PowerProduct(size));
  }

  std::optional<Real> reported_diameter(const Interval &percent) const {
    return mdm::reported_diameter(curves_, percent);
  }

  /// The one that is certain, or 0.
  int the_category() const {
    for (int category = 1; category <= category_count; ++category)
      if (is_in(fines_.lo, category) && is_in(fines_.hi, category))
        return category;
    return 0;
  }

  LengthRange retention_of(int category) const {
    const PowerProduct least(decimal(options_.dispersive ? "0.5" : "0.7"));
    switch (category) {
    case 1: {
      const PowerProduct k(decimal(options_.dispersive ? "6.5" : "9"));
      return at_least(
          {d85_.lo ? std::optional<FilterSize>(k * *d85_.lo) : std::nullopt, FilterSize(k * d85_.hi)},
          PowerProduct(decimal("0.2")));
    }
    case 2:
      return {FilterSize(least), FilterSize(least)};
    case 3: {
      const Rational from = std::max<Rational>(fines_.lo, bound_of(3)),
                     to = std::min<Rational>(fines_.hi, bound_of(2));
      return {between(d85_.lo, to, *least.exact()), between(d85_.hi, from, *least.exact())};
    }
    default:
      return times(4, d85_);
    }
  }

  /// (40 - A)/25 (4 d85 - least) + least, and `least` where 4 d85 is smaller.
  static FilterSize between(const std::optional<PowerProduct> &d, const Rational &fines_percent,
                            const Rational &least) {
    if (!d || not_above(PowerProduct(4) * *d, PowerProduct(least)))
      return PowerProduct(least);
    const Rational part = (bound_of(2) - fines_percent) / (bound_of(2) - bound_of(3));
    if (part == 0)
      return PowerProduct(least);
    return part == 1 ? FilterSize(PowerProduct(4) * *d)
                     : FilterSize(Real(4 * part) * d->real() + Real((1 - part) * least));
  }

  void note_regrading() {
    if (!is_regraded_)
      return;
    notes_.push_back(
        fmt::format("The base is regraded: its percents are of the {} % that pass 4.75 mm, but for d15.",
                    rounded(reported_passing(no_4()), 6)));
    if (options_.rule == FilterRule::usbr || options_.rule == FilterRule::fema)
      notes_.emplace_back(
          "The rule leaves a base of less than 15 % fines as it is where it is neither gap-graded nor "
          "broadly graded: that is for the engineer to say.");
  }

  FilterOptions options_;
  OuterCurves curves_;
  bool is_regraded_ = false, has_irrational_percents_ = false;
  DiameterRange d15_{std::nullopt, PowerProduct()}, d85_{std::nullopt, PowerProduct()};
  Interval fines_; ///< percent finer than 0.075 mm
  std::vector<std::string> notes_;
};

/// The work on one filter.
class Filter {
public:
  Filter(const UnderstoodGradation &report, const std::optional<Rational> &rounding)
      : curves_(curves_of(report, rounding)) {
    result_.id = report.gradation.id();
    result_.notes = report.gradation.notes();
    result_.notes.push_back(rounding_note(curves_.box.is_exact));
  }

  RuleJudgement run(const Base &base, const NamedFilterRule &rule) {
    const DiameterRange d15 = diameters(curves_, Rational(15));
    const LengthRange most = base.retention(), least = base.permeability();
    result_.requirements.push_back(
        {"retention", d15_of_report(), true, base.printed(most), base.retention_text(), at_most(d15, most)});
    result_.requirements.push_back({"permeability", d15_of_report(), false, least.hi.value,
                                    base.permeability_text(), at_least(d15, least)});
    if (rule.largest > 0) {
      fines();
      largest(rule.largest);
      segregation();
    }
    if (curves_.fine[1] > 0)
      result_.notes.push_back(fmt::format("A size below {} mm, the finest sieve, lies between 0 and that.",
                                          shown(curves_.box.openings[1])));
    result_.verdict = verdict_of(result_.requirements);
    return std::move(result_);
  }

private:
  std::optional<Real> reported_diameter(const Rational &percent) const {
    return mdm::reported_diameter(curves_, percent);
  }

  RuleNumber d15_of_report() const { return {"D15", reported_diameter(15), "mm"}; }

  void fines() {
    const Rational most = 5, size = decimal("0.075");
    const Interval finer = passing_range(curves_, size);
    const Compliance verdict = finer.hi <= most  ? Compliance::holds
                               : finer.lo > most ? Compliance::fails
                                                 : Compliance::hangs;
    const PowerProduct at(size);
    const bool known = not_above(curves_.finest(), at);
    result_.requirements.push_back(
        {"fines",
         {"finer than 0.075 mm",
          known ? std::optional(passing(curves_.box, curves_.box.reported, at)) : std::nullopt, "%"},
         true,
         Real(most),
         "5 %",
         verdict});
  }

  void largest(unsigned most) {
    const DiameterRange all = diameters(curves_, Rational(100));
    const PowerProduct limit{Rational(most)};
    result_.requirements.push_back({"largest size",
                                    {"D100", reported_diameter(100), "mm"},
                                    true,
                                    Real(Rational(most)),
                                    fmt::format("{} mm", most),
                                    at_most(all, {FilterSize(limit), FilterSize(limit)})});
  }

  /// The greatest D90 for the least D10 (mm): at a bound that two rows name, the stricter one.
  static unsigned most_d90(const PowerProduct &d10) {
    struct Row {
      const char *up_to;
      unsigned most;
    };
    static const std::array<Row, 5> rows = {{{"1", 25}, {"2", 30}, {"5", 40}, {"10", 50}, {nullptr, 60}}};
    if (!not_above(PowerProduct(decimal("0.5")), d10))
      return 20;
    for (const Row &row : rows)
      if (!row.up_to || not_above(d10, PowerProduct(decimal(row.up_to))))
        return row.most;
    return 60;
  }

  void segregation() {
    const DiameterRange d90 = diameters(curves_, Rational(90)), d10 = diameters(curves_, Rational(10));
    const unsigned least = d10.lo ? most_d90(*d10.lo) : 20, most = most_d90(d10.hi);
    const PowerProduct lo{Rational(least)}, hi{Rational(most)};
    result_.requirements.push_back({"segregation",
                                    {"D90", reported_diameter(90), "mm"},
                                    true,
                                    Real(Rational(least)),
                                    fmt::format("{} mm for this D10", least),
                                    at_most(d90, {FilterSize(lo), FilterSize(hi)})});
    result_.numbers.push_back({"D10", reported_diameter(10), "mm"});
  }

  OuterCurves curves_;
  RuleJudgement result_;
};

void check(const FilterOptions &options) {
  if (numbers_of(options.rule).largest == 0 && (options.dispersive || !options.regrade))
    throw InputError(
        fmt::format("the rule {} has no categories of bases, and does not regrade them: leave out what "
                    "speaks of these",
                    name(options.rule)));
}

} // namespace

std::optional<FilterRule> filter_rule(std::string_view text) {
  const auto *const found = std::find_if(filter_rules.begin(), filter_rules.end(),
                                         [text](const NamedFilterRule &r) { return r.name == text; });
  return found == filter_rules.end() ? std::nullopt : std::optional(found->rule);
}

std::string_view name(FilterRule rule) {
  return numbers_of(rule).name;
}

std::string_view about(FilterRule rule) {
  return numbers_of(rule).about;
}

std::string filter_rule_names() {
  std::vector<std::string_view> names;
  for (const NamedFilterRule &r : filter_rules)
    names.push_back(r.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

RuleReport judge_filters(const std::vector<UnderstoodGradation> &filters, const UnderstoodGradation &base,
                         const FilterOptions &options, const std::optional<Rational> &rounding) {
  check(options);
  const Base soil(base, options, rounding);
  RuleReport report{
      std::string(name(options.rule)), std::string(about(options.rule)), soil.numbers(), soil.notes(), {}};
  for (const std::string &note : base.gradation.notes())
    report.notes.push_back(base.gradation.id() + ": " + note);
  for (const UnderstoodGradation &filter : filters)
    report.samples.push_back(Filter(filter, rounding).run(soil, numbers_of(options.rule)));
  return report;
}

} // namespace mdm

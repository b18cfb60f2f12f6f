#include "soil/aashto.hpp"

namespace mdm {
namespace {

/// The whole number nearest to y, halves to the even one.
Integer nearest_even(const Rational &y) {
  const Integer upper = floor(y + ratio(1, 2));
  const bool half = Rational(upper) - y == ratio(1, 2);
  return half && upper % 2 != 0 ? Integer(upper - 1) : upper;
}

/// The share in percent, rounded. \throws NotAvailable if no precision tells
Integer whole_percent(const Real &share) {
  const Real percent = share * Real(100);
  if (const std::optional<Rational> exact = percent.exact())
    return nearest_even(*exact);
  const IntegerBounds rounded = floor_of(percent + Real(ratio(1, 2)));
  if (!rounded.is_point())
    throw NotAvailable{"1,200 digits do not tell how a percent rounds", true};
  return rounded.lo;
}

/// What the table of the standard asks, in whole numbers.
struct Asked {
  Integer passing_2, passing_425, fines; ///< percent
  std::optional<Integer> liquid;         ///< nothing: at most 40
  Integer plasticity;                    ///< 0: nonplastic
};

/// The group index, whose part of the liquid limit A-2-6 and A-2-7 leave out.
Integer index_of(const Asked &a, bool plasticity_alone) {
  Rational index = ratio(1, 100) * Rational(a.fines - 15) * Rational(a.plasticity - 10);
  if (!plasticity_alone)
    index += Rational(a.fines - 35) * (ratio(2, 10) + ratio(5, 1000) * Rational(*a.liquid - 40));
  return index > 0 ? nearest_even(index) : Integer(0);
}

/// The columns of the table from the left: the first whose limits hold.
AashtoGroup group_of(const Asked &a) {
  const bool high_liquid = a.liquid && *a.liquid > 40, plastic = a.plasticity > 10;
  if (a.passing_2 <= 50 && a.passing_425 <= 30 && a.fines <= 15 && a.plasticity <= 6)
    return {"A-1-a", "stone fragments, gravel and sand", Integer(0)};
  if (a.passing_425 <= 50 && a.fines <= 25 && a.plasticity <= 6)
    return {"A-1-b", "stone fragments, gravel and sand", Integer(0)};
  if (a.passing_425 >= 51 && a.fines <= 10 && a.plasticity == 0)
    return {"A-3", "fine sand", Integer(0)};
  if (a.fines <= 35) {
    const std::string symbol = plastic ? (high_liquid ? "A-2-7" : "A-2-6") : high_liquid ? "A-2-5" : "A-2-4";
    return {symbol, "silty or clayey gravel and sand", plastic ? index_of(a, true) : Integer(0)};
  }
  const std::optional<Integer> index = a.liquid ? std::optional(index_of(a, false)) : std::nullopt;
  if (!plastic)
    return {high_liquid ? "A-5" : "A-4", "silty soil", index};
  if (!high_liquid)
    return {"A-6", "clayey soil", index};
  return {a.plasticity <= *a.liquid - 30 ? "A-7-5" : "A-7-6", "clayey soil", index};
}

Available<Real> passing_or_why(const GradingCurve &part, const Rational &size, const char *text) {
  const Available<Real> passing = part.passing(size);
  return passing ? passing
                 : Available<Real>(NotAvailable{std::string(text) + " mm lies " + passing.why().reason});
}

} // namespace

Available<AashtoGroup> classify_aashto(const GradingCurve &curve,
                                       const std::optional<AtterbergLimits> &limits) {
  const Available<GradingCurve> part = curve.part_passing(75);
  if (!part)
    return NotAvailable{"it is that of what passes 75 mm, and " + part.why().reason};
  const Available<Real> passing_2 = passing_or_why(*part, 2, "2"),
                        passing_425 = passing_or_why(*part, ratio(425, 1000), "0.425"),
                        fines = passing_or_why(*part, ratio(75, 1000), "0.075");
  if (!passing_2)
    return passing_2.why();
  if (!passing_425)
    return passing_425.why();
  try {
    Asked a{whole_percent(*passing_2), whole_percent(*passing_425), 0, std::nullopt, 0};
    if (limits) {
      a.liquid = nearest_even(limits->liquid);
      a.plasticity = *a.liquid - nearest_even(limits->plastic);
    }
    const auto with_fines = [&a](const Real &share) {
      a.fines = whole_percent(share);
      return group_of(a);
    };
    if (fines)
      return with_fines(*fines);
    // Each column on the right allows more fines than those before it: if none and all of the pan choose one
    // column, all between do.
    AashtoGroup none = with_fines(Real(0)), all = with_fines(Real(part->shares()[1]));
    if (none.symbol != all.symbol)
      return NotAvailable{fines.why().reason + ": it is between " + none.symbol + " and " + all.symbol};
    if (none.index != all.index)
      all.index.reset();
    return all;
  } catch (const NotAvailable &why) {
    return why;
  }
}

} // namespace mdm

#include "soil/uscs.hpp"

#include "soil/fractions.hpp"
#include "soil/indices.hpp"

#include <mdm/text/error.hpp>

#include <vector>

namespace mdm {
namespace {

/// Limits in percent, as the standard writes them.
Rational percent(unsigned n) {
  return ratio(n, 100);
}

/// a < b. \throws NotAvailable, as all below, where that ends the classification
bool is_less(const Real &a, const Real &b, const char *what) {
  const Order order = compare(a, b);
  if (order == Order::undecided)
    throw NotAvailable{std::string(what) + ": not decided with " + std::to_string(most_bits) + " bits", true};
  return order == Order::less;
}

/// Shares of the part that passes 75 mm.
struct Shares {
  Real gravel, sand, fines;
};

bool is_well_graded(const GradingCurve &curve, bool is_gravel, bool extrapolate) {
  const Available<PowerProduct> c_u = uniformity(curve, extrapolate), c_c = curvature(curve, extrapolate);
  if (!c_u)
    throw NotAvailable{"fines of at most 12 % need C_u, and " + c_u.why().reason};
  if (is_less(c_u->real(), Real(is_gravel ? 4 : 6), "C_u against its limit"))
    return false;
  return !is_less(c_c->real(), Real(1), "C_c against 1") && !is_less(Real(3), c_c->real(), "C_c against 3");
}

/// `gravel with silt, sand and cobbles`.
std::string with(const std::string &name, const std::vector<std::string> &others) {
  std::string text = name;
  for (std::size_t i = 0; i < others.size(); ++i)
    text += (i == 0 ? " with " : i + 1 == others.size() ? " and " : ", ") + others[i];
  return text;
}

/// The part of a coarse soil's symbol and name that its fines give.
struct FinesNames {
  const char *letter; // of dual symbols
  const char *noun, *adjective;
};

FinesNames names(Fines fines) {
  switch (fines) {
  case Fines::CL:
  case Fines::CH:
    return {"C", "clay", "clayey"};
  case Fines::CL_ML:
    return {"C", "silty clay", "silty, clayey"};
  case Fines::ML:
  case Fines::MH:
    break;
  }
  return {"M", "silt", "silty"};
}

UscsGroup coarse_grained(const GradingCurve &curve, const Shares &s, Fines fines, bool extrapolate,
                         const std::vector<std::string> &larger) {
  const bool is_gravel = is_less(s.sand, s.gravel, "gravel against sand");
  const std::string first = is_gravel ? "G" : "S", noun = is_gravel ? "gravel" : "sand";
  const FinesNames of_fines = names(fines);
  std::vector<std::string> others;
  UscsGroup group;
  if (is_less(Real(percent(12)), s.fines, "fines against 12 %")) {
    group.symbol = first + of_fines.letter;
    if (fines == Fines::CL_ML)
      group.symbol += "-" + first + "M";
    group.name = std::string(of_fines.adjective) + " " + noun;
  } else {
    const bool well = is_well_graded(curve, is_gravel, extrapolate);
    group.symbol = first + (well ? "W" : "P");
    group.name = (well ? "well-graded " : "poorly graded ") + noun;
    if (!is_less(s.fines, Real(percent(5)), "fines against 5 %")) {
      group.symbol += "-" + first + of_fines.letter;
      others.emplace_back(of_fines.noun);
    }
  }
  if (!is_less(is_gravel ? s.sand : s.gravel, Real(percent(15)), "sand or gravel against 15 %"))
    others.emplace_back(is_gravel ? "sand" : "gravel");
  others.insert(others.end(), larger.begin(), larger.end());
  group.name = with(group.name, others);
  return group;
}

UscsGroup fine_grained(const Shares &s, Fines fines, const std::vector<std::string> &larger) {
  UscsGroup group;
  switch (fines) {
  case Fines::ML:
    group = {"ML", "silt"};
    break;
  case Fines::MH:
    group = {"MH", "elastic silt"};
    break;
  case Fines::CL:
    group = {"CL", "lean clay"};
    break;
  case Fines::CH:
    group = {"CH", "fat clay"};
    break;
  case Fines::CL_ML:
    group = {"CL-ML", "silty clay"};
    break;
  }
  // Not the sum of the two, whose bound at 4.75 mm need not be rational: this is exact where 0.075 mm is a
  // sieve.
  const Real coarse = Real(1) - s.fines;
  const bool more_gravel = is_less(s.sand, s.gravel, "gravel against sand");
  std::vector<std::string> others;
  if (!is_less(coarse, Real(percent(30)), "what is coarser than 0.075 mm against 30 %")) {
    group.name = (more_gravel ? "gravelly " : "sandy ") + group.name;
    if (!is_less(more_gravel ? s.sand : s.gravel, Real(percent(15)), "sand or gravel against 15 %"))
      others.emplace_back(more_gravel ? "sand" : "gravel");
  } else if (!is_less(coarse, Real(percent(15)), "what is coarser than 0.075 mm against 15 %")) {
    others.emplace_back(more_gravel ? "gravel" : "sand");
  }
  others.insert(others.end(), larger.begin(), larger.end());
  group.name = with(group.name, others);
  return group;
}

/// The group, if the share `fines` passes 0.075 mm.
UscsGroup classify(const GradingCurve &curve, const Real &fines, Fines of_fines, bool extrapolate,
                   const std::vector<std::string> &larger) {
  const Available<Real> passing_gravel = curve.passing(ratio(475, 100));
  if (!passing_gravel)
    throw NotAvailable{"4.75 mm lies " + passing_gravel.why().reason};
  const Shares s{Real(1) - *passing_gravel, *passing_gravel - fines, fines};
  if (is_less(fines, Real(percent(50)), "fines against 50 %"))
    return coarse_grained(curve, s, of_fines, extrapolate, larger);
  return fine_grained(s, of_fines, larger);
}

/// `cobbles`, `boulders`, or both, where there are any.
std::vector<std::string> larger_than_gravel(const GradingCurve &curve) {
  std::vector<std::string> larger;
  const auto there = [&curve](const Rational &above, const std::optional<Rational> &up_to) {
    const Available<Real> share = share_between(curve, above, up_to);
    return share && compare(*share, Real(0)) == Order::greater;
  };
  if (there(75, Rational(300)))
    larger.emplace_back("cobbles");
  if (there(300, std::nullopt))
    larger.emplace_back("boulders");
  return larger;
}

Available<UscsGroup> classify_part(const GradingCurve &part, Fines fines, bool extrapolate,
                                   const std::vector<std::string> &larger) {
  const Rational no_200 = ratio(75, 1000);
  if (const Available<Real> passed = part.passing(no_200))
    return classify(part, *passed, fines, extrapolate, larger);
  // Between none and all of the pan: each rule changes at most once on the way, and what it says is in the
  // group's symbol and name.
  const UscsGroup none = classify(part, Real(0), fines, extrapolate, larger);
  const UscsGroup all = classify(part, Real(part.shares()[1]), fines, extrapolate, larger);
  if (none == all)
    return all;
  return NotAvailable{"0.075 mm lies " + part.passing(no_200).why().reason + ": it is between " +
                      none.symbol + " and " + all.symbol};
}

} // namespace

Fines classify_fines(const AtterbergLimits &limits) {
  if (limits.liquid < 0 || limits.plastic < 0)
    throw InputError(std::string("the ") + (limits.liquid < 0 ? "liquid" : "plastic") +
                     " limit is negative: give 0 or more, in percent");
  if (limits.plastic > limits.liquid)
    throw InputError("the plastic limit is above the liquid limit: leave both out for nonplastic fines");
  const Rational index = limits.liquid - limits.plastic;
  const bool above_a_line = index >= ratio(73, 100) * (limits.liquid - 20);
  if (limits.liquid >= 50)
    return above_a_line ? Fines::CH : Fines::MH;
  if (!above_a_line || index < 4)
    return Fines::ML;
  return index > 7 ? Fines::CL : Fines::CL_ML;
}

Available<UscsGroup> classify_uscs(const GradingCurve &curve, Fines fines, bool extrapolate) {
  const Available<GradingCurve> part = curve.part_passing(75);
  if (!part)
    return NotAvailable{"it is that of what passes 75 mm, and " + part.why().reason};
  try {
    return classify_part(*part, fines, extrapolate, larger_than_gravel(curve));
  } catch (const NotAvailable &why) {
    return why;
  }
}

} // namespace mdm

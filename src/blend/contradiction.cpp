// As few limits as contradict each other. What comes in is a problem without real shares; what goes out are
// limits of which none can be spared, with multipliers.
//
// Each limit in turn is left out: if the others can be kept then, it is needed and comes back. One pass is
// enough, because what was needed beside more limits is needed beside fewer. The order says which of
// several contradictions is told: what users would rather give up comes last.

#include "blend/contradiction.hpp"

#include "blend/relaxation.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// The limits in the order in which they are left out.
std::vector<BlendLimit> least_wanted_first(const BlendProblem &problem) {
  std::vector<BlendLimit> limits = limits_of(problem); // sieves from the coarsest on
  const auto shares = std::stable_partition(
      limits.begin(), limits.end(), [](const BlendLimit &l) { return l.kind == BlendLimit::Kind::share; });
  const auto lower =
      std::stable_partition(shares, limits.end(), [](const BlendLimit &l) { return l.is_upper; });
  std::reverse(shares, lower);
  return limits;
}

} // namespace

BlendContradiction contradiction_of(const BlendProblem &problem, const Watch &watch) {
  BlendProblem limits = problem;
  limits.aim = BlendAim::none;
  BlendRelaxation relaxation(limits, watch);
  for (const BlendLimit &limit : least_wanted_first(limits)) {
    relaxation.leave_out(limit);
    if (relaxation.is_feasible())
      relaxation.take_back(limit);
  }
  relaxation.is_feasible();
  BlendContradiction c;
  Rational largest = 0;
  for (BlendMultiple &m : relaxation.multiples())
    if (m.limit.kind == BlendLimit::Kind::sum) {
      c.sum = m.multiplier;
    } else {
      largest = std::max(largest, m.multiplier);
      c.limits.push_back(std::move(m));
    }
  const std::vector<BlendLimit> order = limits_of(limits);
  const auto place = [&order](const BlendMultiple &m) {
    return std::find(order.begin(), order.end(), m.limit) - order.begin();
  };
  std::sort(c.limits.begin(), c.limits.end(),
            [&place](const BlendMultiple &a, const BlendMultiple &b) { return place(a) < place(b); });
  c.sum /= largest;
  c.excess = c.sum;
  for (BlendMultiple &m : c.limits) {
    m.multiplier /= largest;
    const Rational term = m.multiplier * value_of(m.limit, limits);
    c.excess += m.limit.is_upper ? Rational(-term) : term;
  }
  return c;
}

} // namespace mdm

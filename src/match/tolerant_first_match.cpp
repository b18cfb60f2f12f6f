// A first match near the chain's bound, before a tree is begun: counts at masses a little above the chain's,
// in ranges that grow by 4 from the part of one particle. Whatever is found has been tested exactly. That
// nothing is found means nothing: the tree begins without.

#include "match/tolerant_first_match.hpp"

#include "match/near.hpp"
#include "match/problem.hpp"
#include "match/window_branching.hpp"

#include <algorithm>
#include <limits>

namespace mdm {

std::optional<TolerantMatch> first_match(const TolerantProblem &problem, const Rational &mass,
                                         const Integer &least, const std::optional<Integer> &most, int rounds,
                                         const Watch &watch) {
  const WindowBranching branching(problem, mass);
  const CountBounds bounds = least_counts(problem);
  // Of classes alone the chain shows too little to be reached; without a walk a mass takes long.
  const bool is_near = branching.walks() && !problem.tolerance().passing.empty();
  const int masses = is_near ? 16 : 1;
  double limit = most ? near(*most) : std::numeric_limits<double>::infinity();
  std::optional<TolerantMatch> best;
  // Where the mass is a part above that of the bound, so is the number of particles.
  double part = is_near ? 1 / near(least) : std::max(1 / near(least), 0x1p-20);
  for (int i = 0; i < rounds && !(best && near(least) * (1 + part) > limit); ++i, part *= 4)
    for (int n = 0; n < masses && !watch.ends(); ++n) {
      const double at = near(mass) * (1 + part * (n + 0.5) / masses);
      std::optional<TolerantMatch> found = branching.match_at(at, bounds, limit);
      if (!found)
        continue;
      best = std::move(found);
      limit = near(total(best->q));
      if (!is_near || total(best->q) <= least)
        return best;
    }
  return best;
}

} // namespace mdm

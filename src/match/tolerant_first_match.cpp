// A first match near the chain's bound, before a tree is begun. Whatever is found has been tested exactly;
// that nothing is found means nothing: the tree begins without.
//
// Where a walk over the classes finds counts, windows of the mass above the chain's are halved, those in
// which a walk has the fewest particles first, and each is tried at its middle: what passes may be possible
// at few masses alone. Otherwise masses are tried in steps that grow by 4 from the part of one particle.

#include "match/tolerant_first_match.hpp"

#include "match/near.hpp"
#include "match/problem.hpp"
#include "match/window_branching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace mdm {
namespace {

/// A window of the mass in which a walk has so many particles.
struct WalkedWindow {
  double particles, above, up_to;

  bool operator<(const WalkedWindow &other) const {
    return particles > other.particles || (particles == other.particles && above > other.above);
  }
};

std::optional<TolerantMatch> walked_match(const WindowRounding &rounding, const CountBounds &bounds,
                                          double mass, double least, double limit, int tries,
                                          const Watch &watch) {
  constexpr double least_width = 1e-14;
  NearWindow window({}, bounds);
  std::priority_queue<WalkedWindow> open;
  const auto add = [&](double above, double up_to) {
    window.above = above;
    window.up_to = up_to;
    const double particles = rounding.fewest(window, limit);
    if (particles < limit)
      open.push({particles, above, up_to});
  };
  std::optional<TolerantMatch> best;
  // Ranges above the mass that grow by 4, once there is nothing with fewer particles before them.
  double above = mass, part = 1 / least;
  const auto add_ranges = [&] {
    const auto fewest = [&] { return least * (above / mass); };
    for (; (open.empty() || open.top().particles > fewest()) && fewest() < limit && part < 0x1p30;
         part *= 4) {
      add(above, mass * (1 + part));
      above = mass * (1 + part);
    }
  };
  for (; tries > 0 && !watch.ends(); --tries) {
    add_ranges();
    if (open.empty() || open.top().particles >= limit)
      break;
    const WalkedWindow top = open.top();
    open.pop();
    const double middle = std::sqrt(top.above * top.up_to);
    if (std::optional<TolerantMatch> found = rounding.match(middle, bounds, limit, 0)) {
      best = std::move(found);
      limit = near(total(best->q));
      if (limit <= least)
        break;
    }
    if (middle <= top.above * (1 + least_width))
      continue;
    add(top.above, middle);
    add(middle, top.up_to);
  }
  return best;
}

} // namespace

std::optional<TolerantMatch> first_match(const TolerantProblem &problem, const Rational &mass,
                                         const Integer &least, const std::optional<Integer> &most, int rounds,
                                         const Watch &watch) {
  const WindowBranching branching(problem, mass);
  const WindowRounding &rounding = branching.rounding();
  const CountBounds bounds = least_counts(problem);
  const double limit = most ? near(*most) : std::numeric_limits<double>::infinity();
  // Of classes alone the chain shows too little to be reached; without a walk a mass takes long.
  if (rounding.walks() && !problem.tolerance().passing.empty())
    return walked_match(rounding, bounds, near(mass), near(least), limit, 16 * rounds, watch);
  double part = std::max(1 / near(least), 0x1p-20);
  for (int i = 0; i < rounds && !watch.ends(); ++i, part *= 4)
    if (std::optional<TolerantMatch> found = rounding.match(near(mass) * (1 + part / 2), bounds, limit, 0))
      return found;
  return std::nullopt;
}

} // namespace mdm

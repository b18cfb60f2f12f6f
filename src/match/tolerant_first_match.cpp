// A first match near the chain's bound, before a tree is begun. Two ways: counts that differ from the
// chain's by one particle in one class or two neighbours, those with as few particles first, each tested;
// and counts rounded at masses a little above the chain's, at steps that grow by 4 from a millionth.
// Whatever is found has been tested exactly. That nothing is found means nothing: the tree begins without.

#include "match/tolerant_first_match.hpp"

#include "match/near.hpp"
#include "match/problem.hpp"
#include "match/quick_masses.hpp"
#include "match/window_branching.hpp"

#include <limits>

namespace mdm {
namespace {

/// True if the counts reach all bounds of the chain.
bool reaches_bounds(const TolerantChain &chain, const std::vector<Integer> &q) {
  const ClassIntervals &intervals = chain.intervals();
  for (std::size_t i = 0; i < q.size(); ++i) {
    Integer sum = 0;
    for (std::size_t j = i; j < q.size(); ++j) {
      sum += q[j];
      if (intervals.has(i, j) && sum < chain.count(i, j))
        return false;
    }
  }
  return true;
}

/// The vectors next to the chain's differences, those with as many particles first.
std::vector<std::vector<Integer>> neighbours(const TolerantChain &chain) {
  const std::vector<Integer> q = chain.differences();
  std::vector<std::vector<Integer>> all;
  const auto add = [&](std::size_t more, std::optional<std::size_t> less) {
    std::vector<Integer> other = q;
    ++other[more];
    if (less)
      --other[*less];
    if (reaches_bounds(chain, other))
      all.push_back(std::move(other));
  };
  for (std::size_t j = 1; j < q.size(); ++j) {
    add(j, j - 1);
    add(j - 1, j);
  }
  for (std::size_t j = 0; j < q.size(); ++j)
    add(j, std::nullopt);
  return all;
}

} // namespace

std::optional<TolerantMatch> neighbouring_match(const TolerantChain &chain, const Watch &watch) {
  for (const std::vector<Integer> &q : neighbours(chain)) {
    if (watch.ends())
      break;
    if (total(q) < chain.problem().at_least())
      continue;
    if (QuickMasses quick = quick_masses(chain.problem(), q); quick.t)
      return TolerantMatch{q, std::move(*quick.t)};
  }
  return std::nullopt;
}

std::optional<TolerantMatch> rounded_match(const TolerantProblem &problem, const Rational &mass,
                                           const std::optional<Integer> &most, const Watch &watch) {
  constexpr int most_tries = 12;
  const WindowBranching branching(problem, mass);
  const CountBounds bounds = least_counts(problem);
  const double limit = most ? near(*most) : std::numeric_limits<double>::infinity();
  Rational step = ratio(1, 1 << 20);
  for (int i = 0; i < most_tries && !watch.ends(); ++i, step *= 4)
    if (std::optional<TolerantMatch> found =
            branching.match_at(near(Rational(mass * (1 + step))), bounds, limit))
      return found;
  return std::nullopt;
}

} // namespace mdm

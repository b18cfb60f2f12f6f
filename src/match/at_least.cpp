// The smallest match with at least n particles (Theorem 7). What comes in is the problem and n; what goes
// out is the match, and z with the chain above it, which prove it.
//
// If the least match has n particles, it is the answer. Else every match with n has a scale above z, the
// n-th smallest of all q^p f_j / m_j, since so many particles fit into no lower scale. The counts that a
// sweep finds above z are the fewest there; if they are fewer than n, particles are added at the least
// scale of theirs, the finest class first, and n is reached.
//
// z is found without walking over n values: about n / (sum of m_j / f_j) of them are below a first guess
// from below, cut to integers, and the at most 2 k that are missing are taken one by one.

#include "match/at_least.hpp"

#include <algorithm>
#include <cassert>
#include <queue>

namespace mdm {
namespace {

/// q^p f / m, p the scale power.
Rational lower_end(const ProblemClass &c, const Integer &q, unsigned p) {
  return ratio(power(q, p) * c.f, c.mass);
}

/// floor(2^bits / a_j) for each class, where a_j^p = f_j / m_j.
std::vector<Integer> inverse_lower_ends(const Problem &problem, unsigned bits) {
  const unsigned p = problem.scale_power();
  std::vector<Integer> inverse;
  for (const ProblemClass &c : problem.classes())
    inverse.push_back(floor_root(floor_div(c.mass << (bits * p), c.f), p));
  return inverse;
}

/// Counts floor(w / a_j) with a sum in [n - 2k, n]: w = n 2^bits / (R + k) <= n / sum(1 / a_j), where
/// R = sum floor(2^bits / a_j) >= n, so that the sum falls short by at most k n / R + k.
std::vector<Integer> counts_near(const Problem &problem, const Integer &n) {
  const unsigned p = problem.scale_power();
  unsigned bits = static_cast<unsigned>(bit_length(n));
  Integer sum = total(inverse_lower_ends(problem, bits));
  while (sum < n) {
    bits *= 2;
    sum = total(inverse_lower_ends(problem, bits));
  }
  const Integer w_numerator = power(Integer(n << bits), p);
  const Integer w_denominator = power(Integer(sum + problem.classes().size()), p);
  std::vector<Integer> counts;
  for (const ProblemClass &c : problem.classes())
    counts.push_back(floor_root(floor_div(w_numerator * c.mass, w_denominator * c.f), p));
  return counts;
}

/// Adds particles to the lower ends q of the least feasible scale above z, from the finest class up, until n
/// are there or no more fit.
std::vector<Integer> filled(const Problem &problem, std::vector<Integer> q, const Rational &z,
                            const Rational &start, const Integer &n) {
  const Rational lowest = std::max(z, problem.lowest_scale(q));
  const bool at_start = start > lowest;
  const auto room = largest_counts(problem, at_start ? start : lowest, !at_start);
  Integer missing = n - total(q);
  for (std::size_t j = 0; j < q.size() && missing > 0; ++j) {
    const Integer added = room[j] ? std::min(missing, Integer(*room[j] - q[j])) : missing;
    q[j] += added;
    missing -= added;
  }
  return q;
}

} // namespace

std::vector<std::optional<Integer>> largest_counts(const Problem &problem, const Rational &scale, bool open) {
  std::vector<std::optional<Integer>> counts;
  for (const ProblemClass &c : problem.classes()) {
    if (c.f == 0) {
      counts.emplace_back();
      continue;
    }
    const Integer n = numerator(scale) * c.mass;
    const Integer d = denominator(scale) * c.f;
    const Integer below = open ? floor_div(n, d) : Integer(ceil_div(n, d) - 1);
    counts.emplace_back(floor_root(std::max(below, Integer(0)), problem.scale_power()));
  }
  return counts;
}

Rational crowded_scale(const Problem &problem, const Integer &n) {
  assert(n >= 1);
  const std::vector<ProblemClass> &classes = problem.classes();
  const unsigned p = problem.scale_power();
  if (std::any_of(classes.begin(), classes.end(), [](const ProblemClass &c) { return c.f == 0; }))
    return 0;
  std::vector<Integer> counts = counts_near(problem, n);
  Rational scale = 0;
  for (std::size_t j = 0; j < counts.size(); ++j)
    scale = std::max(scale, lower_end(classes[j], counts[j], p));
  // From here the next smallest multiples, one by one: at most 2k.
  using Next = std::pair<Rational, std::size_t>;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> next;
  for (std::size_t j = 0; j < counts.size(); ++j)
    next.emplace(lower_end(classes[j], Integer(counts[j] + 1), p), j);
  for (Integer missing = n - total(counts); missing > 0; --missing) {
    const std::size_t j = next.top().second;
    scale = std::max(scale, next.top().first);
    next.pop();
    ++counts[j];
    next.emplace(lower_end(classes[j], Integer(counts[j] + 1), p), j);
  }
  return scale;
}

AtLeastMatch at_least_match(const Problem &problem, const Integer &n, const Rational &start,
                            const Limits &limits, const Watch &of_call) {
  const Watch watch = of_call.telling([&](Progress &known) {
    known.lower_bound = std::max(known.lower_bound, n);
    if (const Integer particles = total(some_match(problem)); particles >= n)
      known.particles = particles;
  });
  LeastMatch least = least_match(problem, limits, watch);
  if (least.complete && total(least.q) >= n)
    return {least.q, 0, std::move(least)};
  const Rational z = crowded_scale(problem, n);
  const Problem higher = problem.from_scale(z, true);
  const bool is_above = least.complete && z > 0;
  if (is_above)
    least = least_match(higher, limits, watch);
  std::vector<Integer> q = filled(higher, least.complete ? least.q : some_match(higher), z, start, n);
  return {std::move(q), is_above ? z : Rational(0), std::move(least)};
}

AtLeastMatch at_least_match(const Problem &problem, const Integer &n, const Rational &start,
                            const Limits &limits) {
  return at_least_match(problem, n, start, limits, Watch(limits.deadline));
}

} // namespace mdm

#include <mdm/match/spectrum.hpp>

#include <mdm/match/at_least.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// floor(2^bits / a_j) - floor(2^bits / b_j) - 1, at most 2^bits (1/a_j - 1/b_j), summed over the classes.
Integer spread_below(const Problem &problem, unsigned bits) {
  const unsigned b = problem.law().b;
  Integer sum = 0;
  for (const ProblemClass &c : problem.classes()) {
    const Integer mass = c.mass << (bits * b);
    sum += floor_root(floor_div(mass, c.f), b) - floor_root(floor_div(mass, c.F), b) - 1;
  }
  return sum;
}

/// A number from which on every integer is reached (Theorem 8): the sum of the lower ends above a scale where every class
/// is feasible, no floor binds, and s sum(1/a_j - 1/b_j) >= 3k - 1.
Integer all_from_bound(const Problem &problem) {
  const unsigned b = problem.law().b;
  Rational scale = problem.lowest_scale(some_match(problem));
  for (const ProblemClass &c : problem.classes())
    scale = std::max(scale, ratio(power(c.floor, b) * c.F, c.mass));
  unsigned bits = 64;
  while (spread_below(problem, bits) <= 0)
    bits *= 2;
  const Integer wanted = Integer(3 * problem.classes().size() - 1) << bits;
  scale = std::max(scale, power(ratio(wanted, spread_below(problem, bits)), b));
  const Problem above = problem.from_scale(scale, true);
  Integer sum = 0;
  for (const ProblemClass &c : above.classes())
    sum += c.floor;
  return sum;
}

/// Most particles at the highest scale of the match q.
Integer most_particles(const Problem &problem, const std::vector<Integer> &q) {
  Integer sum = 0;
  for (const std::optional<Integer> &n : largest_counts(problem, problem.highest_scale(q), false))
    sum += n.value();
  return sum;
}

/// Appends [from, to], joined with the last interval if they touch.
void append(std::vector<std::pair<Integer, Integer>> &intervals, const Integer &from, const Integer &to) {
  if (!intervals.empty() && intervals.back().second + 1 >= from)
    intervals.back().second = to;
  else
    intervals.emplace_back(from, to);
}

} // namespace

Spectrum spectrum(const Problem &problem, const Limits &limits) {
  Spectrum result;
  const Limits sweep_limits{std::nullopt, limits.deadline};
  LeastMatch least = least_match(problem, sweep_limits);
  if (!least.complete)
    return result;
  result.all_from = total(least.q);
  const auto unbounded = [](const ProblemClass &c) { return c.f == 0; };
  if (std::any_of(problem.classes().begin(), problem.classes().end(), unbounded)) {
    result.complete = true;
    return result;
  }
  const Integer enough = all_from_bound(problem);
  Integer next = total(least.q);
  for (std::uint64_t step = 1; next < enough; ++step) {
    // Between the lower ends q and the most particles at their highest scale everything is reached.
    const Integer most = most_particles(problem, least.q);
    append(result.intervals, std::max(next, total(least.q)), most);
    next = most + 1;
    result.all_from = next;
    if (limits.max_steps && step >= *limits.max_steps)
      return result;
    least = least_match(problem.from_scale(crowded_scale(problem, next), true), sweep_limits);
    if (!least.complete)
      return result;
  }
  // What follows the last gap belongs to the part without end.
  result.complete = true;
  result.all_from = std::max(next, Integer(total(least.q)));
  if (!result.intervals.empty() && result.intervals.back().second + 1 >= result.all_from) {
    result.all_from = result.intervals.back().first;
    result.intervals.pop_back();
  }
  return result;
}

} // namespace mdm

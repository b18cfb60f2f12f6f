// All numbers of particles that have an exact match (Theorem 8). What comes in is the problem; what goes
// out are intervals, ascending, and a number from which on there is a match of every number.
//
// Invariant: of the numbers below `all_from` those in the intervals are reached, and no others. In a step,
// the least match above the scale at which all_from - 1 particles are crowded has counts q. From it on
// every number up to the greatest of the stretch is reached: while q stays the lower ends or, from the
// gapless scale on, while every class is feasible. The next step begins behind that.
//
// It ends when every class is settled at a scale without gaps, which is so from some scale on; with a class
// that begins at size 0, at once.

#include "match/at_least.hpp"
#include "match/problem_of.hpp"
#include "match/problem_spectrum.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// floor(2^bits / a_j) - floor(2^bits / b_j) - 1, at most 2^bits (1/a_j - 1/b_j), summed over the classes.
Integer spread_below(const Problem &problem, unsigned bits) {
  const unsigned p = problem.scale_power();
  Integer sum = 0;
  for (const ProblemClass &c : problem.classes()) {
    const Integer mass = c.mass << (bits * p);
    sum += floor_root(floor_div(mass, c.f), p) - floor_root(floor_div(mass, c.F), p) - 1;
  }
  return sum;
}

/// A scale from which on the reachable numbers have no gap as long as every class stays feasible (Theorem 8):
/// no floor binds, and s sum(1/a_j - 1/b_j) >= 3k - 1.
Rational gapless_scale(const Problem &problem) {
  const unsigned p = problem.scale_power();
  unsigned bits = 64;
  while (spread_below(problem, bits) <= 0)
    bits *= 2;
  const Integer wanted = Integer(3 * problem.classes().size() - 1) << bits;
  Rational scale = power(ratio(wanted, spread_below(problem, bits)), p);
  for (const ProblemClass &c : problem.classes())
    scale = std::max(scale, ratio(power(Integer(c.floor - 1), p) * c.F, c.mass));
  return scale;
}

/// The highest scale up to which every class stays feasible above the lower ends q; nothing if there is none:
/// a settled class is feasible at every higher scale, another one up to q^p F / mass.
std::optional<Rational> feasible_up_to(const Problem &problem, const std::vector<Integer> &settled,
                                       const std::vector<Integer> &q) {
  std::optional<Rational> end;
  for (std::size_t j = 0; j < q.size(); ++j) {
    if (q[j] >= settled[j])
      continue;
    const ProblemClass &c = problem.classes()[j];
    const Rational last = ratio(power(q[j], problem.scale_power()) * c.F, c.mass);
    end = end ? std::min(*end, last) : last;
  }
  return end;
}

/// Most particles at a scale.
Integer most_particles(const Problem &problem, const Rational &scale) {
  Integer sum = 0;
  for (const std::optional<Integer> &n : largest_counts(problem, scale, false))
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

Spectrum spectrum(const Match &m, const Limits &limits, const ProgressCall &progress) {
  return spectrum(problem_of(m), limits, Watch(limits.deadline, progress));
}

Spectrum spectrum(const Problem &problem, const Limits &limits) {
  return spectrum(problem, limits, Watch(limits.deadline));
}

Spectrum spectrum(const Problem &problem, const Limits &limits, const Watch &watch) {
  Spectrum result;
  Limits sweep_limits;
  sweep_limits.keep_proof = false;
  LeastMatch least = least_match(problem, sweep_limits, watch);
  if (!least.complete)
    return result;
  result.all_from = total(least.q);
  const auto unbounded = [](const ProblemClass &c) { return c.f == 0; };
  if (std::any_of(problem.classes().begin(), problem.classes().end(), unbounded)) {
    result.complete = true;
    return result;
  }
  const Rational gapless = gapless_scale(problem);
  std::vector<Integer> settled;
  for (const ProblemClass &c : problem.classes())
    settled.push_back(settled_count(c, problem.scale_power()));
  for (std::uint64_t step = 1;; ++step) {
    // From the lower ends q at their lowest scale up to the most particles at `end` everything is reached:
    // while q stays the lower ends, or, where gaps are excluded, while every class is feasible.
    std::optional<Rational> end = problem.highest_scale(least.q);
    if (problem.lowest_scale(least.q) >= gapless)
      end = feasible_up_to(problem, settled, least.q);
    const Integer first = std::max(result.all_from, total(least.q));
    if (!end) {
      result.complete = true;
      append(result.intervals, first, first);
      result.all_from = result.intervals.back().first;
      result.intervals.pop_back();
      return result;
    }
    const Integer last = most_particles(problem, *end);
    append(result.intervals, first, last);
    result.all_from = last + 1;
    if (watch.ends() || (limits.max_steps && step >= *limits.max_steps))
      return result;
    least =
        least_match(problem.from_scale(crowded_scale(problem, result.all_from), true), sweep_limits, watch);
    if (!least.complete)
      return result;
  }
}

} // namespace mdm

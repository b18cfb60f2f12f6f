// Counts whose mean particles are nearly those of sizes uniform by volume. With the scale s class j wants s
// m_j / mu_j particles. s is where these, or the floor where that is more, sum to n: classes at their
// floors are set aside, the rest share what is left, and that is repeated while more come to their floors,
// at most once for each class. The numbers are rounded down, and the particles that are missing go where
// most was cut off. If the mean of a class would lie outside it, there is no answer.

#include "sets/uniform_counts.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// m / mu of each class, cut to multiples of one fraction so that sums stay short; the least has 64 bits.
std::vector<Rational> weights(const Gradation &g, const Problem &problem) {
  std::vector<Rational> exact;
  for (const ProblemClass &c : problem.classes())
    exact.push_back(g.mass(c.index) / uniform_mean(g.lower(c.index), g.upper(c.index), problem.law().a));
  const Rational unit = *std::min_element(exact.begin(), exact.end()) / Rational(Integer(1) << 64);
  for (Rational &w : exact)
    w = unit * Rational(floor(Rational(w / unit)));
  return exact;
}

/// The s with sum max(r_j, s w_j) = n, r_j the floors.
/// \pre n is at least their sum: the last class has no less than its floor
Rational sharing_scale(const Problem &problem, const std::vector<Rational> &w, const Integer &n) {
  std::vector<bool> at_floor(w.size(), false);
  for (;;) {
    Integer left = n;
    Rational weight = 0;
    for (std::size_t i = 0; i < w.size(); ++i)
      if (at_floor[i])
        left -= problem.classes()[i].floor;
      else
        weight += w[i];
    assert(weight > 0 && left > 0);
    const Rational s = Rational(left) / weight;
    bool changed = false;
    for (std::size_t i = 0; i < w.size(); ++i)
      if (!at_floor[i] && s * w[i] < problem.classes()[i].floor)
        changed = at_floor[i] = true;
    if (!changed)
      return s;
  }
}

/// max(r_j, s w_j) as integers that sum to n: rounded up where the rest is largest.
std::vector<Integer> rounded_counts(const Problem &problem, const std::vector<Rational> &w, const Rational &s,
                                    const Integer &n) {
  std::vector<Integer> q;
  std::vector<std::pair<Rational, std::size_t>> rests;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const Rational share = s * w[i];
    q.push_back(std::max(floor(share), problem.classes()[i].floor));
    if (share > q.back())
      rests.emplace_back(Rational(q.back()) - share, i);
  }
  std::sort(rests.begin(), rests.end());
  Integer missing = n - total(q);
  for (const auto &[rest, i] : rests)
    if (missing > 0) {
      ++q[i];
      --missing;
    }
  return q;
}

} // namespace

Rational uniform_mean(const Rational &l, const Rational &u, unsigned dimension) {
  if (l == 0)
    return power(u, dimension) / 2;
  return dimension == 2 ? Rational(l * u) : Rational(2 * l * l * u * u / (l + u));
}

Rational farthest_mean(const Gradation &g, const Problem &problem, const std::vector<Integer> &q,
                       const Rational &scale) {
  Rational farthest = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const std::size_t j = problem.classes()[i].index;
    const Rational mean = scale * g.mass(j) / Rational(q[i]);
    const Rational off = mean / uniform_mean(g.lower(j), g.upper(j), problem.law().a) - 1;
    farthest = std::max(farthest, Rational(abs(off)));
  }
  return farthest;
}

std::optional<UniformCounts> uniform_counts(const Gradation &g, const Problem &problem, const Integer &n) {
  const std::vector<Rational> w = weights(g, problem);
  const Rational s = sharing_scale(problem, w, n);
  std::vector<Integer> q = rounded_counts(problem, w, s, n);
  const Rational &unit = problem.scale_unit();
  Window window{problem.lowest_scale(q) * unit, problem.highest_scale(q) * unit, std::nullopt};
  // A scale with short numbers, well inside the window.
  static const Rational near = ratio(1, 1000000000);
  const Rational lo = s * (1 - near), hi = s * (1 + near);
  if (total(q) != n || lo <= window.above || hi > window.up_to)
    return std::nullopt;
  return UniformCounts{std::move(q), simplest_between(lo, hi), std::move(window)};
}

} // namespace mdm

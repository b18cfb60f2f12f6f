// Matches of a given mass near what the relaxation of a window has found. Where shares of classes and what
// passes are bounded, the classes are walked over (count_walk.cpp). A total or a demanded weight ties them
// all together: then the relaxation is solved at this mass alone. Its counts are rounded up to what their
// shares need, and the coarsest class whose count is no whole number is fixed at the nearest one, and the
// rest is solved again: particles of coarse classes are few and heavy, and those of fine ones make up for
// what is lost. It ends when all counts are whole, when no better match is to be expected, or after 40
// classes. All counts are tested exactly.

#include "match/window_rounding.hpp"

#include "match/near.hpp"
#include "match/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mdm {
namespace {

/// A count is whole that is so close to one.
constexpr double part_noise = 1e-7;

double count_sum(const std::vector<double> &q) {
  return std::accumulate(q.begin(), q.end(), 0.0);
}

/// The coarsest class whose count is no whole number.
std::optional<std::size_t> coarsest_part(const std::vector<double> &counts) {
  for (std::size_t j = counts.size(); j-- > 0;)
    if (std::fabs(counts[j] - std::round(counts[j])) > part_noise)
      return j;
  return std::nullopt;
}

CountWalk walk_over(const TolerantProblem &problem, const WindowRelaxation &relaxation) {
  std::vector<CountWalk::Class> classes;
  for (std::size_t j = 0; j < problem.classes(); ++j)
    classes.push_back({relaxation.f(j), relaxation.F(j), relaxation.share(j), relaxation.passing(j)});
  return CountWalk(std::move(classes));
}

} // namespace

WindowRounding::WindowRounding(const TolerantProblem &problem, const MassWindows &windows,
                               const WindowRelaxation &relaxation)
    : problem_(problem), windows_(windows), relaxation_(relaxation), walk_(walk_over(problem, relaxation)) {}

/// As many particles as the shares need, where at least a part of one is there.
std::vector<double> WindowRounding::rounded(const WindowPoint &point, double mass) const {
  std::vector<double> counts;
  for (std::size_t j = 0; j < point.counts.size(); ++j) {
    const double up = std::ceil(point.counts[j] - part_noise);
    const double needed = std::ceil(point.shares[j] * mass / relaxation_.F(j) * (1 - 1e-12));
    counts.push_back(up > 0 ? std::clamp(needed, 1.0, up) : 0.0);
  }
  add_missing(counts, mass);
  return counts;
}

/// As many as are asked for at least, from the finest class on.
void WindowRounding::add_missing(std::vector<double> &counts, double mass) const {
  double missing = near(problem_.at_least()) - count_sum(counts);
  for (std::size_t j = 0; j < counts.size() && missing > 0; ++j) {
    if (counts[j] == 0)
      continue;
    const double f = relaxation_.f(j);
    const double room = f > 0 ? std::ceil(relaxation_.share(j).hi * mass / f) - 1 - counts[j] : missing;
    const double more = std::clamp(room, 0.0, missing);
    counts[j] += more;
    missing -= more;
  }
}

std::optional<TolerantMatch> WindowRounding::tested(const std::vector<double> &counts, double mass) const {
  const std::vector<double> shares = relaxation_.shares_of(counts, mass);
  if (shares.empty())
    return std::nullopt;
  TolerantMatch match;
  for (const double n : counts)
    match.q.emplace_back(n);
  for (const Rational &share : exact_shares(shares))
    match.t.push_back(share * Rational(mass));
  if (total(match.q) == 0 || !problem_.is_match(match.q, match.t))
    return std::nullopt;
  return match;
}

/// Shares of which only one value is allowed have it, as have sums of them: of the classes between two such
/// sums the one with the greatest share takes what is left.
std::vector<Rational> WindowRounding::exact_shares(const std::vector<double> &near_shares) const {
  const std::vector<ShareBounds> &passing = problem_.tolerance().passing;
  const std::size_t k = near_shares.size();
  std::vector<Rational> shares;
  Rational sum = 0;
  std::size_t widest = k; ///< k: none so far
  for (std::size_t j = 0; j < k; ++j) {
    const ShareBounds &of = windows_.shares()[j];
    shares.push_back(of.is_point() ? of.lo : Rational(near_shares[j]));
    if (!of.is_point() && (widest == k || near_shares[j] > near_shares[widest]))
      widest = j;
    sum += shares[j];
    const bool is_last = j + 1 == k;
    if (widest == k || !(is_last || (!passing.empty() && passing[j].is_point())))
      continue;
    const Rational rest = (is_last ? Rational(1) : passing[j].lo) - sum;
    shares[widest] += rest;
    sum += rest;
    widest = k;
  }
  return shares;
}

double WindowRounding::fewest(const NearWindow &window, double limit) const {
  const std::vector<double> counts = walk_.counts(window, limit);
  return counts.empty() ? std::numeric_limits<double>::infinity() : count_sum(counts);
}

/// At the one mass of the window.
std::optional<TolerantMatch> WindowRounding::walked(const NearWindow &at, double limit) const {
  const double mass = at.up_to;
  std::vector<double> counts = walk_.counts(at, limit);
  if (counts.empty())
    return std::nullopt;
  add_missing(counts, mass);
  if (!(count_sum(counts) < limit))
    return std::nullopt;
  TolerantMatch match;
  for (const double n : counts)
    match.q.emplace_back(n);
  std::optional<std::vector<Rational>> t = masses(match.q, Rational(mass));
  if (!t || !problem_.is_match(match.q, *t))
    return std::nullopt;
  match.t = std::move(*t);
  return match;
}

/// Masses of the classes in the middle of what the bounds on single classes and on what passes allow. Nothing
/// if they allow none.
std::optional<std::vector<Rational>> WindowRounding::masses(const std::vector<Integer> &q,
                                                            const Rational &mass) const {
  struct Bounds {
    Rational low, high;         ///< of the class
    Rational at_least, at_most; ///< of all up to it
  };
  const std::size_t k = q.size();
  const std::vector<ShareBounds> &passing = problem_.tolerance().passing;
  std::vector<Bounds> all;
  Rational least = 0, most = 0;
  for (std::size_t j = 0; j < k; ++j) {
    Bounds of{0, 0, 0, 0};
    if (q[j] > 0) {
      of.low = std::max(Rational(windows_.shares()[j].lo * mass), Rational(q[j] * problem_.f(j)));
      of.high = std::min(Rational(windows_.shares()[j].hi * mass), Rational(q[j] * problem_.F(j)));
    }
    const ShareBounds sieve = j + 1 == k ? ShareBounds{1, 1} : passing.empty() ? ShareBounds{} : passing[j];
    least = std::max(Rational(least + of.low), Rational(sieve.lo * mass));
    most = std::min(Rational(most + of.high), Rational(sieve.hi * mass));
    if (of.low > of.high || least > most)
      return std::nullopt;
    of.at_least = least;
    of.at_most = most;
    all.push_back(std::move(of));
  }
  std::vector<Rational> t(k);
  Rational above = mass; // passes the sieve of class j
  for (std::size_t j = k; j-- > 0;) {
    const Rational low = std::max(j == 0 ? Rational(0) : all[j - 1].at_least, Rational(above - all[j].high));
    const Rational high = std::min(j == 0 ? Rational(0) : all[j - 1].at_most, Rational(above - all[j].low));
    const Rational quarter = (high - low) / 4;
    const Rational below = simplest_between(Rational(low + quarter), Rational(high - quarter));
    t[j] = above - below;
    above = below;
  }
  return t;
}

std::optional<TolerantMatch> WindowRounding::match(double mass, const CountBounds &bounds, double limit,
                                                   double excess_price) const {
  constexpr int most_tries = 40;
  std::optional<TolerantMatch> best;
  NearWindow window({}, bounds);
  window.above = window.up_to = mass;
  for (int i = 0; i < most_tries; ++i) {
    const WindowPoint point = relaxation_.minimise(window, limit, excess_price);
    if (!(point.particles < limit - 1 + part_noise))
      break;
    if (walks())
      return walked(window, limit);
    excess_price = point.prices.excess;
    const std::vector<double> counts = rounded(point, mass);
    if (count_sum(counts) < limit)
      if (std::optional<TolerantMatch> found = tested(counts, mass)) {
        limit = count_sum(counts);
        best = std::move(found);
      }
    const std::optional<std::size_t> j = coarsest_part(point.counts);
    if (!j)
      break;
    window.least[*j] = window.most[*j] = std::round(point.counts[*j]);
  }
  return best;
}

} // namespace mdm

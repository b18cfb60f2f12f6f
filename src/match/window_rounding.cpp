// Matches of a given mass near what the relaxation of a window has found. The relaxation is solved at this
// mass alone. Its counts are rounded up to what their shares need and tested exactly, at the mass and a
// little beside it. Then the coarsest class whose count is no whole number is fixed at the nearest one, and
// the rest is solved again: particles of coarse classes are few and heavy, and those of fine ones make up
// for what is lost. It ends when all counts are whole, when no better match is to be expected, or after 40
// classes.

#include "match/window_rounding.hpp"

#include "match/near.hpp"
#include "match/problem.hpp"

#include <algorithm>
#include <cmath>
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

} // namespace

/// As many particles as the shares need, where at least a part of one is there.
std::vector<double> WindowRounding::rounded(const WindowPoint &point, double mass) const {
  std::vector<double> counts;
  for (std::size_t j = 0; j < point.counts.size(); ++j) {
    const double up = std::ceil(point.counts[j] - part_noise);
    const double needed = std::ceil(point.shares[j] * mass / relaxation_.F(j) * (1 - 1e-12));
    counts.push_back(up > 0 ? std::clamp(needed, 1.0, up) : 0.0);
  }
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
  return counts;
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

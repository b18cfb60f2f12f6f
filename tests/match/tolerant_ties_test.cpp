// Small problems in which bounds meet exactly, as those of sieve series do, by enumeration in machine
// integers.

#include "catch.hpp"
#include "match/problem.hpp"
#include "match/tolerant_chain.hpp"
#include "match/tolerant_match.hpp"

#include <mdm/match/solve.hpp>

#include <functional>
#include <random>

namespace tolerant_ties_test {

using namespace mdm;

namespace {

/// A problem with f(x) = x: a class in (f, F], what passes within shares in units of 1 / unit.
struct Ties {
  static constexpr std::int64_t unit = 12;
  std::vector<std::int64_t> openings, factors, f, F;
  std::vector<std::pair<std::int64_t, std::int64_t>> passing; ///< after each class, the last [unit, unit]
  std::int64_t mass = 0;                                      ///< M >= mass, 0 for no demand
  bool optional_classes = true;
};

Ties random_ties(std::mt19937_64 &random) {
  const auto below = [&](std::uint64_t end) { return static_cast<std::int64_t>(random() % end); };
  Ties p;
  const std::int64_t classes = 2 + below(2);
  // Openings in equal ratios or equal steps, from 0 or more; factors 1 to 3 in some, so that F may fall.
  const std::int64_t kind = below(3), finest = below(2), step = 1 + below(2);
  std::int64_t x = finest;
  const bool has_factors = below(3) == 0;
  for (std::int64_t j = 0; j < classes; ++j) {
    const std::int64_t next =
        kind == 0 ? std::max<std::int64_t>(1, 2 * x) : x + (kind == 1 ? step : 1 + below(4));
    const std::int64_t factor = has_factors ? 1 + below(3) : 1;
    p.openings.push_back(x);
    p.factors.push_back(factor);
    p.f.push_back(x * factor);
    p.F.push_back(next * factor);
    x = next;
  }
  p.openings.push_back(x);
  std::int64_t before = 0;
  for (std::int64_t j = 0; j + 1 < classes; ++j) {
    const std::int64_t middle = before + below(static_cast<std::uint64_t>(Ties::unit - before + 1));
    const std::int64_t width = below(4);
    p.passing.emplace_back(std::max<std::int64_t>(0, middle - width), std::min(Ties::unit, middle + width));
    before = middle;
  }
  p.passing.emplace_back(Ties::unit, Ties::unit);
  if (!has_factors && below(3) == 0)
    p.mass = 1 + below(10);
  p.optional_classes = below(2) == 0;
  return p;
}

/// A fraction with a positive denominator.
struct Fraction {
  std::int64_t n, d;
  friend bool operator<(const Fraction &a, const Fraction &b) { return a.n * b.d < b.n * a.d; }
};

/// Some M has all sums of consecutive classes between what their particles hold (theory of bounds on what
/// passes: of every two sieves).
bool is_match(const Ties &p, const std::vector<std::int64_t> &q) {
  Fraction above{0, 1}, least{p.mass, 1};
  std::optional<Fraction> most;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const std::pair<std::int64_t, std::int64_t> from =
        i == 0 ? std::pair<std::int64_t, std::int64_t>(0, 0) : p.passing[i - 1];
    std::int64_t f = 0, F = 0;
    for (std::size_t j = i; j < q.size(); ++j) {
      f += p.f[j] * q[j];
      F += p.F[j] * q[j];
      const std::int64_t need = p.passing[j].first - from.second, room = p.passing[j].second - from.first;
      if (room < 0 || (room == 0 && F > 0))
        return false;
      if (need > 0 && (!most || Fraction{F * Ties::unit, need} < *most))
        most = {F * Ties::unit, need};
      if (F > 0 && above < Fraction{f * Ties::unit, room})
        above = {f * Ties::unit, room};
    }
  }
  return !most || (above < *most && !(*most < least));
}

/// The least number of particles up to `limit`.
std::optional<std::int64_t> enumerated(const Ties &p, std::int64_t limit) {
  std::vector<std::int64_t> q(p.f.size());
  const std::function<bool(std::size_t, std::int64_t)> finds = [&](std::size_t j, std::int64_t left) {
    if (j + 1 == q.size()) {
      q[j] = left;
      return (p.optional_classes || left > 0) && is_match(p, q);
    }
    for (q[j] = p.optional_classes ? 0 : 1; q[j] <= left; ++q[j])
      if (finds(j + 1, left - q[j]))
        return true;
    return false;
  };
  for (std::int64_t n = 1; n <= limit; ++n)
    if (finds(0, n))
      return n;
  return std::nullopt;
}

TolerantProblem problem_of(const Ties &p) {
  Gradation::Data data;
  for (const std::int64_t x : p.openings) {
    data.sizes.emplace_back(x);
    data.masses.emplace_back(1);
  }
  data.masses.back() = 0;
  for (const std::int64_t factor : p.factors)
    data.factors.emplace_back(factor);
  data.factors.emplace_back(1);
  TolerantDemands demands;
  demands.min_per_class = p.optional_classes ? 0 : 1;
  if (p.mass > 0)
    demands.weight = Rational(p.mass);
  Tolerance tolerance;
  for (const auto &[lo, hi] : p.passing)
    tolerance.passing.push_back({ratio(lo, Ties::unit), ratio(hi, Ties::unit)});
  return TolerantProblem(Gradation(std::move(data)), MassLaw{1, 1}, tolerance, demands);
}

} // namespace

TEST_CASE("where bounds meet exactly, the chain's bound is not above the enumerated optimum") {
  constexpr int problems = 100000;
  constexpr std::int64_t limit = 12;
  std::mt19937_64 random(51);
  int decided = 0, equal = 0, none = 0, searched = 0;
  for (int i = 0; i < problems; ++i) {
    const Ties ties = random_ties(random);
    const std::optional<std::int64_t> least = enumerated(ties, limit);
    const TolerantProblem problem = problem_of(ties);
    const ShareClosure shares(problem);
    if (shares.contradicts()) {
      REQUIRE_FALSE(least);
      ++none;
      continue;
    }
    for (const bool all_intervals : {false, true}) {
      const TolerantChain chain(problem, shares, all_intervals, {}, {});
      REQUIRE((chain.complete() || chain.contradicts()));
      if (chain.contradicts()) {
        REQUIRE_FALSE(least);
        none += all_intervals ? 1 : 0;
      } else if (least) {
        REQUIRE(chain.particles() <= *least);
        decided += all_intervals ? 1 : 0;
        equal += all_intervals && chain.particles() == *least ? 1 : 0;
      }
    }
    if (i % 4 != 0)
      continue;
    const TolerantResult found = tolerant_match(problem);
    REQUIRE(found.complete);
    REQUIRE((!least || (found.best && total(found.best->q) == *least)));
    REQUIRE((least || !found.best || total(found.best->q) > limit));
    searched += found.nodes > 0 ? 1 : 0;
  }
  INFO(decided << " " << equal << " " << none << " " << searched);
  CHECK(decided >= 60000);
  CHECK(equal >= 50000);
  CHECK(none >= 1000);
  CHECK(searched >= 100);
}

} // namespace tolerant_ties_test

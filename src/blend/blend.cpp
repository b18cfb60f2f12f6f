// The best blend in steps, or why there is none (proofs/README.md, Theorem 22). What comes in are
// stockpiles, limits, an aim and a number of steps; what goes out are the best blends in order, the best
// one of real shares with the price of each limit, or limits that contradict each other.
//
// Real shares come first: a linear program decides exactly whether there are any. Without real shares there
// are none in steps, and the contradiction says why. With them the search over steps (search.cpp) begins at
// their value, which no blend in steps is below. Where there is none, the limits may be widened: the aim is
// then the widest excess over a limit.

#include "blend/contradiction.hpp"
#include "blend/relaxation.hpp"
#include "blend/search.hpp"
#include "blend/tangent.hpp"

#include <mdm/blend/blend.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

void check_stockpile(const Stockpile &s, const BlendProblem &p) {
  if (s.passing.size() != p.sieves.size())
    throw InputError(printable(s.name) + ": it does not say what passes each sieve");
  if (s.least < 0 || s.most > 1 || s.least > s.most)
    throw InputError(printable(s.name) + ": the limits of its share are not in order between 0 and 100 %");
  if (s.cost < 0)
    throw InputError(printable(s.name) + ": its cost is negative: give one from 0 on");
}

void check_problem(const BlendProblem &p, const BlendOptions &o) {
  if (p.stockpiles.empty())
    throw InputError("there is no stockpile to blend: give one or more");
  for (const Stockpile &s : p.stockpiles)
    check_stockpile(s, p);
  if (p.steps < 1 || p.steps > most_blend_steps)
    throw InputError(
        fmt::format("a whole of {} steps is none: give from 1 to {}", p.steps, most_blend_steps));
  if (p.at_most && *p.at_most == 0)
    throw InputError("a blend of no stockpiles is none: allow one or more");
  if (aims_at_target(p.aim))
    for (const BlendSieve &sieve : p.sieves)
      if (!sieve.target && sieve.is_sieve())
        throw InputError("a deviation needs a target at each sieve: give one");
  if (o.best == 0)
    throw InputError("no blend is asked for: ask for one or more");
  for (const std::size_t s : p.widened)
    if (s >= p.sieves.size() || !p.sieves[s].is_sieve())
      throw InputError("there is no such sieve whose limits could be widened");
  if (o.relaxed && *o.relaxed >= p.sieves.size())
    throw InputError("there is no such sieve whose limits could be widened");
}

/// The percents by which a blend is beyond the limits of a sieve; 0 within them.
Rational excess_at(const BlendSieve &sieve, const Rational &passing) {
  return std::max({Rational(0), Rational(sieve.least - passing), Rational(passing - sieve.most)});
}

Rational value_of_aim(const BlendProblem &p, const Blend &blend) {
  Rational value = 0;
  if (p.aim == BlendAim::cost)
    for (std::size_t i = 0; i < p.stockpiles.size(); ++i)
      value += blend.shares[i] * p.stockpiles[i].cost;
  if (aims_at_target(p.aim))
    for (std::size_t s = 0; s < p.sieves.size(); ++s) {
      if (!p.sieves[s].is_sieve())
        continue;
      const Rational deviation = abs(blend.passing[s] - p.sieves[s].target.value());
      value = p.aim == BlendAim::max_deviation ? std::max(value, deviation)
              : p.aim == BlendAim::deviation   ? Rational(value + deviation)
                                               : Rational(value + deviation * deviation);
    }
  if (p.aim == BlendAim::widening)
    for (const std::size_t s : p.widened)
      value = std::max(value, excess_at(p.sieves[s], blend.passing[s]));
  return value;
}

std::vector<Rational> shares_of(const BlendSearch::Counts &counts, const BlendProblem &p) {
  std::vector<Rational> shares;
  for (const std::uint64_t n : counts)
    shares.push_back(ratio(n, p.steps));
  return shares;
}

/// Shares in steps: each is rounded down, and the steps that are missing go to those that lost most, the
/// first ones of several.
std::vector<Rational> rounded_shares(const std::vector<Rational> &shares, const BlendProblem &p) {
  BlendSearch::Counts counts;
  std::vector<Rational> lost;
  std::uint64_t missing = p.steps;
  for (const Rational &share : shares) {
    const Rational count = share * p.steps;
    counts.push_back(floor(count).convert_to<std::uint64_t>());
    lost.push_back(count - Rational(floor(count)));
    missing -= counts.back();
  }
  std::vector<std::size_t> order(counts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&lost](std::size_t a, std::size_t b) { return lost[a] > lost[b]; });
  for (std::size_t i = 0; i < missing; ++i)
    ++counts[order[i]];
  return shares_of(counts, p);
}

/// Multiples of conditions that add up to: the aim is at least its least value.
std::vector<BlendMultiple> multiples_of_least(const BlendProblem &p, const Watch &watch) {
  BlendRelaxation relaxation(p, watch);
  relaxation.demand_less(relaxation.least_value().value());
  relaxation.is_feasible();
  return relaxation.multiples();
}

/// The same of the tangent at the least squares, whose least value is theirs.
std::vector<BlendMultiple> prices_of_squares(const BlendProblem &p, const Blend &least, const Watch &watch) {
  const Tangent tangent = tangent_with(p, slopes_at(p, least.passing));
  std::vector<BlendMultiple> prices = multiples_of_least(tangent.problem, watch);
  for (BlendMultiple &m : prices)
    if (m.limit.kind == BlendLimit::Kind::sum)
      m.multiplier -= tangent.raised;
  return prices;
}

/// The real optimum, its prices, and what rounding makes of it. False if no real shares will do.
bool solve_real(const BlendProblem &p, const Watch &watch, BlendAnswer &a) {
  BlendRelaxation relaxation(p, watch);
  if (!relaxation.least_value())
    return false;
  a.real = blend_of(p, relaxation.first_shares());
  a.rounded = blend_of(p, rounded_shares(a.real->shares, p));
  a.bound = a.real->value;
  if (p.aim == BlendAim::none)
    return true;
  a.prices = p.aim == BlendAim::squares ? prices_of_squares(p, *a.real, watch) : multiples_of_least(p, watch);
  return true;
}

/// The best blend that is known where the search ended early: one that it saw, or the rounded real optimum.
std::optional<Blend> known_blend(const BlendProblem &p, const BlendSearch &search,
                                 const std::optional<Blend> &rounded) {
  std::optional<Blend> known;
  if (const std::optional<BlendSearch::Counts> seen = search.seen())
    known = blend_of(p, shares_of(*seen, p));
  if (rounded && broken_limits(p, *rounded).empty() && keeps_at_most(p, *rounded) &&
      (!known || rounded->value < known->value))
    known = rounded;
  return known;
}

void solve_in_steps(const BlendProblem &p, const BlendOptions &o, const Watch &watch, BlendAnswer &a) {
  BlendSearch search(p, watch, o.node_limit);
  while (a.best.size() < o.best) {
    const std::optional<BlendSearch::Counts> counts = search.next();
    if (a.best.empty()) {
      a.tree = search.tree();
      a.splits = search.splits();
    }
    if (!counts)
      break;
    a.best.push_back(blend_of(p, shares_of(*counts, p)));
  }
  using Status = BlendAnswer::Status;
  if (!a.best.empty()) {
    a.status = Status::optimal;
    a.bound = a.best.front().value;
    a.is_all = a.best.size() < o.best && !search.is_limited();
    return;
  }
  a.status = search.is_limited() ? Status::unknown : Status::none;
  a.bound = search.least_value().value_or(a.bound);
  if (!search.is_limited())
    return;
  if (std::optional<Blend> known = known_blend(p, search, a.rounded)) {
    a.status = Status::feasible;
    a.best.push_back(*std::move(known));
  }
}

void solve_widened(const BlendProblem &p, const BlendOptions &o, const Watch &watch, BlendAnswer &a) {
  BlendProblem wider = p;
  wider.aim = BlendAim::widening;
  wider.widened = o.relaxed ? std::vector<std::size_t>{*o.relaxed} : limited_sieves(p);
  BlendAnswer of_wider;
  a.is_widening_decided = !solve_real(wider, watch, of_wider);
  if (a.is_widening_decided)
    return;
  a.widened_real = of_wider.real;
  BlendOptions one = o;
  one.best = 1;
  solve_in_steps(wider, one, watch, of_wider);
  if (of_wider.status == BlendAnswer::Status::optimal)
    a.widened = of_wider.best.front();
  a.is_widening_decided = a.widened || of_wider.status == BlendAnswer::Status::none;
}

} // namespace

Blend blend_of(const BlendProblem &problem, const std::vector<Rational> &shares) {
  Blend blend{shares, std::vector<Rational>(problem.sieves.size()), 0};
  for (std::size_t s = 0; s < problem.sieves.size(); ++s)
    for (std::size_t i = 0; i < shares.size(); ++i)
      blend.passing[s] += shares[i] * problem.stockpiles[i].passing[s];
  blend.value = value_of_aim(problem, blend);
  return blend;
}

std::vector<BlendLimit> broken_limits(const BlendProblem &problem, const Blend &blend) {
  std::vector<BlendLimit> broken;
  for (const BlendLimit &limit : limits_of(problem)) {
    const Rational &found =
        limit.kind == BlendLimit::Kind::passing ? blend.passing[limit.index] : blend.shares[limit.index];
    const Rational bound = value_of(limit, problem);
    if (limit.is_upper ? found > bound : found < bound)
      broken.push_back(limit);
  }
  return broken;
}

bool keeps_at_most(const BlendProblem &problem, const Blend &blend) {
  const auto used =
      std::count_if(blend.shares.begin(), blend.shares.end(), [](const Rational &s) { return s > 0; });
  return !problem.at_most || static_cast<std::size_t>(used) <= *problem.at_most;
}

BlendAnswer solve_blend(const BlendProblem &problem, const BlendOptions &options) {
  check_problem(problem, options);
  const Watch watch(options.deadline,
                    options.go_on ? ProgressCall([&options](const Progress &) { return options.go_on(); })
                                  : ProgressCall());
  BlendAnswer answer;
  try {
    const bool has_real = solve_real(problem, watch, answer);
    if (has_real) {
      solve_in_steps(problem, options, watch, answer);
    } else {
      answer.status = BlendAnswer::Status::none;
      answer.tree.resize(1);
      answer.contradiction = contradiction_of(problem, watch);
    }
    if (answer.status == BlendAnswer::Status::none)
      solve_widened(problem, options, watch, answer);
  } catch (const Simplex::Interrupted &) { // what is known is in the answer
  }
  return answer;
}

} // namespace mdm

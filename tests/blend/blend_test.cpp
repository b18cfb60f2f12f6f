#include "blend/published.hpp"
#include "catch.hpp"

#include <mdm/blend/blend.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <functional>
#include <random>

namespace blend_test {

using namespace mdm;
using namespace mdm_test;

namespace {

std::vector<int> counts_of(const Blend &blend, const BlendProblem &p) {
  std::vector<int> counts;
  for (const Rational &share : blend.shares)
    counts.push_back(static_cast<int>(numerator(Rational(share * p.steps))));
  return counts;
}

/// A blend as enumeration sees it: the value of its aim, and its counts.
using Enumerated = std::pair<Rational, std::vector<int>>;

/// What passes a sieve, computed from counts.
Rational passing(const BlendProblem &p, const std::vector<int> &counts, std::size_t sieve) {
  Rational sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    sum += counts[i] * p.stockpiles[i].passing[sieve];
  return sum / p.steps;
}

/// The value of the aim, or nothing if the counts break a limit.
std::optional<Rational> judged(const BlendProblem &p, const std::vector<int> &counts) {
  Rational value = 0, cost = 0;
  std::size_t used = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Rational share = Rational(counts[i]) / p.steps;
    if (share < p.stockpiles[i].least || share > p.stockpiles[i].most)
      return std::nullopt;
    cost += share * p.stockpiles[i].cost;
    used += counts[i] > 0;
  }
  if (p.at_most && used > *p.at_most)
    return std::nullopt;
  for (std::size_t s = 0; s < p.sieves.size(); ++s) {
    const Rational found = passing(p, counts, s);
    if (p.aim == BlendAim::widening) {
      value = std::max({value, Rational(p.sieves[s].least - found), Rational(found - p.sieves[s].most)});
      continue;
    }
    if (found < p.sieves[s].least || found > p.sieves[s].most)
      return std::nullopt;
    if (p.aim == BlendAim::deviation)
      value += abs(found - *p.sieves[s].target);
    if (p.aim == BlendAim::max_deviation)
      value = std::max(value, Rational(abs(found - *p.sieves[s].target)));
    if (p.aim == BlendAim::squares)
      value += (found - *p.sieves[s].target) * (found - *p.sieves[s].target);
  }
  return p.aim == BlendAim::cost ? cost : value;
}

/// All blends within the limits, best first.
std::vector<Enumerated> enumerated(const BlendProblem &p) {
  std::vector<Enumerated> all;
  std::vector<int> counts(p.stockpiles.size());
  const std::function<void(std::size_t, int)> walk = [&](std::size_t i, int left) {
    if (i + 1 == counts.size()) {
      counts[i] = left;
      if (const std::optional<Rational> value = judged(p, counts))
        all.emplace_back(*value, counts);
      return;
    }
    for (counts[i] = 0; counts[i] <= left; ++counts[i])
      walk(i + 1, left - counts[i]);
  };
  walk(0, static_cast<int>(p.steps));
  std::sort(all.begin(), all.end());
  return all;
}

/// 2 to 5 stockpiles of some sieves in coarse steps, with limits around a blend of them or anywhere.
BlendProblem random_problem(std::mt19937_64 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  BlendProblem p;
  const int stockpiles = 2 + upto(3), sieves = 1 + upto(4);
  p.steps = static_cast<std::uint64_t>(stockpiles == 2 ? 20 : 12 - 2 * (stockpiles - 3));
  p.aim = static_cast<BlendAim>(upto(5));
  for (int i = 0; i < stockpiles; ++i) {
    Stockpile s{std::string(1, static_cast<char>('A' + i)), {}, 0, 1, Rational(upto(30)) / 4};
    for (int j = 0; j < sieves; ++j)
      s.passing.emplace_back(upto(1000) / Rational(10));
    std::sort(s.passing.begin(), s.passing.end());
    if (upto(5) == 0)
      s.most = Rational(2 + upto(5)) / 7;
    if (upto(5) == 0)
      s.least = Rational(upto(2)) / 9;
    p.stockpiles.push_back(std::move(s));
  }
  const int first = upto(static_cast<unsigned>(stockpiles - 1)),
            second = upto(static_cast<unsigned>(stockpiles - 1));
  for (int j = 0; j < sieves; ++j) {
    const auto s = static_cast<std::size_t>(j);
    const Rational middle = (p.stockpiles[static_cast<std::size_t>(first)].passing[s] +
                             p.stockpiles[static_cast<std::size_t>(second)].passing[s]) /
                            2;
    BlendSieve sieve{Rational(j + 1), 0, 100, middle + upto(10) - 5};
    if (upto(3) != 0)
      sieve.least = std::max(Rational(0), Rational(middle - upto(12) + 1));
    if (upto(3) != 0)
      sieve.most = std::min(Rational(100), std::max(sieve.least, Rational(middle + upto(12) - 1)));
    p.sieves.push_back(sieve);
    p.widened.push_back(s);
  }
  if (upto(4) == 0)
    p.at_most = static_cast<std::size_t>(1 + upto(2));
  return p;
}

/// The problem with percents that pass 9.5 mm and 2.36 mm, and limits on the coarseness factor.
BlendProblem with_coarseness(BlendProblem p, std::mt19937_64 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  for (Stockpile &s : p.stockpiles) {
    const int coarse = upto(100);
    s.coarse = CoarsePassing{Rational(coarse), Rational(upto(static_cast<unsigned>(coarse)))};
  }
  const int least = upto(70);
  limit_coarseness(p, {Rational(least), Rational(least + upto(30))});
  return p;
}

/// Whether 100 (mass on 9.5 mm) / (mass on 2.36 mm) is within the limits.
bool keeps_coarseness(const BlendProblem &p, const std::vector<int> &counts) {
  Rational coarse = 0, all = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    coarse += counts[i] * (100 - p.stockpiles[i].coarse->at_9_5_mm);
    all += counts[i] * (100 - p.stockpiles[i].coarse->at_2_36_mm);
  }
  return all == 0 || (p.coarseness->least <= 100 * coarse / all && 100 * coarse / all <= p.coarseness->most);
}

/// The sum of the multiples is a contradiction.
void check_contradiction(const BlendProblem &p, const BlendContradiction &c) {
  std::vector<Rational> left(p.stockpiles.size(), c.sum);
  Rational right = c.sum, largest = 0;
  for (const BlendMultiple &m : c.limits) {
    CHECK(m.multiplier > 0);
    largest = std::max(largest, m.multiplier);
    const Rational signed_multiplier = m.limit.is_upper ? Rational(-m.multiplier) : m.multiplier;
    if (m.limit.kind == BlendLimit::Kind::share) {
      const Stockpile &s = p.stockpiles[m.limit.index];
      left[m.limit.index] += signed_multiplier;
      right += signed_multiplier * (m.limit.is_upper ? s.most : s.least);
    } else {
      const BlendSieve &sieve = p.sieves[m.limit.index];
      for (std::size_t i = 0; i < left.size(); ++i)
        left[i] += signed_multiplier * p.stockpiles[i].passing[m.limit.index];
      right += signed_multiplier * (m.limit.is_upper ? sieve.most : sieve.least);
    }
  }
  CHECK(largest == 1);
  CHECK(right == c.excess);
  CHECK(right > 0);
  for (const Rational &coefficient : left)
    CHECK(coefficient <= 0);
}

} // namespace

TEST_CASE("the cheapest whole percents of four stockpiles, and the real optimum that rounding breaks") {
  const BlendProblem p = four_stockpiles();
  const BlendAnswer a = solve_blend(p);
  REQUIRE(a.status == BlendAnswer::Status::optimal);
  CHECK(counts_of(a.best.at(0), p) == std::vector<int>{61, 11, 27, 1});
  CHECK(a.best[0].value == parse_decimal("8.1167"));
  REQUIRE(a.real);
  CHECK(a.real->value == ratio(193093911, 23865550));
  REQUIRE(a.rounded);
  CHECK(counts_of(*a.rounded, p) == std::vector<int>{62, 10, 28, 0});
  CHECK(broken_limits(p, *a.rounded).size() == 2);
  CHECK(broken_limits(p, a.best[0]).empty());
}

TEST_CASE("prices of limits add up to the value of the real optimum") {
  const BlendProblem p = four_stockpiles();
  const BlendAnswer a = solve_blend(p);
  Rational sum = 0;
  std::vector<Rational> left(4, Rational(0));
  for (const BlendMultiple &m : a.prices) {
    const Rational multiplier = m.limit.is_upper ? Rational(-m.multiplier) : m.multiplier;
    sum += multiplier * value_of(m.limit, p);
    for (std::size_t i = 0; i < 4; ++i)
      left[i] +=
          multiplier * (m.limit.kind == BlendLimit::Kind::sum       ? Rational(1)
                        : m.limit.kind == BlendLimit::Kind::passing ? p.stockpiles[i].passing[m.limit.index]
                                                                    : Rational(m.limit.index == i ? 1 : 0));
  }
  CHECK(sum == ratio(193093911, 23865550));
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(left[i] <= p.stockpiles[i].cost);
}

TEST_CASE("two stockpiles of which no blend keeps the limits: the two limits that contradict each other") {
  const BlendProblem p = verified_but_impossible();
  const BlendAnswer a = solve_blend(p);
  CHECK(a.status == BlendAnswer::Status::none);
  CHECK_FALSE(a.real);
  REQUIRE(a.contradiction);
  REQUIRE(a.contradiction->limits.size() == 2);
  CHECK(in_words(a.contradiction->limits[0].limit, p) == "at most 90 % passing 12.5 mm");
  CHECK(a.contradiction->limits[0].multiplier == ratio(9, 10));
  CHECK(in_words(a.contradiction->limits[1].limit, p) == "at least 7 % passing 0.075 mm");
  CHECK(a.contradiction->limits[1].multiplier == 1);
  CHECK(a.contradiction->sum == 81);
  CHECK(a.contradiction->excess == 7);
  check_contradiction(p, *a.contradiction);
  REQUIRE(a.widened_real);
  CHECK(a.widened_real->value == ratio(34, 9));
  REQUIRE(a.widened);
  CHECK(a.widened->value == ratio(38, 10)); // 62/38: 93.8 % pass 12.5 mm
}

TEST_CASE("one sieve's limits alone are widened where that helps") {
  BlendProblem p = problem_of({"A", "B"}, "4 0 60 50 100  1 40 100 0 90");
  BlendOptions o;
  o.relaxed = 1; // 1 mm is sieve 0, 4 mm sieve 1
  const BlendAnswer coarse = solve_blend(p, o);
  REQUIRE(coarse.widened_real);
  CHECK(coarse.widened_real->value == ratio(110, 9)); // B = 4/9: 50 + 50 * 4/9 = 650/9, 60 + 110/9
  o.relaxed = 0;
  const BlendAnswer fine = solve_blend(p, o);
  REQUIRE(fine.widened_real);
  CHECK(fine.widened_real->value == 22); // B = 1/5: 18 %
  p.sieves[0].most = 10;
  p.sieves[0].least = 0;
  p.sieves[1].most = 100;
  p.sieves[1].least = 99;
  o.relaxed = 0;
  CHECK(solve_blend(p, o).widened_real->value == ratio(782, 10)); // B = 49/50: 88.2 %
}

TEST_CASE("the published blend of two stockpiles holds, and the edge of all that do") {
  BlendProblem p = two_stockpiles();
  CHECK(broken_limits(p, blend_of(p, {ratio(45, 100), ratio(55, 100)})).empty());
  p.stockpiles[1].cost = 1; // the least of the second
  p.aim = BlendAim::cost;
  const BlendAnswer most = solve_blend(p);
  REQUIRE(most.real);
  p.stockpiles[1].cost = 0;
  p.stockpiles[0].cost = 1;
  const BlendAnswer least = solve_blend(p);
  REQUIRE(least.real);
  const std::vector<Rational> edges = {most.real->shares[0], least.real->shares[0]};
  CHECK(std::find(edges.begin(), edges.end(), ratio(41, 91)) != edges.end());
}

TEST_CASE("the published curve of three stockpiles is that of their shares, rounded to its digits") {
  const BlendProblem p = missouri();
  const Blend blend = blend_of(p, {ratio(390, 1000), ratio(518, 1000), ratio(92, 1000)});
  const std::vector<std::string> published = {"0.9",  "1.4",  "4.3",  "18.3", "32.4", "34.3", "43.1",
                                              "60.0", "72.5", "97.4", "100",  "100",  "100"};
  REQUIRE(blend.passing.size() == published.size());
  for (std::size_t s = 0; s < published.size(); ++s) {
    CAPTURE(s);
    CHECK(abs(blend.passing[s] - parse_decimal(published[s])) <= ratio(5, 100));
  }
}

TEST_CASE("all whole-percent blends of the cold bins, in the order of their shares") {
  const BlendProblem p = cold_bins();
  BlendOptions o;
  o.best = 2000;
  const BlendAnswer a = solve_blend(p, o);
  CHECK(a.is_all);
  REQUIRE(a.best.size() == 1152);
  const std::vector<Enumerated> expected = enumerated(p);
  REQUIRE(expected.size() == 1152);
  std::vector<std::vector<int>> found;
  for (const Blend &b : a.best)
    found.push_back(counts_of(b, p));
  CHECK(found.front() == expected.front().second);
  CHECK(found.back() == expected.back().second);
  CHECK(std::is_sorted(found.begin(), found.end()));
  CHECK(std::find(found.begin(), found.end(), std::vector<int>{45, 30, 25}) != found.end());
}

TEST_CASE("the published blend of the hot bins holds") {
  const BlendProblem p = hot_bins();
  const Rational fifth = ratio(20, 100);
  CHECK(broken_limits(p, blend_of(p, {ratio(42, 100), fifth, ratio(18, 100), fifth})).empty());
}

TEST_CASE("the best blends of random problems are those of enumeration, in its order") {
  std::mt19937_64 random(32);
  int with_blends = 0, contradictions = 0, without = 0;
  for (int trial = 0; trial < 400; ++trial) {
    CAPTURE(trial);
    const BlendProblem p = random_problem(random);
    BlendOptions o;
    o.best = 4;
    const BlendAnswer a = solve_blend(p, o);
    const std::vector<Enumerated> expected = enumerated(p);
    REQUIRE(a.best.size() == std::min<std::size_t>(4, expected.size()));
    CHECK(a.is_all == (expected.size() < 4 && !expected.empty()));
    CHECK((a.status == BlendAnswer::Status::none) == expected.empty());
    for (std::size_t i = 0; i < a.best.size(); ++i) {
      CHECK(counts_of(a.best[i], p) == expected[i].second);
      CHECK(a.best[i].value == expected[i].first);
    }
    if (!expected.empty()) {
      REQUIRE(a.real);
      CHECK(a.real->value <= expected[0].first);
      CHECK(broken_limits(p, *a.real).empty() != (p.aim == BlendAim::widening && a.real->value > 0));
      ++with_blends;
    }
    if (a.contradiction) {
      check_contradiction(p, *a.contradiction);
      ++contradictions;
    } else if (expected.empty()) {
      ++without;
    }
    if (expected.empty() && p.aim != BlendAim::widening) {
      BlendProblem wider = p;
      wider.aim = BlendAim::widening;
      const std::vector<Enumerated> widened = enumerated(wider);
      CHECK(a.widened.has_value() == !widened.empty());
      if (a.widened)
        CHECK(a.widened->value == widened.front().first);
    }
  }
  CHECK(with_blends > 50);
  CHECK(contradictions > 50);
  CHECK(without > 5);
}

TEST_CASE("blends whose coarseness factor is limited are those of enumeration that keep its limits") {
  std::mt19937_64 random(10);
  int with_blends = 0, fewer = 0;
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const BlendProblem without = random_problem(random);
    if (without.aim == BlendAim::widening)
      continue;
    const BlendProblem p = with_coarseness(without, random);
    std::vector<Enumerated> expected = enumerated(without);
    const std::size_t all = expected.size();
    expected.erase(std::remove_if(expected.begin(), expected.end(),
                                  [&p](const Enumerated &e) { return !keeps_coarseness(p, e.second); }),
                   expected.end());
    BlendOptions o;
    o.best = 4;
    const BlendAnswer a = solve_blend(p, o);
    REQUIRE(a.best.size() == std::min<std::size_t>(4, expected.size()));
    for (std::size_t i = 0; i < a.best.size(); ++i) {
      CHECK(counts_of(a.best[i], p) == expected[i].second);
      CHECK(a.best[i].value == expected[i].first);
    }
    with_blends += !expected.empty();
    fewer += !expected.empty() && expected.size() < all;
  }
  CHECK(with_blends > 30);
  CHECK(fewer > 30);
}

TEST_CASE("of two stockpiles each limit of a contradiction is needed") {
  std::mt19937_64 random(2);
  int checked = 0;
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    BlendProblem p = random_problem(random);
    p.stockpiles.resize(2);
    p.aim = BlendAim::none;
    const BlendAnswer a = solve_blend(p);
    if (!a.contradiction)
      continue;
    // The shares of the second stockpile that keep all limits but one: an interval.
    for (std::size_t left_out = 0; left_out < a.contradiction->limits.size(); ++left_out) {
      Rational lo = 0, hi = 1;
      for (std::size_t i = 0; i < a.contradiction->limits.size(); ++i) {
        const BlendLimit &l = a.contradiction->limits[i].limit;
        if (i == left_out)
          continue;
        const bool is_share = l.kind == BlendLimit::Kind::share;
        const Rational at_0 = is_share ? Rational(l.index == 0 ? 1 : 0) : p.stockpiles[0].passing[l.index];
        const Rational at_1 = is_share ? Rational(l.index == 1 ? 1 : 0) : p.stockpiles[1].passing[l.index];
        const Rational slope = at_1 - at_0, bound = value_of(l, p);
        if (slope == 0) {
          if (l.is_upper ? at_0 > bound : at_0 < bound)
            hi = -1;
        } else if ((slope > 0) == l.is_upper) {
          hi = std::min(hi, Rational((bound - at_0) / slope));
        } else {
          lo = std::max(lo, Rational((bound - at_0) / slope));
        }
      }
      CHECK(lo <= hi);
      ++checked;
    }
  }
  CHECK(checked > 50);
}

TEST_CASE("a search that a limit ends says what is certain") {
  const BlendProblem p = four_stockpiles();
  BlendOptions o;
  o.node_limit = 1;
  const BlendAnswer a = solve_blend(p, o);
  CHECK((a.status == BlendAnswer::Status::unknown || a.status == BlendAnswer::Status::feasible));
  CHECK(a.bound >= ratio(193093911, 23865550));
  CHECK(a.bound <= parse_decimal("8.1167"));
  o.deadline = std::chrono::steady_clock::now();
  CHECK(solve_blend(p, o).status == BlendAnswer::Status::unknown);
}

TEST_CASE("no problem is refused") {
  const auto refuses = [](const std::function<void(BlendProblem &)> &change) {
    BlendProblem p = four_stockpiles();
    change(p);
    CHECK_THROWS_AS(solve_blend(p), InputError);
  };
  refuses([](BlendProblem &p) { p.stockpiles.clear(); });
  refuses([](BlendProblem &p) { p.steps = 0; });
  refuses([](BlendProblem &p) { p.steps = most_blend_steps + 1; });
  refuses([](BlendProblem &p) { p.at_most = 0; });
  refuses([](BlendProblem &p) { p.aim = BlendAim::deviation; });
  refuses([](BlendProblem &p) { p.stockpiles[2].cost = -1; });
  refuses([](BlendProblem &p) { p.stockpiles[2].least = 2; });
  refuses([](BlendProblem &p) { p.stockpiles[2].passing.pop_back(); });
  refuses([](BlendProblem &p) { p.widened = {9}; });
  BlendOptions none;
  none.best = 0;
  CHECK_THROWS_AS(solve_blend(four_stockpiles(), none), InputError);
}

} // namespace blend_test

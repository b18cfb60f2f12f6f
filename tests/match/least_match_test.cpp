#include "brute_force.hpp"
#include "catch.hpp"
#include "match/least_match.hpp"
#include "plain_gradation.hpp"

#include <limits>

namespace least_match_test {

using namespace mdm;

namespace {

/// Without doubles every decision is exact.
template <class Int>
SweepProblem<Int> without_doubles(const Problem &p) {
  SweepProblem<Int> sweep(p);
  for (SweepClass<Int> &c : sweep.classes)
    c.lower = c.per_upper = std::numeric_limits<double>::quiet_NaN();
  return sweep;
}

/// The match by every number tier; they must agree in counts and chain.
LeastMatch by_all_tiers(const Problem &p) {
  const LeastMatch exact = sweep(without_doubles<Integer>(p));
  const LeastMatch filtered = sweep(SweepProblem<Integer>(p));
  CHECK(filtered.q == exact.q);
  CHECK(filtered.chain == exact.chain);
  const LeastMatch chosen = least_match(p);
  CHECK(chosen.q == exact.q);
  CHECK(chosen.chain == exact.chain);
  try {
    for (const Swept<Int128> &fast : {sweep(SweepProblem<Int128>(p)), sweep(without_doubles<Int128>(p))}) {
      CHECK(fast.chain == exact.chain);
      for (std::size_t j = 0; j < exact.q.size(); ++j)
        CHECK(fast.q[j].to_integer() == exact.q[j]);
    }
  } catch (const Int128Overflow &) {
  }
  return exact;
}

std::vector<Integer> integers(const std::vector<long> &n) {
  return {n.begin(), n.end()};
}

} // namespace

TEST_CASE("a sieve series that divides exactly is decided at the open bound") {
  // q a < s <= q b with a = 1/2, b = 4 and a = 8, b = 27: from the second class s > 8, so the first needs 3,
  // not 2.
  const Problem p(gradation({1, 2, 3}, {2, 1, 0}), {}, 1);
  CHECK(by_all_tiers(p).q == integers({3, 1}));
}

TEST_CASE("a single class needs one particle") {
  CHECK(by_all_tiers(Problem(gradation({0, 1}, {5, 0}), {}, 1)).q == integers({1}));
  CHECK(by_all_tiers(Problem(gradation({0, 1}, {5, 0}), {}, 7)).q == integers({7}));
}

TEST_CASE("the least match is that of enumeration") {
  std::mt19937_64 random(5);
  int decided = 0;
  for (int i = 0; i < 3000; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Integer floor = static_cast<int>(1 + random() % 3);
    const brute::Problem b = brute::problem(g, floor);
    const auto expected = brute::least_match(b, brute::some_scale(b));
    const Problem p(g, {}, floor);
    const LeastMatch found = by_all_tiers(p);
    if (expected) {
      ++decided;
      CHECK(found.q == *expected);
    } else {
      CHECK(p.highest_scale(found.q) * p.scale_unit() > brute::some_scale(b));
    }
  }
  CHECK(decided >= 2900);
}

TEST_CASE("masses at the edges of machine words are decided exactly") {
  std::mt19937_64 random(6);
  for (const unsigned bits : {31U, 53U, 63U, 64U, 127U, 200U})
    for (int i = 0; i < 100; ++i) {
      const Gradation small = brute::random_gradation(random);
      std::vector<Rational> masses = small.masses();
      for (Rational &m : masses)
        if (m > 0)
          m = m * Rational(Integer(1) << bits) + static_cast<int>(random() % 3) - 1;
      const Gradation g = gradation(small.sizes(), masses);
      const brute::Problem b = brute::problem(g, 1);
      const auto expected = brute::least_match(b, brute::some_scale(b));
      const LeastMatch found = by_all_tiers(Problem(g, {}, 1));
      if (expected)
        CHECK(found.q == *expected);
    }
}

TEST_CASE("the steps are within the bound, and one is enough where every class is wide") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    const Problem p(brute::random_gradation(random), {}, 1);
    Integer bound = 1;
    bool wide = true;
    for (const ProblemClass &c : p.classes()) {
      bound += std::max(Integer(0), Integer(ceil_div(c.f, c.F - c.f) - c.floor));
      wide = wide && c.F >= 2 * c.f;
    }
    const LeastMatch found = least_match(p);
    CHECK(found.chain.size() <= bound);
    if (wide)
      CHECK(found.chain.size() <= 1);
  }
}

TEST_CASE("the cost does not depend on the size of N") {
  // 10^300 particles of the fine class.
  const Problem p(
      gradation({0, 1, Rational(power_of_ten(100)), Rational(2 * power_of_ten(100))}, {1, 0, 1, 0}), {}, 1);
  CHECK(by_all_tiers(p).q[0] == power_of_ten(300) + 1);
}

TEST_CASE("power laws are decided by powers") {
  // f = sqrt on (1, 2] and (2, 4], equal masses: q1 < s <= q1 sqrt 2 and q2 sqrt 2 < s <= 2 q2. From s > sqrt
  // 2 on, q1 = 2 asks for s > 2, q2 = 2 for s > 2 sqrt 2, an irrational tie with 2 q1, so q1 = 3; then (3, 4]
  // is left.
  const MassLaw root{1, 2};
  const Problem p(gradation({1, 2, 4}, {1, 1, 0}), root, 1);
  CHECK(by_all_tiers(p).q == integers({3, 2}));
  // 128 sqrt 2 on both sides: f = x^(1/2), m = (1, 128): a tie of irrational numbers.
  const Problem tie(gradation({0, 2, 32768, 65536}, {1, 0, 128, 0}), root, 1);
  const LeastMatch found = by_all_tiers(tie);
  // s > sqrt(32768) / 128 = sqrt 2, and the first class holds s <= q sqrt 2: more than one.
  CHECK(found.q == integers({2, 1}));
}

TEST_CASE("an interrupted sweep leaves true bounds") {
  std::mt19937_64 random(8);
  int interrupted = 0;
  for (int i = 0; i < 400; ++i) {
    const Problem p(brute::random_gradation(random), {}, 1);
    const Integer n = total(least_match(p).q);
    CHECK(n <= total(some_match(p)));
    CHECK(p.lowest_scale(some_match(p)) < p.highest_scale(some_match(p)));
    for (std::uint64_t steps = 0; steps < 4; ++steps) {
      const LeastMatch part = least_match(p, {steps, std::nullopt});
      if (part.complete) {
        CHECK(total(part.q) == n);
        continue;
      }
      ++interrupted;
      CHECK(part.chain.size() == steps);
      CHECK(total(part.q) <= n);
    }
  }
  CHECK(interrupted >= 400);
}

TEST_CASE("a passed deadline stops a long sweep") {
  std::vector<Rational> sizes, masses;
  for (int j = 0; j <= 8; ++j) {
    sizes.push_back(power(ratio(1000000 + 1, 1000000), static_cast<unsigned>(j)));
    masses.emplace_back(j == 8 ? 0 : 1 + j * j % 7);
  }
  const Problem p(gradation(sizes, masses), {}, 1);
  const LeastMatch part = least_match(p, {std::nullopt, std::chrono::steady_clock::now()});
  CHECK_FALSE(part.complete);
  CHECK(total(part.q) <= total(some_match(p)));
}

TEST_CASE("a start is nothing but floors") {
  std::mt19937_64 random(9);
  for (int i = 0; i < 500; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Problem p(g, {}, 1);
    const Rational start = ratio(static_cast<int>(1 + random() % 2000), static_cast<int>(1 + random() % 20));
    const brute::Problem b = brute::problem(g, 1);
    const auto expected = brute::least_match(b, brute::some_scale(b), start);
    const LeastMatch found = by_all_tiers(p.from_scale(Rational(start / p.scale_unit()), false));
    if (expected)
      CHECK(found.q == *expected);
    CHECK(p.highest_scale(found.q) * p.scale_unit() >= start);
  }
}

} // namespace least_match_test

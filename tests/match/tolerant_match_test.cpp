#include "catch.hpp"
#include "match/least_match.hpp"
#include "match/problem_of.hpp"
#include "match/tolerant_match.hpp"
#include "plain_gradation.hpp"
#include "tolerant_twins.hpp"

#include <mdm/match/solve.hpp>

#include <ctime>

namespace tolerant_match_test {

using namespace mdm;
using namespace tolerant_twins;

TEST_CASE("a lower bound is strict only for a class that holds particles") {
  // (0, 2], (2, 5], (5, 9] within 25 points of (50, 25, 25): the middle class may be empty, and then holds
  // no mass. Strict everywhere would give 4, closed everywhere 2.
  const Gradation g = gradation({0, 2, 5, 9}, {2, 1, 1, 0});
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::retained, 25), {}}) == 3);
}

TEST_CASE("whole counts on excluded bounds are no match") {
  // (1, 2], (2, 3] within 10 points in sum of (20, 80): one particle of 2 and one of 3 touch the bounds.
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::total, 10), {}}) == 3);
}

TEST_CASE("a sample has at least one particle") {
  const Gradation g = gradation({0, 2, 5, 9}, {2, 1, 1, 0});
  for (const Kind kind : {Kind::retained, Kind::passing})
    CHECK(least_particles({g, by_length, tolerance_of(g, kind, 100), {}}) == 1);
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::total, 100), {}}) == 1);
}

TEST_CASE("a tolerance of nothing is the exact problem") {
  std::mt19937_64 random(41);
  for (int i = 0; i < 200; ++i) {
    const Gradation g = random_gradation(random, 4);
    const Integer exact = total(least_match(Problem(g, {}, 1)).q);
    for (const Kind kind : {Kind::retained, Kind::passing, Kind::total})
      CHECK(least_particles({g, {}, tolerance_of(g, kind, 0), {}}) == exact);
  }
}

TEST_CASE("a volume is that of the particles, whatever their density") {
  // Spheres of up to 3: 27 in units of pi / 6 each, although one of them weighs 4 times 27.
  Gradation::Data data;
  data.sizes = {1, 2, 3};
  data.masses = {1, 1, 0};
  data.factors = {1, 4, 1};
  const Gradation g((Gradation::Data(data)));
  TolerantDemands demands;
  demands.weight = 81;
  CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 100), demands}) == 3);
  demands.weight = 82;
  CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 100), demands}) == 4);
}

TEST_CASE("a volume within no tolerance is that of the exact problem, densities included") {
  std::mt19937_64 random(45);
  int with_factors = 0;
  for (int i = 0; i < 150; ++i) {
    const Gradation g = random_gradation(random, 4);
    with_factors += g.has_factors() ? 1 : 0;
    Question exact;
    exact.solids = SolidsVolume{Rational(static_cast<int>(1 + random() % 900))};
    Question tolerant = exact;
    tolerant.tolerances = {{Kind::retained, 0}};
    const Match found = solve(g, tolerant, {});
    REQUIRE(found.status == Status::optimal);
    CHECK(found.particles() == solve(g, exact, {}).particles());
  }
  CHECK(with_factors >= 32);
}

TEST_CASE("the least number within a tolerance is that of enumeration") {
  std::mt19937_64 random(42);
  int none = 0, decided = 0;
  for (int i = 0; i < 1000; ++i) {
    const Twins twins = random_twins(random, i % 4 == 0 ? 4 : 3);
    const TolerantResult found = tolerant_match(twins.problem);
    REQUIRE(found.complete);
    CHECK(refutes(twins, found));
    const int limit = twins.brute.classes.size() == 4 ? 7 : 11;
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, limit);
    INFO("problem " << i);
    if (!found.best) {
      ++none;
      CHECK_FALSE(least.has_value());
      continue;
    }
    check_match(twins, *found.best);
    CHECK(twins.problem.is_match(found.best->q, found.best->t));
    CHECK(found.lower_bound == total(found.best->q));
    if (least)
      CHECK(total(found.best->q) == *least);
    else
      CHECK(total(found.best->q) > limit);
    decided += least ? 1 : 0;
  }
  CHECK(decided >= 900);
  CHECK(none >= 25);
}

TEST_CASE("a search that is stopped leaves a match and a bound that are true") {
  std::mt19937_64 random(43);
  int stopped = 0;
  for (int i = 0; i < 6000; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult all = tolerant_match(twins.problem);
    for (std::uint64_t nodes = 0; nodes < std::min<std::uint64_t>(all.nodes, 12); ++nodes) {
      Limits limits;
      limits.node_limit = nodes;
      const TolerantResult part = tolerant_match(twins.problem, limits);
      CHECK(part.nodes == nodes);
      if (part.complete) { // its bound was as many as the best has
        CHECK(total(part.best->q) == total(all.best->q));
        continue;
      }
      CHECK_FALSE(part.tree.empty());
      CHECK(part.proved == part.lower_bound);
      ++stopped;
      if (part.best) {
        check_match(twins, *part.best);
        CHECK(part.lower_bound <= total(part.best->q));
      }
      if (all.best)
        CHECK(part.lower_bound <= total(all.best->q));
    }
  }
  CHECK(stopped >= 800);
}

TEST_CASE("a search has the same result twice") {
  std::mt19937_64 random(44);
  for (int i = 0; i < 100; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult a = tolerant_match(twins.problem), b = tolerant_match(twins.problem);
    CHECK(a.nodes == b.nodes);
    CHECK(a.tree.size() == b.tree.size());
    CHECK(a.best.has_value() == b.best.has_value());
    if (a.best) {
      CHECK(a.best->q == b.best->q);
      CHECK(a.best->t == b.best->t);
    }
  }
}

TEST_CASE("a band without a curve has no match of any number") {
  const Gradation g = gradation({0, 1, 2, 4}, {1, 1, 1, 0});
  const Twins crossing(g, {}, {{}, {{ratio(1, 2), 1}, {0, ratio(1, 4)}, {0, 1}}, {}}, {});
  const Twins not_all(g, {}, {{}, {{0, 1}, {0, 1}, {0, ratio(9, 10)}}, {}}, {});
  const Twins below_nothing(g, {}, {{{0, 1}, {ratio(1, 2), ratio(1, 4)}, {0, 1}}, {}, {}}, {});
  for (const Twins *twins : {&crossing, &not_all, &below_nothing}) {
    const TolerantResult found = tolerant_match(twins->problem);
    CHECK(found.complete);
    CHECK_FALSE(found.best.has_value());
    CHECK(refutes(*twins, found));
  }
}

TEST_CASE("many particles can be asked for without an end of the search") {
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  for (const Integer &n : {Integer(4), Integer(11), Integer(1000), power_of_ten(18)})
    CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 2), {1, n, {}}}) == n);
}

namespace {

std::vector<Rational> in_units_of(const TolerantProblem &problem, std::vector<Rational> masses) {
  for (Rational &t : masses)
    t *= problem.unit();
  return masses;
}

/// Classes of the same ratio, as narrow as a sieve analysis never has them.
Gradation geometric(int classes) {
  std::vector<Rational> sizes{1}, masses;
  for (int j = 0; j < classes; ++j) {
    sizes.push_back(ratio(floor(Rational(sizes.back() * 10400)), 10000));
    masses.emplace_back(1 + j * 7 % 11);
  }
  masses.emplace_back(0);
  return gradation(std::move(sizes), std::move(masses));
}

} // namespace

TEST_CASE("a tolerance of nothing needs no search, however many classes there are") {
  const Gradation g = geometric(100);
  const Match exact = solve(g);
  for (const Kind kind : {Kind::retained, Kind::passing, Kind::total}) {
    Question question;
    question.tolerances = {{kind, 0}};
    const Match m = solve(g, question);
    CHECK(m.status == Status::optimal);
    CHECK(m.particles() == exact.particles());
    const Twins twins(g, {}, *m.tolerance, {});
    const TolerantMatch found{m.sample->quantities, in_units_of(twins.problem, class_masses(m))};
    const TolerantResult again = tolerant_match(twins.problem, {}, found);
    CHECK(again.nodes == 0);
    CHECK(refutes(twins, again));
    CHECK(TreeReader(twins, std::get<Tree>(*m.evidence()), *m.particles()).holds());
  }
}

TEST_CASE("the time for many classes grows as their number") {
  const auto seconds = [](int classes) {
    std::vector<Rational> sizes = {1}, masses;
    for (int j = 1; j <= classes; ++j) {
      sizes.emplace_back(j + 1);
      masses.emplace_back(1 + j % 7);
    }
    masses.emplace_back(0);
    Question question;
    question.tolerances = {{AskedTolerance::Kind::retained, 1}};
    const std::clock_t start = std::clock();
    SolveOptions options;
    options.limits.max_steps = 100;
    options.limits.node_limit = 0;
    CHECK_FALSE(solve(gradation(sizes, masses), question, options).complete);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const double once = seconds(4000);
  CHECK(seconds(32000) < 24 * once + 1); // the square is 64
}

TEST_CASE("a deadline ends a search before its first node is done") {
  Question question;
  question.tolerances = {{Kind::passing, ratio(1, 2)}};
  SolveOptions options;
  const auto start = std::chrono::steady_clock::now();
  options.limits.deadline = start + std::chrono::milliseconds(100);
  const Match m = solve(geometric(150), question, options);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  CHECK(m.status == Status::feasible);
  CHECK(m.lower_bound > 1);
  CHECK(m.lower_bound <= m.particles());
}

TEST_CASE("where a search would not fit into memory the exact match is the answer") {
  const Gradation g = geometric(1100);
  Question question;
  question.tolerances = {{Kind::retained, 1}};
  const Match m = solve(g, question);
  CHECK(m.status == Status::feasible);
  CHECK(m.particles() == solve(g).particles());
  CHECK(m.lower_bound < m.particles());
  CHECK(std::any_of(m.notes.begin(), m.notes.end(),
                    [](const std::string &note) { return note.find("memory") != std::string::npos; }));
}

TEST_CASE("more particles than may be end a search") {
  const Gradation g = gradation({4, 5, 6, 7, 8}, {1, 3, 2, 5, 0});
  Question question;
  question.tolerances = {{Kind::retained, 1}};
  const Match least = solve(g, question);
  REQUIRE(least.status == Status::optimal);
  SolveOptions options;
  options.at_most = *least.particles() - 1;
  const Match none = solve(g, question, options);
  CHECK(none.status == Status::none);
  CHECK(none.lower_bound > *options.at_most);
  options.at_most = least.particles();
  CHECK(solve(g, question, options).status == Status::optimal);
  options.at_most = 1;
  CHECK(solve(g, question, options).status == Status::none);
  const TolerantProblem problem = tolerant_problem_of(least);
  Limits limits;
  limits.at_most = 1;
  CHECK(tolerant_match(problem, limits).nodes <= tolerant_match(problem).nodes);
}

} // namespace tolerant_match_test

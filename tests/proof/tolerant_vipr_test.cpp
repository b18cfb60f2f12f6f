#include "catch.hpp"
#include "match/brute_force.hpp"
#include "match/problem_of.hpp"
#include "match/tolerant_match.hpp"
#include "proof/vipr.hpp"
#include "vipr_checker.hpp"

#include <mdm/match/solve.hpp>

namespace tolerant_vipr_test {

using namespace mdm;

namespace {

Question random_question(std::mt19937_64 &random) {
  using Kind = AskedTolerance::Kind;
  const Kind kinds[] = {Kind::retained, Kind::passing, Kind::total};
  const Rational percents[] = {0, 1, 5, ratio(25, 2), 20, 25, 50, 100};
  Question q;
  q.tolerances = {{kinds[random() % 3], percents[random() % 8]}};
  if (random() % 4 == 0)
    q.tolerances.push_back({kinds[random() % 3], percents[random() % 8]});
  if (random() % 3 == 0)
    q.min_per_class = static_cast<int>(1 + random() % 4);
  if (random() % 3 == 0)
    q.at_least = static_cast<int>(1 + random() % 20);
  if (random() % 4 == 0)
    q.solids =
        Cylinder{static_cast<int>(1 + random() % 20), static_cast<int>(1 + random() % 20), ratio(7, 10)};
  return q;
}

/// The particles and masses of a match as values of the export's variables: d the least of the excesses over
/// lower bounds and the mass, y_j = 1 where class j is not empty.
std::map<std::size_t, Rational> values_of(const Match &m) {
  const TolerantProblem problem = tolerant_problem_of(m);
  TolerantMatch best{m.sample->quantities, class_masses(m)};
  for (Rational &t : best.t)
    t *= problem.unit();
  const std::size_t k = problem.classes(), d = problem.variables();
  std::map<std::size_t, Rational> x;
  Rational mass = 0;
  for (const Rational &t : best.t)
    mass += t;
  x[d] = mass;
  const std::vector<Rational> target = shares(m.gradation);
  for (std::size_t j = 0; j < k; ++j) {
    x[j] = Rational(best.q[j]);
    x[k + j] = best.t[j];
    x[d + 1 + j] = best.q[j] > 0 ? 1 : 0;
    if (best.q[j] > 0)
      x[d] = std::min(x[d], Rational(best.t[j] - Rational(problem.f(j) * best.q[j])));
    if (d == 3 * k)
      x[2 * k + j] = std::max(Rational(0), Rational(best.t[j] - target[j] * mass));
  }
  return x;
}

} // namespace

TEST_CASE("the VIPR export of a tolerance proves that fewer particles leave no slack") {
  std::mt19937_64 random(51);
  int searched = 0;
  for (int i = 0; i < 500; ++i) {
    const Match m = solve(brute::random_gradation(random), random_question(random));
    REQUIRE(m.complete);
    const std::string text = vipr(m);
    INFO(text);
    REQUIRE_NOTHROW(vipr_checker::Checker(text).check_at_most(0));
    searched += std::get<Tree>(*m.evidence()).size() > 1 ? 1 : 0;
    // The problem of the file is no harder than it may be: of N + 1 it has the match as a solution, d > 0,
    // and is not refuted.
    Match more = m;
    for (Integer &q : more.sample->quantities)
      if (q > 0) {
        ++q;
        break;
      }
    const std::string wrong = vipr(more);
    const std::map<std::size_t, Rational> x = values_of(m);
    REQUIRE(x.at(tolerant_problem_of(m).variables()) > 0);
    REQUIRE(vipr_checker::Checker(wrong).admits(x));
    REQUIRE_FALSE(vipr_checker::Checker(text).admits(x));
    REQUIRE_THROWS(vipr_checker::Checker(wrong).check_at_most(0));
  }
  CHECK(searched >= 150);
}

TEST_CASE("a band without a curve is refuted for any number of particles") {
  Gradation::Data data;
  data.sizes = {0, 1, 2, 4};
  data.masses = {1, 1, 1, 0};
  Question q;
  q.band = Envelope{"", SizeUnit::mm, {1, 2}, {50, 0}, {100, 25}, {}};
  const Match none = solve(Gradation(data), q);
  REQUIRE(none.status == Status::none);
  CHECK_NOTHROW(vipr_checker::Checker(vipr(none)).check_at_most(0));
  q.band->passing_max = {100, 100};
  const Match some = solve(Gradation(data), q);
  CHECK(some.status == Status::optimal);
  CHECK_NOTHROW(vipr_checker::Checker(vipr(some)).check_at_most(0));
}

} // namespace tolerant_vipr_test

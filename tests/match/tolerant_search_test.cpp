#include "match/problem.hpp"
#include "match/share_closure.hpp"
#include "match/tolerant_search.hpp"
#include "tolerant_twins.hpp"

namespace tolerant_search_test {

using namespace mdm;
using namespace tolerant_twins;

namespace {

struct Counts {
  int decided = 0, split = 0;
};

/// Searches random problems, by windows from a mass on if that is given.
Counts search_all(unsigned seed, int problems, const std::optional<Rational> &mass) {
  std::mt19937_64 random(seed);
  int decided = 0, split = 0;
  for (int i = 0; i < problems; ++i) {
    const Twins twins = random_twins(random, i % 4 == 0 ? 4 : 3);
    const ShareClosure shares(twins.problem);
    if (shares.contradicts())
      continue;
    std::optional<TolerantMatch> best;
    Limits limits;
    limits.node_limit = 5000;
    TolerantSearch search(twins.problem, least_counts(twins.problem), 0, best, limits, {}, mass);
    search.run();
    INFO("problem " << i);
    CHECK(search.is_complete());
    if (!search.is_complete())
      continue;
    split += search.nodes() > 1 ? 1 : 0;
    const int limit = twins.brute.classes.size() == 4 ? 7 : 11;
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, limit);
    if (!best) {
      CHECK_FALSE(least.has_value());
      CHECK(TreeReader(twins, search.tree(), std::nullopt).holds());
      continue;
    }
    const Integer n = total(best->q);
    check_match(twins, *best);
    CHECK(TreeReader(twins, search.tree(), n).holds());
    CHECK_FALSE(TreeReader(twins, search.tree(), Integer(n + 1)).holds());
    CHECK((least ? n == *least : n > limit));
    decided += least ? 1 : 0;
  }
  return {decided, split};
}

} // namespace

TEST_CASE("a search without the chain's bounds has the least number of enumeration, and proves it") {
  const Counts found = search_all(48, 800, std::nullopt);
  CHECK(found.decided >= 650);
  CHECK(found.split >= 200);
}

TEST_CASE("a search by windows of the mass has the least number of enumeration, and proves it") {
  for (const Rational &mass : {Rational(1), ratio(1, 7), Rational(400)}) {
    const Counts found = search_all(49, 300, mass);
    CHECK(found.decided >= 240);
    CHECK(found.split >= 75);
  }
}

/// Openings with masses, factors of their classes, and f(x) = x times the factor.
TolerantProblem linear_problem(const std::vector<std::array<int, 3>> &rows, const Tolerance &tolerance) {
  Gradation::Data data;
  for (const auto &[opening, mass, factor] : rows) {
    data.sizes.emplace_back(opening);
    data.masses.emplace_back(mass);
    data.factors.emplace_back(factor);
  }
  return TolerantProblem(Gradation(std::move(data)), MassLaw{1, 1}, tolerance, {});
}

TEST_CASE("a search by windows ends soon where fewer particles would do at an excluded mass alone") {
  Tolerance passing, retained;
  passing.passing = {{ratio(3, 10), ratio(9, 10)}, {ratio(3, 5), ratio(9, 10)}, {1, 1}};
  retained.retained = {{ratio(2, 21), ratio(16, 21)}, {0, ratio(23, 42)}, {ratio(1, 42), ratio(29, 42)}};
  for (const TolerantProblem &problem :
       {linear_problem({{5, 2, 1}, {6, 5, 1}, {8, 0, 1}, {9, 0, 1}}, passing),
        linear_problem({{0, 6, 1}, {2, 3, 4}, {4, 5, 3}, {8, 0, 1}}, retained)}) {
    std::optional<TolerantMatch> best;
    Limits limits;
    limits.node_limit = 200;
    TolerantSearch search(problem, least_counts(problem), 0, best, limits, {}, Rational(1));
    search.run();
    CHECK(search.is_complete());
    CHECK(search.certain() == 4);
  }
}

TEST_CASE("searches by windows of ten thousand problems agree with enumeration", "[.long]") {
  CHECK(search_all(50, 10000, Rational(1)).decided >= 8000);
}

} // namespace tolerant_search_test

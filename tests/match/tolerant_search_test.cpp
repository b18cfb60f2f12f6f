#include "match/problem.hpp"
#include "match/tolerant_search.hpp"
#include "tolerant_twins.hpp"

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
    TolerantSearch search(twins.problem, shares, least_counts(twins.problem), 0, nullptr, best, limits, {},
                          mass);
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

TEST_CASE("searches by windows of ten thousand problems agree with enumeration", "[.long]") {
  CHECK(search_all(50, 10000, Rational(1)).decided >= 8000);
}

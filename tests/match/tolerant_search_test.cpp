#include "match/problem.hpp"
#include "match/tolerant_search.hpp"
#include "tolerant_twins.hpp"

using namespace mdm;
using namespace tolerant_twins;

TEST_CASE("a search without the chain's bounds has the least number of enumeration, and proves it") {
  std::mt19937_64 random(48);
  int decided = 0, split = 0;
  for (int i = 0; i < 800; ++i) {
    const Twins twins = random_twins(random, i % 4 == 0 ? 4 : 3);
    const ShareClosure shares(twins.problem);
    if (shares.contradicts())
      continue;
    CountBounds bounds;
    for (std::size_t j = 0; j < twins.problem.classes(); ++j)
      bounds.classes.push_back({twins.problem.least(j), std::nullopt});
    std::optional<TolerantMatch> best;
    TolerantSearch search(twins.problem, shares, bounds, 0, nullptr, best, {}, {});
    search.run();
    INFO("problem " << i);
    REQUIRE(search.is_complete());
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
  CHECK(decided >= 650);
  CHECK(split >= 200);
}

#include "all_cases.hpp"
#include "match/tolerant_chain_proof.hpp"
#include "tolerant_twins.hpp"

namespace tolerant_chain_proof_test {

using namespace mdm;
using namespace tolerant_twins;

TEST_CASE("the chain's counts are proved, and are not above the least number") {
  std::mt19937_64 random(46);
  const int trials = takes_all_cases() ? 1500 : 750;
  int reached = 0, more = 0, none = 0;
  for (int i = 0; i < trials; ++i) {
    const Twins twins = random_twins(random, 4);
    const ShareClosure shares(twins.problem);
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, 7);
    if (shares.contradicts()) {
      CHECK(TreeReader(twins, share_contradiction(twins.problem, shares), std::nullopt).holds());
      CHECK_FALSE(least.has_value());
      ++none;
      continue;
    }
    for (const bool all_intervals : {false, true}) {
      const TolerantChain chain(twins.problem, shares, all_intervals, {}, {});
      CHECK(chain.complete() != chain.contradicts());
      if (chain.contradicts()) {
        CHECK(TreeReader(twins, chain_contradiction(chain), std::nullopt).holds());
        CHECK_FALSE(least.has_value());
        continue;
      }
      CHECK(TreeReader(twins, chain_tree(chain), chain.particles()).holds());
      CHECK_FALSE(TreeReader(twins, chain_tree(chain), Integer(chain.particles() + 1)).holds());
      if (!least)
        continue;
      CHECK(chain.particles() <= *least);
      reached += chain.particles() == *least ? 1 : 0;
      more += chain.particles() > 1 ? 1 : 0;
    }
  }
  CHECK(reached >= trials);
  CHECK(more * 10 >= trials * 8);
  CHECK(none * 75 >= trials);
}

TEST_CASE("counts that a volume demands are proved, whatever the densities") {
  std::mt19937_64 random(47);
  for (int i = 0; i < 300; ++i) {
    const Gradation g = random_gradation(random, 4);
    TolerantDemands demands;
    demands.weight = static_cast<int>(1 + random() % 900);
    const Kind kinds[] = {Kind::retained, Kind::passing, Kind::total};
    const Twins twins(g, {}, tolerance_of(g, kinds[random() % 3], random_percent(random)), demands);
    const ShareClosure shares(twins.problem);
    REQUIRE_FALSE(shares.contradicts());
    for (const bool all_intervals : {false, true}) {
      const TolerantChain chain(twins.problem, shares, all_intervals, {}, {});
      CHECK(TreeReader(twins, chain_tree(chain), chain.particles()).holds());
    }
  }
}

} // namespace tolerant_chain_proof_test

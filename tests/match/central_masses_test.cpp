#include "match/central_masses.hpp"
#include "tolerant_twins.hpp"

namespace central_masses_test {

using namespace mdm;
using namespace tolerant_twins;

TEST_CASE("central masses are a match, and fail where there is none") {
  std::mt19937_64 random(45);
  for (int i = 0; i < 300; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult found = tolerant_match(twins.problem);
    if (!found.best)
      continue;
    const auto t = central_masses(twins.problem, found.best->q, twins.brute.demands.weight, ratio(1, 1000));
    REQUIRE(t.has_value());
    check_match(twins, {found.best->q, *t});
  }
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  const Twins twins(g, by_length, tolerance_of(g, Kind::total, 10), {});
  CHECK_FALSE(central_masses(twins.problem, {1, 1}, std::nullopt, 0).has_value());
}

} // namespace central_masses_test

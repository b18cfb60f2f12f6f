// The finest classes that have 90 % of the particles and 5 % of the mass.

#include "catch.hpp"
#include "match/costly_fines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

namespace costly_fines_test {

using namespace mdm;

namespace {

/// A match with these quantities, whatever they match.
std::optional<CostlyFines> fines_of(const std::vector<std::string> &masses,
                                    const std::vector<int> &quantities) {
  std::vector<std::string> sizes;
  for (std::size_t j = 0; j < masses.size(); ++j)
    sizes.push_back(std::to_string(j + 1));
  Match m = solve(gradation_of(sizes, masses));
  m.sample->quantities.assign(quantities.begin(), quantities.end());
  return costly_fines(m);
}

} // namespace

TEST_CASE("fines are costly from 90 % of the particles and up to 5 % of the mass on", "[match]") {
  const std::optional<CostlyFines> both = fines_of({"5", "95", "0"}, {90, 10});
  REQUIRE(both);
  CHECK(both->below.text() == "2");
  CHECK(both->particles == ratio(9, 10));
  CHECK(both->mass == ratio(1, 20));
  CHECK_FALSE(fines_of({"5", "95", "0"}, {89, 10}));
  CHECK_FALSE(fines_of({"5.0001", "94.9999", "0"}, {90, 10}));
}

TEST_CASE("as few classes as have 90 % of the particles are counted", "[match]") {
  const std::optional<CostlyFines> two = fines_of({"1", "2", "1", "96", "0"}, {50, 45, 4, 1});
  REQUIRE(two);
  CHECK(two->below.text() == "3");
  CHECK(two->mass == ratio(3, 100));
  CHECK_FALSE(fines_of({"1", "2", "97", "0"}, {50, 30, 20}));
}

TEST_CASE("without an answer no fines are costly", "[match]") {
  SolveOptions options;
  options.at_most = 1;
  CHECK_FALSE(costly_fines(solve(gradation_of({"1", "2", "30"}, {"1", "999", "0"}), {}, options)));
}

} // namespace costly_fines_test

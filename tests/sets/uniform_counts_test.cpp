// Particles shared out so that means are those of sizes uniform by volume.

#include "catch.hpp"
#include "plain_gradation.hpp"
#include "sets/uniform_counts.hpp"

namespace uniform_counts_test {

using namespace mdm;

namespace {

std::optional<UniformCounts> counts(const Gradation &g, const Integer &least, const Integer &n,
                                    unsigned dimension = 2) {
  return uniform_counts(g, Problem(g, MassLaw{dimension, 1}, least), n);
}

} // namespace

TEST_CASE("the mean of sizes uniform by volume") {
  CHECK(uniform_mean(1, 2, 2) == 2);
  CHECK(uniform_mean(1, 2, 3) == ratio(8, 3));
  CHECK(uniform_mean(0, 2, 3) == 4);
}

TEST_CASE("counts are shares by volume where these are whole numbers") {
  // Mean areas 2 and 8: 3 / 2 and 16 / 8 particles a unit of scale.
  const Gradation g = gradation({1, 2, 4}, {3, 16, 0});
  const std::optional<UniformCounts> c = counts(g, 1, 700);
  REQUIRE(c);
  CHECK(c->q == std::vector<Integer>{300, 400});
  const Problem problem(g, MassLaw{2, 1}, 1);
  CHECK(farthest_mean(g, problem, c->q, c->scale) < ratio(1, 100000000));
  CHECK(farthest_mean(g, problem, c->q, 200) == 0);
  CHECK(farthest_mean(g, problem, c->q, 300) == ratio(1, 2));
}

TEST_CASE("the largest rests are rounded up, and the sum is met") {
  const std::optional<UniformCounts> c = counts(gradation({1, 2, 4}, {3, 16, 0}), 1, 9);
  REQUIRE(c);
  CHECK(c->q == std::vector<Integer>{4, 5}); // of 3.86 and 5.14
}

TEST_CASE("a class has its floor where its share is less, and the others have the rest") {
  const std::optional<UniformCounts> c = counts(gradation({1, 2, 4, 8}, {60, 64, 224, 0}), 10, 45);
  REQUIRE(c);
  CHECK(c->q == std::vector<Integer>{25, 10, 10}); // of 30, 8 and 7
}

TEST_CASE("no counts are given where a mean would leave its class") {
  const Gradation narrow = gradation({100, 101, 102}, {10, 11, 0});
  CHECK_FALSE(counts(narrow, 1, 3));
  CHECK(counts(narrow, 1, 2100));
  CHECK_FALSE(counts(gradation({1, 2, 40}, {1000, 1, 0}), 10, 40));
}

TEST_CASE("floors that take all particles are counts") {
  const std::optional<UniformCounts> c = counts(gradation({1, 2, 4}, {3, 16, 0}), 10, 20);
  REQUIRE(c);
  CHECK(c->q == std::vector<Integer>{10, 10});
}

} // namespace uniform_counts_test

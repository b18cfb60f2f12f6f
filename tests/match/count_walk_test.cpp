#include "catch.hpp"
#include "match/count_walk.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

namespace count_walk_test {

using namespace mdm;

namespace {

using Classes = std::vector<CountWalk::Class>;

/// Masses from one to the other, with bounds on counts or none.
NearWindow window(double above, double up_to, std::vector<double> least, std::vector<double> most) {
  NearWindow window({}, {});
  window.above = above;
  window.up_to = up_to;
  window.least = std::move(least);
  window.most = std::move(most);
  return window;
}
NearWindow window(double above, double up_to, std::size_t classes) {
  return window(above, up_to, std::vector<double>(classes, 0),
                std::vector<double>(classes, std::numeric_limits<double>::infinity()));
}

double uniform(std::mt19937_64 &random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// Bounds around some curve, sometimes none, or those that fix nothing.
Classes random_classes(std::mt19937_64 &random) {
  Classes classes;
  const std::size_t k = 2 + random() % 3;
  double size = random() % 3 == 0 ? 0 : uniform(random, 0.5, 2);
  std::vector<double> shares;
  for (std::size_t j = 0; j < k; ++j)
    shares.push_back(random() % 4 == 0 ? 0 : uniform(random, 0, 1));
  shares.push_back(0.1);
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double of_class = uniform(random, 0, 0.4), of_sieve = uniform(random, 0, 0.4);
  const bool has_retained = random() % 2 == 0, has_passing = !has_retained || random() % 2 == 0;
  double passing = 0;
  for (std::size_t j = 0; j <= k; ++j) {
    const double share = shares[j] / all, next = size + uniform(random, 0.2, 2);
    passing += share;
    CountWalk::Class c{size, next, {0, 1}, {0, 1}};
    if (has_retained)
      c.share = {std::max(0.0, share - of_class), std::min(1.0, share + of_class)};
    if (has_passing)
      c.passing = {std::max(0.0, passing - of_sieve), std::min(1.0, passing + of_sieve)};
    classes.push_back(c);
    size = next;
  }
  classes.back().passing = {1, 1};
  return classes;
}

/// True if there are masses for the counts: by all sums of consecutive classes.
bool can_have(const Classes &classes, const std::vector<double> &q, double mass) {
  const std::size_t k = classes.size();
  for (std::size_t i = 0; i < k; ++i) {
    double low = 0, high = 0;
    for (std::size_t j = i; j < k; ++j) {
      const CountWalk::Class &c = classes[j];
      const double least = q[j] > 0 ? std::max(q[j] * c.f, c.share.lo * mass) : 0;
      const double most = q[j] > 0 ? std::min(q[j] * c.F, c.share.hi * mass) : 0;
      if (least > most || most < c.share.lo * mass)
        return false;
      low += least;
      high += most;
      const ShareBand before = i == 0 ? ShareBand{0, 0} : classes[i - 1].passing;
      if (high < (c.passing.lo - before.hi) * mass || low > (c.passing.hi - before.lo) * mass)
        return false;
    }
  }
  return true;
}

/// The fewest particles, at most 9; infinite where there are more.
double fewest(const Classes &classes, double mass, const std::vector<double> &least,
              const std::vector<double> &most) {
  double best = std::numeric_limits<double>::infinity();
  std::vector<double> q(classes.size());
  const std::function<void(std::size_t, double)> count = [&](std::size_t j, double so_far) {
    if (j == q.size()) {
      if (can_have(classes, q, mass))
        best = std::min(best, so_far);
      return;
    }
    for (q[j] = least[j]; q[j] <= most[j] && so_far + q[j] <= std::min(9.0, best); ++q[j])
      count(j + 1, so_far + q[j]);
  };
  count(0, 0);
  return best;
}

} // namespace

TEST_CASE("a walk over the classes finds the fewest particles of enumeration", "[count_walk]") {
  std::mt19937_64 random(51);
  int found = 0, none = 0;
  for (int i = 0; i < 3000; ++i) {
    const Classes classes = random_classes(random);
    const double mass = uniform(random, 1, 30);
    std::vector<double> least(classes.size(), 0),
        most(classes.size(), std::numeric_limits<double>::infinity());
    if (i % 3 == 0) {
      least[random() % least.size()] = 1;
      most[random() % most.size()] = static_cast<double>(1 + random() % 3);
    }
    const double expected = fewest(classes, mass, least, most);
    const std::vector<double> q = CountWalk(classes).counts(window(mass, mass, least, most), 10);
    INFO("problem " << i << ", mass " << mass);
    if (q.empty()) {
      CHECK(expected > 9);
      ++none;
      continue;
    }
    CHECK(std::accumulate(q.begin(), q.end(), 0.0) == expected);
    CHECK(can_have(classes, q, mass));
    for (std::size_t j = 0; j < q.size(); ++j)
      CHECK((q[j] >= least[j] && q[j] <= most[j]));
    ++found;
  }
  CHECK(found >= 500);
  CHECK(none >= 500);
}

TEST_CASE("a walk over a window has no more particles than one at a mass inside", "[count_walk]") {
  std::mt19937_64 random(52);
  const auto particles = [](const std::vector<double> &q) {
    return q.empty() ? std::numeric_limits<double>::infinity() : std::accumulate(q.begin(), q.end(), 0.0);
  };
  int fewer = 0, equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const Classes classes = random_classes(random);
    const CountWalk walk(classes);
    const double above = uniform(random, 1, 30), up_to = above * uniform(random, 1, 1.5);
    const double all = particles(walk.counts(window(above, up_to, classes.size()), 50));
    for (const double mass : {above, uniform(random, above, up_to), up_to}) {
      const double one = particles(walk.counts(window(mass, mass, classes.size()), 50));
      INFO("problem " << i << ", mass " << mass);
      CHECK(all <= one);
      fewer += all < one ? 1 : 0;
      equal += all == one ? 1 : 0;
    }
  }
  CHECK(fewer >= 300);
  CHECK(equal >= 300);
}

TEST_CASE("a walk finds counts beyond what enumeration can, and none at or above its limit", "[count_walk]") {
  // Half of the mass in particles of up to 1 needs 5e8 of them, the other half 5 of up to 1e8.
  const Classes classes = {{0.5, 1, {0.5, 0.5}, {0, 1}}, {9e7, 1e8, {0.5, 0.5}, {1, 1}}};
  CHECK(CountWalk(classes).counts(window(1e9, 1e9, 2), 1e9) == std::vector<double>{5e8, 5});
  CHECK(CountWalk(classes).counts(window(1e9, 1e9, 2), 5e8 + 5).empty());
}

TEST_CASE("a walk ends where one particle more is less than doubles have digits for", "[count_walk]") {
  const Classes classes = {{0.5, 1, {0.5, 0.5}, {0, 1}}, {0x1p51, 0x1p52, {0.5, 0.5}, {1, 1}}};
  const std::vector<double> q =
      CountWalk(classes).counts(window(0x1p70, 0x1p70, 2), std::numeric_limits<double>::infinity());
  REQUIRE(q.size() == 2);
  CHECK(std::abs(q[0] - 0x1p69) <= 1e-14 * 0x1p69);
  CHECK(q[1] == 0x1p17);
}

TEST_CASE("a walk takes more particles of a fine class where a coarse one has no room", "[count_walk]") {
  // A particle of the coarse class alone is above 0.6, what it may have at most: all is in the fine class.
  const Classes classes = {{0, 0.25, {0, 1}, {0.2, 1}}, {0.6, 1, {0, 0.6}, {1, 1}}};
  CHECK(CountWalk(classes).counts(window(0.9, 0.9, 2), 100) == std::vector<double>{4, 0});
}

} // namespace count_walk_test

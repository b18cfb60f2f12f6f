// Representative sets with exact class volumes: room for a spread.

#include "catch.hpp"
#include "plain_gradation.hpp"
#include "sets/matched_set.hpp"

#include <random>

namespace matched_set_test {

using namespace mdm;

namespace {

/// The mean volume of sizes from l to u, uniform by volume.
Rational mean_volume(const Rational &l, const Rational &u, unsigned dimension) {
  return dimension == 2 ? Rational(l * u) : Rational(2 * l * l * u * u / (l + u));
}

} // namespace

TEST_CASE("with room no class's mean particle is far from that of uniform volumes") {
  std::mt19937_64 random(61);
  for (int i = 0; i < 60; ++i) {
    std::vector<Rational> sizes = {ratio(1 + random() % 20, 10)}, masses;
    for (std::size_t j = 0; j < 1 + random() % 5; ++j) {
      sizes.push_back(sizes.back() * ratio(102 + random() % 150, 100));
      masses.push_back(random() % 5 == 0 && j > 0 ? 0 : 1 + random() % 50);
    }
    masses.emplace_back(0);
    const unsigned dimension = 2 + random() % 2;
    const Representativity wanted{1 + random() % 20, 1 + random() % 500, dimension};
    const Match m = roomy_set(gradation(sizes, masses), wanted, {}, 8);
    REQUIRE(m.complete);
    CHECK(m.particles() >= wanted.at_least);
    const MatchScale &scale = *m.sample->scale;
    CHECK(scale.window.above < scale.chosen);
    CHECK(scale.chosen <= scale.window.up_to);
    for (std::size_t j = 0; j < m.gradation.classes(); ++j) {
      const Integer &q = m.sample->quantities[j];
      CHECK((q > 0) == (masses[j] > 0));
      if (q == 0)
        continue;
      CHECK(q >= wanted.min_per_class);
      const Rational mean = mean_volume(sizes[j], sizes[j + 1], dimension);
      const Rational volume = scale.chosen * masses[j] / Rational(q);
      // A share of the particles by volume, rounded; or between the bounds that the smallest N comes from,
      // which are rounded down to 8 digits of the size.
      const Rational share = scale.chosen * masses[j] / mean;
      const bool is_rounded = abs(Rational(share - Rational(q))) < 1 + ratio(1, 1000000);
      const bool is_between =
          volume <= mean && volume > (power(sizes[j], dimension) + mean) / 2 * (1 - ratio(1, 1000000));
      CHECK((is_rounded || is_between));
    }
  }
}

TEST_CASE(
    "where a number of particles is asked for, means are as near to uniform as whole numbers let them") {
  const std::vector<Rational> sizes = {ratio(1, 10), ratio(1, 5), ratio(1, 4), ratio(3, 10), ratio(1, 2)};
  const std::vector<Rational> masses = {3, 28, 36, 33, 0};
  for (const int n : {1000, 20001, 1000000}) {
    const Match m = roomy_set(gradation(sizes, masses), {10, n, 3}, {}, 8);
    CHECK(m.particles() == n);
    for (std::size_t j = 0; j < 4; ++j) {
      const Integer &q = m.sample->quantities[j];
      const Rational mean = m.sample->scale->chosen * masses[j] / Rational(q);
      const Rational off = mean / mean_volume(sizes[j], sizes[j + 1], 3) - 1;
      CHECK(abs(off) <= ratio(1, q) * (1 + ratio(1, 1000)));
    }
    REQUIRE(m.notes.size() == 1);
    CHECK(m.notes[0].find("the mean volume of the particles of every class is within ") == 0);
  }
}

TEST_CASE("no smaller set has that room") {
  // Discs in (1, 2] and (2, 4]: mean areas 2 and 8, from 3/2 and 6 on, all sizes but the second decimals.
  for (int second = 1; second < 20; ++second) {
    const Rational masses[] = {7, second};
    const Match m = roomy_set(gradation({1, 2, 4}, {7, second, 0}), {1, 1, 2}, {}, 30);
    REQUIRE(m.sample->quantities.size() == 2);
    int least = 0;
    for (int n = 2; least == 0; ++n)
      for (int q = 1; q < n && least == 0; ++q) {
        const Rational above = std::max(ratio(3 * q, 2) / masses[0], Rational(6 * (n - q)) / masses[1]);
        const Rational up_to = std::min(Rational(2 * q) / masses[0], Rational(8 * (n - q)) / masses[1]);
        if (above < up_to)
          least = n;
      }
    CHECK(m.particles() == least);
  }
}

TEST_CASE("a class that begins at 0 needs no room") {
  const Match m = roomy_set(gradation({0, 1, 2}, {1, 1, 0}), {3, 1, 3}, {}, 6);
  CHECK(m.sample->quantities.size() == 2);
  CHECK(m.complete);
}

TEST_CASE("a spread of a set with room has volume in both halves of a class") {
  const Match m = roomy_set(gradation({1, 2, 4}, {7, 5, 0}), {1, 4000, 3}, {}, 8);
  const ParticlesOf particles = spread_particles(m, 5);
  for (std::size_t j = 0; j < 2; ++j) {
    const Rational middle = j == 0 ? ratio(3, 2) : Rational(3);
    Rational fine = 0, all = 0;
    particles(j, [&](const Enclosure &size, const Integer &n) {
      CHECK(n == 1);
      const Rational volume = power(size.upper(), 3);
      all += volume;
      fine += size.upper() <= middle ? volume : Rational(0);
    });
    const double share = Rational(fine / all).convert_to<double>();
    CHECK(share == Approx(0.5).margin(0.2));
  }
}

} // namespace matched_set_test

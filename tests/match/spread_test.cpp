// Particles of many sizes: exact class masses, every particle in its class.

#include "brute_force.hpp"
#include "catch.hpp"
#include "match/mass_draw.hpp"
#include "match/spread.hpp"
#include "plain_gradation.hpp"
#include "sets/uniform_by_volume.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <cmath>

namespace spread_test {

using namespace mdm;

namespace {

std::vector<Integer> all_parts(const ClassSpread &c) {
  std::vector<Integer> n;
  ClassSpread::Masses masses = c.masses();
  for (std::uint64_t i = 0; i < c.quantity(); ++i)
    n.push_back(masses.next());
  return n;
}

/// T^b of class j, from the definitions.
Rational powered_mass(const Match &m, std::size_t j) {
  return m.tolerance ? m.sample->mass * power(m.classes()[j].share, m.question.law.b)
                     : m.sample->scale->chosen * power(m.gradation.mass(j), m.question.law.b);
}

/// Every statement of a spread: the sum, the class and, for an integer exponent, the sizes.
void check_spread(const Match &m, std::uint64_t seed) {
  const MassLaw &law = m.question.law;
  Integer particles = 0;
  for (const ClassSpread &c : spread(m, seed).classes) {
    const std::size_t j = c.index();
    const Rational mass = powered_mass(m, j);
    const Rational factor = power(m.gradation.factor(j), law.b);
    const Rational f = factor * power(m.gradation.lower(j), law.a);
    const Rational F = factor * power(m.gradation.upper(j), law.a);
    Integer sum = 0;
    Rational low = 0, high = 0;
    for (const Integer &n : all_parts(c)) {
      sum += n;
      const Rational one = mass * power(ratio(n, c.parts()), law.b);
      CHECK(f < one);
      CHECK(one <= F);
      const Enclosure x = c.size(n, 9);
      CHECK(m.gradation.lower(j) < x.lower());
      CHECK(x.upper() <= m.gradation.upper(j));
      CHECK(factor * power(x.lower(), law.a) <= one);
      CHECK(one <= factor * power(x.upper(), law.a));
      low += factor * power(x.lower(), law.a);
      high += factor * power(x.upper(), law.a);
      ++particles;
    }
    CHECK(sum == c.parts());
    if (law.b == 1) {
      CHECK(low <= mass);
      CHECK(mass <= high);
    }
  }
  CHECK(particles == m.particles());
}

Gradation with_factors(const Gradation &g, std::mt19937_64 &random) {
  Gradation::Data data;
  data.sizes = g.sizes();
  data.masses = g.masses();
  for (std::size_t j = 0; j < g.sizes().size(); ++j)
    data.factors.push_back(ratio(1 + random() % 9, 1 + random() % 9));
  return Gradation(std::move(data));
}

double to_double(const Rational &r) {
  return r.convert_to<double>();
}

} // namespace

TEST_CASE("spreads of exact matches have the mass of their class and stay inside it") {
  std::mt19937_64 random(51);
  for (const MassLaw &law : {MassLaw{3, 1}, MassLaw{2, 1}, MassLaw{1, 1}, MassLaw{5, 2}, MassLaw{1, 2},
                             MassLaw{3, 2}, MassLaw{7, 1}})
    for (int i = 0; i < 30; ++i) {
      Question question;
      question.law = law;
      question.min_per_class = random() % 8;
      if (random() % 3 == 0)
        question.at_least = 1 + random() % 300;
      SolveOptions options;
      options.scale = random() % 4 == 0 ? ScaleChoice::upper : ScaleChoice::automatic;
      Gradation g = brute::random_gradation(random);
      if (random() % 3 == 0)
        g = with_factors(g, random);
      check_spread(solve(g, question, options), random());
    }
}

TEST_CASE("spreads of matches within a tolerance have the masses that were achieved") {
  std::mt19937_64 random(52);
  for (int i = 0; i < 40; ++i) {
    Question question;
    question.tolerances.push_back(parse_tolerance(random() % 2 == 0 ? "retained:5%" : "total:9%"));
    question.law = random() % 4 == 0 ? MassLaw{2, 1} : MassLaw{};
    const Match m = solve(brute::random_gradation(random), question);
    REQUIRE(m.has_answer());
    check_spread(m, random());
  }
}

TEST_CASE("a single particle has the mass of its class") {
  const Match m = solve(gradation({1, 2, 3}, {2, 1, 0}));
  for (const ClassSpread &c : spread(m, 7).classes) {
    if (c.quantity() == 1)
      CHECK(all_parts(c) == std::vector<Integer>{c.parts()});
  }
}

TEST_CASE("particles that must all be as large as the sieve are") {
  const Gradation g = gradation({1, 2}, {1, 0});
  const ClassSpread c(g, 0, MassLaw{}, 5, 40, 3); // 5 particles of mass 8
  for (const Integer &n : all_parts(c)) {
    CHECK(n * 5 == c.parts());
    const Enclosure x = c.size(n, 6);
    CHECK(x.lower() == 2);
    CHECK(x.upper() == 2);
  }
}

TEST_CASE("almost as light as can be, particles are just above the sieve") {
  const Gradation g = gradation({1, 2}, {1, 0});
  const Rational mass = 5 + ratio(1, power_of_ten(30));
  const ClassSpread c(g, 0, MassLaw{}, 5, mass, 3);
  Integer sum = 0;
  for (const Integer &n : all_parts(c)) {
    CHECK(Rational(n) / Rational(c.parts()) * mass > 1);
    CHECK(c.size(n, 6).lower() > 1);
    sum += n;
  }
  CHECK(sum == c.parts());
}

TEST_CASE("narrow classes have room") {
  const Rational width = ratio(1, power_of_ten(40));
  const Gradation g = gradation({1, 1 + width}, {1, 0});
  const ClassSpread c(g, 0, MassLaw{}, 1000, 1000 * power(Rational(1 + width / 3), 3), 3);
  std::set<Integer> different;
  Integer sum = 0;
  for (const Integer &n : all_parts(c)) {
    CHECK(c.least() <= n);
    CHECK(n <= c.most());
    different.insert(n);
    sum += n;
  }
  CHECK(sum == c.parts());
  CHECK(different.size() > 990);
}

TEST_CASE("masses are drawn as the paper draws sizes") {
  // Discs and spheres between sizes 2 and 3, masses in parts of 10^-30.
  std::mt19937_64 random(53);
  const Rational unit(power_of_ten(30));
  for (const unsigned dimension : {2U, 3U}) {
    const UniformByVolume sizes(2, 3, dimension);
    const MassDraw draw(numerator(Rational(power(Rational(2), dimension) * unit)),
                        numerator(Rational(power(Rational(3), dimension) * unit)), MassLaw{dimension, 1});
    for (int i = 0; i < 200; ++i) {
      const std::uint64_t r = random();
      const Rational y = ratio(2 * Integer(r) + 1, Integer(1) << 65);
      const Rational expected = power(sizes.powered_size(y), dimension); // of the size to the power d - 1
      const Rational mass = power(Rational(Rational(draw(r)) / unit), dimension - 1);
      CHECK(abs(Rational(mass / expected - 1)) < ratio(1, power_of_ten(17)));
    }
  }
}

TEST_CASE("masses are drawn for every law") {
  const Integer unit = power_of_ten(30);
  const std::uint64_t half = std::uint64_t{1} << 63;
  const auto close = [](const Integer &mass, const Integer &expected) {
    return abs(Rational(ratio(mass, expected) - 1)) < ratio(1, power_of_ten(15));
  };
  // x: the median size of 1 to 4 is 2. x^(1/2), sizes 1 to 16: any mass is as likely, sqrt(x) = (1 + 4)/2.
  CHECK(close(MassDraw(unit, 4 * unit, MassLaw{1, 1})(half), 2 * unit));
  CHECK(close(MassDraw(unit, 4 * unit, MassLaw{1, 2})(half), 5 * unit / 2));
  // x^(3/2), sizes 1 to 4: (4/x)^(1/2) is from 2 to 1, in the middle 3/2: x = 16/9, x^(3/2) = 64/27.
  CHECK(close(MassDraw(unit, 8 * unit, MassLaw{3, 2})(half), 64 * unit / 27));
  for (const MassLaw &law :
       {MassLaw{3, 1}, MassLaw{1, 1}, MassLaw{1, 3}, MassLaw{1000, 1}, MassLaw{999, 1000}}) {
    const MassDraw draw(unit, 8 * unit, law);
    Integer before = unit;
    for (std::uint64_t k = 0; k < 64; ++k) {
      const Integer mass = draw(k << 58);
      CHECK(before <= mass);
      CHECK(mass <= 8 * unit);
      before = mass;
    }
    CHECK(close(draw(0), unit));
    CHECK(close(draw(~std::uint64_t{0}), 8 * unit));
  }
}

TEST_CASE("with the mean mass of the distribution a spread is uniform by volume") {
  // Spheres from 1 to 3: mean mass 2 l^2 u^2 / (l + u) = 4.5. Of the mass, the half is below size 2.
  const Gradation g = gradation({1, 3}, {1, 0});
  const std::uint64_t q = 20000;
  const ClassSpread c(g, 0, MassLaw{}, q, Rational(9 * q) / 2, 5);
  Rational quarters[4];
  for (const Integer &n : all_parts(c)) {
    const Rational share = ratio(n, c.parts());
    const Rational mass = share * 9 * q / 2;
    quarters[mass <= ratio(27, 8) ? 0 : mass <= 8 ? 1 : mass <= ratio(125, 8) ? 2 : 3] += share;
  }
  // A quarter has a standard deviation of less than sqrt(mean of mass^2) / (mean of mass sqrt q) = 1.5 /
  // sqrt(20000) < 0.011: five of them.
  for (const Rational &share : quarters)
    CHECK(std::abs(to_double(share) - 0.25) < 0.055);
}

TEST_CASE("a class that begins at 0 is spread from half the mean mass on") {
  const Gradation g = gradation({0, 2}, {1, 0});
  const ClassSpread c(g, 0, MassLaw{}, 1000, 3000, 11);
  Integer sum = 0;
  for (const Integer &n : all_parts(c)) {
    CHECK(n * 10000 >= c.parts()); // no dust: a tenth of the mean mass or more
    sum += n;
  }
  CHECK(sum == c.parts());
}

TEST_CASE("a spread depends on the seed alone") {
  const Gradation g = gradation({1, 2, 3}, {5, 9, 0});
  Question question;
  question.min_per_class = 20;
  const Match m = solve(g, question), again = solve(g, question);
  const std::vector<ClassSpread> a = spread(m, 1).classes, b = spread(again, 1).classes,
                                 c = spread(m, 2).classes;
  REQUIRE(a.size() == 2);
  for (std::size_t j = 0; j < 2; ++j) {
    CHECK(all_parts(a[j]) == all_parts(b[j]));
    CHECK(all_parts(a[j]) != all_parts(c[j]));
  }
}

TEST_CASE("spreads are those of another program") {
  // Shares of the class's mass by mpmath with 40 digits, Philox written again.
  struct Case {
    std::vector<Rational> sizes;
    unsigned dimension;
    Rational mass;
    std::uint64_t seed;
    std::vector<const char *> shares;
  };
  const Case cases[] = {{{1, 2},
                         3,
                         12,
                         1,
                         {"0.383847599847493507", "0.359237361835411866", "0.170606479400670271",
                          "0.0863085589164243558"}}, // pulled down
                        {{1, 2},
                         3,
                         20,
                         1,
                         {"0.312234977851181718", "0.300791981343666136", "0.213084478155331273",
                          "0.173888562649820873"}}, // up
                        {{1, 2, 3},
                         2,
                         20,
                         (std::uint64_t{1} << 40) + 5,
                         {"0.41784691199067924", "0.286784056878915092", "0.295369031130405668"}}};
  for (const Case &c : cases) {
    std::vector<Rational> masses(c.sizes.size(), 1);
    masses.back() = 0;
    const Gradation g = gradation(c.sizes, masses);
    const ClassSpread spread(g, c.sizes.size() - 2, MassLaw{c.dimension, 1}, c.shares.size(), c.mass, c.seed);
    const std::vector<Integer> n = all_parts(spread);
    for (std::size_t i = 0; i < n.size(); ++i)
      CHECK(abs(Rational(ratio(n[i], spread.parts()) - parse_decimal(c.shares[i]))) <
            ratio(1, power_of_ten(16)));
  }
}

TEST_CASE("too many particles are not spread") {
  Question question;
  question.at_least = Integer(2) * most_spread_particles;
  const Match m = solve(gradation({1, 2}, {1, 0}), question);
  CHECK_THROWS_AS(spread(m, 1), InputError);
}

} // namespace spread_test

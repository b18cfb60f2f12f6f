#include "all_cases.hpp"
#include "brute_force.hpp"
#include "catch.hpp"
#include "gradation/material_gradation.hpp"
#include "sanitizers.hpp"
#include "tolerant_brute_force.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>

#include <map>

namespace material_match_test {

using namespace mdm;

namespace {

/// A class of a material in whole numbers; the factor in hundredths.
struct SmallClass {
  int lower, upper, mass, factor;
};

/// Two or three materials, four classes at most; the classes of a material touch, those of two overlap.
using SmallBeach = std::map<std::string, std::vector<SmallClass>>;

SmallBeach random_beach(std::mt19937_64 &random) {
  const auto from = [&random](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  SmallBeach beach;
  std::size_t left = 4;
  for (const char *name : {"quartz", "shell", "mica"}) {
    const std::size_t classes = left > 2 && from(0, 1) == 0 ? 2 : 1;
    if (left < classes)
      break;
    left -= classes;
    int lower = from(0, 9);
    std::vector<SmallClass> &all = beach[name];
    for (std::size_t j = 0; j < classes; ++j) {
      const int upper = lower + from(1, 3);
      all.push_back({lower, upper, j == 0 ? from(1, 9) : from(0, 9), from(0, 2) == 0 ? 100 : from(80, 300)});
      lower = upper;
    }
  }
  return beach;
}

std::string csv(const SmallBeach &beach) {
  std::string text = "size_mm,mass,factor,material\n";
  for (const auto &[name, classes] : beach) {
    for (const SmallClass &c : classes)
      text += std::to_string(c.lower) + "," + std::to_string(c.mass) + "," + std::to_string(c.factor) + "," +
              name + "\n";
    text += std::to_string(classes.back().upper) + ",0,1," + name + "\n";
  }
  return text;
}

/// By the definition: c x^3 over the mass at both ends of each class.
brute::Problem problem(const SmallBeach &beach) {
  brute::Problem p;
  for (const auto &[name, classes] : beach)
    for (const SmallClass &c : classes)
      if (c.mass > 0) {
        const auto end = [&c](int x) { return ratio(Integer(c.factor * x * x * x), Integer(c.mass)); };
        p.push_back({end(c.lower), end(c.upper), 1});
      }
  return p;
}

/// The same within tolerances in percent, of which one below 0 is not asked for.
tolerant_brute::Problem problem_within(const SmallBeach &beach, int retained, int total) {
  tolerant_brute::Problem p;
  int all = 0;
  for (const auto &[name, classes] : beach)
    for (const SmallClass &c : classes)
      all += c.mass;
  for (const auto &[name, classes] : beach)
    for (const SmallClass &c : classes) {
      const auto end = [&c](int x) { return ratio(c.factor * x * x * x, 100); };
      const Rational share = ratio(c.mass, all), width = ratio(retained, 100);
      p.classes.push_back({end(c.lower), end(c.upper), ratio(c.factor, 100), c.mass > 0});
      p.target.push_back(share);
      if (retained >= 0)
        p.tolerance.retained.push_back(
            {std::max(Rational(0), Rational(share - width)), std::min(Rational(1), Rational(share + width))});
    }
  if (total >= 0)
    p.tolerance.total = ratio(total, 100);
  return p;
}

/// Of the classes with mass.
std::vector<Integer> quantities(const Match &m) {
  std::vector<Integer> q;
  for (std::size_t j = 0; j < m.gradation.classes(); ++j)
    if (m.gradation.mass(j) != 0)
      q.push_back(m.sample->quantities[j]);
    else
      CHECK(m.sample->quantities[j] == 0);
  return q;
}

Match solved(const std::string &text, const Question &question = {}) {
  return solve(read_material_gradation(text, "beach.csv"), question);
}

} // namespace

TEST_CASE("the least match of several materials is that of enumeration", "[match]") {
  std::mt19937_64 random(28);
  int larger = 0;
  for (int i = 0; i < 400; ++i) {
    const SmallBeach beach = random_beach(random);
    const std::string text = csv(beach);
    CAPTURE(i, text);
    const Match m = solved(text);
    REQUIRE(m.status == Status::optimal);
    const std::optional<brute::Vector> expected =
        brute::least_match(problem(beach), m.sample->scale->window.up_to);
    REQUIRE(expected);
    REQUIRE(quantities(m) == *expected);
    Integer alone = 0;
    for (const auto &[name, classes] : beach)
      alone += *solved(csv({{name, classes}})).particles();
    REQUIRE(*m.particles() >= alone); // Theorem 28 (b)
    larger += *m.particles() > alone ? 1 : 0;
  }
  CHECK(larger > 100);
}

TEST_CASE("the least number of several materials within a tolerance is that of enumeration", "[match]") {
  std::mt19937_64 random(30);
  const auto percent = [&random](unsigned end) { return static_cast<int>(random() % end); };
  int decided = 0, fewer = 0;
  const int trials = takes_all_cases() && !MDM_IS_SANITIZED ? 200 : 40; // enumeration takes long
  for (int i = 0; i < trials; ++i) {
    const SmallBeach beach = random_beach(random);
    const int retained = i % 3 == 0 ? -1 : percent(30), total = i % 3 == 1 ? -1 : percent(50);
    Question question;
    if (retained >= 0)
      question.tolerances.push_back({AskedTolerance::Kind::retained, retained});
    if (total >= 0)
      question.tolerances.push_back({AskedTolerance::Kind::total, total});
    CAPTURE(i, csv(beach), retained, total);
    const Match m = solved(csv(beach), question);
    REQUIRE(m.status == Status::optimal);
    for (std::size_t j = 0; j < m.gradation.classes(); ++j)
      REQUIRE((m.gradation.is_class(j) || m.sample->quantities[j] == 0));
    constexpr int limit = 8;
    const std::optional<int> least =
        tolerant_brute::least_particles(problem_within(beach, retained, total), limit);
    REQUIRE((least ? *m.particles() == *least : *m.particles() > limit));
    decided += least ? 1 : 0;
    fewer += *m.particles() < *solved(csv(beach)).particles() ? 1 : 0;
  }
  CHECK(decided > trials / 2);
  CHECK(fewer > trials / 2);
}

TEST_CASE("sizes of several materials have the masses that were asked for", "[match]") {
  std::mt19937_64 random(29);
  for (int i = 0; i < 100; ++i) {
    const Match m = solved(csv(random_beach(random)));
    const Gradation &g = m.gradation;
    for (std::size_t j = 0; j < g.classes(); ++j) {
      if (g.mass(j) == 0)
        continue;
      const Enclosure &x = *m.sample->sizes[j];
      const auto mass = [&](const Rational &size) {
        return Rational(m.sample->quantities[j] * g.factor(j) * power(size, 3));
      };
      const Rational asked = m.sample->scale->chosen * g.mass(j);
      REQUIRE(mass(x.lower()) <= asked);
      REQUIRE(asked <= mass(x.upper()));
      REQUIRE(g.lower(j) < x.lower());
      REQUIRE(x.upper() <= g.upper(j));
    }
  }
}

TEST_CASE("a single material has the match that it has without a name", "[match]") {
  const std::string rows[] = {"0.5,3,2.65", "1,5,2.7", "2,0,1", "0.063,2,2.5"};
  std::string plain = "size_mm,mass,factor\n", named = "size_mm,mass,factor,material\n";
  for (const std::string &row : rows) {
    plain += row + "\n";
    named += row + ",quartz\n";
  }
  Question question;
  for (const int at_least : {1, 300}) {
    question.at_least = at_least;
    const Match m = solved(named, question), expected = solve(read_gradation(plain, "a.csv"), question);
    CHECK(m.sample->quantities == expected.sample->quantities);
    CHECK(m.sample->scale->chosen == expected.sample->scale->chosen);
    for (std::size_t j = 0; j < expected.sample->sizes.size(); ++j)
      CHECK(m.sample->sizes[j]->text() == expected.sample->sizes[j]->text());
  }
}

TEST_CASE("floors and a number of particles hold for all materials together", "[match]") {
  std::mt19937_64 random(30);
  for (int i = 0; i < 60; ++i) {
    const SmallBeach beach = random_beach(random);
    const std::string text = csv(beach);
    CAPTURE(text);
    Question question;
    question.min_per_class = 3;
    brute::Problem p = problem(beach);
    for (brute::Class &c : p)
      c.floor = 3;
    const Match floored = solved(text, question);
    REQUIRE(quantities(floored) == brute::least_match(p, floored.sample->scale->window.up_to));
    question.min_per_class = 0;
    question.at_least = *solved(text).particles() + 3;
    const Match many = solved(text, question);
    const std::set<Integer> reachable = brute::reachable(problem(beach), *many.particles());
    REQUIRE(*reachable.lower_bound(question.at_least) == *many.particles());
  }
}

TEST_CASE("the solids of several materials are the sum of their volumes", "[match]") {
  // 500 mm^3 over pi/6 of each: particles of up to 1 mm.
  Question question;
  question.solids = Cylinder{10, 10, ratio(1, 2)};
  const Match m =
      solved("size_mm,mass,factor,material\n0.9,265,2.65,a\n1,0,1,a\n0.9,275,2.75,b\n1,0,1,b\n", question);
  // pi/4 10^2 10 / 1.5 = pi/6 s (100 + 100): s = 5.
  CHECK(m.sample->scale->chosen == 5);
  CHECK(m.sample->quantities[0] == m.sample->quantities[2]);
  CHECK(m.sample->quantities[0] == 500);
}

} // namespace material_match_test

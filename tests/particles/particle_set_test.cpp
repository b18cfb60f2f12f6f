#include "answer/answer.hpp"
#include "answer/answer_particles.hpp"
#include "particles/particle_set.hpp"
#include "support.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <cmath>
#include <cstdlib>
#include <random>

namespace particle_set_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Rational cube(const Rational &x) {
  return x * x * x;
}

/// What a C program reads.
Rational read_double(const std::string &text) {
  return Rational(std::strtod(text.c_str(), nullptr));
}

/// All that a written number promises about the size whose cube is `cube_of_size`, in (lower, upper].
void check_number(const WrittenNumber &n, const Rational &cube_of_size, const Rational &lower,
                  const Rational &upper, const Rational &most_error) {
  INFO(n.text << " in (" << lower << ", " << upper << "]");
  CHECK(parse_decimal(n.text) == n.decimal());
  CHECK(std::strtod(n.text.c_str(), nullptr) == n.value);
  for (const Rational &x : {n.decimal(), read_double(n.text)}) {
    CHECK(x > lower);
    CHECK(x <= upper);
    CHECK(abs(Rational(cube(x) / cube_of_size - 1)) <= most_error);
  }
}

std::size_t digits(const std::string &text) {
  const std::string figures = text.substr(0, text.find('e'));
  std::string kept;
  for (const char c : figures)
    if (c != '.' && (c != '0' || !kept.empty()))
      kept += c;
  kept.erase(kept.find_last_not_of('0') + 1);
  return kept.size();
}

const std::string sand = "size_mm,mass\n0.038,3.86\n0.076,1.28\n0.11,10.13\n0.15,44.86\n0.25,21.22\n"
                         "0.43,12.05\n0.85,6.6\n2.4,0\n";

Match match(const std::string &csv, const Question &question = {}, const SolveOptions &options = {}) {
  return solve(read_gradation(csv, "sand.csv"), question, options);
}

} // namespace

TEST_CASE("written numbers: no decimal of fewer digits would do") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) {
    const Rational x = ratio(Integer(random() >> 20), Integer(random() >> (20 + i % 30)) + 1) + ratio(1, 7);
    const Rational width = x / Rational(power_of_ten(static_cast<unsigned>(i % 12)));
    const Rational most_error = ratio(1, power_of_ten(static_cast<unsigned>(1 + i % 14)));
    const SizeToWrite size{cube(x), 3, x - width / 3, x + width / 5, most_error};
    const std::optional<WrittenNumber> n = shortest_number(size);
    REQUIRE(n);
    check_number(*n, cube(x), size.lower, size.upper, most_error);
    // Every decimal of one digit fewer that could serve is one of the two next to x.
    const std::size_t fewer = digits(n->text) - 1;
    if (fewer == 0)
      continue;
    Rational unit = 1;
    while (x / unit >= Rational(power_of_ten(static_cast<unsigned>(fewer))))
      unit *= 10;
    while (x / unit < Rational(power_of_ten(static_cast<unsigned>(fewer - 1))))
      unit /= 10;
    for (const Integer &steps : {floor(Rational(x / unit)), ceil(Rational(x / unit))}) {
      const Rational y = Rational(steps) * unit;
      INFO(to_decimal(y) << " instead of " << n->text);
      const bool serves = size.allows(y) && size.allows(read_double(to_decimal(y)));
      CHECK_FALSE(serves);
    }
  }
}

TEST_CASE("written numbers: at an opening whose double is beyond it, the double before it") {
  // The double of 7.6e-5 is above it, that of 0.00085 below.
  const Rational upper = ratio(76, 1000000);
  REQUIRE(Rational(7.6e-5) > upper);
  const std::optional<WrittenNumber> below =
      shortest_number({cube(upper), 3, ratio(1, 100000), upper, ratio(1, 1000000000)});
  REQUIRE(below);
  CHECK(below->value == std::nextafter(7.6e-5, 0.0));
  CHECK(below->decimal() < upper);
  REQUIRE(Rational(0.00085) < ratio(85, 100000));
  CHECK(shortest_number({cube(ratio(85, 100000)), 3, 0, ratio(85, 100000), ratio(1, 1000)})->text ==
        "8.5e-4");
  // A class that no double is in.
  const Rational just_above = upper + ratio(1, power_of_ten(30));
  CHECK_FALSE(shortest_number({cube(just_above), 3, upper, just_above, ratio(1, 1000)}));
}

TEST_CASE("short decimals: the shorter of both notations") {
  CHECK(short_decimal(Integer(85), 5) == "8.5e-4");
  CHECK(short_decimal(Integer(85), 3) == "0.085");
  CHECK(short_decimal(Integer(8500), -2) == "8.5e5");
  CHECK(short_decimal(Integer(1), -9) == "1e9");
  CHECK(short_decimal(Integer(0), 3) == "0");
  CHECK(short_decimal(Rational(2650)) == "2650");
  CHECK(short_decimal(ratio(265, 100000000)) == "2.65e-6");
  CHECK(std::strtod(short_decimal(ratio(1, 3)).c_str(), nullptr) == Approx(1.0 / 3).epsilon(1e-15));
}

TEST_CASE("particle sets: counts, classes and masses are those of the match") {
  for (const SizeUnit unit : {SizeUnit::m, SizeUnit::mm, SizeUnit::um, SizeUnit::in}) {
    const Match m = match(sand);
    ParticleSetOptions options;
    options.unit = unit;
    options.most_mass_error = ratio(1, 1000000);
    const ParticleSet set = particle_set(m, options);
    CHECK(set.name == "sand");
    CHECK(set.particles() == m.particles());
    CHECK(set.mass_error() <= options.most_mass_error);
    CHECK(set.mass_error() > 0);
    const std::vector<Integer> &q = m.sample->quantities;
    REQUIRE(set.classes.size() == q.size());
    const Rational one_mm = Rational(1) / in_mm(unit);
    for (std::size_t j = 0; j < set.classes.size(); ++j) {
      const ParticleClass &c = set.classes[j];
      REQUIRE(c.sizes.size() == 1);
      CHECK(c.quantity() == q[j]);
      CHECK(c.lower == m.gradation.lower(j) * one_mm);
      const Rational volume = m.sample->scale->chosen * m.gradation.mass(j) / q[j] * cube(one_mm);
      check_number(c.sizes[0].diameter, volume, c.lower, c.upper, set.mass_error());
      check_number(c.sizes[0].radius, volume / 8, c.lower / 2, c.upper / 2, set.mass_error());
      CHECK(c.density * cube(Rational(1000) / in_mm(unit)) == 2650);
    }
  }
}

TEST_CASE("particle sets: an answer gives the same as the match that it is of") {
  for (const bool tolerant : {false, true}) {
    Question question;
    if (tolerant)
      question.tolerances.push_back(parse_tolerance("retained:1%"));
    const Match m = match(sand, question);
    const ParticleSet direct = particle_set(m);
    const ParticleSet read = particle_set(read_answer(answer_json(m), "answer.json"), {});
    CHECK(read.name == "sand");
    REQUIRE(read.classes.size() == direct.classes.size());
    for (std::size_t j = 0; j < read.classes.size(); ++j) {
      CHECK(read.classes[j].number == direct.classes[j].number);
      CHECK(read.classes[j].quantity() == direct.classes[j].quantity());
      CHECK(read.classes[j].sizes[0].diameter.text == direct.classes[j].sizes[0].diameter.text);
      CHECK(read.classes[j].sizes[0].radius.text == direct.classes[j].sizes[0].radius.text);
      CHECK(read.classes[j].mass_error == direct.classes[j].mass_error);
    }
  }
}

TEST_CASE("particle sets: empty classes are left out, factors make the grains heavier") {
  const ParticleSet set = particle_set(match("size_mm,mass,factor\n1,8,2\n2,0,1\n3,64,1\n4,0,1\n"));
  REQUIRE(set.classes.size() == 2);
  CHECK(set.classes[0].number == 1);
  CHECK(set.classes[1].number == 3);
  CHECK(set.classes[0].density == 5300);
  CHECK(set.classes[1].density == 2650);
}

TEST_CASE("particle sets: irrational laws") {
  Question question;
  question.law = {5, 2};
  const ParticleSet set = particle_set(match(sand, question));
  CHECK(set.mass_error() <= ratio(1, 1000000000));
  CHECK(set.law == question.law);
}

TEST_CASE("particle sets: what an answer says wrongly is refused") {
  const AnswerSample answer = read_answer(answer_json(match(sand)), "answer.json");
  CHECK_THROWS_AS(particle_set(answer, {2, 1}), InputError);
  CHECK_THROWS_AS(particle_set(answer, {3, 2}), InputError);
  AnswerSample other = answer;
  other.particles += 1;
  CHECK_THROWS_AS(particle_set(other, {}), InputError);
  other = answer;
  other.classes[0].lower.power = other.classes[0].size_hi;
  CHECK_THROWS_AS(particle_set(other, {}), InputError);
  other = answer;
  other.classes[0].lower.power = -1;
  CHECK_THROWS_AS(particle_set(other, {}), InputError);
  other = answer;
  std::swap(other.classes[0], other.classes[1]);
  CHECK_THROWS_AS(particle_set(other, {}), InputError);
  other = answer;
  other.classes[1].lower = other.classes[0].lower;
  CHECK_THROWS_AS(particle_set(other, {}), InputError);
}

TEST_CASE("particle sets: a spread has the counts and, within the stated error, the masses of its match") {
  for (const bool tolerant : {false, true}) {
    Question question;
    question.at_least = 3000;
    if (tolerant)
      question.tolerances.push_back(parse_tolerance("retained:1%"));
    const Match m = match(sand, question);
    const ParticleSet one = particle_set(m);
    const ParticleSet set = spread_particle_set(m, 5);
    CHECK(set.particles() == m.particles());
    REQUIRE(set.classes.size() == one.classes.size());
    for (std::size_t j = 0; j < set.classes.size(); ++j) {
      const ParticleClass &c = set.classes[j];
      CHECK(c.quantity() == one.classes[j].quantity());
      Rational mass = 0;
      for (const ParticleSize &size : c.sizes)
        for (const Rational &x :
             {size.diameter.decimal(), read_double(size.diameter.text), Rational(2 * size.radius.decimal()),
              Rational(2 * read_double(size.radius.text))}) {
          CHECK((x > c.lower && x <= c.upper));
          mass += cube(x) / 4;
        }
      const Rational exact =
          Rational(one.classes[j].quantity()) * cube(one.classes[j].sizes[0].diameter.decimal());
      CHECK(abs(Rational(mass / exact - 1)) <= 2 * ParticleSetOptions().most_mass_error);
    }
    CHECK(set.classes[0].sizes.front().diameter.value < set.classes[0].sizes.back().diameter.value);
  }
}

TEST_CASE("particle sets: the answer of a spread is refused") {
  AnswerSample answer = read_answer(answer_json(match(sand)), "answer.json");
  answer.has_spread = true;
  CHECK_THROWS_AS(particle_set(answer, {}), InputError);
}

} // namespace particle_set_test

// Gradations whose openings are roots of fractions: sieves of half, quarter and tenth phi.

#include "catch.hpp"
#include "match/problem_spectrum.hpp"
#include "match/spread.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <random>

namespace root_test {

using namespace mdm;

namespace {

/// Random sieves at multiples of 1/d phi with masses of a few digits.
Gradation random_phi(std::mt19937_64 &random, unsigned d, bool factors) {
  Gradation::Data data;
  data.root = d;
  const std::size_t n = 3 + random() % 6;
  int exponent = static_cast<int>(random() % 20) - 15; // of 2, in units of 1/d
  const Integer most = random() % 2 == 0 ? 9 : 999;
  for (std::size_t j = 0; j < n; ++j) {
    const Rational size = exponent < 0 ? ratio(1, Integer(1) << static_cast<unsigned>(-exponent))
                                       : Rational(Integer(1) << static_cast<unsigned>(exponent));
    data.sizes.push_back(j == 0 && random() % 4 == 0 ? Rational(0) : size);
    exponent += 1 + static_cast<int>(random() % (d + 1));
    data.masses.emplace_back(j + 1 == n ? Integer(0) : Integer(random() % (most + 1)));
    data.factors.emplace_back(ratio(1 + Integer(random() % 5), 1 + Integer(random() % 3)));
  }
  if (data.masses[n - 2] == 0)
    data.masses[n - 2] = 1;
  if (!factors)
    data.factors.clear();
  data.root = d;
  return Gradation(std::move(data));
}

/// The same sieves to the power d: fractions, with the law a/(b d) the same problem.
Gradation powered(const Gradation &g) {
  Gradation::Data data;
  data.sizes = g.powers();
  data.masses = g.masses();
  data.factors = g.factors();
  return Gradation(std::move(data));
}

/// Every class holds its mass at the scale, and its enclosed size is in it: from the definitions, to the
/// power d.
void check_match(const Match &m) {
  const Gradation &g = m.gradation;
  const unsigned d = g.root(), p = m.question.law.b * d, degree = m.question.law.a * d;
  const Rational &scale = m.sample->scale->chosen;
  const std::vector<MatchClass> classes = m.classes();
  REQUIRE(classes.size() == g.classes());
  for (std::size_t j = 0; j < classes.size(); ++j) {
    REQUIRE(classes[j].size.has_value() == (g.mass(j) > 0));
    if (!classes[j].size)
      continue;
    const Rational size =
        scale * power(Rational(g.mass(j) / (g.factor(j) * Rational(classes[j].quantity))), p);
    CHECK(power(g.powers()[j], m.question.law.a) < size);
    CHECK(size <= power(g.powers()[j + 1], m.question.law.a));
    const Rational lo = classes[j].size->lower(), hi = classes[j].size->upper();
    CHECK(g.powers()[j] < power(lo, d));
    CHECK(power(hi, d) <= g.powers()[j + 1]);
    CHECK(power(lo, degree) <= size);
    CHECK((lo == hi ? power(hi, degree) == size : power(hi, degree) > size));
  }
}

Gradation read(const std::string &content) {
  return read_gradation(content, "sand.csv");
}

const std::string tied = "size_phi,mass\n-2,0\n-1.5,1\n-1,0\n-0.5,0\n0,1\n";

} // namespace

TEST_CASE("half-phi sieves tie exactly: 10 particles, where rounded openings need 9") {
  const Match m = solve(read(tied));
  CHECK(m.particles() == 10);
  check_match(m);
  CHECK(solve(read_gradation(tied, "sand.csv", {.phi = PhiReading::rounded})).particles() == 9);
}

TEST_CASE("phi sieves and their powers with the law over the root have the same matches") {
  std::mt19937_64 random(1301);
  for (int i = 0; i < 300; ++i) {
    const unsigned d = std::vector<unsigned>{2, 4, 10}[random() % 3];
    const Gradation g = random_phi(random, d, random() % 3 == 0);
    Question question, of_powers;
    question.law = random() % 3 == 0 ? MassLaw{5, 2} : MassLaw{3, 1};
    of_powers.law = MassLaw{question.law.a, question.law.b * d};
    question.min_per_class = of_powers.min_per_class = Integer(random() % 4);
    question.at_least = of_powers.at_least = random() % 2 == 0 ? Integer(1) : Integer(1 + random() % 200);
    const Match m = solve(g, question), same = solve(powered(g), of_powers);
    CHECK(m.sample->quantities == same.sample->quantities);
    const Chain &chain = std::get<Chain>(*m.evidence()), &same_chain = std::get<Chain>(*same.evidence());
    CHECK(chain.steps == same_chain.steps);
    CHECK(chain.above == same_chain.above);
    const MatchScale &scale = *m.sample->scale, &same_scale = *same.sample->scale;
    CHECK(scale.window.above == same_scale.window.above);
    CHECK(scale.window.up_to == same_scale.window.up_to);
    CHECK(scale.chosen == same_scale.chosen);
    check_match(m);
  }
}

TEST_CASE("phi sieves and their powers have the same spectrum") {
  std::mt19937_64 random(1302);
  for (int i = 0; i < 60; ++i) {
    const unsigned d = std::vector<unsigned>{2, 4, 10}[random() % 3];
    const Gradation g = random_phi(random, d, false);
    const Limits limits{200};
    const Spectrum of_phi = spectrum(Problem(g, {}, 1), limits);
    const Spectrum of_powers = spectrum(Problem(powered(g), MassLaw{3, d}, 1), limits);
    CHECK(of_phi.intervals == of_powers.intervals);
    CHECK(of_phi.all_from == of_powers.all_from);
    CHECK(spectrum(solve(g), limits).intervals == of_phi.intervals);
  }
}

TEST_CASE("whole phi with a root above 1 has the matches of the fractions") {
  std::mt19937_64 random(1303);
  for (int i = 0; i < 100; ++i) {
    const Gradation g = powered(random_phi(random, 1, true));
    Gradation::Data data;
    for (const Rational &x : g.sizes())
      data.sizes.push_back(power(x, 2));
    data.masses = g.masses();
    data.factors = g.factors();
    data.root = 2;
    Question question;
    question.solids = random() % 2 == 0 ? Solids(SolidsVolume{100}) : Solids(Cylinder{5, 7, ratio(1, 3)});
    question.size_factor = ratio(1 + Integer(random() % 5), 2);
    const Match m = solve(Gradation(data), question), same = solve(g, question);
    CHECK(m.sample->quantities == same.sample->quantities);
    CHECK(m.sample->scale->window.up_to == power(same.sample->scale->window.up_to, 2));
    check_match(m);
  }
}

TEST_CASE("a volume of solids is had at the scale that is its root") {
  Question question;
  question.solids = SolidsVolume{50};
  const Match m = solve(read(tied), question);
  check_match(m);
  CHECK(m.solids_volume()->upper() >= 50);
  question.solids = Cylinder{10, 10, ratio(1, 2)};
  const Match cylinder = solve(read(tied), question);
  check_match(cylinder);
  CHECK(cylinder.sample->scale->window.start->is_point());
}

TEST_CASE("the upper end of the scales is refused where a size would be an irrational opening") {
  SolveOptions options;
  options.scale = ScaleChoice::upper;
  const std::string half = "size_phi,mass\n-1.5,0\n-0.5,1\n0.5,3\n1,0\n";
  CHECK_THROWS_WITH(solve(read(half), {}, options),
                    Catch::Contains("is irrational: choose another --scale") &&
                        Catch::Contains("mdm convert"));
  const Match m = solve(read("size_phi,mass\n-1,0\n-0.5,1\n"), {}, options); // the opening above is 2 mm
  CHECK(m.sample->sizes[0]->text() == "2");
}

TEST_CASE("a spread keeps every size within irrational openings") {
  std::mt19937_64 random(1304);
  for (int i = 0; i < 40; ++i) {
    const Match m = solve(random_phi(random, 2, false));
    if (m.particles() > 2000)
      continue;
    const Spread spread = mdm::spread(m, 7);
    for (const ClassSpread &c : spread.classes) {
      const std::size_t j = c.index();
      ClassSpread::Masses masses = c.masses();
      Integer sum = 0;
      for (std::uint64_t n = 0; n < c.quantity(); ++n) {
        const Integer parts = masses.next();
        sum += parts;
        const Enclosure x = c.size(parts, 15);
        CHECK(m.gradation.powers()[j] < power(x.lower(), 2));
        CHECK(power(x.upper(), 2) <= m.gradation.powers()[j + 1]);
      }
      CHECK(sum == c.parts());
    }
  }
}

TEST_CASE("within a tolerance irrational masses are refused, rational ones are exact") {
  Question question;
  question.tolerances = {parse_tolerance("retained:1%")};
  CHECK_THROWS_WITH(solve(read(tied), question), Catch::Contains("mdm convert writes the openings in mm"));
  question.law = MassLaw{2, 1};
  const Match m = solve(read(tied), question);
  CHECK(m.status == Status::optimal);
  Gradation::Data data;
  data.sizes = read(tied).powers();
  data.masses = read(tied).masses();
  Question of_powers = question;
  of_powers.law = MassLaw{1, 1};
  CHECK(solve(Gradation(data), of_powers).particles() == m.particles());
}

TEST_CASE("powers that are too long are refused, with the conversion as the remedy") {
  CHECK_THROWS_WITH(solve(read("size_phi,mass\n-0.001,0\n0,1." + std::string(400, '1') + "\n")),
                    Catch::Contains("roots of degree 1000") && Catch::Contains("mdm convert"));
}

} // namespace root_test

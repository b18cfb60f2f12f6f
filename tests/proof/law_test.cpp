// Laws by table and by sum against enumeration, which takes their values by formulas of its own.

#include "catch.hpp"
#include "match/brute_force.hpp"
#include "match/problem_of.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

namespace law_test {

using namespace mdm;

namespace {

int up_to(std::mt19937_64 &random, unsigned most) {
  return static_cast<int>(1 + random() % most);
}

/// A table that reaches size 16, which no random gradation is beyond.
MassLaw random_table(std::mt19937_64 &random) {
  MassLaw law{1, 1};
  Rational mass = 0;
  for (int x = 0; x < 16;) {
    x = std::min(16, x + up_to(random, 5));
    mass += ratio(up_to(random, 40), 4);
    law.table.push_back({Rational(x) - (x < 16 && random() % 3 == 0 ? ratio(1, 2) : Rational(0)), mass});
  }
  return law;
}

MassLaw random_sum(std::mt19937_64 &random) {
  MassLaw law{1, 1};
  for (unsigned n = 4; n >= 1; --n)
    if (random() % 2 == 0 || (n == 1 && law.sum.empty()))
      law.sum.push_back({ratio(up_to(random, 9), up_to(random, 4)), n});
  return law;
}

/// f(x), by the definition.
Rational value(const MassLaw &law, const Rational &x) {
  Rational f = 0;
  for (const LawTerm &term : law.sum) {
    Rational product = term.coefficient;
    for (unsigned i = 0; i < term.exponent; ++i)
      product *= x;
    f += product;
  }
  Rational size = 0, mass = 0;
  for (const LawNode &node : law.table) {
    if (x > size)
      f = mass + (node.mass - mass) * (std::min(x, node.size) - size) / (node.size - size);
    size = node.size;
    mass = node.mass;
  }
  return f;
}

brute::Problem problem(const Gradation &g, const MassLaw &law) {
  brute::Problem p;
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.mass(j) > 0)
      p.push_back({g.factor(j) * value(law, g.lower(j)) / g.mass(j),
                   g.factor(j) * value(law, g.upper(j)) / g.mass(j), 1});
  return p;
}

/// Factors that are decimals, for the file.
Gradation random_gradation(std::mt19937_64 &random) {
  const Gradation g = brute::random_gradation(random);
  Gradation::Data data{g.id(), g.unit(), g.sizes(), g.masses(), {}, {}, {}, {}};
  if (g.has_factors())
    for (std::size_t j = 0; j < g.sizes().size(); ++j)
      data.factors.push_back(ratio(up_to(random, 9), 4));
  return Gradation(std::move(data));
}

checker::Verdict checked(const Gradation &g, const std::string &certificate) {
  return checker::check({"gradation", gradation_csv(g)}, {"certificate", certificate});
}

std::string law_line(const std::string &certificate) {
  const std::size_t at = certificate.find("law ");
  return certificate.substr(at, certificate.find('\n', at) - at);
}

/// Every size is in its class, and f encloses the mass of a particle.
void check_sizes(const Match &m) {
  const Gradation &g = m.gradation;
  const std::vector<Rational> masses = powered_masses(m);
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const Integer &q = m.sample->quantities[j];
    if (q == 0)
      continue;
    const Enclosure &x = m.sample->sizes[j].value();
    const Rational one = masses[j] / (g.factor(j) * Rational(q));
    REQUIRE(x.lower() > g.lower(j));
    REQUIRE(x.upper() <= g.upper(j));
    REQUIRE(value(m.question.law, x.lower()) <= one);
    if (x.is_point())
      REQUIRE(value(m.question.law, x.lower()) == one);
    else
      REQUIRE(value(m.question.law, x.upper()) > one);
  }
}

} // namespace

TEST_CASE("laws by table and sum have the matches of enumeration, and certificates that are accepted") {
  std::mt19937_64 random(30);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const Gradation g = random_gradation(random);
    Question question;
    question.law = i % 2 == 0 ? random_table(random) : random_sum(random);
    SolveOptions options;
    options.digits = 1 + static_cast<unsigned>(random() % 20);
    options.scale = random() % 3 == 0 ? ScaleChoice::automatic : ScaleChoice::upper;
    INFO(gradation_csv(g) << question.law.formula(SizeUnit::mm));
    Match m = [&] {
      try {
        return solve(g, question, options);
      } catch (const InputError &) { // at the upper end a size may be an opening that is no decimal
        options.scale = ScaleChoice::automatic;
        return solve(g, question, options);
      }
    }();
    const brute::Problem b = problem(g, question.law);
    if (const auto expected = brute::least_match(b, brute::some_scale(b))) {
      brute::Vector found;
      for (std::size_t j = 0; j < g.classes(); ++j)
        if (g.mass(j) > 0)
          found.push_back(m.sample->quantities[j]);
      REQUIRE(found == *expected);
      ++compared;
    }
    check_sizes(m);
    const std::string text = certificate(m);
    const checker::Verdict verdict = checked(g, text);
    INFO(text << verdict.line << verdict.reason);
    REQUIRE(verdict.code == checker::Verdict::accepted);
    REQUIRE(verdict.line.find("mass law " + question.law.formula(SizeUnit::mm)) != std::string::npos);
    std::string more = text;
    const std::string line = "particles " + to_string(*m.particles());
    more.replace(more.find(line), line.size(), "particles " + to_string(Integer(*m.particles() + 1)));
    REQUIRE(checked(g, more).code != checker::Verdict::accepted);
  }
  CHECK(compared > 500);
}

TEST_CASE("laws by table and sum within a tolerance: certificates that are accepted") {
  std::mt19937_64 random(31);
  for (int i = 0; i < 150; ++i) {
    const Gradation g = random_gradation(random);
    Question question;
    question.law = i % 2 == 0 ? random_table(random) : random_sum(random);
    const Match exact = solve(g, question, {});
    for (const char *tolerance : {"retained:5%", "passing:2%", "total:10%"}) {
      question.tolerances = {parse_tolerance(tolerance)};
      const Match m = solve(g, question, {});
      INFO(gradation_csv(g) << question.law.formula(SizeUnit::mm) << tolerance);
      REQUIRE(m.status == Status::optimal);
      REQUIRE(*m.particles() <= *exact.particles());
      const checker::Verdict verdict = checked(g, certificate(m));
      INFO(verdict.line << verdict.reason);
      REQUIRE(verdict.code == checker::Verdict::accepted);
    }
  }
}

TEST_CASE("a table with the values of a power at all openings has its match, and its sizes there") {
  std::mt19937_64 random(32);
  for (int i = 0; i < 300; ++i) {
    const Gradation g = brute::random_gradation(random);
    for (unsigned n = 1; n <= 3; ++n) {
      Question powers, tables;
      powers.law = {n, 1};
      tables.law = {1, 1};
      for (const Rational &x : g.sizes())
        if (x > 0)
          tables.law.table.push_back({x, power(x, n)});
      SolveOptions options;
      options.scale = ScaleChoice::upper;
      const Match a = solve(g, powers, options), b = solve(g, tables, options);
      REQUIRE(a.sample->quantities == b.sample->quantities);
      REQUIRE(a.sample->scale->chosen == b.sample->scale->chosen);
      for (std::size_t j = 0; j < g.classes(); ++j)
        if (a.sample->sizes[j] && a.sample->sizes[j]->upper() == g.upper(j))
          REQUIRE(b.sample->sizes[j]->lower() == g.upper(j));
    }
  }
}

TEST_CASE("a sum of one power of factor 1 is that power, to the last digit") {
  std::mt19937_64 random(33);
  for (int i = 0; i < 300; ++i) {
    const Gradation g = random_gradation(random);
    Question spheres, sums;
    sums.law = {1, 1, {}, {{1, 3}}};
    std::string of_sphere = certificate(solve(g, spheres, {})), of_sum = certificate(solve(g, sums, {}));
    REQUIRE(law_line(of_sum) == "law sum 1 3");
    of_sum.replace(of_sum.find("law sum 1 3"), 11, "law 3");
    REQUIRE(of_sum == of_sphere);
  }
}

TEST_CASE("a match of a law by table or sum is refused under another law") {
  const Gradation g({0, 1, 2, 4}, {1, 2, 3, 0});
  Question question;
  question.law = {1, 1, {}, {{2, 3}, {ratio(1, 2), 1}}};
  const std::string of_sum = certificate(solve(g, question, {}));
  REQUIRE(law_line(of_sum) == "law sum 2 3 1/2 1");
  question.law = {1, 1, {{1, 1}, {2, ratio(15, 2)}, {4, 65}}, {}};
  const std::string of_table = certificate(solve(g, question, {}));
  REQUIRE(law_line(of_table) == "law table 1 1 2 7.5 4 65");
  const auto with = [](std::string text, const std::string &line) {
    return text.replace(text.find("law "), law_line(text).size(), line);
  };
  CHECK(checked(g, of_sum).code == checker::Verdict::accepted);
  CHECK(checked(g, of_table).code == checker::Verdict::accepted);
  for (const char *line : {"law sum 2 3 1/3 1", "law sum 2 3", "law sum 2 4 1/2 1", "law 3", "law 1",
                           "law table 1 1 2 8 4 65", "law table 4 65", "law table 1 1 2 7.5"}) {
    INFO(line);
    CHECK(checked(g, with(of_sum, line)).code == checker::Verdict::refused);
    CHECK(checked(g, with(of_table, line)).code == checker::Verdict::refused);
  }
  for (const char *line : {"law sum",
                           "law sum 2",
                           "law sum 2 3 1/2",
                           "law sum 0 3",
                           "law sum 1/2 1 2 3",
                           "law sum 2 3 2 3",
                           "law sum 2/4 3",
                           "law sum 2.5 3",
                           "law sum 1 0",
                           "law sum 1 1001",
                           "law sum 1 03",
                           "law sum -1 3",
                           "law table",
                           "law table 1",
                           "law table 1 1 2",
                           "law table 1 1 1 2 4 65",
                           "law table 1 1 2 1 4 65",
                           "law table 0 0 4 65",
                           "law table 4 65 2 1",
                           "law table 1/2 1 4 65",
                           "law table 1.0 1 4 65",
                           "law tables 4 65",
                           "law table 4  65",
                           "law curve 3"}) {
    INFO(line);
    CHECK(checked(g, with(of_sum, line)).code == checker::Verdict::malformed);
    CHECK(checked(g, with(of_table, line)).code == checker::Verdict::malformed);
  }
  std::string terms = "law sum", nodes = "law table";
  for (int i = 0; i < 17; ++i)
    terms += " 1 " + std::to_string(17 - i);
  for (int i = 1; i <= 1001; ++i)
    nodes += " " + std::to_string(i) + " " + std::to_string(i);
  for (const std::string &line : {terms, nodes})
    CHECK(checked(g, with(of_sum, line)).code == checker::Verdict::malformed);
}

TEST_CASE("a law by table or sum holds for openings that are fractions, up to its last node") {
  const Gradation g({0, 1, 2, 4}, {1, 2, 3, 0});
  Question question;
  question.law = {1, 1, {{1, 1}, {3, 9}}, {}};
  const auto message = [&](const Gradation &of) -> std::string {
    try {
      solve(of, question, {});
    } catch (const InputError &e) {
      return e.what();
    }
    return {};
  };
  CHECK(message(g) ==
        "the size 4 is beyond the table of the mass law, which ends at 3: add a row to the table");
  Gradation::Data data;
  data.sizes = {1, 2, 8};
  data.masses = {1, 1, 0};
  data.root = 2;
  CHECK(message(Gradation(data)).find("convert") != std::string::npos);
  question.solids = SolidsVolume{5};
  CHECK(message(g).find("needs spheres") != std::string::npos);
}

} // namespace law_test

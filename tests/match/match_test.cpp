// The answer in its one form, whatever was asked and however the search ended.

#include "brute_force.hpp"
#include "catch.hpp"
#include "plain_gradation.hpp"

#include <mdm/match/solve.hpp>

namespace match_test {

using namespace mdm;

namespace {

Question within(const std::string &tolerance) {
  Question question;
  question.tolerances = {parse_tolerance(tolerance)};
  return question;
}

Integer particles_of(const Match &m) {
  Integer n = 0;
  for (const MatchClass &c : m.classes())
    n += c.quantity;
  return n;
}

} // namespace

TEST_CASE("the classes of a match hold its shares in sizes of their own, exactly or within a tolerance") {
  std::mt19937_64 random(71);
  int changed = 0;
  for (int i = 0; i < 300; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Match m = solve(g, random() % 2 == 0 ? Question{} : within("retained:5%"));
    REQUIRE(m.status == Status::optimal);
    const std::vector<Rational> target = shares(g);
    const std::vector<MatchClass> classes = m.classes();
    REQUIRE(classes.size() == g.classes());
    Rational all = 0;
    for (std::size_t j = 0; j < classes.size(); ++j) {
      const MatchClass &c = classes[j];
      all += c.share;
      CHECK(c.mass == g.mass(j));
      CHECK(abs(Rational(c.share - target[j])) <= (m.tolerance ? ratio(1, 20) : Rational(0)));
      changed += c.share == target[j] ? 0 : 1;
      REQUIRE((c.share > 0) == c.size.has_value());
      REQUIRE((c.quantity > 0) == c.size.has_value());
      if (!c.size)
        continue;
      CHECK(g.lower(j) < c.size->lower());
      CHECK(c.size->upper() <= g.upper(j));
      // q c x^3 = share M
      const Rational of_mass = c.share * m.sample->mass / (Rational(c.quantity) * g.factor(j));
      CHECK(power(c.size->lower(), 3) <= of_mass);
      CHECK(of_mass <= power(c.size->upper(), 3));
    }
    CHECK(all == 1);
    CHECK(particles_of(m) == m.particles());
    CHECK(std::holds_alternative<Tree>(m.evidence().value()) == m.tolerance.has_value());
    CHECK(m.sample->scale.has_value() != m.tolerance.has_value());
  }
  CHECK(changed > 100);
}

TEST_CASE("where no set matches there are no particles and no classes, and the tree says why") {
  Question question;
  question.band = Envelope{"", SizeUnit::mm, {1, 2}, {50, 0}, {100, 25}, {}};
  const Match none = solve(gradation({0, 1, 2, 4}, {1, 1, 1, 0}), question);
  CHECK(none.status == Status::none);
  CHECK(none.complete);
  CHECK_FALSE(none.particles().has_value());
  CHECK(none.classes().empty());
  CHECK_FALSE(none.solids_volume().has_value());
  CHECK(std::holds_alternative<Tree>(none.evidence().value()));
}

TEST_CASE("where a limit came before a match there are no particles, and evidence of a bound") {
  Question question;
  question.band = Envelope{"", SizeUnit::mm, {1, 2}, {10, 40}, {20, 70}, {}};
  SolveOptions options;
  options.limits.deadline = std::chrono::steady_clock::now();
  const Match unknown = solve(gradation({0, 1, 2, 4}, {1, 1, 1, 0}), question, options);
  CHECK(unknown.status == Status::unknown);
  CHECK_FALSE(unknown.particles().has_value());
  CHECK(unknown.classes().empty());
  REQUIRE(unknown.evidence().has_value());
  CHECK(unknown.proof.bound == unknown.lower_bound);
}

TEST_CASE("a match with more particles than may be is known and no answer") {
  const Gradation g = gradation({1, 2, 3}, {2, 1, 0});
  SolveOptions options;
  options.at_most = 1;
  for (const Question &question : {Question{}, within("retained:1%")}) {
    const Match m = solve(g, question, options);
    CHECK(m.status == Status::none);
    CHECK_FALSE(m.has_answer());
    CHECK(m.lower_bound > 1);
    CHECK((!m.particles() || *m.particles() > 1));
  }
}

TEST_CASE("evidence is there if it was to be kept, of a bound where the search did not come to its end") {
  const Gradation g = gradation({10, 11, 20, 21}, {1, 0, 1, 0});
  SolveOptions options;
  REQUIRE(solve(g, {}, options).evidence().has_value());
  CHECK_FALSE(std::get<Chain>(*solve(g, {}, options).evidence()).steps.empty());
  options.limits.keep_proof = false;
  CHECK_FALSE(solve(g, {}, options).evidence().has_value());
  CHECK_FALSE(solve(g, within("retained:0.1%"), options).evidence().has_value());
  options.limits.keep_proof = true;
  options.limits.max_steps = 0;
  const Match limited = solve(g, {}, options);
  CHECK(limited.proof.bound == limited.lower_bound);
  CHECK(std::get<Chain>(limited.evidence().value()).steps.empty());
}

TEST_CASE("a bound that is the number of the match is no evidence without the end of the sweep") {
  Question question;
  question.min_per_class = 1000;
  SolveOptions options;
  options.limits.max_steps = 0;
  const Match m = solve(gradation({10, 20}, {1, 0}), question, options);
  REQUIRE(m.lower_bound == m.particles());
  CHECK_FALSE(m.complete);
  CHECK_FALSE(m.evidence().has_value());
  CHECK_FALSE(m.proof.bound.has_value());
}

TEST_CASE("the steps of a chain are classes of the gradation") {
  const Match m = solve(gradation({1, 2, 10, 11, 20, 21}, {0, 0, 1, 0, 1, 0}));
  for (const std::uint32_t j : std::get<Chain>(m.evidence().value()).steps)
    CHECK(m.gradation.mass(j) > 0);
}

TEST_CASE("a chain for more particles than the least match has begins above a scale") {
  Question question;
  question.at_least = 8;
  for (question.at_least = 8; question.at_least < 40; ++question.at_least) {
    const Match m = solve(gradation({10, 11, 20, 21}, {1, 0, 1, 0}), question);
    const Chain &chain = std::get<Chain>(m.evidence().value());
    if (m.particles() == question.at_least)
      CHECK((chain.steps.empty() && !chain.above));
    else if (chain.above)
      CHECK(*chain.above > 0);
  }
}

} // namespace match_test

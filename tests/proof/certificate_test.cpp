#include "catch.hpp"
#include "match/brute_force.hpp"
#include "proof/vipr.hpp"
#include "vipr_checker.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

namespace certificate_test {

using namespace mdm;

namespace {

mdm::checker::Verdict checked(const Gradation &g, const std::string &certificate) {
  return mdm::checker::check({"gradation", gradation_csv(g)}, {"certificate", certificate});
}

/// A question of random parts that fits g.
Question random_question(const Gradation &g, std::mt19937_64 &random) {
  Question q;
  const MassLaw laws[] = {{3, 1}, {3, 1}, {3, 1}, {2, 1}, {5, 2}, {1, 2}, {1, 3}};
  q.law = laws[random() % 7];
  if (random() % 3 == 0)
    q.min_per_class = static_cast<int>(1 + random() % 4);
  if (random() % 2 == 0)
    q.at_least = static_cast<int>(1 + random() % 60);
  if (random() % 4 == 0)
    q.size_factor = ratio(static_cast<int>(1 + random() % 30), 10);
  if (random() % 4 == 0 && g.sizes().front() == 0)
    q.pan_size = g.sizes()[1] / 2;
  if (random() % 4 == 0 && g.mass(g.classes() - 1) > 0)
    q.cut_below = g.lower(g.classes() - 1);
  if (q.cut_below == Rational(0))
    q.cut_below = std::nullopt;
  if (!q.law.is_sphere())
    return q;
  switch (random() % 6) {
  case 0:
    q.solids =
        Cylinder{static_cast<int>(1 + random() % 30), static_cast<int>(1 + random() % 30), ratio(7, 10)};
    break;
  case 1:
    q.solids = Box{static_cast<int>(1 + random() % 30), 2, ratio(5, 2), ratio(1, 4)};
    break;
  case 2:
    q.solids = SolidsVolume{ratio(static_cast<int>(1 + random() % 3000), 10)};
    break;
  default:
    break;
  }
  return q;
}

} // namespace

TEST_CASE("the certificate of every match is accepted, and refused with another N") {
  std::mt19937_64 random(16);
  for (int i = 0; i < 2000; ++i) {
    Gradation g = brute::random_gradation(random);
    if (g.has_factors()) { // thirds are no decimals
      Gradation::Data data{g.id(), g.unit(), g.sizes(), g.masses(), {}, {}, {}, {}};
      for (std::size_t j = 0; j < g.sizes().size(); ++j)
        data.factors.push_back(ratio(static_cast<int>(1 + random() % 9), 4));
      g = Gradation(std::move(data));
    }
    SolveOptions options;
    options.digits = 1 + static_cast<unsigned>(random() % 25);
    options.scale = random() % 3 == 0 ? ScaleChoice::upper : ScaleChoice::automatic;
    const Match m = solve(g, random_question(g, random), options);
    const std::string text = certificate(m);
    const mdm::checker::Verdict verdict = checked(g, text);
    INFO(gradation_csv(g) << text << verdict.line << verdict.reason);
    REQUIRE(verdict.code == mdm::checker::Verdict::accepted);
    std::string more = text;
    const std::string line = "particles " + to_string(*m.particles());
    more.replace(more.find(line), line.size(), "particles " + to_string(Integer(*m.particles() + 1)));
    REQUIRE(checked(g, more).code != mdm::checker::Verdict::accepted);
  }
}

TEST_CASE("the certificate of an exact search that a limit ended has its bounds, and is refused with a "
          "higher one") {
  std::mt19937_64 random(33);
  int limited = 0;
  for (int i = 0; i < 4000; ++i) {
    Gradation g = brute::random_gradation(random);
    if (g.has_factors())
      continue;
    SolveOptions options;
    options.limits.max_steps = random() % 4;
    const Match m = solve(g, random_question(g, random), options);
    if (!m.proof.bound)
      continue;
    ++limited;
    REQUIRE_FALSE(m.complete);
    REQUIRE(m.proof.bound == m.lower_bound);
    const Certified made = certified(m);
    const mdm::checker::Verdict verdict = checked(g, made.text);
    INFO(gradation_csv(g) << made.text << verdict.line << verdict.reason);
    REQUIRE(made.bound == m.lower_bound);
    REQUIRE(verdict.code == mdm::checker::Verdict::accepted);
    std::string higher = made.text;
    const std::string line = "particles " + to_string(m.lower_bound) + "..";
    higher.replace(higher.find(line), line.size(),
                   "particles " + to_string(Integer(m.lower_bound + 1)) + "..");
    REQUIRE(checked(g, higher).code != mdm::checker::Verdict::accepted);
  }
  CHECK(limited > 300);
}

TEST_CASE("a chain that is too long for the format is cut, and the bound with it") {
  Question question;
  question.law = {1000, 1};
  Gradation::Data data;
  data.sizes = {1, parse_decimal("1.000000001"), parse_decimal("1.000000002")};
  data.masses = {1, 1, 0};
  const Gradation g(std::move(data));
  SolveOptions options;
  options.limits.max_steps = 250'000;
  const Match m = solve(g, question, options);
  REQUIRE(m.proof.bound.has_value());
  const Certified made = certified(m);
  REQUIRE(made.bound.has_value());
  CHECK(*made.bound < *m.proof.bound);
  CHECK(*made.bound > *m.proof.bound / 2);
  const mdm::checker::Verdict verdict = checked(g, made.text);
  INFO(verdict.line << verdict.reason);
  CHECK(verdict.code == mdm::checker::Verdict::accepted);
  CHECK(verdict.line.find(" exactly is between " + to_string(*made.bound) + " and ") != std::string::npos);
}

TEST_CASE("the VIPR export is a proof by the rules of the format") {
  std::mt19937_64 random(17);
  for (int i = 0; i < 400; ++i) {
    const Gradation g = brute::random_gradation(random);
    Question q = random_question(g, random);
    if (q.law.b > 1)
      q.law = {};
    const Match m = solve(g, q);
    const std::string text = vipr(m);
    INFO(text);
    REQUIRE_NOTHROW(vipr_checker::Checker(text).check(*m.particles()));
    REQUIRE_THROWS(vipr_checker::Checker(text).check(*m.particles() + 1));
  }
}

TEST_CASE("numbers in the gaps of the spectrum are proved out of reach") {
  Gradation::Data data;
  data.sizes = {10, 11, 20, 21};
  data.masses = {1, 0, 1, 0};
  const Gradation g(std::move(data));
  int gaps = 0;
  for (int n = 2; n < 80; ++n) {
    Question q;
    q.at_least = n;
    const Match m = solve(g, q);
    gaps += m.particles() > n ? 1 : 0;
    CHECK(checked(g, certificate(m)).code == mdm::checker::Verdict::accepted);
    CHECK_NOTHROW(vipr_checker::Checker(vipr(m)).check(*m.particles()));
  }
  CHECK(gaps >= 10);
}

TEST_CASE("a VIPR export needs rational numbers") {
  Gradation::Data data;
  data.sizes = {1, 4, 9};
  data.masses = {2, 1, 0};
  Question q;
  q.law = {3, 2};
  const Match squares = solve(Gradation(data), q);
  CHECK_NOTHROW(vipr_checker::Checker(vipr(squares)).check(*squares.particles()));
  data.sizes = {1, 2, 9};
  CHECK_THROWS_AS(vipr(solve(Gradation(data), q)), InputError);
}

TEST_CASE("a certificate with a number of more than 100,000 digits is refused, not written") {
  Gradation::Data data;
  data.sizes = {1, ratio(3, 2), 2, 3};
  data.masses = {1, 2, 3, 0};
  Question question;
  question.law = MassLaw{1000, 999};
  question.at_least = power_of_ten(110); // `above` is a 999th power
  const Match m = solve(Gradation(data), question);
  CHECK_THROWS_WITH(certificate(m), Catch::Contains("digits, and its format allows 100000"));
  question.at_least = 20;
  CHECK_FALSE(certificate(solve(Gradation(data), question)).empty());
}

TEST_CASE("that no certificate can be short enough is said before solving") {
  Gradation::Data data;
  data.sizes = {1, 1 + ratio(1, power_of_ten(900)), 2};
  data.masses = {1, 1, 0};
  Question question;
  CHECK_NOTHROW(check_certifiable(Gradation(data), question));
  question.law = MassLaw{1000, 1};
  CHECK_THROWS_AS(check_certifiable(Gradation(data), question), InputError);
  question.law = MassLaw{};
  question.min_per_class = Integer(1) << (1 << 20);
  CHECK_THROWS_AS(check_certifiable(Gradation(data), question), InputError);
}

TEST_CASE("only what could not be certified is refused before solving") {
  Gradation::Data data;
  data.sizes = {1, ratio(3, 2), 2, 3};
  data.masses = {1, 2, 3, 0};
  const auto is_refused = [](const auto &action) {
    try {
      action();
      return false;
    } catch (const InputError &) {
      return true;
    }
  };
  for (const unsigned digits : {98U, 108U})
    for (Integer Question::*const least : {&Question::at_least, &Question::min_per_class}) {
      Question question;
      question.law = MassLaw{1000, 999};
      question.*least = power_of_ten(digits);
      const bool before = is_refused([&] { check_certifiable(Gradation(data), question); });
      const bool after = is_refused([&] { certificate(solve(Gradation(data), question)); });
      INFO(digits);
      CHECK((after || !before));
      CHECK(before == (digits == 108));
    }
}

} // namespace certificate_test

#include "catch.hpp"
#include "check.hpp"
#include "match/brute_force.hpp"
#include "vipr_checker.hpp"

#include <mdm/error.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/proof/vipr.hpp>

using namespace mdm;

namespace {

mdm_check::Verdict checked(const Gradation &g, const std::string &certificate) {
  return mdm_check::check({"gradation", gradation_csv(g)}, {"certificate", certificate});
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
    const mdm_check::Verdict verdict = checked(g, text);
    INFO(gradation_csv(g) << text << verdict.line);
    REQUIRE(verdict.code == mdm_check::Verdict::accepted);
    std::string more = text;
    const std::string line = "particles " + to_string(m.particles());
    more.replace(more.find(line), line.size(), "particles " + to_string(Integer(m.particles() + 1)));
    REQUIRE(checked(g, more).code != mdm_check::Verdict::accepted);
  }
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
    REQUIRE_NOTHROW(vipr_checker::Checker(text).check(m.particles()));
    REQUIRE_THROWS(vipr_checker::Checker(text).check(m.particles() + 1));
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
    CHECK(checked(g, certificate(m)).code == mdm_check::Verdict::accepted);
    CHECK_NOTHROW(vipr_checker::Checker(vipr(m)).check(m.particles()));
  }
  CHECK(gaps > 8);
}

TEST_CASE("a VIPR export needs rational numbers") {
  Gradation::Data data;
  data.sizes = {1, 4, 9};
  data.masses = {2, 1, 0};
  Question q;
  q.law = {3, 2};
  const Match squares = solve(Gradation(data), q);
  CHECK_NOTHROW(vipr_checker::Checker(vipr(squares)).check(squares.particles()));
  data.sizes = {1, 2, 9};
  CHECK_THROWS_AS(vipr(solve(Gradation(data), q)), InputError);
}

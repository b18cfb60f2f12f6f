#include "blend/blend_vipr.hpp"
#include "catch.hpp"
#include "vipr_checker.hpp"

#include <mdm/text/error.hpp>

#include <random>

namespace blend_vipr_test {

using namespace mdm;

namespace {

/// 2 or 3 stockpiles on two sieves, and the fineness modulus that a third one stands for.
BlendProblem random_problem(std::mt19937_64 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  BlendProblem p;
  p.steps = static_cast<std::uint64_t>(4 + upto(8));
  p.aim = static_cast<BlendAim>(upto(3));
  for (int i = 2 + upto(1); i > 0; --i) {
    const int fine = upto(60);
    p.stockpiles.push_back({std::string(1, static_cast<char>('A' + i)), {fine, fine + upto(40), upto(100)}});
    Stockpile &s = p.stockpiles.back();
    s.cost = ratio(upto(20), 3);
    if (upto(4) == 0)
      s.most = ratio(5, 7);
    if (upto(4) == 0)
      s.least = ratio(1, 9);
  }
  for (const int size : {1, 2}) {
    const int least = upto(50);
    p.sieves.push_back({size, least, least + upto(50), Rational(upto(100))});
  }
  p.sieves.push_back({0, upto(30), 70 + upto(30), std::nullopt, FinenessModulus::en});
  return p;
}

/// All blends in steps, within the limits or not.
std::vector<Blend> blends_of(const BlendProblem &p) {
  std::vector<Blend> blends;
  const std::uint64_t third = p.stockpiles.size() == 3 ? p.steps : 0;
  for (std::uint64_t a = 0; a <= p.steps; ++a)
    for (std::uint64_t c = 0; c <= std::min(third, p.steps - a); ++c) {
      std::vector<Rational> shares = {ratio(a, p.steps), ratio(p.steps - a - c, p.steps), ratio(c, p.steps)};
      shares.resize(p.stockpiles.size());
      blends.push_back(blend_of(p, shares));
    }
  return blends;
}

/// The blend as values of the file's variables.
std::map<std::size_t, Rational> values_of(const BlendProblem &p, const Blend &blend) {
  std::map<std::size_t, Rational> x;
  for (const Rational &share : blend.shares)
    x.emplace(x.size(), share * p.steps);
  if (p.aim == BlendAim::max_deviation)
    x.emplace(x.size(), blend.value);
  for (std::size_t s = 0; s < 2 && p.aim == BlendAim::deviation; ++s)
    x.emplace(x.size(), abs(Rational(blend.passing[s] - *p.sieves[s].target)));
  return x;
}

} // namespace

TEST_CASE("the VIPR export of a blend states its problem and proves its value, or that there is none") {
  std::mt19937_64 random(23);
  int none = 0, searched = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const BlendProblem p = random_problem(random);
    const BlendAnswer a = solve_blend(p);
    const std::string text = blend_vipr(p, a);
    INFO(text);
    std::optional<Rational> least;
    for (const Blend &blend : blends_of(p)) {
      const bool is_within = broken_limits(p, blend).empty();
      CHECK(vipr_checker::Checker(text).admits(values_of(p, blend), "min") == is_within);
      if (is_within)
        least = std::min(least.value_or(blend.value), blend.value);
    }
    if (least)
      CHECK_NOTHROW(vipr_checker::Checker(text).check(*least));
    else
      CHECK_NOTHROW(vipr_checker::Checker(text).check_infeasible());
    none += !least;
    searched += a.tree.size() > 1;
  }
  CHECK(none > 50);
  CHECK(searched > 100);
}

TEST_CASE("a VIPR export does not serve another claim") {
  std::mt19937_64 random(24);
  int forged = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const BlendProblem p = random_problem(random);
    const BlendAnswer a = solve_blend(p);
    if (a.best.empty() || p.aim == BlendAim::none)
      continue;
    std::string text = blend_vipr(p, a);
    CHECK_THROWS(vipr_checker::Checker(text).check(a.best.front().value + 1));
    CHECK_THROWS(vipr_checker::Checker(text).check_infeasible());
    // A share more of the blend's steps is no solution.
    const std::size_t from = text.find("\nblend ") + 1, to = text.find('\n', from);
    text.replace(from, to - from, "blend 1 0 " + std::to_string(p.steps + 1));
    CHECK_THROWS(vipr_checker::Checker(text).check(a.best.front().value));
    ++forged;
  }
  CHECK(forged > 100);
}

TEST_CASE("what is not linear has no VIPR export") {
  std::mt19937_64 random(25);
  BlendProblem p = random_problem(random);
  p.at_most = 1;
  CHECK_THROWS_AS(blend_vipr(p, solve_blend(p)), InputError);
  p.at_most.reset();
  p.aim = BlendAim::squares;
  CHECK_THROWS_AS(blend_vipr(p, solve_blend(p)), InputError);
}

} // namespace blend_vipr_test

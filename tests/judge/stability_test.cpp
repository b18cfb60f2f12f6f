// Internal stability, against curves that are read point by point in double, and ties made by hand.

#include "all_cases.hpp"
#include "catch.hpp"
#include "judge/stability.hpp"
#include "soils.hpp"

#include <algorithm>

namespace stability_test {

using namespace mdm;
using namespace judge_test;

namespace {

const std::vector<std::string> sieves = {"64",   "31.5",  "16",   "8",    "4",    "2",
                                         "0.85", "0.425", "0.25", "0.15", "0.075"};

struct Made {
  UnderstoodGradation report;
  Points points; // ascending
};

Made made(const std::vector<int> &tenths, const std::vector<double> &moved = {}) {
  std::vector<std::string> passing;
  Points points;
  for (std::size_t i = 0; i < sieves.size(); ++i) {
    passing.push_back(of_tenths(tenths[i]));
    points.emplace_back(std::stod(sieves[i]), tenths[i] / 10.0 + (moved.empty() ? 0 : moved[i]));
  }
  std::reverse(points.begin(), points.end());
  return {soil(sieves, passing), points};
}

double middle(const Real &y) {
  const Enclosure e = enclose(y, 12);
  return static_cast<double>(e.lower());
}

/// The least H/F at 4,000 sizes.
double least_by_points(const Points &points) {
  const double d60 = size_at(points, 60), d10 = size_at(points, 10);
  const double most = d60 / d10 > 3 ? 20 : 30;
  const double from = std::log(points.front().first), to = std::log(size_at(points, most));
  double least = 1e300;
  for (int i = 0; i <= 4000; ++i) {
    const double d = std::exp(from + (to - from) * i / 4000), f = percent_at(points, d);
    if (f > 1e-9)
      least = std::min(least, percent_at(points, 4 * d) / f - 1);
  }
  return least;
}

/// The greatest quotient at 4,000 splits, and beside those where a percent of the curve is on either side.
double most_by_points(const Points &points) {
  double most = 0;
  const double from = points.front().second, beside = 1e-7;
  const auto look = [&](double f) {
    if (from + beside / 2 < f && f < 85)
      most = std::max(most, size_at(points, 15 + f) / size_at(points, f));
  };
  for (int i = 1; i < 4000; ++i)
    look(from + (85 - from) * i / 4000);
  for (const auto &point : points)
    for (const double f : {point.second, point.second - 15})
      for (const double side : {-beside, beside})
        look(f + side);
  return most;
}

RuleJudgement exact(const Made &m, StabilityRule rule) {
  return judge_stability(m.report, rule, Rational(0));
}

const Requirement &the_one(const RuleJudgement &j) {
  REQUIRE(j.requirements.size() == 1);
  return j.requirements.front();
}

/// Sieves of 1, 2, 4, ... mm from the coarsest on, taken as exact.
RuleJudgement by_octaves(const std::vector<std::string> &passing, StabilityRule rule) {
  std::vector<std::string> sizes;
  for (std::size_t i = passing.size(); i-- > 0;)
    sizes.push_back(std::to_string(1U << i));
  return judge_stability(soil(sizes, passing), rule, Rational(0));
}

} // namespace

TEST_CASE("the least H/F is that of a curve read point by point", "[stability]") {
  std::mt19937 random(1);
  for (int i = 0; i < 40; ++i) {
    const Made m = made(random_tenths(random, sieves.size(), 0));
    const RuleJudgement j = exact(m, StabilityRule::kenney_lau);
    CAPTURE(i);
    if (j.requirements.empty()) // as much passes the finest sieve
      continue;
    const double found = middle(*the_one(j).value.value), seen = least_by_points(m.points);
    CHECK(found <= seen + 1e-9);
    CHECK(found == Approx(seen).epsilon(0.02).margin(0.02));
    CHECK((j.verdict == Compliance::holds) == (found >= 1));
  }
}

TEST_CASE("the greatest quotient of a split is that of a curve read point by point", "[stability]") {
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const Made m = made(random_tenths(random, sieves.size(), 0));
    const RuleJudgement j = exact(m, StabilityRule::kezdi);
    CAPTURE(i);
    if (j.requirements.empty())
      continue;
    const double found = middle(*the_one(j).value.value), seen = most_by_points(m.points);
    CHECK(found >= seen * (1 - 1e-5));
    CHECK(found == Approx(seen).epsilon(1e-4));
    CHECK((j.verdict == Compliance::holds) == (found <= 4));
  }
}

TEST_CASE("d90/d60 lies between the lines of Burenkova, or not", "[stability]") {
  std::mt19937 random(3);
  int holds = 0, fails = 0;
  for (int i = 0; i < 200; ++i) {
    const Made m = made(random_tenths(random, sieves.size(), 0));
    const RuleJudgement j = exact(m, StabilityRule::burenkova);
    if (m.points.front().second >= 15)
      continue;
    const double d90 = size_at(m.points, 90), h1 = d90 / size_at(m.points, 60),
                 h2 = std::log10(d90 / size_at(m.points, 15));
    const bool inside = 0.76 * h2 + 1 < h1 && h1 < 1.86 * h2 + 1;
    CHECK((j.verdict == Compliance::holds) == inside);
    ++(inside ? holds : fails);
  }
  CHECK(holds > 20);
  CHECK(fails > 20);
}

TEST_CASE("H/F of exactly 1 passes, and a hair below fails", "[stability]") {
  // At 2 mm F = 10 % and 20 % pass 8 mm: H/F = 1.
  const std::vector<std::string> tie = {"100", "100", "60", "20", "15", "10", "0"};
  const RuleJudgement passes = by_octaves(tie, StabilityRule::kenney_lau);
  CHECK(passes.verdict == Compliance::holds);
  CHECK(the_one(passes).value.value->exact() == Rational(1));
  std::vector<std::string> below = tie;
  below[3] = "19.99999999999999999999";
  CHECK(by_octaves(below, StabilityRule::kenney_lau).verdict == Compliance::fails);
}

TEST_CASE("a quotient of exactly 4 passes, and a hair above fails", "[stability]") {
  // D_20 = 1 mm and D_35 = 4 mm; every other split is narrower.
  const std::vector<std::string> tie = {"100", "60", "35", "25", "20"};
  const RuleJudgement passes = by_octaves(tie, StabilityRule::kezdi);
  CHECK(passes.verdict == Compliance::holds);
  CHECK(the_one(passes).value.value->exact() == Rational(4));
  std::vector<std::string> above = tie;
  above[2] = "34.99999999999999999999";
  CHECK(by_octaves(above, StabilityRule::kezdi).verdict == Compliance::fails);
}

TEST_CASE("a gap is seen from both its sides", "[stability]") {
  // Nothing between 1 and 64 mm.
  const RuleJudgement j =
      by_octaves({"100", "30", "30", "30", "30", "30", "30", "0.1"}, StabilityRule::kezdi);
  CHECK(j.verdict == Compliance::fails);
  CHECK(middle(*the_one(j).value.value) > 32);
}

TEST_CASE("no verdict on what only the pan tells", "[stability]") {
  const UnderstoodGradation fines = soil({"4", "2", "1"}, {"100", "95", "90"});
  for (const StabilityRule rule :
       {StabilityRule::kenney_lau, StabilityRule::kezdi, StabilityRule::burenkova}) {
    const RuleJudgement j = judge_stability(fines, rule, Rational(0));
    CHECK(j.verdict == Compliance::hangs);
    CHECK(j.requirements.empty());
    CHECK(j.notes.back().rfind("Not judged: ", 0) == 0);
  }
}

TEST_CASE("a verdict on a rounded report is that of every curve that rounds to it", "[stability]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> move(-0.49, 0.49);
  const int trials = takes_all_cases() ? 150 : 75;
  int decided = 0, hanging = 0;
  for (int i = 0; i < trials; ++i) {
    std::vector<int> tenths = random_tenths(random, sieves.size(), 0);
    for (int &t : tenths)
      t -= t % 10;
    const StabilityRule rule = i % 3 == 0   ? StabilityRule::kenney_lau
                               : i % 3 == 1 ? StabilityRule::kezdi
                                            : StabilityRule::burenkova;
    const RuleJudgement j = judge_stability(made(tenths).report, rule, Rational(1));
    if (j.requirements.empty())
      continue;
    ++(j.verdict == Compliance::hangs ? hanging : decided);
    for (int k = 0; k < 10; ++k) {
      std::vector<double> moved(sieves.size(), 0);
      for (std::size_t s = 1; s < moved.size(); ++s) {
        const double before = tenths[s - 1] / 10.0 + moved[s - 1], here = tenths[s] / 10.0;
        moved[s] = std::min(std::max(here + move(random), 0.0), before) - here;
      }
      const Points points = made(tenths, moved).points;
      bool holds = false;
      if (rule == StabilityRule::burenkova) {
        const double d90 = size_at(points, 90), h1 = d90 / size_at(points, 60),
                     h2 = std::log10(d90 / size_at(points, 15));
        holds = 0.76 * h2 + 1 < h1 && h1 < 1.86 * h2 + 1;
      } else {
        holds =
            rule == StabilityRule::kenney_lau ? least_by_points(points) >= 1 : most_by_points(points) <= 4;
      }
      CAPTURE(i, k);
      if (j.verdict == Compliance::fails)
        CHECK_FALSE(holds);
      if (j.verdict == Compliance::holds)
        CHECK(holds);
    }
  }
  CHECK(decided * 15 > trials * 4); // more than 40 of 150
  CHECK(hanging > 0);
}

TEST_CASE("rules of stability have names", "[stability]") {
  for (const StabilityRule rule : {StabilityRule::kenney_lau, StabilityRule::kezdi, StabilityRule::burenkova})
    CHECK(stability_rule(name(rule)) == rule);
  CHECK_FALSE(stability_rule("kenney"));
  CHECK_FALSE(stability_rule(""));
}

} // namespace stability_test

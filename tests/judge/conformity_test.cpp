// Verdicts on samples, against enumeration.

#include "all_cases.hpp"
#include "catch.hpp"
#include "half_planes.hpp"
#include "judge/conformity.hpp"
#include "plain_gradation.hpp"
#include "sanitizers.hpp"

#include <array>
#include <random>

namespace conformity_test {

using namespace mdm;
using namespace judge_test;

namespace {

Specification limits(std::vector<PassingLimits> sieves) {
  return {"limits", {}, std::move(sieves), {}};
}

/// Masses as they are, or percents passing with the roundings of the gradation.
UnderstoodGradation exact(Gradation g) {
  return {std::move(g), "", "", "", {}, true};
}

/// Passing percents of 1, 8 and 32 mm with half a unit of the last digit.
UnderstoodGradation by_passing(long at_1, long at_8, const Rational &half) {
  Gradation::Data data;
  data.sizes = {0, 1, 8, 32};
  data.masses = {Rational(at_1), Rational(at_8 - at_1), Rational(100 - at_8), 0};
  data.roundings = {0, half, half, half};
  return exact(Gradation(std::move(data)));
}

/// The same by percents retained below 1, below 8 and below 32 mm.
UnderstoodGradation by_retained(const std::array<long, 3> &retained, const Rational &half) {
  Gradation::Data data;
  data.sizes = {0, 1, 8, 32};
  for (const long r : retained)
    data.masses.emplace_back(r);
  data.masses.emplace_back(0);
  UnderstoodGradation report = exact(Gradation(std::move(data)));
  report.kind = "retained_percent";
  report.mass_roundings = {half, half, half, 0};
  return report;
}

} // namespace

TEST_CASE("verdicts are those of the corners of all curves", "[judge]") {
  const unsigned times = MDM_IS_SANITIZED ? 5'000 : takes_all_cases() ? 100'000 : 10'000;
  std::mt19937 random(20261123);
  const auto below = [&random](unsigned n) { return static_cast<long>(random() % n); };
  const std::array<Rational, 5> sizes = {1, 2, 4, 8, 16};
  std::array<unsigned, 3> seen = {};
  for (unsigned k = 0; k < times; ++k) {
    const long half = below(4), at_1 = below(40), at_8 = at_1 + below(12); // half percents
    const bool retained = below(2) == 0;
    const long sum_off = retained && half > 0 ? below(3) - 1 : 0; // what is exact is not refused
    std::vector<HalfPlane> box = {{-1, 0, 0}, {1, -1, 0}, {0, 1, 600}};
    std::optional<UnderstoodGradation> g;
    const std::int64_t h = 3 * half;
    if (retained) {
      const std::array<long, 3> r = {at_1, at_8 - at_1, 100 - at_8 + sum_off};
      g = by_retained(r, ratio(half, 2));
      add_range(box, 1, 0, 6 * r[0] - h, 6 * r[0] + h);
      add_range(box, -1, 1, 6 * r[1] - h, 6 * r[1] + h);
      add_range(box, 0, -1, 6 * r[2] - 600 - h, 6 * r[2] - 600 + h);
    } else {
      g = by_passing(at_1, at_8, ratio(half, 2));
      add_range(box, 1, 0, 6 * at_1 - h, 6 * at_1 + h);
      add_range(box, 0, 1, 6 * at_8 - h, 6 * at_8 + h);
    }
    if (!has_corner(box, {})) {
      CHECK_THROWS(judge(*g, limits({{1, 0, 100}})));
      continue;
    }
    // Limits near the curve, in halves of a percent, at the places 0, 1/3, 2/3 and 1 between 1 and 8 mm, and
    // halfway between 8 and 32 mm.
    std::vector<PassingLimits> sieves;
    std::vector<HalfPlane> wanted;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (below(3) == 0)
        continue;
      const long middle = i < 4 ? 2 * at_1 + (at_8 - at_1) * 2 * static_cast<long>(i) / 3 : at_8 + 100;
      const long least = std::max(0L, middle - below(6)),
                 most = std::min(200L, std::max(least, middle + below(6) - 1));
      sieves.push_back({sizes[i], ratio(least, 2), ratio(most, 2)});
      if (i < 4)
        add_range(wanted, 3 - static_cast<int>(i), static_cast<int>(i), 9 * least, 9 * most);
      else
        add_range(wanted, 0, 1, 6 * least - 600, 6 * most - 600);
    }
    const Compliance expected = expected_verdict(box, wanted);
    const Conformity c = judge(*g, limits(sieves));
    if (c.verdict != expected)
      FAIL("case " << k << ": " << name(c.verdict) << " instead of " << name(expected));
    ++seen.at(static_cast<std::size_t>(expected));
    check_witnesses(c, box, wanted, 0);
  }
  for (const unsigned n : seen)
    CHECK(n > times / 20);
}

TEST_CASE("ties at interpolated sieves are decided, 10,000 times", "[judge]") {
  std::mt19937 random(31);
  const auto below = [&random](unsigned n) { return static_cast<long>(random() % n); };
  const Rational little = ratio(1, 1'000'000'000'000);
  unsigned wrong = 0;
  for (int k = 0; k < 10'000; ++k) {
    // The size u r^p lies p/q of the way from u to u r^q.
    const unsigned q = static_cast<unsigned>(2 + below(5)), p = 1 + static_cast<unsigned>(below(q - 1));
    const Rational u = ratio(1 + below(400), 1 + below(90)), r = 1 + ratio(1 + below(30), 1 + below(30));
    const Rational lower = ratio(below(4000), 100), mass = ratio(1 + below(5900), 100);
    const UnderstoodGradation g =
        exact(gradation({0, u, u * power(r, q), u * power(r, q + 1)}, {lower, mass, 100 - lower - mass, 0}));
    const Rational passing = lower + mass * ratio(p, q), size = u * power(r, p);
    const auto verdict = [&](const Rational &least, const Rational &most) {
      return judge(g, limits({{size, least, most}})).verdict;
    };
    wrong += verdict(passing, passing) != Compliance::holds;
    wrong += verdict(passing + little, 100) != Compliance::fails;
    wrong += verdict(0, passing - little) != Compliance::fails;
  }
  CHECK(wrong == 0);
}

TEST_CASE("an irrational percent is told from its limit, however near", "[judge]") {
  // 2 mm between 1 and 10 mm: log 2 of the way.
  const UnderstoodGradation g = exact(gradation({0, 1, 10}, {20, 80, 0}));
  const char *digits = "0.301029995663981195213738894724493026768189881462108541310";
  const Rational log_2 = [&] {
    Rational value = 0, unit = 1;
    for (const char *d = digits + 2; *d != 0; ++d)
      value += (*d - '0') * (unit /= 10);
    return value;
  }();
  const Rational at = 20 + 80 * log_2, little = ratio(1, 1'000'000'000) * ratio(1, 1'000'000'000);
  CHECK(judge(g, limits({{2, at - little, at + little}})).verdict == Compliance::holds);
  CHECK(judge(g, limits({{2, at + little, 100}})).verdict == Compliance::fails);
  CHECK(judge(g, limits({{2, 0, at - little}})).verdict == Compliance::fails);
}

TEST_CASE("limits that hold one by one but not together fail", "[judge]") {
  // x passes 1 mm and y passes 8 mm, both 50 +- 0.5: x >= 50.2 and y <= 50.1 are possible, not together.
  const Conformity c =
      judge(by_passing(50, 50, ratio(1, 2)), limits({{1, ratio(502, 10), 100}, {8, 0, ratio(501, 10)}}));
  CHECK(c.sieves[0].verdict == Compliance::hangs);
  CHECK(c.sieves[1].verdict == Compliance::hangs);
  CHECK(c.verdict == Compliance::fails);
  CHECK(std::any_of(c.notes.begin(), c.notes.end(),
                    [](const std::string &n) { return n.find("together") != std::string::npos; }));
}

TEST_CASE("all failing sieves are named, with their distances", "[judge]") {
  const Conformity c = judge(exact(gradation({0, 1, 8, 32}, {30, 30, 40, 0})),
                             limits({{1, 0, 20}, {8, 65, 70}, {32, 100, 100}, {64, 100, 100}}));
  CHECK(c.verdict == Compliance::fails);
  REQUIRE(c.sieves.size() == 4);
  CHECK(c.sieves[0].verdict == Compliance::fails);
  CHECK(c.sieves[0].distance->exact() == Rational(-10));
  CHECK(c.sieves[1].verdict == Compliance::fails);
  CHECK(c.sieves[1].distance->exact() == Rational(-5));
  CHECK(c.sieves[2].verdict == Compliance::holds);
  CHECK(c.sieves[2].distance->exact() == Rational(0));
  CHECK(c.sieves[3].verdict == Compliance::holds);
}

TEST_CASE("below the finest sieve anything from nothing to all may pass", "[judge]") {
  const UnderstoodGradation g = exact(gradation({0, 1, 8}, {10, 90, 0}));
  const auto verdict = [&](const Rational &least, const Rational &most) {
    return judge(g, limits({{ratio(1, 2), least, most}})).verdict;
  };
  CHECK(verdict(0, 10) == Compliance::holds);
  CHECK(verdict(0, 9) == Compliance::hangs);
  CHECK(verdict(11, 20) == Compliance::fails);
  const Conformity c = judge(g, limits({{ratio(1, 4), 6, 100}, {ratio(1, 2), 0, 5}, {1, 0, 100}}));
  CHECK(c.verdict == Compliance::fails);
  CHECK_FALSE(c.sieves[0].passing);
}

TEST_CASE("where nothing passes the finest sieve nothing passes a finer one", "[judge]") {
  const Conformity c = judge(exact(gradation({1, 8}, {90, 0})), limits({{ratio(1, 2), 0, 0}}));
  CHECK(c.verdict == Compliance::holds);
  CHECK(judge(exact(gradation({1, 8}, {90, 0})), limits({{ratio(1, 2), 1, 5}})).verdict == Compliance::fails);
}

TEST_CASE("openings of phi that are irrational are sieves too", "[judge]") {
  Gradation::Data data; // 2^-0.5, 2^0.5 and 2^1.5 mm
  data.sizes = {ratio(1, 2), 2, 8};
  data.masses = {40, 60, 0};
  data.root = 2;
  const UnderstoodGradation g = exact(Gradation(std::move(data)));
  // 1 mm lies halfway between the finest two.
  CHECK(judge(g, limits({{1, 20, 20}})).verdict == Compliance::holds);
  CHECK(judge(g, limits({{1, ratio(2001, 100), 100}})).verdict == Compliance::fails);
}

} // namespace conformity_test

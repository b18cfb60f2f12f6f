// Limits on fineness moduli and on what stays between two sieves, against the corners of all curves.

#include "all_cases.hpp"
#include "catch.hpp"
#include "half_planes.hpp"
#include "judge/conformity.hpp"
#include "judge/further_limits.hpp"
#include "sanitizers.hpp"
#include "soils.hpp"

#include <mdm/text/error.hpp>

#include <array>
#include <random>

namespace further_limits_test {

using namespace mdm;
using namespace judge_test;

namespace {

Specification limits(std::vector<PassingLimits> sieves) {
  return {"limits", {}, std::move(sieves), {}};
}

/// Percents that pass 0.125 to 4 mm; those of 0.5 and 1 mm are rounded, the others exact.
struct Report {
  std::array<long, 6> passing;
  long half; ///< of a unit of the last digit, in halves of a percent

  UnderstoodGradation gradation() const {
    Gradation::Data data;
    data.sizes = {0, ratio(1, 8), ratio(1, 4), ratio(1, 2), 1, 2, 4, 8};
    const Rational h = ratio(half, 2);
    data.roundings = {0, 0, 0, h, h, 0, 0, 0};
    long below = 0;
    for (const long p : passing) {
      data.masses.emplace_back(p - below);
      below = p;
    }
    data.masses.emplace_back(100 - below);
    data.masses.emplace_back(0);
    return {Gradation(std::move(data)), "", "", "", {}, true};
  }
  /// x passes 0.5 mm, y passes 1 mm.
  std::vector<HalfPlane> curves() const {
    std::vector<HalfPlane> box;
    add_range(box, 1, 0, 6 * passing[2] - 3 * half, 6 * passing[2] + 3 * half);
    add_range(box, 0, 1, 6 * passing[3] - 3 * half, 6 * passing[3] + 3 * half);
    add_range(box, 1, 0, 6 * passing[1], 6 * passing[4]);
    add_range(box, 0, 1, 6 * passing[1], 6 * passing[4]);
    box.push_back({1, -1, 0});
    return box;
  }
};

} // namespace

TEST_CASE("verdicts with further limits are those of the corners of all curves", "[judge]") {
  const unsigned times = takes_all_cases() ? 50'000 : MDM_IS_SANITIZED ? 3'000 : 10'000;
  std::mt19937 random(20261127);
  const auto below = [&random](long n) {
    return static_cast<long>(random() % static_cast<unsigned long>(n));
  };
  std::array<unsigned, 3> seen = {};
  for (unsigned k = 0; k < times; ++k) {
    Report r{{}, below(5)};
    for (std::size_t i = 0; i < r.passing.size(); ++i)
      r.passing[i] = (i == 0 ? 0 : r.passing[i - 1]) + below(16);
    const std::array<long, 6> &p = r.passing;
    std::vector<HalfPlane> wanted;
    std::vector<PassingLimits> sieves = {{ratio(1, 4), 0, 100}, {2, 0, 100}};
    const std::size_t skipped =
        below(3) == 0 ? 2 + static_cast<std::size_t>(below(2)) : 0; // no sieve of the limits
    for (const std::size_t i : {std::size_t{2}, std::size_t{3}}) {
      if (i == skipped)
        continue;
      const long least = std::max(0L, 2 * p[i] - below(7)), most = std::min(200L, 2 * p[i] + below(7));
      sieves.push_back({i == 2 ? ratio(1, 2) : Rational(1), ratio(least, 2), ratio(most, 2)});
      add_range(wanted, i == 2 ? 1 : 0, i == 2 ? 0 : 1, 3 * least, 3 * most);
    }
    std::sort(sieves.begin(), sieves.end(), [](const auto &a, const auto &b) { return a.size < b.size; });
    std::vector<FurtherLimit> further;
    if (below(4) != 0) { // in hundredths
      const long sum = p[0] + p[1] + p[2] + p[3] + p[4] + p[5], least = 600 - sum - below(4),
                 most = std::max(least, 600 - sum + below(4) - 1);
      further.push_back({FinenessModulus::en, ratio(least, 100), ratio(most, 100)});
      const long others = p[0] + p[1] + p[4] + p[5];
      add_range(wanted, 1, 1, 6 * (600 - most - others), 6 * (600 - least - others));
    }
    if (below(4) != 0) {
      const std::size_t first = skipped == 2 ? 3 : 2, last = skipped == 3 ? 2 : 3;
      const long most = std::max({p[first] - p[1], p[last] - p[first], p[4] - p[last]}) + below(5) - 2;
      further.push_back({std::nullopt, std::nullopt, Rational(most)});
      wanted.push_back({first == 2 ? 1 : 0, first == 2 ? 0 : 1, 6 * (most + p[1])});
      if (first != last)
        wanted.push_back({-1, 1, 6 * most});
      wanted.push_back({last == 2 ? -1 : 0, last == 2 ? 0 : -1, 6 * (most - p[4])});
    }
    const std::vector<HalfPlane> box = r.curves();
    const Compliance expected = expected_verdict(box, wanted);
    const Conformity c = judge(r.gradation(), limits(sieves), std::nullopt, further);
    if (c.verdict != expected)
      FAIL("case " << k << ": " << name(c.verdict) << " instead of " << name(expected));
    ++seen.at(static_cast<std::size_t>(expected));
    check_witnesses(c, box, wanted, 2);
  }
  for (const unsigned n : seen)
    CHECK(n > times / 20);
}

TEST_CASE("the fineness modulus and what stays between sieves of ASTM C33 are judged", "[judge]") {
  const UnderstoodGradation sand =
      soil({"9.5", "4.75", "2.36", "1.18", "0.6", "0.3", "0.15"}, {"100", "97", "85", "67", "45", "20", "5"});
  const Specification c33 = *shipped_specification("astm-c33-fine");
  const Conformity c = judge(sand, c33, Rational(0),
                             {parse_further_limit("FM=2.3..3.1"), parse_further_limit("retained=..45%")});
  CHECK(c.verdict == Compliance::holds);
  REQUIRE(c.limits.size() == 7);
  CHECK(c.limits[0].number.name == "FM");
  CHECK(*c.limits[0].value->exact() == ratio(281, 100));
  CHECK(c.limits[1].number.name == "retained between 0.15 and 0.3 mm");
  CHECK(*c.limits[1].value->exact() == Rational(15));
  CHECK(judge(sand, c33, Rational(0), {parse_further_limit("FM=2.82..")}).verdict == Compliance::fails);
  CHECK(judge(sand, c33, Rational(1), {parse_further_limit("FM=2.81..")}).verdict == Compliance::hangs);
  CHECK(judge(sand, c33, Rational(0), {parse_further_limit("retained=..24.9%")}).verdict ==
        Compliance::fails);
}

TEST_CASE("what stays between two sieves is judged where the sample has others between them", "[judge]") {
  const std::vector<FurtherLimit> limit = {parse_further_limit("retained=..97.8")};
  const UnderstoodGradation sand = soil({"1", "0.5", "0.125"}, {"100", "50.0", "2.2"});
  const Specification spec = limits({{ratio(1, 8), 0, ratio(49, 4)}, {1, 99, 100}});
  const Conformity c = judge(sand, spec, ratio(1, 10), limit);
  CHECK(c.verdict == Compliance::hangs);
  CHECK(judge(sand, spec, ratio(1, 100), limit).verdict == Compliance::hangs);
  CHECK(judge(sand, spec, ratio(1, 10), {parse_further_limit("retained=..97.7")}).verdict ==
        Compliance::fails);
  // Together: 45 to 46 between 0.25 and 2 mm and at most 20 at each of the three sieves between.
  const UnderstoodGradation three = soil({"4", "2", "1", "0.5", "0.25"}, {"100", "80", "65", "50", "35"});
  const Specification ends = limits({{ratio(1, 4), 0, 34}, {2, 81, 100}, {4, 100, 100}});
  CHECK(judge(three, ends, Rational(4), {parse_further_limit("retained=..46")}).verdict == Compliance::fails);
  CHECK(judge(three, ends, Rational(4), {parse_further_limit("retained=..48")}).verdict == Compliance::hangs);
}

TEST_CASE("what is not told of further limits is undecided, and says so", "[judge]") {
  // Of 0.3 mm nothing is known but that at most as much passes as at 0.6 mm.
  const UnderstoodGradation sand =
      soil({"9.5", "4.75", "2.36", "1.18", "0.6"}, {"100", "97", "85", "67", "45"});
  const Conformity below = judge(sand, limits({{ratio(3, 10), 0, 100}, {ratio(3, 5), 0, 100}}), Rational(0),
                                 {parse_further_limit("retained=..45")});
  CHECK(below.verdict == Compliance::holds);
  CHECK_FALSE(below.limits[0].value);
  const Conformity modulus =
      judge(sand, limits({{ratio(3, 5), 0, 100}}), Rational(0), {parse_further_limit("FM=2.3..3.1")});
  CHECK(modulus.verdict == Compliance::hangs); // from 2.16 to 3.06
  // At 1 mm what passes is interpolated.
  const Conformity between = judge(sand, limits({{ratio(3, 5), 0, 100}, {1, 0, 100}}), Rational(1),
                                   {parse_further_limit("retained=..16.1")});
  CHECK(between.verdict == Compliance::undecided);
}

TEST_CASE("limits that are none are refused", "[judge]") {
  for (const char *text : {"", "FM", "FM=", "FM=2.3", "FM=..", "fm=2..3", "FM=3..2", "FM=a..b",
                           "retained=..%", "retained=45", "FM=2..3..4", "=2..3", "D50=1..2"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(parse_further_limit(text), InputError);
  }
}

} // namespace further_limits_test

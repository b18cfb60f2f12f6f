#include "packing/apollonian.hpp"
#include "packing/contacts.hpp"
#include "packing/support.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace apollonian_test {

using namespace mdm;
using namespace packing_test;

namespace {

/// A bound is covered by 1e-12 of the middle, and the digits that were computed independently are its first.
void check_covered(const ApollonianGasket &gasket, int most, std::uint64_t circles, const char *share) {
  const ApollonianCensus census = gasket.census(most);
  CHECK(census.circles == circles);
  const Interval covered = gasket.covered(census);
  CHECK(covered.lo < covered.hi);
  CHECK(covered.hi - covered.lo < ratio(1, Integer("1000000000000")));
  const Integer unit = 1000000000;
  CHECK(abs(Rational(covered.lo - ratio(Integer(share), unit))) < ratio(1, unit));
  std::uint64_t sum = 0;
  for (const std::uint64_t n : census.octaves)
    sum += n;
  CHECK(sum == circles);
}

std::set<std::int64_t> curvatures(const ApollonianGasket &gasket, int most) {
  std::set<std::int64_t> all;
  gasket.each(most, [&all](const ApollonianCircle &c) { all.insert(c.p); });
  return all;
}

} // namespace

TEST_CASE("circles of gaskets are as many, and cover as much, as was counted by other programs") {
  const ApollonianGasket equal = ApollonianGasket::equal(), small = ApollonianGasket::integral({-1, 2, 2, 3}),
                         coins = ApollonianGasket::integral({-11, 21, 24, 28});
  check_covered(equal, 100, 451, "981864541");
  check_covered(equal, 1000, 9070, "996322306");
  check_covered(equal, 10000, 183502, "999257231");
  check_covered(small, 100, 168, "969196217");
  check_covered(small, 1000, 3328, "993754344");
  check_covered(small, 10000, 67166, "998735782");
  check_covered(coins, 100, 9, "842499756");
  check_covered(coins, 1000, 144, "966699939");
  check_covered(coins, 10000, 2939, "993324049");
  check_covered(equal, 100000, 3707710, "999849788");
  check_covered(small, 100000, 1359170, "999744577");
  check_covered(coins, 100000, 59337, "998649846");
}

TEST_CASE("over a decade of curvatures circles grow by the gasket's dimension") {
  // 1.305686728049877... (Vytnova, Wormell 2024, prove 128 digits).
  const double dimension = 1.305686728;
  const auto slope = [](const ApollonianGasket &gasket) {
    return std::log10(static_cast<double>(gasket.census(100000).circles) /
                      static_cast<double>(gasket.census(10000).circles));
  };
  CHECK(std::fabs(slope(ApollonianGasket::equal()) - dimension) < 0.001);
  CHECK(std::fabs(slope(ApollonianGasket::integral({-1, 2, 2, 3})) - dimension) < 0.001);
  CHECK(std::fabs(slope(ApollonianGasket::integral({-11, 21, 24, 28})) - dimension) < 0.001);
}

TEST_CASE("curvatures of the gasket of -1, 2, 2, 3 are those of OEIS A042944") {
  const std::set<std::int64_t> found = curvatures(ApollonianGasket::integral({-1, 2, 2, 3}), 60);
  CHECK(found ==
        std::set<std::int64_t>{2, 3, 6, 11, 14, 15, 18, 23, 26, 27, 30, 35, 38, 39, 42, 47, 50, 51, 54, 59});
  CHECK(curvatures(ApollonianGasket::integral({3, 2, -1, 2}), 60) == found);
}

TEST_CASE("circles touch in exact numbers") {
  // Each circle is inside the outer one, and touches it or three others: counted by |z - z'| = 1/k + 1/k'.
  const ApollonianGasket gasket = ApollonianGasket::integral({-11, 21, 24, 28});
  std::vector<ApollonianCircle> circles;
  gasket.each(300, [&circles](const ApollonianCircle &c) { circles.push_back(c); });
  const Rational scale(gasket.scale());
  const auto centre = [&](std::int64_t at, std::int64_t k) -> Rational { return Rational(at) / (scale * k); };
  for (const ApollonianCircle &c : circles) {
    int touched = 0;
    const Rational x = centre(c.x, c.p), y = centre(c.y, c.p), r = ratio(1, c.p);
    const Rational inside = ratio(1, 11) - r, from_outer = x * x + y * y;
    CHECK(from_outer <= inside * inside);
    touched += from_outer == inside * inside ? 1 : 0;
    for (const ApollonianCircle &d : circles) {
      if (d == c)
        continue;
      const Rational dx = x - centre(d.x, d.p), dy = y - centre(d.y, d.p), apart = r + ratio(1, d.p);
      CHECK(dx * dx + dy * dy >= apart * apart);
      touched += dx * dx + dy * dy == apart * apart ? 1 : 0;
    }
    CHECK(touched >= 3);
  }
}

TEST_CASE("a bound on curvatures is inclusive, as exact numbers decide") {
  const ApollonianGasket small = ApollonianGasket::integral({-1, 2, 2, 3});
  CHECK(small.census(2).circles == 2);
  CHECK(small.census(ratio(Integer("19999999999999999999"), Integer("10000000000000000000"))).circles == 0);
  CHECK(small.census(3).circles == 4);
  // 3 + 2 sqrt 3 = 6.46410161513775458...
  const ApollonianGasket equal = ApollonianGasket::equal();
  const Integer hundred("100000000000000000");
  const std::uint64_t before = equal.census(ratio(Integer("646410161513775458"), hundred)).circles;
  CHECK(equal.census(ratio(Integer("646410161513775459"), hundred)).circles == before + 1);
}

TEST_CASE("gaskets on a lattice hold circles that do not overlap and almost touch") {
  for (const ApollonianGasket &gasket :
       {ApollonianGasket::equal(), ApollonianGasket::integral({-1, 2, 2, 3})}) {
    const Packing p = gasket.packing(100);
    CHECK(p.discs.size() == gasket.census(100).circles);
    const PackingContacts contacts = packing_contacts(p, 8);
    CHECK(contacts.overlaps == 0);
    // Each circle but the first three touches three that came before, at most two of which are the outer one.
    CHECK(contacts.pairs.size() > 2 * p.discs.size());
    for (const PackedDisc &d : p.discs)
      CHECK((d.r > 0 && d.x >= d.r && d.x <= p.width - d.r && d.y >= d.r && d.y <= p.width - d.r));
  }
}

TEST_CASE("the exponent of the size distribution is the gasket's dimension") {
  const ApollonianGasket gasket = ApollonianGasket::equal();
  const ApollonianCensus census = gasket.census(20000);
  const Ball slope = apollonian_slope(census.circles, census.circles - census.octaves[0]).ball(64);
  CHECK(slope.lower() > ratio(130, 100));
  CHECK(slope.upper() < ratio(131, 100));
}

TEST_CASE("quadruples that are no root of a gasket in a circle are refused, the reduced one named") {
  const auto refused = [](const std::array<Integer, 4> &w, const std::string &what) {
    CHECK(has(refusal([&] { ApollonianGasket::integral(w); }), what));
  };
  refused({1, 2, 3, 4}, "Descartes");
  refused({0, 0, 1, 1}, "strip");
  refused({0, 1, 1, 4}, "strip");
  refused({-1, 2, 3, 6}, "-1,2,2,3");
  refused({2, 2, 3, 15}, "-1,2,2,3");
  refused({1, -2, -2, -3}, "signs");
  refused({-1000001, 2, 2, 3}, "10^6");
  CHECK(has(refusal([] { ApollonianGasket::equal().census(Rational(Integer("1000000000001"))); }), "10^12"));
  CHECK(ApollonianGasket::equal().census(ratio(1, 2)).circles == 0);
}

} // namespace apollonian_test

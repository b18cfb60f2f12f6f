// Counts of representative sets, against a second computation.

#include "../soil/soil.hpp"
#include "catch.hpp"
#include "sets/beta_curve.hpp"
#include "sets/class_counts.hpp"

#include <mdm/text/error.hpp>

#include <cmath>
#include <limits>

namespace class_counts_test {

using namespace mdm;
using namespace grading_test;

namespace {

std::vector<Integer> estimates(const ClassCounts &counts) {
  std::vector<Integer> n;
  for (const IntegerBounds &bounds : counts.estimate) {
    CHECK(bounds.is_point());
    n.push_back(bounds.lo);
  }
  return n;
}

ClassCounts counts_of(const BetaCurve &curve, Classing classing, unsigned n, const Representativity &wanted) {
  return class_counts(size_classes(curve, classing, n), curve, wanted);
}

/// h in long double, for the curves of the paper's figures.
long double h(unsigned a, unsigned b, long double x) {
  if (a == 1 && b == 3)
    return 1 - (1 - x) * (1 - x) * (1 - x);
  if (a == 3 && b == 3)
    return x * x * x * (10 - 15 * x + 6 * x * x);
  return x * x * x; // 3, 1
}

/// N' in long double, with diameters and not their powers; -1 too close to an integer.
std::vector<long long> estimates_by_float(unsigned a, unsigned b, bool geometric, unsigned dimension) {
  const long double low = 0.02L, high = 1.98L, ratio = high / low;
  std::vector<long double> n;
  for (int i = 0; i < 10; ++i) {
    const auto bound = [&](int k) {
      return geometric ? low * std::pow(ratio, static_cast<long double>(k) / 10)
                       : low + (high - low) * k / 10;
    };
    const long double l = bound(i), u = bound(i + 1);
    const long double f = h(a, b, (u - low) / (high - low)) - h(a, b, (l - low) / (high - low));
    const long double d = dimension == 2 ? 2 * l * u / (l + u) : l / std::sqrt(1 - (1 - l * l / (u * u)) / 2);
    n.push_back(f / std::pow(d, static_cast<long double>(dimension)));
  }
  const long double least = *std::min_element(n.begin(), n.end());
  std::vector<long long> result;
  for (const long double x : n) {
    const long double y = 10 * x / least;
    const bool close = std::abs(y - std::round(y)) < 1e-14L * y;
    result.push_back(close && x != least ? -1 : static_cast<long long>(x == least ? 10 : std::floor(y)));
  }
  return result;
}

} // namespace

TEST_CASE("counts of the paper's curves are those of a second computation") {
  for (const auto &[a, b] : {std::pair(1U, 3U), std::pair(3U, 3U), std::pair(3U, 1U)})
    for (const bool geometric : {false, true})
      for (const unsigned dimension : {2U, 3U}) {
        INFO(a << " " << b << (geometric ? " geometric " : " regular ") << dimension);
        const BetaCurve curve(a, b, ratio(2, 100), ratio(198, 100));
        CHECK(curve.span() == ratio(98, 100));
        const Representativity wanted{10, 2000, dimension};
        const ClassCounts counts =
            counts_of(curve, geometric ? Classing::geometric : Classing::regular, 10, wanted);
        const std::vector<Integer> exact = estimates(counts);
        const std::vector<long long> expected = estimates_by_float(a, b, geometric, dimension);
        Integer sum = 0;
        for (std::size_t j = 0; j < 10; ++j) {
          CHECK(expected[j] >= 0);
          CHECK(exact[j] == expected[j]);
          sum += exact[j];
        }
        CHECK(exact[counts.scarcest] == 10);
        for (std::size_t j = 0; j < 10; ++j)
          CHECK(counts.numbers[j] == (sum < 2000 ? Integer(2000 * exact[j] / sum) : exact[j]));
      }
}

TEST_CASE("floors at integers are decided in the field of the bounds") {
  // f_v is proportional to d and V to d^D: n_i / n_j = r^((1 - D)(i - j)) with r = 100^(1/10), r^5 = 10.
  const BetaCurve uniform(1, 1, 1, 100);
  CHECK(estimates(counts_of(uniform, Classing::geometric, 10, {10, 1, 2})) ==
        std::vector<Integer>{630, 398, 251, 158, 100, 63, 39, 25, 15, 10});
  CHECK(estimates(counts_of(uniform, Classing::geometric, 10, {10, 1, 3})) ==
        std::vector<Integer>{39810, 15848, 6309, 2511, 1000, 398, 158, 63, 25, 10});
}

TEST_CASE("inverses that are fractions give exact isochoric classes") {
  // I_{1/4}(1/2, 1/2) = 1/3: bounds 1, 2, 4, 5, d_m = 4/3, 8/3, 40/9, ratios of n 100/9 and 25/9.
  const BetaCurve arcsine(ratio(1, 2), ratio(1, 2), 1, 5);
  CHECK(estimates(counts_of(arcsine, Classing::isochoric, 3, {9, 1, 2})) == std::vector<Integer>{100, 25, 9});
  CHECK(BetaCurve(2, 2, 1, 4).diameter(ratio(7, 27)).fraction() == Rational(2)); // 3 / 9 - 2 / 27
}

TEST_CASE("geometric classes of a curve that is linear in log size hold equal volumes, exactly") {
  const SieveCurve line(curve({{"1", "0"}, {"2", "100"}}), Interpolation::log);
  // d_m and thus n in ratio sqrt 2 to the power D
  const ClassCounts counts = class_counts(size_classes(line, Classing::geometric, 2), line, {10, 1, 2});
  CHECK(estimates(counts) == std::vector<Integer>{20, 10});
}

TEST_CASE("what 4096 bits do not decide is said, with both values") {
  // The same, as isochoric classes: that h^-1(1/2) is sqrt 2 is not known exactly.
  const SieveCurve line(curve({{"1", "0"}, {"2", "100"}}), Interpolation::log);
  const ClassCounts counts = class_counts(size_classes(line, Classing::isochoric, 2), line, {10, 1, 2});
  CHECK_FALSE(counts.decided());
  CHECK(counts.estimate[0].lo == 19);
  CHECK(counts.estimate[0].hi == 20);
  CHECK(counts.estimated().lo == 29);
  CHECK_FALSE(is_accessible(counts, {10, 1, 2}, 29));
}

TEST_CASE("without an exact form the enclosures decide the same") {
  // I_x(3, 3) through Arb, by hiding that the parameters are integers.
  const BetaCurve near(3 + ratio(1, power_of_ten(30)), 3, ratio(2, 100), ratio(198, 100));
  const BetaCurve exact(3, 3, ratio(2, 100), ratio(198, 100));
  for (const Classing classing : {Classing::regular, Classing::geometric, Classing::isochoric})
    CHECK(estimates(counts_of(near, classing, 7, {10, 1, 3})) ==
          estimates(counts_of(exact, classing, 7, {10, 1, 3})));
}

TEST_CASE("isochoric classes hold equal volumes: counts follow the diameters") {
  const BetaCurve uniform(1, 1, 1, 2);
  const std::vector<SizeClass> classes = size_classes(uniform, Classing::isochoric, 2);
  CHECK(classes[0].upper.real.fraction() == ratio(3, 2));
  // d_m = 6/5 and 12/7: (10/7)^2
  CHECK(estimates(class_counts(classes, uniform, {100, 1, 2})) == std::vector<Integer>{204, 100});
}

TEST_CASE("the floors of Eq. 9 may sum to less than N_min") {
  const BetaCurve uniform(1, 1, 1, 2);
  const ClassCounts counts = counts_of(uniform, Classing::isochoric, 2, {100, 1000, 2});
  CHECK(counts.numbers == std::vector<Integer>{671, 328}); // 1000 * 204 / 304 = 671.05, 328.9
  CHECK(counts.particles() == 999);
}

TEST_CASE("a set is accessible if max(sum N', N_min) is not above N_max") {
  const Representativity wanted{100, 310, 2};
  const BetaCurve uniform(1, 1, 1, 2);
  const ClassCounts counts = counts_of(uniform, Classing::isochoric, 2, wanted); // sum N' = 304
  CHECK(is_accessible(counts, wanted, 310) == true);
  CHECK(is_accessible(counts, wanted, 309) == false);
  CHECK(is_accessible(counts, {100, 1, 2}, 304) == true);
  CHECK(is_accessible(counts, {100, 1, 2}, 303) == false);
}

TEST_CASE("a measured curve has its sieves as classes, and empty ones get nothing") {
  const SieveCurve stair(curve({{"1", "0"}, {"2", "50"}, {"4", "50"}, {"8", "100"}}), Interpolation::stair);
  const std::vector<SizeClass> classes = sieve_classes(stair);
  CHECK(classes[1].is_empty());
  // d_m = 4/3 and 16/3
  CHECK(estimates(class_counts(classes, stair, {3, 1, 2})) == std::vector<Integer>{48, 0, 3});
  CHECK(estimates(class_counts(classes, stair, {3, 1, 3})) == std::vector<Integer>{192, 0, 3});
}

TEST_CASE("between sieves a measured curve is what it is said to be") {
  const GradingCurve points = curve({{"1", "0"}, {"4", "40"}, {"16", "100"}});
  const SieveCurve log(points, Interpolation::log), linear(points, Interpolation::linear),
      stair(points, Interpolation::stair);
  CHECK(log.passing(Surd(2)).exact() == ratio(1, 5));
  CHECK(linear.passing(Surd(2)).fraction() == ratio(2, 15));
  CHECK(stair.passing(Surd(2)).fraction() == Rational(0));
  CHECK(stair.passing(Surd(4)).fraction() == ratio(2, 5));
  CHECK(log.diameter(ratio(1, 5)).fraction() == Rational(2));
  CHECK(linear.diameter(ratio(2, 15)).fraction() == Rational(2));
  CHECK(stair.diameter(ratio(2, 15)).fraction() == Rational(4));
  // Geometric bounds 1, 2, 4, 8, 16: two share 40 % each way.
  const std::vector<SizeClass> classes = size_classes(log, Classing::geometric, 4);
  CHECK(classes[0].volume_fraction.exact() == ratio(1, 5));
  CHECK(classes[3].volume_fraction.exact() == ratio(3, 10));
  // Irrational bounds: 16^(1/3) = 2.52, h = 4/5 of 40 % with exponent 2/3 of the first stretch.
  CHECK(rounded(size_classes(log, Classing::geometric, 3)[0].volume_fraction, 10) == "0.2666666667");
}

TEST_CASE("what cannot be is refused") {
  const BetaCurve uniform(1, 1, 1, 2);
  CHECK_THROWS_AS(size_classes(uniform, Classing::regular, 0), InputError);
  CHECK_THROWS_AS(SieveCurve(curve({{"0", "0"}, {"1", "100"}}), Interpolation::log), InputError);
  const SieveCurve stair(curve({{"1", "0"}, {"2", "100"}}), Interpolation::stair);
  CHECK_THROWS_AS(size_classes(stair, Classing::isochoric, 3), InputError);
  // Counts of thousands of digits.
  CHECK_THROWS_AS(counts_of(BetaCurve(1, 1000, 1, 100), Classing::regular, 20, {}), InputError);
}

} // namespace class_counts_test

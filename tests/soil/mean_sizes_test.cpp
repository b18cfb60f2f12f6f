// Mean sizes, fineness moduli and conductivities against sums by hand.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/fineness_modulus.hpp"
#include "soil/indices.hpp"
#include "soil/permeability.hpp"

#include <random>

namespace mean_sizes_test {

using namespace mdm;
using grading_test::curve;

namespace {

double middle(const Real &y) {
  const Ball b = y.ball(100);
  return (b.lower().convert_to<double>() + b.upper().convert_to<double>()) / 2;
}

} // namespace

TEST_CASE("mean sizes lie between those at the lower and at the upper sieves", "[means]") {
  // A quarter in (1, 2], three quarters in (2, 6].
  const GradingCurve c = curve({{"1", "0"}, {"2", "25"}, {"6", "100"}});
  CHECK(volume_mean(c)->lo.exact() == ratio(7, 4));
  CHECK(volume_mean(c)->hi.exact() == Rational(5));
  CHECK(surface_mean(c)->lo.exact() == ratio(8, 5)); // 1 / (1/4 + 3/8)
  CHECK(surface_mean(c)->hi.exact() == Rational(4)); // 1 / (1/8 + 1/8)
}

TEST_CASE("any particles within the classes have mean sizes within the bounds", "[means]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> within(0.001, 1);
  const std::vector<double> sieves = {0.1, 0.25, 0.5, 2, 5};
  const GradingCurve c = curve({{"0.1", "0"}, {"0.25", "10"}, {"0.5", "45"}, {"2", "85"}, {"5", "100"}});
  const std::vector<double> shares = {0.1, 0.35, 0.4, 0.15};
  for (int i = 0; i < 100; ++i) {
    double over_size = 0, times_size = 0; // sums of w / x and w x over three particles a class
    for (std::size_t j = 0; j < shares.size(); ++j)
      for (int part = 0; part < 3; ++part) {
        const double x = sieves[j] + within(random) * (sieves[j + 1] - sieves[j]);
        over_size += shares[j] / 3 / x;
        times_size += shares[j] / 3 * x;
      }
    CHECK(middle(surface_mean(c)->lo) <= 1 / over_size);
    CHECK(1 / over_size <= middle(surface_mean(c)->hi));
    CHECK(middle(volume_mean(c)->lo) <= times_size);
    CHECK(times_size <= middle(volume_mean(c)->hi));
  }
}

TEST_CASE("mean sizes are not known where a pan at size 0 holds mass", "[means]") {
  CHECK_FALSE(surface_mean(curve({{"0", "0"}, {"1", "1"}, {"2", "100"}})));
  CHECK_FALSE(volume_mean(curve({{"0", "0"}, {"1", "1"}, {"2", "100"}})));
  CHECK(volume_mean(curve({{"0", "0"}, {"1", "0"}, {"2", "100"}}))->hi.exact() == Rational(2));
}

TEST_CASE("the fineness modulus of ASTM C125 adds what is retained", "[means]") {
  // The mean of the limits of C33: 2.3 + 3.1 is what its two curves have, of percents 100, 95, 80, ...
  const GradingCurve fine = curve({{"0.075", "0"},
                                   {"0.15", "10"},
                                   {"0.3", "30"},
                                   {"0.6", "60"},
                                   {"1.18", "85"},
                                   {"2.36", "100"},
                                   {"4.75", "100"}});
  CHECK(fineness_modulus(fine, FinenessModulus::astm)->exact() == ratio(215, 100));
  const GradingCurve coarse = curve({{"4.75", "0"}, {"9.5", "40"}, {"19", "90"}, {"37.5", "100"}});
  CHECK(fineness_modulus(coarse, FinenessModulus::astm)->exact() == ratio(670, 100));
  CHECK(fineness_modulus(coarse, FinenessModulus::en)->exact() == Rational(6));
}

TEST_CASE("the fineness modulus of EN 12620 is interpolated where there is no sieve", "[means]") {
  // 1 mm lies in the middle of 0.5 and 2 mm, in log size.
  const GradingCurve c =
      curve({{"0.0625", "0"}, {"0.125", "10"}, {"0.25", "20"}, {"0.5", "30"}, {"2", "90"}, {"4", "100"}});
  CHECK(fineness_modulus(c, FinenessModulus::en)->exact() == ratio(90 + 80 + 70 + 40 + 10, 100));
  const Available<Real> hidden =
      fineness_modulus(curve({{"0", "0"}, {"0.2", "10"}, {"2", "100"}}), FinenessModulus::en);
  REQUIRE_FALSE(hidden);
  CHECK(hidden.why().reason == "0.125 mm lies below 0.2 mm, the finest sieve");
}

TEST_CASE("the span is of D10, D50 and D90", "[means]") {
  CHECK(span(curve({{"0.1", "0"}, {"0.2", "10"}, {"0.4", "50"}, {"1", "90"}, {"2", "100"}}))->exact() ==
        Rational(2));
  CHECK_FALSE(span(curve({{"0", "0"}, {"0.2", "20"}, {"2", "100"}})));
}

TEST_CASE("Hazen's conductivity is 0.01 m/s at a D10 of 1 mm", "[means]") {
  const GradingCurve c = curve({{"0.1", "0"}, {"0.2", "10"}, {"0.4", "60"}, {"1", "100"}});
  CHECK(hazen_conductivity(c, false)->exact() == ratio(4, 10000));
  CHECK(is_hazen_soil(c, false));
  CHECK_FALSE(
      is_hazen_soil(curve({{"0.1", "0"}, {"0.2", "10"}, {"1", "60"}, {"2", "100"}}), false)); // C_u = 5
  CHECK_FALSE(is_hazen_soil(curve({{"0.05", "0"}, {"0.0999", "10"}, {"0.2", "60"}, {"1", "100"}}), false));
  CHECK(is_hazen_soil(curve({{"0.05", "0"}, {"0.1", "10"}, {"0.2", "60"}, {"1", "100"}}), false));
}

TEST_CASE("the conductivity of Kozeny and Carman is that of spheres of D[3,2]", "[means]") {
  const GradingCurve c = curve({{"0.2", "0"}, {"0.4", "100"}});
  const Available<RealRange> k = kozeny_carman_conductivity(c, ratio(6, 10));
  // In cm and s: gamma / mu = 9.93e4, S = 6 / D, D from 0.02 to 0.04 cm.
  const double per_square = 9.93e4 / 5 / 36 * 0.216 / 1.6;
  CHECK(middle(k->lo) == Approx(per_square * 0.02 * 0.02 / 100));
  CHECK(middle(k->hi) == Approx(per_square * 0.04 * 0.04 / 100));
  CHECK_FALSE(kozeny_carman_conductivity(curve({{"0", "0"}, {"1", "1"}, {"2", "100"}}), 1));
}

} // namespace mean_sizes_test

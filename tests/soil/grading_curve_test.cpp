// The grading curve: shares at sizes and sizes at shares.

#include "catch.hpp"
#include "soil.hpp"

namespace grading_curve_test {

using namespace mdm;
using namespace grading_test;

namespace {

std::optional<Rational> share(const GradingCurve &c, const char *size) {
  return c.passing(decimal(size))->exact();
}

std::optional<Rational> diameter(const GradingCurve &c, const Rational &p, bool extrapolate = false) {
  return c.diameter(p, extrapolate)->exact();
}

Rational percent(int n) {
  return ratio(n, 100);
}

} // namespace

TEST_CASE("shares are exact at the sieves and outside") {
  const GradingCurve c = curve({{"0.1", "0"}, {"0.2", "12.5"}, {"0.5", "33.3"}, {"2", "100"}});
  CHECK(share(c, "0") == Rational(0));
  CHECK(share(c, "0.05") == Rational(0));
  CHECK(share(c, "0.1") == Rational(0));
  CHECK(share(c, "0.2") == ratio(1, 8));
  CHECK(share(c, "0.5") == ratio(333, 1000));
  CHECK(share(c, "2") == Rational(1));
  CHECK(share(c, "1000") == Rational(1));
  CHECK_FALSE(c.interpolates(decimal("0.2")));
  CHECK_FALSE(c.interpolates(decimal("0.05")));
  CHECK_FALSE(c.interpolates(3));
  CHECK(c.interpolates(1));
}

TEST_CASE("between sieves the share is linear in log size") {
  const GradingCurve c = curve({{"1", "0"}, {"16", "40"}, {"32", "100"}});
  CHECK(share(c, "2") == ratio(10, 100));
  CHECK(share(c, "4") == ratio(20, 100));
  CHECK(share(c, "8") == ratio(30, 100));
  // 0.4 + 0.6 log2(20/16) = 0.593156856932417...
  CHECK(rounded(*c.passing(20), 12) == "0.593156856932");
  CHECK_FALSE(share(c, "20"));
}

TEST_CASE("sizes of any unit are millimetres") {
  Gradation::Data data;
  data.sizes = {1000, 4000};
  data.masses = {5, 0};
  data.unit = SizeUnit::um;
  CHECK(GradingCurve(Gradation(data)).sizes() == std::vector<Rational>{1, 4});
  data.unit = SizeUnit::m;
  CHECK(GradingCurve(Gradation(data)).sizes() == std::vector<Rational>{1000000, 4000000});
  data.factors = {3, 1};
  CHECK(GradingCurve(Gradation(data)).shares() == std::vector<Rational>{0, 1});
}

TEST_CASE("a share that a sieve has gives its opening, any other a power between two") {
  const GradingCurve c = curve({{"1", "0"}, {"16", "40"}, {"32", "100"}});
  CHECK(diameter(c, percent(40)) == Rational(16));
  CHECK(diameter(c, percent(100)) == Rational(32));
  CHECK(diameter(c, percent(10)) == Rational(2));
  CHECK(diameter(c, percent(30)) == Rational(8));
  CHECK_FALSE(diameter(c, percent(60)));
  // 16 * 2^(1/3)
  CHECK(rounded(c.diameter(percent(60))->real(), 12) == "20.1587367983");
}

TEST_CASE("an empty class has one share and gives the size at its lower end") {
  const GradingCurve c =
      curve({{"1", "0"}, {"2", "0"}, {"4", "50"}, {"8", "50"}, {"16", "100"}, {"32", "100"}});
  CHECK(share(c, "1.5") == Rational(0));
  CHECK(share(c, "5") == ratio(1, 2));
  CHECK_FALSE(c.interpolates(5));
  CHECK(diameter(c, percent(50)) == Rational(4));
  CHECK(diameter(c, percent(100)) == Rational(16));
  CHECK(diameter(c, percent(75)) == std::nullopt);
  CHECK(pow(*c.diameter(percent(75)), 2).exact() == Rational(128));
  CHECK(c.finest() == 1);
  CHECK(c.coarsest() == 3);
}

TEST_CASE("inside a pan at size 0 nothing is known") {
  const GradingCurve c = curve({{"0", "0"}, {"0.075", "20"}, {"0.6", "60"}, {"2", "100"}});
  CHECK(share(c, "0") == Rational(0));
  CHECK(share(c, "0.075") == ratio(1, 5));
  CHECK_FALSE(c.passing(decimal("0.05")));
  CHECK(c.passing(decimal("0.05")).why().reason == "below 0.075 mm, the finest sieve");
  CHECK(c.in_pan(percent(10)));
  CHECK_FALSE(c.in_pan(percent(20)));
  CHECK_FALSE(c.diameter(percent(10)));
  CHECK(c.diameter(percent(10)).why().reason == "below 0.075 mm, the finest sieve");
  CHECK(diameter(c, percent(20)) == decimal("0.075"));
}

TEST_CASE("an empty pan at size 0 is known to be empty") {
  const GradingCurve c = curve({{"0", "0"}, {"0.1", "0"}, {"0.4", "100"}});
  CHECK(share(c, "0.05") == Rational(0));
  CHECK_FALSE(c.in_pan(percent(10)));
  CHECK(diameter(c, percent(50)) == ratio(1, 5));
}

TEST_CASE("extrapolation continues the line of the two finest sieves") {
  const GradingCurve c = curve({{"0", "0"}, {"1", "20"}, {"2", "30"}, {"4", "100"}});
  CHECK(diameter(c, percent(10), true) == ratio(1, 2));
  CHECK(pow(*c.diameter(percent(5), true), 2).exact() == ratio(1, 8));
  // Nothing changes where it is not needed.
  CHECK(diameter(c, percent(20), true) == Rational(1));
  CHECK(diameter(c, percent(30), true) == Rational(2));
}

TEST_CASE("a curve that cannot be extrapolated says why") {
  const auto reason = [](const GradingCurve &c) { return c.diameter(percent(10), true).why().reason; };
  CHECK(reason(curve({{"0", "0"}, {"1", "100"}})).find("one class only") != std::string::npos);
  CHECK(reason(curve({{"0", "0"}, {"1", "20"}, {"2", "20"}, {"4", "100"}})).find("is empty") !=
        std::string::npos);
  CHECK(reason(curve({{"0", "0"}, {"1", "20"}, {"2", "20.0999"}, {"4", "100"}})).find("100 times") !=
        std::string::npos);
  CHECK(curve({{"0", "0"}, {"1", "20"}, {"2", "20.1"}, {"4", "100"}}).diameter(percent(10), true));
}

TEST_CASE("the part that passes a sieve is a curve of its own") {
  const GradingCurve c = curve({{"1", "0"}, {"2", "20"}, {"4", "40"}, {"8", "40"}, {"16", "100"}});
  const Available<GradingCurve> part = c.part_passing(4);
  CHECK(part->sizes() == std::vector<Rational>{1, 2, 4});
  CHECK(part->shares() == std::vector<Rational>{0, ratio(1, 2), 1});
  CHECK(c.part_passing(6)->sizes() == part->sizes());
  CHECK(c.part_passing(16)->shares() == c.shares());
  CHECK(c.part_passing(100)->shares() == c.shares());
  CHECK_FALSE(c.part_passing(12)); // inside a class
  CHECK_FALSE(c.part_passing(1));  // nothing passes
}

} // namespace grading_curve_test

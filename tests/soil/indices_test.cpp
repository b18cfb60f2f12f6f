// Index numbers: by hand where they are exact, by long double elsewhere.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/indices.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <cmath>
#include <fstream>

namespace indices_test {

using namespace mdm;
using namespace grading_test;

namespace {

/// The indices once more, in long double.
class Plain {
public:
  explicit Plain(const Gradation &g) {
    long double total = 0;
    for (std::size_t i = 0; i < g.sizes().size(); ++i) {
      x_.push_back(std::log(g.sizes()[i].convert_to<long double>()));
      p_.push_back(total);
      total += g.masses()[i].convert_to<long double>();
    }
    for (long double &p : p_)
      p /= total;
  }

  long double diameter(long double p) const {
    std::size_t i = 0;
    while (p_[i] < p)
      ++i;
    return std::exp(x_[i - 1] + (x_[i] - x_[i - 1]) * (p - p_[i - 1]) / (p_[i] - p_[i - 1]));
  }
  long double uniformity() const { return diameter(0.6L) / diameter(0.1L); }
  long double curvature() const { return diameter(0.3L) * diameter(0.3L) / diameter(0.6L) / diameter(0.1L); }

  /// P at a logarithm of size.
  long double at(long double x) const {
    if (x <= x_.front())
      return 0;
    for (std::size_t i = 1; i < x_.size(); ++i)
      if (x <= x_[i])
        return p_[i - 1] + (p_[i] - p_[i - 1]) * (x - x_[i - 1]) / (x_[i] - x_[i - 1]);
    return 1;
  }
  /// The integral of P from one logarithm to another: trapezes between all corners.
  long double integral(long double from, long double to) const {
    std::vector<long double> corners = {from};
    for (const long double x : x_)
      if (x > from && x < to)
        corners.push_back(x);
    corners.push_back(to);
    long double sum = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
      sum += (corners[i] - corners[i - 1]) * (at(corners[i]) + at(corners[i - 1])) / 2;
    return sum;
  }
  long double grain_size_index() const {
    const long double from = std::log(0.001L), to = std::log(75.0L);
    return integral(from, to) / (to - from);
  }
  long double curvature_index() const {
    const long double width = x_.back() - x_[1];
    return (integral(x_[1], x_.back()) - p_[1] * width) / ((1 - p_[1]) * width / 2);
  }

private:
  std::vector<long double> x_, p_; // logarithms of sizes, shares
};

bool agrees(const Real &y, long double plain) {
  const long double value = enclose(y, 17).lower().convert_to<long double>();
  return std::fabs(value / plain - 1) < 1e-12L;
}

std::optional<Rational> exact(const Available<PowerProduct> &p) {
  return p->exact();
}

} // namespace

TEST_CASE("C_u and C_c where the sizes are sieves") {
  const GradingCurve c = curve({{"0.05", "0"}, {"0.1", "10"}, {"0.3", "30"}, {"0.6", "60"}, {"2", "100"}});
  CHECK(exact(uniformity(c)) == Rational(6));
  CHECK(exact(curvature(c)) == ratio(3, 2));
}

TEST_CASE("C_u is known to be 6 although D10 and D60 are irrational") {
  const GradingCurve c = curve({{"0.1", "0"}, {"3.6", "100"}});
  CHECK_FALSE(exact(c.diameter(ratio(1, 10))));
  CHECK_FALSE(exact(c.diameter(ratio(6, 10))));
  CHECK(exact(uniformity(c)) == Rational(6));
  CHECK(compare(uniformity(c)->real(), Real(6)) == Order::equal);
  CHECK_FALSE(exact(curvature(c)));
  CHECK(pow(*curvature(c), 10).exact() == ratio(1, 36));
}

TEST_CASE("C_u and C_c need D10") {
  const GradingCurve c = curve({{"0", "0"}, {"1", "20"}, {"2", "30"}, {"4", "60"}, {"8", "100"}});
  CHECK_FALSE(uniformity(c));
  CHECK(uniformity(c).why().reason == "D10 is below 1 mm, the finest sieve");
  CHECK_FALSE(curvature(c));
  CHECK(exact(uniformity(c, true)) == Rational(8));
  CHECK(exact(curvature(c, true)) == Rational(2));
}

TEST_CASE("I_C of a straight line is 1, above it more, below it less") {
  const auto i_c = [](const GradingCurve &c) { return curvature_index(c)->exact(); };
  CHECK(i_c(curve({{"0", "0"}, {"1", "20"}, {"2", "40"}, {"4", "60"}, {"8", "80"}, {"16", "100"}})) ==
        Rational(1));
  CHECK(i_c(curve({{"0.1", "0"}, {"1", "0"}, {"10", "100"}})) == Rational(1));
  // Steps of log size 1, 1; areas over the level of 20: 1/2 * 60 + 70 of a triangle of 80.
  CHECK(i_c(curve({{"0", "0"}, {"1", "20"}, {"2", "80"}, {"4", "100"}})) == ratio(100, 80));
  CHECK(i_c(curve({{"0", "0"}, {"1", "20"}, {"2", "20"}, {"4", "100"}})) == ratio(1, 2));
}

TEST_CASE("I_C needs something above the finest sieve") {
  CHECK_FALSE(curvature_index(curve({{"0", "0"}, {"1", "100"}})));
  CHECK_FALSE(curvature_index(curve({{"0", "0"}, {"1", "100"}, {"2", "100"}})));
}

TEST_CASE("I_GS is exact where the corners divide the span") {
  const auto i_gs = [](const GradingCurve &c) { return grain_size_index(c)->exact(); };
  CHECK(i_gs(curve({{"0.001", "0"}, {"75", "100"}})) == ratio(1, 2));
  CHECK(i_gs(curve({{"75", "0"}, {"90", "100"}})) == Rational(0));
  CHECK(i_gs(curve({{"100", "0"}, {"200", "100"}})) == Rational(0));
  CHECK(i_gs(curve({{"0.0001", "0"}, {"0.001", "100"}})) == Rational(1));
  CHECK(i_gs(curve({{"0.0001", "0"}, {"0.0005", "100"}})) == Rational(1));
  CHECK(i_gs(curve({{"0.001", "0"}, {"75", "60"}, {"100", "100"}})) == ratio(3, 10));
  CHECK(i_gs(curve({{"0", "0"}, {"0.001", "0"}, {"75", "100"}})) == ratio(1, 2));
}

TEST_CASE("I_GS is cut at both ends of the span") {
  const Gradation wide = soil({{"0.0001", "0"}, {"0.3", "40"}, {"750", "100"}});
  CHECK(agrees(*grain_size_index(GradingCurve(wide)), Plain(wide).grain_size_index()));
  const Gradation one = soil({{"0.0001", "0"}, {"1000", "100"}});
  CHECK(agrees(*grain_size_index(GradingCurve(one)), Plain(one).grain_size_index()));
}

TEST_CASE("I_GS is not available where a pan at size 0 holds mass") {
  CHECK_FALSE(grain_size_index(curve({{"0", "0"}, {"1", "1"}, {"2", "100"}})));
}

TEST_CASE("phi_1 and zeta_1 are those of the finest and the coarsest class with particles") {
  const GradingCurve c =
      curve({{"0", "0"}, {"0.1", "0"}, {"0.2", "30"}, {"0.5", "80"}, {"1", "100"}, {"2", "100"}});
  CHECK(finest_mass_ratio(c) == ratio(3, 2));
  CHECK(coarsest_volume_ratio(c).exact() == Rational(125));
  const GradingCurve one = curve({{"0", "0"}, {"1", "100"}});
  CHECK(finest_mass_ratio(one) == 1);
  CHECK(coarsest_volume_ratio(one).exact() == Rational(1));
}

TEST_CASE("the suite's indices agree with long double") {
  std::ifstream suite(MDM_SUITE);
  REQUIRE(suite);
  int count = 0;
  for (std::string line; std::getline(suite, line); ++count) {
    if (count % 10 != 0)
      continue;
    const Gradation g = read_json_gradation(line, "suite", "");
    const GradingCurve c(g);
    const Plain plain(g);
    CHECK(agrees(uniformity(c)->real(), plain.uniformity()));
    CHECK(agrees(curvature(c)->real(), plain.curvature()));
    CHECK(agrees(*grain_size_index(c), plain.grain_size_index()));
    CHECK(agrees(*curvature_index(c), plain.curvature_index()));
    CHECK(agrees(c.diameter(ratio(1, 2))->real(), plain.diameter(0.5L)));
  }
}

} // namespace indices_test

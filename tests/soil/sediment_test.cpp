// Measures of sediments: uniform curves worked out by hand, limits that are met exactly, and random curves in
// double.

#include "catch.hpp"
#include "soil/sediment.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <cmath>
#include <random>

namespace sediment_test {

using namespace mdm;

namespace {

SedimentDescription of(const std::vector<std::string> &sizes, const std::vector<std::string> &masses) {
  return describe_sediment(gradation_of(sizes, masses));
}

double middle(const Available<Real> &y) {
  REQUIRE(y);
  const Enclosure e = enclose(*y, 12);
  return (static_cast<double>(e.lower()) + static_cast<double>(e.upper())) / 2;
}

std::optional<Rational> exact(const NamedMeasure &m) {
  REQUIRE(m.value);
  return m.value->exact();
}

/// What sedimentology reads from a curve: the phi that p percent are coarser than, by bisection.
class PhiCurve {
public:
  PhiCurve(std::vector<double> sizes, std::vector<double> masses)
      : sizes_(std::move(sizes)), masses_(std::move(masses)) {
    for (const double m : masses_)
      total_ += m;
  }

  double phi(double percent) const {
    double lo = -std::log2(sizes_.back()), hi = -std::log2(sizes_.front());
    for (int i = 0; i < 100; ++i) {
      const double mid = (lo + hi) / 2;
      (coarser(mid) < percent ? lo : hi) = mid;
    }
    return lo;
  }

private:
  double coarser(double phi) const {
    double mass = 0;
    for (std::size_t j = 0; j + 1 < sizes_.size(); ++j) {
      const double fine = -std::log2(sizes_[j]), coarse = -std::log2(sizes_[j + 1]);
      mass += masses_[j] * std::min(1.0, std::max(0.0, (phi - coarse) / (fine - coarse)));
    }
    return 100 * mass / total_;
  }

  std::vector<double> sizes_, masses_;
  double total_ = 0;
};

} // namespace

TEST_CASE("a sand between 250 and 500 um has a mean of 1.5 phi and is very well sorted", "[sediment]") {
  const SedimentDescription s = of({"0.25", "0.5"}, {"1", "0"});
  CHECK(exact(s.graphic.mean) == ratio(3, 2));
  CHECK(s.graphic.mean.word == "medium sand");
  CHECK(exact(s.graphic.sorting) == ratio(68, 400) + ratio(9, 66));
  CHECK(s.graphic.sorting.word == "very well sorted");
  CHECK(exact(s.graphic.skewness) == Rational(0));
  CHECK(s.graphic.skewness.word == "symmetrical");
  CHECK(exact(s.graphic.kurtosis) == ratio(45, 61));
  CHECK(s.graphic.kurtosis.word == "platykurtic");
  CHECK(exact(s.moments.mean) == ratio(3, 2));
  CHECK_FALSE(s.moments.sorting.value);
  CHECK(s.folk == "sand");
  REQUIRE(s.modes.size() == 1);
  CHECK(s.modes[0].up_to.text() == "0.5");
}

TEST_CASE("a number at a limit has the word above it", "[sediment]") {
  CHECK(exact(of({"0.125", "0.5"}, {"1", "0"}).graphic.mean) == Rational(2));
  CHECK(of({"0.125", "0.5"}, {"1", "0"}).graphic.mean.word == "fine sand");
  CHECK(of({"0.1251", "0.5"}, {"1", "0"}).graphic.mean.word == "medium sand");
  // Two classes of a phi each, 2 phi apart: moments 1 phi, or just below, from the mean.
  const SedimentDescription tie = of({"0.125", "0.25", "0.5", "1"}, {"1", "0", "1", "0"});
  CHECK(exact(tie.moments.sorting) == Rational(1));
  CHECK(tie.moments.sorting.word == "poorly sorted");
  CHECK(of({"0.125", "0.25", "0.5", "1"}, {"0.999999999999", "0", "1", "0"}).moments.sorting.word ==
        "moderately sorted");
}

TEST_CASE("a sorting at a limit is known though the middles of classes are irrational", "[sediment]") {
  // Classes of a phi each around sqrt(50) and sqrt(200) mm: half a phi from their mean.
  const SedimentDescription s = of({"5", "10", "20"}, {"1", "1", "0"});
  CHECK_FALSE(s.moments.mean.value->exact());
  CHECK(exact(s.moments.sorting) == ratio(1, 2));
  CHECK(s.moments.sorting.word == "moderately well sorted");
  CHECK_FALSE(s.limited());
}

TEST_CASE("graphic measures are those of curves in double", "[sediment]") {
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    std::vector<std::string> sizes, masses;
    std::vector<double> x, m;
    for (int j = 0; j < 9; ++j) {
      sizes.push_back(std::to_string(1 << j) + "." + std::to_string(random() % 10));
      x.push_back(std::stod(sizes.back()));
      masses.push_back(j == 8 ? "0" : std::to_string(random() % 20 + (j % 3 == 0 ? 1 : 0)));
      m.push_back(std::stod(masses.back()));
    }
    const PhiCurve curve(x, m);
    const auto p = [&](double percent) { return curve.phi(percent); };
    const SedimentDescription s = of(sizes, masses);
    CAPTURE(i);
    CHECK(middle(s.graphic.mean.value) == Approx((p(16) + p(50) + p(84)) / 3).margin(1e-9));
    CHECK(middle(s.graphic.sorting.value) == Approx((p(84) - p(16)) / 4 + (p(95) - p(5)) / 6.6));
    CHECK(middle(s.graphic.skewness.value) == Approx((p(16) + p(84) - 2 * p(50)) / (2 * (p(84) - p(16))) +
                                                     (p(5) + p(95) - 2 * p(50)) / (2 * (p(95) - p(5))))
                                                  .margin(1e-9));
    CHECK(middle(s.graphic.kurtosis.value) == Approx((p(95) - p(5)) / (2.44 * (p(75) - p(25)))));
    CHECK(middle(s.trask_sorting) == Approx(std::exp2((p(75) - p(25)) / 2)));
    double total = 0, mean = 0, variance = 0, third = 0, fourth = 0;
    for (std::size_t j = 0; j < 8; ++j)
      total += m[j];
    const auto mid = [&](std::size_t j) { return -(std::log2(x[j]) + std::log2(x[j + 1])) / 2; };
    for (std::size_t j = 0; j < 8; ++j)
      mean += m[j] / total * mid(j);
    for (std::size_t j = 0; j < 8; ++j) {
      const double d = mid(j) - mean, w = m[j] / total;
      variance += w * d * d;
      third += w * d * d * d;
      fourth += w * d * d * d * d;
    }
    CHECK(middle(s.moments.mean.value) == Approx(mean).margin(1e-9));
    CHECK(middle(s.moments.sorting.value) == Approx(std::sqrt(variance)));
    CHECK(middle(s.moments.skewness.value) == Approx(third / std::pow(variance, 1.5)).margin(1e-9));
    CHECK(middle(s.moments.kurtosis.value) == Approx(fourth / variance / variance));
  }
}

TEST_CASE("textures of Folk, at their limits too", "[sediment]") {
  const auto texture = [](const char *mud, const char *sand, const char *gravel) {
    return of({"0.001", "0.0625", "2", "64"}, {mud, sand, gravel, "0"}).folk;
  };
  CHECK(texture("5", "15", "80") == "gravel");
  CHECK(texture("0", "20.1", "79.9") == "sandy gravel");
  CHECK(texture("7", "63", "30") == "sandy gravel");
  CHECK(texture("7.1", "62.9", "30") == "muddy sandy gravel");
  CHECK(texture("36", "34", "30") == "muddy gravel");
  CHECK(texture("9.5", "85.5", "5") == "gravelly sand");
  CHECK(texture("47.5", "47.5", "5") == "gravelly muddy sand");
  CHECK(texture("50", "45", "5") == "gravelly mud");
  CHECK(texture("0", "99.99", "0.01") == "slightly gravelly sand");
  CHECK(texture("0", "99.991", "0.009") == "sand");
  CHECK(texture("50", "50", "0") == "muddy sand");
  CHECK(texture("50.01", "49.99", "0") == "sandy mud");
  CHECK(texture("90", "10", "0") == "sandy mud");
  CHECK(texture("90.01", "9.99", "0") == "mud");
}

TEST_CASE("what the pan hides is not available", "[sediment]") {
  const SedimentDescription some = of({"0", "0.0625", "2"}, {"10", "90", "0"});
  CHECK_FALSE(some.graphic.mean.value);
  CHECK_FALSE(some.moments.mean.value);
  CHECK(some.folk == "sand");
  const SedimentDescription coarse = of({"0", "0.1", "2"}, {"10", "90", "0"});
  CHECK(coarse.folk.empty());
  const SedimentDescription little = of({"0", "0.0625", "2"}, {"4", "96", "0"});
  CHECK(little.graphic.mean.value);
  CHECK_FALSE(little.moments.mean.value);
}

TEST_CASE("neighbours of one height are one mode", "[sediment]") {
  const SedimentDescription s = of({"1", "2", "4", "8", "16", "32"}, {"20", "5", "30", "30", "10", "0"});
  REQUIRE(s.modes.size() == 2);
  CHECK(s.modes[0].above.text() == "4");
  CHECK(s.modes[0].up_to.text() == "16");
  CHECK(s.modes[1].up_to.text() == "2");
  CHECK(of({"1", "2", "4", "8"}, {"5", "5", "5", "0"}).modes.size() == 1);
  CHECK(of({"1", "2", "4", "8"}, {"5", "5", "6", "0"}).modes.size() == 1);
}

TEST_CASE("modes stand above their neighbours, the highest first", "[sediment]") {
  const SedimentDescription s = of({"1", "2", "4", "8", "16", "64"}, {"3", "1", "4", "1", "6", "0"});
  REQUIRE(s.modes.size() == 3);
  CHECK(s.modes[0].up_to.text() == "8"); // 4 in a phi
  CHECK(s.modes[1].up_to.text() == "2"); // 3 in a phi, as 6 in 2 phi: the finer one first
  CHECK(s.modes[2].up_to.text() == "64");
}

} // namespace sediment_test

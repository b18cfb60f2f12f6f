// Sizes are drawn uniform by volume, the same on every machine, inside their classes; drawn sets have the
// curve, as far as so many independent draws must.

#include "catch.hpp"
#include "sets/beta_curve.hpp"
#include "sets/class_counts.hpp"
#include "sets/set_sizes.hpp"

#include <cmath>

namespace set_sizes_test {

using namespace mdm;

namespace {

std::vector<SizeClass> classes(Classing classing) {
  return size_classes(BetaCurve(1, 1, 1, 10), classing, 4);
}

double value(const Real &y) {
  return enclose(y, 17).lower().convert_to<double>();
}

/// Volumes X_i = d_i^D of particles up to `d`, others 0, in one class [l, u] uniform by volume: X_i is in [0,
/// u^D] and has the mean (d - l) / (u - l) * v, v the mean volume.
struct Expected {
  double l, u;
  unsigned dimension;

  double mean_volume() const { return dimension == 2 ? l * u : 2 * l * l * u * u / (l + u); }
  double up_to(double d) const { return mean_volume() * (std::min(std::max(d, l), u) - l) / (u - l); }
};

} // namespace

TEST_CASE("the partition function and its inverse belong together") {
  const UniformByVolume discs(2, 6, 2), spheres(2, 6, 3);
  CHECK(discs.powered_size(ratio(1, 2)) == Rational(3)); // 2 a b / (a + b)
  CHECK(discs.partition(3) == ratio(1, 2));
  CHECK(discs.powered_size(0) == Rational(2));
  CHECK(discs.powered_size(1) == Rational(6));
  CHECK(spheres.powered_size(ratio(1, 2)) == ratio(36, 5)); // 2 a^2 b^2 / (a^2 + b^2)
  for (int i = 1; i < 20; ++i) {
    const Rational y = ratio(i, 20);
    CHECK(discs.partition(discs.powered_size(y)) == y);
    CHECK(discs.size(y, 20).lower() <= discs.powered_size(y));
    const Enclosure d = spheres.size(y, 20);
    CHECK(spheres.partition(d.lower()) <= y);
    CHECK(spheres.partition(d.upper()) >= y);
  }
}

TEST_CASE("sizes lie inside their class, however near to its bounds") {
  const Rational tiny = ratio(1, Integer(1) << 65);
  for (const Classing classing : {Classing::regular, Classing::geometric})
    for (const unsigned dimension : {2U, 3U})
      for (const SizeClass &c : classes(classing)) {
        const ClassSizes sizes(c, dimension, 15);
        for (const Rational &y : {tiny, ratio(1, 3), Rational(1 - tiny)}) {
          const Enclosure d = sizes.at(y);
          CHECK(compare(c.lower.real, Real(d.lower())) != Order::greater);
          CHECK(compare(Real(d.upper()), c.upper.real) != Order::greater);
          CHECK(d.upper() - d.lower() <= ratio(2, power_of_ten(14)));
          if (const std::optional<Rational> exact = sizes.exact(y)) {
            CHECK(d.lower() <= *exact);
            CHECK(*exact <= d.upper());
          }
          CHECK(sizes.exact(y).has_value() == (dimension == 2 && c.lower.real.fraction().has_value() &&
                                               c.upper.real.fraction().has_value()));
        }
      }
}

TEST_CASE("few digits do not touch the open end of a class") {
  // Bounds 1, 2, 3 and 4 are decimals of one digit.
  const Draws draws = Draws::quantiles();
  for (const SizeClass &c : size_classes(BetaCurve(2, 3, 1, 4), Classing::regular, 3))
    for (const unsigned dimension : {2U, 3U})
      for (const unsigned digits : {1U, 2U, 3U}) {
        const ClassSizes sizes(c, dimension, digits);
        for (std::uint64_t i = 0; i < 500; ++i) {
          const Enclosure d = sizes.at(draws(0, i, 500));
          CHECK(d.lower() > *c.lower.real.fraction());
          CHECK(d.upper() <= *c.upper.real.fraction());
          if (const std::optional<ShortSize> quick = sizes.quick(draws.bits(0, i, 500)))
            CHECK(ratio(Integer(quick->lo), power_of_ten(quick->places)) > *c.lower.real.fraction());
        }
      }
  // Nor where the class is too narrow for sixty digits.
  const SizeClass narrow{Surd(Rational(1)), Surd(Rational(1 + ratio(1, power_of_ten(90)))), Rational(1)};
  const Enclosure d = ClassSizes(narrow, 3, 3).at(ratio(1, 2));
  CHECK(d.lower() > 1);
  CHECK(d.upper() <= *narrow.upper.real.fraction());
}

TEST_CASE("irrational bounds give the enclosure of the size between them") {
  const SizeClass c = size_classes(BetaCurve(1, 1, 1, 2), Classing::geometric, 2)[0]; // 1 to sqrt 2
  // 2 sqrt 2 / (1 + sqrt 2) = 4 - 2 sqrt 2
  const Enclosure d = ClassSizes(c, 2, 15).at(ratio(1, 2));
  CHECK(d.lower_text() == "1.1715728752538");
  CHECK(d.upper_text() == "1.17157287525381");
}

TEST_CASE("draws are reproducible and in the open interval") {
  CHECK(Draws::quantiles()(5, 0, 2) == ratio(1, 4));
  CHECK(Draws::quantiles()(7, 1, 2) == ratio(3, 4));
  // The first number of stream 0 with key 0 is e169c58d6627e8d5 (hexadecimal).
  CHECK(Draws::random(0)(0, 0, 1) == ratio(2 * Integer(0xe169c58d6627e8d5ULL) + 1, Integer(1) << 65));
  CHECK(Draws::random(1)(0, 0, 1) != Draws::random(2)(0, 0, 1));
  CHECK(Draws::random(1)(0, 1, 1) != Draws::random(1)(1, 0, 1));
}

TEST_CASE("a drawn class has the distribution") {
  // Kolmogorov: sqrt(n) sup |F_n - F| is above 2.2 with chance 2 exp(-2 * 2.2^2) < 2e-4; the seed is fixed.
  constexpr std::uint64_t n = 4000;
  const Draws draws = Draws::random(42);
  std::vector<Rational> y;
  for (std::uint64_t i = 0; i < n; ++i)
    y.push_back(draws(3, i, n));
  std::sort(y.begin(), y.end());
  Rational worst = 0;
  for (std::uint64_t i = 0; i < n; ++i)
    worst = std::max({worst, Rational(ratio(i + 1, n) - y[i]), Rational(y[i] - ratio(i, n))});
  CHECK(worst * worst * n < ratio(484, 100));
}

TEST_CASE("the curve of drawn sets is within Hoeffding's bound of h's segments, and those near h") {
  // Hoeffding: the sum of n independent X_i in [0, w] is off by more than w sqrt(n log(2/c) / 2) with chance
  // c. With c = 10^-6 / 400 for each of at most 4 * 10 * 10 sums of a case, one fails with chance 10^-6; the
  // seeds are fixed.
  const double log_2_over_c = std::log(2 * 400 / 1e-6);
  for (const auto &[a, b] : {std::pair(1, 3), std::pair(3, 3), std::pair(3, 1)})
    for (const unsigned dimension : {2U, 3U})
      for (const std::uint64_t seed : {1U, 2U}) {
        const BetaCurve curve(a, b, ratio(1, 10), ratio(9, 10));
        const std::vector<SizeClass> classes = size_classes(curve, Classing::geometric, 10);
        const ClassCounts counts = class_counts(classes, curve, {50, 5000, dimension});
        const ParticlesOf particles =
            drawn_particles(classes, counts.numbers, dimension, 15, Draws::random(seed));
        double total = 0, total_expected = 0, total_bound = 0;
        std::vector<double> below, below_expected, below_bound; // at the upper ends of classes
        for (std::size_t j = 0; j < classes.size(); ++j) {
          const Expected expected{value(classes[j].lower.real), value(classes[j].upper.real), dimension};
          std::vector<double> sizes;
          particles(j, [&](const Enclosure &size, const Integer &) {
            sizes.push_back(size.lower().convert_to<double>());
          });
          const auto n = static_cast<double>(sizes.size());
          const double bound = std::pow(expected.u, dimension) * std::sqrt(n * log_2_over_c / 2);
          double whole = 0;
          for (int k = 1; k <= 4; ++k) {
            const double d = expected.l + (expected.u - expected.l) * k / 4;
            double sum = 0;
            for (const double size : sizes)
              sum += size <= d ? std::pow(size, dimension) : 0;
            CHECK(std::abs(sum - n * expected.up_to(d)) <= bound);
            whole = sum;
          }
          total += whole;
          total_expected += n * expected.mean_volume();
          total_bound += bound;
          below.push_back(total);
          below_expected.push_back(total_expected);
          below_bound.push_back(total_bound);
        }
        // d_m^D is below the mean volume v, but not much in classes of ratio 9^(1/10): v / d_m^D is at most
        // 1.013 in dimension 2 and 1.037 in dimension 3, and the floors lose at most one particle in 50.
        const double bias = dimension == 2 ? 0.013 : 0.037;
        for (std::size_t j = 0; j < classes.size(); ++j) {
          const double h = value(curve.passing(classes[j].upper));
          const double y = below[j] / total, y_expected = below_expected[j] / total_expected;
          CHECK(std::abs(y - y_expected) <= 2 * total_bound / (total_expected - total_bound));
          CHECK(std::abs(y_expected - h) <= bias + 0.02);
        }
      }
}

TEST_CASE("sizes without randomness are as even as they can be") {
  // Of the quantiles (2 i + 1) / (2 q), F_n is never off by more than 1 / (2 q).
  const std::vector<SizeClass> classes = size_classes(BetaCurve(1, 1, 1, 3), Classing::regular, 2);
  const UniformByVolume first(1, 2, 3);
  const unsigned q = 500;
  unsigned i = 0;
  drawn_particles(classes, {q, 0}, 3, 15, Draws::quantiles())(0, [&](const Enclosure &size, const Integer &) {
    CHECK(first.partition(size.lower()) <= ratio(2 * i + 1, 2 * q));
    CHECK(first.partition(size.upper()) >= ratio(2 * i + 1, 2 * q));
    ++i;
  });
  CHECK(i == q);
}

} // namespace set_sizes_test

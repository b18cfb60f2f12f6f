// Drawn sets have the curve, as far as so many independent draws must.

#include "catch.hpp"

#include <mdm/grading/beta_curve.hpp>
#include <mdm/grading/class_counts.hpp>
#include <mdm/grading/set_sizes.hpp>

#include <cmath>

using namespace mdm;

namespace {

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

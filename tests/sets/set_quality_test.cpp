// The quality of sets, against hand-made cases and the sizes themselves.

#include "../soil/soil.hpp"
#include "catch.hpp"
#include "sets/beta_curve.hpp"
#include "sets/class_counts.hpp"
#include "sets/set_sizes.hpp"

#include <cmath>

namespace set_quality_test {

using namespace mdm;
using namespace grading_test;

namespace {

bool holds(const Interval &i, const Rational &r) {
  return i.lo <= r && r <= i.hi;
}

bool is_narrow(const Interval &i) {
  return i.lo <= i.hi && i.hi - i.lo < ratio(1, power_of_ten(10));
}

/// Discs: 3 of size 1 in class 1, 1 of size 3 in class 2, as exact decimals.
void discs(std::size_t j, const TakeSize &take) {
  if (j == 0)
    take({1, 1, 0}, 3);
  else
    take({3, 3, 0}, 1);
}

} // namespace

TEST_CASE("shares, errors, C_r, C_u and C_c of a set made by hand") {
  const SieveCurve linear(curve({{"0.5", "0"}, {"2", "50"}, {"8", "100"}}), Interpolation::linear);
  const std::vector<SizeClass> classes = sieve_classes(linear);
  const SetQuality q = set_quality(linear, classes, 2, 3, discs);
  // Volumes 3 and 9 of 12; points 0.5, 2 and 8 with h = 0, 1/2, 1 and found 0, 1/4, 1.
  CHECK(holds(q.shares[0], ratio(1, 4)));
  CHECK(holds(q.shares[1], ratio(3, 4)));
  CHECK(holds(q.largest[0], ratio(1, 3)));
  CHECK(holds(q.largest[1], Rational(1)));
  CHECK(holds(q.worst_error, ratio(1, 4)));
  CHECK(rounded(real_in(q.c_r), 8) == "0.24253563"); // sqrt((1/16) / (17/16))
  CHECK(holds(q.c_u, Rational(3)));
  CHECK(holds(q.c_c, ratio(9, 3)));
  const Interval all[] = {q.shares[0], q.worst_error, q.c_r, q.c_u, q.c_c};
  for (const Interval &i : all)
    CHECK(is_narrow(i));
}

TEST_CASE("exact shares decide where a share ends just at a class") {
  const SieveCurve linear(curve({{"0.5", "0"}, {"2", "10"}, {"8", "100"}}), Interpolation::linear);
  const std::vector<SizeClass> classes = sieve_classes(linear);
  // Sizes of which a tenth lies in class 1, known to 3 digits only.
  const ParticlesOf particles = [](std::size_t j, const TakeSize &take) {
    if (j == 0)
      take({999, 1001, 3}, 1);
    else
      take({2999, 3001, 3}, 1);
  };
  const SetQuality q =
      set_quality(linear, classes, 2, 2, particles, std::vector<Rational>{ratio(1, 10), ratio(9, 10)});
  CHECK(q.worst_error.is_point());
  CHECK(q.worst_error.lo == 0);
  CHECK(holds(q.c_u, Rational(3)));
  CHECK(q.c_u.hi < ratio(301, 100));
  // Without them D10 may be either size.
  CHECK(set_quality(linear, classes, 2, 2, particles).c_u.lo < ratio(11, 10));
}

TEST_CASE("the error of exact shares is exact where they are no decimals") {
  const SieveCurve linear(curve({{"0.5", "0"}, {"2", "10"}, {"8", "100"}}), Interpolation::linear);
  std::vector<SizeClass> classes = sieve_classes(linear);
  classes[0].volume_fraction = Real(ratio(1, 3));
  classes[1].volume_fraction = Real(ratio(2, 3));
  const SetQuality q =
      set_quality(linear, classes, 2, 2, discs, std::vector<Rational>{ratio(1, 3), ratio(2, 3)});
  CHECK(q.worst_error.is_point());
  CHECK(q.worst_error.lo == 0);
}

TEST_CASE("C_r is narrow however near the largest size is to the smallest") {
  // Halves of the volume end at the middle of two classes' quantiles, whatever the width: of one particle a
  // class at its median, 1 of 2 is found at the middle and 1 at the end, where h is 1/2 and 1.
  for (const unsigned places : {2U, 20U, 34U}) {
    const BetaCurve beta(1, 1, 1, 1 + ratio(1, power_of_ten(places)));
    const std::vector<SizeClass> classes = size_classes(beta, Classing::geometric, 2);
    const ParticlesOf particles = drawn_particles(classes, {1, 1}, 2, 15, Draws::quantiles());
    const SetQuality q = set_quality(beta, classes, 2, 3, particles);
    CHECK(q.c_r.lo >= 0);
    CHECK(q.c_r.hi < ratio(1, 100));
  }
}

TEST_CASE("a drawn set is judged as by its sizes in doubles, and refining does not tell otherwise") {
  const BetaCurve beta(3, 3, ratio(2, 100), ratio(198, 100));
  const std::vector<SizeClass> classes = size_classes(beta, Classing::geometric, 10);
  const ClassCounts counts = class_counts(classes, beta, {10, 2000, 3});
  const ParticlesOf particles = drawn_particles(classes, counts.numbers, 3, 15, Draws::random(1));
  std::vector<double> sizes;
  for (std::size_t j = 0; j < classes.size(); ++j)
    particles(j, [&](const Enclosure &size, const Integer &count) {
      CHECK(count == 1);
      sizes.push_back(size.lower().convert_to<double>());
    });
  CHECK(Integer(sizes.size()) == counts.particles());
  const auto volume_up_to = [&](double d) {
    double sum = 0;
    for (const double size : sizes)
      sum += size <= d ? size * size * size : 0;
    return sum;
  };
  const double total = volume_up_to(2);
  double deviations = 0, squares = 0;
  constexpr int points = 20;
  for (int i = 0; i < points; ++i) {
    const double d = 0.02 * std::pow(99.0, i / (points - 1.0)), x = (d - 0.02) / 1.96;
    const double found = i == points - 1 ? 1 : volume_up_to(d) / total;
    const double h = x * x * x * (10 - 15 * x + 6 * x * x);
    deviations += (found - h) * (found - h);
    squares += found * found;
  }
  std::sort(sizes.begin(), sizes.end());
  const auto diameter = [&](double p) {
    double sum = 0;
    for (const double size : sizes) {
      sum += size * size * size;
      if (sum >= p * total)
        return size;
    }
    return sizes.back();
  };
  const SetQuality q = set_quality(beta, classes, 3, points, particles);
  const auto value = [](const Interval &i) { return i.lo.convert_to<double>(); };
  CHECK(value(q.c_r) == Approx(std::sqrt(deviations / squares)).epsilon(1e-9));
  CHECK(value(q.c_u) == Approx(diameter(0.6) / diameter(0.1)).epsilon(1e-9));
  CHECK(value(q.c_c) == Approx(diameter(0.3) * diameter(0.3) / diameter(0.6) / diameter(0.1)).epsilon(1e-9));
  const Interval all[] = {q.shares[3], q.largest[9], q.worst_error, q.c_r, q.c_u, q.c_c};
  for (const Interval &i : all)
    CHECK(is_narrow(i));
}

} // namespace set_quality_test

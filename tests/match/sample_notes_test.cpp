// What is said of a sample to who models with it.

#include "catch.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace sample_notes_test {

using namespace mdm;

namespace {

Gradation graded(std::vector<Rational> sizes, std::vector<Rational> masses) {
  Gradation::Data data;
  data.sizes = std::move(sizes);
  data.masses = std::move(masses);
  return Gradation(std::move(data));
}

std::string notes_of(const Match &m) {
  std::string text;
  for (const std::string &note : m.notes)
    text += note + "\n";
  return text;
}

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

Match in_cylinder(const Rational &height) {
  Question q;
  q.solids = Cylinder{10, height, 1};
  return solve(graded({ratio(1, 2), 1, 2}, {1, 3, 0}), q);
}

} // namespace

TEST_CASE("of a specimen the figures of a representative volume are told", "[notes]") {
  const std::string high = notes_of(in_cylinder(100)), low = notes_of(in_cylinder(17));
  CHECK(has(high, "representative volume"));
  CHECK(has(high, "above the 15 to 20"));
  CHECK(has(low, "below the 15 to 20")); // d_max is above 1 and up to 2 mm
  // D50: a quarter of the mass is finer than 1, so D50 = 2^(1/3) = 1.26, and d_max / D50 below 1.59.
  CHECK(has(high, "d_max / D50 = 1."));
  const Match m = in_cylinder(100);
  CHECK(has(high, "the coarsest class has " + to_string(m.sample->quantities.back()) + " particles"));
  const Rational height_over_size = Rational(100) / m.sample->sizes.back()->upper();
  CHECK(has(high, approximate(height_over_size, 3) + " times as high"));
}

TEST_CASE("without a specimen nothing is said of a volume, and nothing of sizes far from sieves", "[notes]") {
  CHECK(notes_of(solve(graded({1, 2, 4}, {1, 3, 0}))).empty());
  Question q;
  q.solids = SolidsVolume{1000};
  CHECK_FALSE(has(notes_of(solve(graded({1, 2, 4}, {1, 3, 0}), q)), "representative"));
}

TEST_CASE("sizes that crowd a sieve are named with their class", "[notes]") {
  // One particle in a class of a relative width of 10^-8: the middle is 5 10^-9 away from either sieve.
  const Rational near = 1 + ratio(1, power_of_ten(8));
  CHECK(has(notes_of(solve(graded({1, near}, {1, 0}))),
            "sizes crowd a sieve: within 1e-6 of themselves, in class 1"));
  const Rational far = 1 + ratio(1, 1000);
  CHECK(notes_of(solve(graded({1, far}, {1, 0}))).empty());
}

} // namespace sample_notes_test

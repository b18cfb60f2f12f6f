// What is known of spheres in their places: decided exactly, and as scipy has it.

#include "catch.hpp"
#include "files.hpp"
#include "packing/cut_sphere.hpp"
#include "packing/sphere_texture.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <cstdlib>

namespace sphere_texture_test {

using namespace mdm;

namespace {

/// Spheres `x y z diameter`.
SphereSample sample_of(const std::vector<std::array<const char *, 4>> &spheres) {
  SphereSample sample;
  for (const auto &[x, y, z, d] : spheres)
    sample.add({x, y, z}, 1, parse_decimal(d), 0);
  return sample;
}

SphereTextureOptions in_box(int side, std::array<bool, 3> periodic = {}) {
  SphereTextureOptions options;
  options.space.box = SpaceBox{{0, 0, 0}, {side, side, side}};
  options.space.to_top = false;
  options.space.periodic = periodic;
  return options;
}

double middle(const Interval &y) {
  CHECK(y.lo <= y.hi);
  return cut_double(Rational((y.lo + y.hi) / 2));
}

} // namespace

TEST_CASE("the packing of a random sample is as numpy and scipy have it, and bad places are refused") {
  CHECK(std::system("/usr/bin/python3 '" MDM_SOURCE_DIR "/tests/packing/check_sample.py' '" MDM_PROGRAM
                    "' > /dev/null") == 0);
}

TEST_CASE("spheres touch or overlap as their decimals say, not their doubles") {
  // 0.1 + 0.2 is 0.3, though not in doubles.
  const SphereTexture touch =
      sphere_texture(sample_of({{"0", "0", "0", "0.2"}, {"0.3", "0", "0", "0.4"}}), 1);
  CHECK(touch.contacts == 1);
  CHECK(touch.overlaps.pairs == 0);
  CHECK(touch.overlaps.largest.hi == 0);
  const SphereTexture apart =
      sphere_texture(sample_of({{"0", "0", "0", "0.2"}, {"0.3000000000000000000001", "0", "0", "0.4"}}), 1);
  CHECK(apart.contacts == 0);
  CHECK(apart.coordination.floating == 2);
  const SphereTexture overlap =
      sphere_texture(sample_of({{"0", "0", "0", "0.2"}, {"0.2999999999999999999999", "0", "0", "0.4"}}), 1);
  CHECK(overlap.contacts == 1);
  CHECK(overlap.overlaps.pairs == 1);
  CHECK(overlap.overlaps.largest.lo >= 0);
  CHECK(overlap.overlaps.largest.hi > ratio(1, power_of_ten(22)));
}

TEST_CASE("a gap up to which spheres touch is exact") {
  const SphereSample sample = sample_of({{"0", "0", "0", "1"}, {"0.8", "0.6", "0.1", "0.2"}});
  SphereTextureOptions options; // d^2 = 1.01, r + r' = 0.6
  options.gap = ratio(404987, 1000000);
  CHECK(sphere_texture(sample, 1, options).contacts == 0);
  options.gap = ratio(404988, 1000000);
  CHECK(sphere_texture(sample, 1, options).contacts == 1);
}

TEST_CASE("spheres touch across a periodic side, and no further") {
  const SphereSample sample =
      sample_of({{"0.25", "5", "5", "1"}, {"9.25", "5", "5", "1"}, {"5", "5", "5", "1"}});
  CHECK(sphere_texture(sample, 1, in_box(10)).contacts == 0);
  CHECK(sphere_texture(sample, 1, in_box(10, {true, false, false})).contacts == 1);
  CHECK(sphere_texture(sample, 1, in_box(10, {false, true, true})).contacts == 0);
  CHECK_THROWS_AS(sphere_texture(sample, 1, in_box(2, {true, false, false})), InputError);
}

TEST_CASE("one touching cluster of spheres has its coordination with and without rattlers") {
  // A row of three, of which the middle touches two; one alone.
  const SphereTexture t = sphere_texture(
      sample_of({{"0", "0", "0", "1"}, {"1", "0", "0", "1"}, {"2", "0", "0", "1"}, {"0", "9", "0", "1"}}), 1);
  CHECK(t.contacts == 2);
  CHECK(t.coordination.mean() == 1);
  CHECK(t.coordination.rattlers == 3);
  CHECK(t.coordination.floating == 1);
  CHECK(t.coordination.mean_without_rattlers() == Rational(2)); // (4 - 2) / 1
}

TEST_CASE("the void ratio of a cube around its sphere is 6 / pi - 1") {
  const SphereTexture t = sphere_texture(sample_of({{"1", "1", "1", "2"}}), 1);
  CHECK(t.space.volume() == 8);
  CHECK(middle(t.void_ratio) == Approx(0.9098593171027440).epsilon(1e-14));
  CHECK_FALSE(t.inner);
  CHECK_FALSE(t.segregation);
}

TEST_CASE("stray spheres far away do not change what is near") {
  std::vector<std::array<const char *, 4>> spheres(40, {"1", "1", "1", "0.5"});
  spheres.push_back({"1e59", "-1e59", "1e59", "0.5"});
  spheres.push_back({"1e59", "-1e59", "1e59", "0.5"});
  CHECK(sphere_texture(sample_of(spheres), 1).contacts == 40 * 39 / 2 + 1);
}

TEST_CASE("sizes that are far apart, and lengths without bounds, are judged or refused") {
  SphereSample sample;
  sample.add({"0", "0", "0"}, 1, Rational(power_of_ten(60)), 0);
  sample.add({"1e59", "0", "0"}, 1, ratio(1, power_of_ten(60)), 0);
  sample.add({"0", "1e-65", "0"}, 1, ratio(1, power_of_ten(60)), 0);
  const SphereTexture t = sphere_texture(sample, 1);
  CHECK(t.contacts == 2); // each of the small ones is inside the large one
  CHECK(t.overlaps.pairs == 2);
  CHECK_THROWS_AS(sample.add({"0", "0", "0"}, 1, Rational(power_of_ten(61)), 0), InputError);
  CHECK_THROWS_AS(sample.add({"0", "0", "0"}, 1, ratio(1, power_of_ten(61)), 0), InputError);
  CHECK_THROWS_AS(sample.add({"0", "0", "-1e60"}, 1, 1, 0), InputError);
  CHECK_THROWS_AS(sample.add({"0", "0", "x"}, 1, 1, 0), InputError);
}

TEST_CASE("spheres below the floor of their box are refused, and some outside it counted") {
  SphereTextureOptions options = in_box(10);
  options.space.to_top = true;
  CHECK_THROWS_AS(sphere_texture(sample_of({{"5", "5", "-3", "1"}}), 1, options), InputError);
  const SphereTexture t = sphere_texture(
      sample_of({{"5", "5", "-3", "1"}, {"5", "5", "5", "1"}, {"0", "5", "5", "1"}}), 1, options);
  CHECK(t.outside == 1);
  CHECK(t.space.high[2] == ratio(11, 2));
}

TEST_CASE("a part of one small sphere far from the origin is known well") {
  // Half of it is inside: the doubles of its place err by more than its radius.
  SphereTextureOptions options;
  options.space.box = SpaceBox{{Rational(power_of_ten(20)), 0, 0}, {Rational(power_of_ten(20)) + 1, 1, 1}};
  options.space.to_top = false;
  options.margin = 0;
  const SphereTexture t =
      sphere_texture(sample_of({{"100000000000000000000", "0.5", "0.5", "0.01"}}), 1, options);
  REQUIRE(t.inner_void_ratio);
  CHECK(middle(*t.inner_void_ratio) == Approx(2 * 6 / 3.14159265358979 * 1e6 - 1).epsilon(1e-9));
}

TEST_CASE("layers are segregated in full, equal columns not at all") {
  SphereSample layers, columns;
  for (const char *const z : {"0.5", "1.5", "2.5", "3.5", "4.5", "5.5", "6.5", "7.5", "8.5", "9.5"})
    for (const char *const x : {"1", "3"}) {
      layers.add({x, "1", z}, 1, 1, std::string(z) < "5" ? 0 : 1);
      columns.add({x, "1", z}, 1, 1, *x == '1' ? 0 : 1);
    }
  const SphereTexture full = sphere_texture(layers, 2), none = sphere_texture(columns, 2);
  REQUIRE(full.segregation);
  REQUIRE(none.segregation);
  CHECK(middle(*full.segregation) == Approx(1).epsilon(1e-12));
  CHECK(middle(*none.segregation) < 1e-12);
  CHECK(middle(*full.groups[0].mean_height) == Approx(2.5));
  CHECK(middle(*full.groups[1].mean_height) == Approx(7.5));
}

TEST_CASE("planes through the centre keep a half, a quarter and an eighth of a sphere") {
  CHECK(middle(packing::kept_share({0, 1, 1})) == 0.5);
  CHECK(middle(packing::kept_share({0, 1, 0})) == Approx(0.25).epsilon(1e-14));
  CHECK(middle(packing::kept_share({0, 0, 0})) == Approx(0.125).epsilon(1e-14));
}

TEST_CASE("planes that just touch a sphere, or pass its centre closely, keep what others keep") {
  const Rational hair = ratio(1, power_of_ten(60)), most = 1 - hair, third = ratio(1, 3);
  for (const Rational &side : {hair, most, Rational(-hair), third})
    for (const Rational &other : {hair, most, Rational(-hair), Rational(-most), third}) {
      const double one = middle(packing::kept_share({1, other, 1}));
      const double part = side == most ? one : side == third ? -1 : one / 2;
      const double both = middle(packing::kept_share({side, other, 1}));
      if (part >= 0)
        CHECK(both == Approx(part).margin(1e-15));
      CHECK(middle(packing::kept_share({side, other, most})) == Approx(both).margin(1e-15));
    }
}

TEST_CASE("what two planes keep on both of their sides is the whole sphere") {
  const auto kept = [](const char *x, const char *y, const char *z) {
    return middle(packing::kept_share({parse_decimal(x), parse_decimal(y), parse_decimal(z)}));
  };
  CHECK(kept("0.3", "0.4", "0.5") + kept("-0.3", "0.4", "0.5") ==
        Approx(kept("1", "0.4", "0.5")).epsilon(1e-14));
  CHECK(kept("0.3", "-0.9", "1") + kept("-0.3", "-0.9", "1") ==
        Approx(kept("1", "-0.9", "1")).epsilon(1e-14));
  CHECK(kept("-0.8", "-0.8", "0.2") == 0);
}

} // namespace sphere_texture_test

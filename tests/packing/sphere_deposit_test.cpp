#include "packing/sphere_deposit.hpp"
#include "packing/support.hpp"

#include <algorithm>
#include <cmath>

namespace sphere_deposit_test {

using namespace mdm;
using namespace packing_test;

namespace {

constexpr std::int64_t unit = 500000000; ///< the smallest radius

/// n radii from 1 to `ratio`, uniform by volume.
std::vector<std::int64_t> radii(std::size_t n, double ratio, std::uint64_t seed = 1) {
  std::vector<std::int64_t> all;
  std::uint64_t state = seed;
  for (std::size_t i = 0; i < n; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const double u = static_cast<double>(state >> 33) / 2147483648.0;
    all.push_back(
        static_cast<std::int64_t>(static_cast<double>(unit) / std::sqrt(1 - u * (1 - 1 / (ratio * ratio)))));
  }
  return all;
}

double cube(double x) {
  return x * x * x;
}

/// A space about as high as wide once they lie, and wide enough.
SphereSpace space_for(const std::vector<std::int64_t> &r, Sides sides) {
  double volume = 0;
  for (const std::int64_t each : r)
    volume += cube(2 * static_cast<double>(each));
  const auto side = std::max(static_cast<std::int64_t>(std::cbrt(volume)),
                             2 * least_widths * *std::max_element(r.begin(), r.end()) + 20);
  return {side, side, sides};
}

constexpr std::initializer_list<Sides> all_sides = {Sides::walls, Sides::cylinder, Sides::periodic};

/// The file of a deposit, for the judge.
std::string file_of(const std::vector<std::int64_t> &r, const SphereSpace &space,
                    const std::vector<DepositedSphere> &spheres) {
  std::string text = std::to_string(space.a) + " " + std::to_string(space.b) + " " +
                     (space.sides == Sides::walls      ? "walls"
                      : space.sides == Sides::cylinder ? "cylinder"
                                                       : "periodic");
  for (std::size_t i = 0; i < r.size(); ++i) {
    text += "\n" + std::to_string(spheres[i].at[0]) + " " + std::to_string(spheres[i].at[1]) + " " +
            std::to_string(spheres[i].at[2]) + " " + std::to_string(r[i]);
    for (const std::int32_t s : spheres[i].supports)
      text += " " + std::to_string(s);
  }
  return text + "\n";
}

/// What the independent checker says.
bool accepts(const std::vector<std::string> &files) {
  const mdm_test::TemporaryFolder folder;
  std::string command = "/usr/bin/python3 '" MDM_SOURCE_DIR "/tests/packing/check_spheres.py'";
  for (std::size_t i = 0; i < files.size(); ++i)
    command += " " + folder.write(std::to_string(i), files[i]);
  return std::system((command + " > " + (folder / "verdict")).c_str()) == 0;
}

/// Void ratio between a quarter and two thirds of the height, by the parts of the spheres there.
double void_ratio(const std::vector<std::int64_t> &r, const SphereSpace &space,
                  const std::vector<DepositedSphere> &spheres) {
  const double pi = std::acos(-1.0);
  double top = 0, solids = 0;
  for (const DepositedSphere &s : spheres)
    top = std::max(top, static_cast<double>(s.at[2]));
  const double low = top / 4, high = 2 * top / 3;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto radius = static_cast<double>(r[i]), z = static_cast<double>(spheres[i].at[2]);
    const auto below = [&](double level) {
      const double h = std::clamp(level - z + radius, 0.0, 2 * radius);
      return pi * h * h * (3 * radius - h) / 3;
    };
    solids += below(high) - below(low);
  }
  return static_cast<double>(space.a) * static_cast<double>(space.b) * (high - low) / solids - 1;
}

} // namespace

TEST_CASE("deposited spheres do not overlap and rest on three, as another program finds") {
  std::vector<std::string> files;
  for (const Sides sides : all_sides)
    for (const double ratio : {1.0, 2.0, 12.0}) {
      const std::vector<std::int64_t> r = radii(600, ratio);
      const SphereSpace space = space_for(r, sides);
      files.push_back(file_of(r, space, deposit_spheres(r, space, 1)));
    }
  CHECK(accepts(files));
}

TEST_CASE("spheres are deposited where there is hardly room, and on a coarse lattice") {
  std::vector<std::string> files;
  for (const Sides sides : all_sides)
    for (const std::int64_t radius : {least_radius_units + 1, unit}) {
      const std::vector<std::int64_t> r(200, radius);
      const SphereSpace space{6 * radius + 1, 6 * radius + 1, sides};
      files.push_back(file_of(r, space, deposit_spheres(r, space, 3)));
    }
  CHECK(accepts(files));
}

TEST_CASE("the judge of deposits refuses spheres that overlap, stand out, or float") {
  const std::vector<std::int64_t> r = radii(300, 2);
  const SphereSpace space = space_for(r, Sides::walls);
  const std::vector<DepositedSphere> good = deposit_spheres(r, space, 1);
  REQUIRE(accepts({file_of(r, space, good)}));
  std::vector<DepositedSphere> floating = good;
  floating.back().at[2] += 1000;
  CHECK_FALSE(accepts({file_of(r, space, floating)}));
  std::vector<std::int64_t> overlapping = r;
  overlapping[150] += 300;
  CHECK_FALSE(accepts({file_of(overlapping, space, good)}));
  CHECK_FALSE(accepts({file_of(r, {space.a - unit, space.b, Sides::walls}, good)}));
  CHECK_FALSE(accepts({file_of(r, {space.a, space.b, Sides::cylinder}, good)}));
}

TEST_CASE("spheres of one size fill 0.58 to 0.64 of a space without walls") {
  // Visscher, Bolsterli (1972): 0.582 for equal spheres, each in the first place that it finds; random close
  // packings have 0.64. Wide gradings are denser.
  const std::vector<std::int64_t> equal(8000, unit), wide = radii(8000, 4);
  const SphereSpace a = space_for(equal, Sides::periodic), b = space_for(wide, Sides::periodic);
  const double of_equal = void_ratio(equal, a, deposit_spheres(equal, a, 1));
  CHECK(of_equal > 1 / 0.64 - 1);
  CHECK(of_equal < 1 / 0.582 - 1);
  CHECK(void_ratio(wide, b, deposit_spheres(wide, b, 1)) < of_equal - 0.05);
}

TEST_CASE("a deposit of spheres depends on its seed and nothing else") {
  const std::vector<std::int64_t> r = radii(500, 3);
  for (const Sides sides : all_sides) {
    const SphereSpace space = space_for(r, sides);
    const std::string first = file_of(r, space, deposit_spheres(r, space, 1));
    CHECK(first == file_of(r, space, deposit_spheres(r, space, 1)));
    CHECK(first != file_of(r, space, deposit_spheres(r, space, 2)));
  }
}

TEST_CASE("deposited spheres lie where they lay on the machine that wrote this test") {
  const auto hash = [](Sides sides) {
    const std::vector<std::int64_t> r = radii(2000, 5);
    const SphereSpace space{30 * unit, 30 * unit, sides};
    std::uint64_t h = 0xcbf29ce484222325;
    for (const char c : file_of(r, space, deposit_spheres(r, space, 1)))
      h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return h;
  };
  CHECK(hash(Sides::walls) == 0x7a27f01c4dc4109e);
  CHECK(hash(Sides::cylinder) == 0xad81338da8be031e);
  CHECK(hash(Sides::periodic) == 0xd92cd29e4ef4ca94);
}

TEST_CASE("progress of a deposit of spheres, and none at all") {
  std::size_t lying = 0;
  const std::vector<std::int64_t> r(50, unit);
  deposit_spheres(r, space_for(r, Sides::walls), 1, [&lying](std::size_t n) {
    CHECK(n == lying + 1);
    lying = n;
  });
  CHECK(lying == 50);
  CHECK(deposit_spheres({}, {unit, unit, Sides::walls}, 1).empty());
}

TEST_CASE("a deposit of spheres that becomes too high for its lattice is refused") {
  const std::int64_t large = most_sphere_units / 8;
  const std::vector<std::int64_t> r(300, large);
  CHECK(has(refusal([&] { deposit_spheres(r, {7 * large, 7 * large, Sides::walls}, 1); }), "wider box"));
}

} // namespace sphere_deposit_test

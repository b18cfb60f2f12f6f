// Two grains that hold each other, held against their force at a million overlaps.

#include "particles/cohesion.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace cohesion_test {

using namespace mdm;

namespace {

constexpr double radius = 1e-4, effective_radius = radius / 2;
const Elasticity soft{5000000, ratio(1, 4)};
const double modulus = 5e6 / (2 * (1 - 0.25 * 0.25));

struct Contact {
  double overlap, force; ///< pressing: above 0
};

/// By the radius of the contact (Johnson, Kendall and Roberts).
Contact jkr(double surface_energy, double a) {
  return {a * a / effective_radius - 2 * std::sqrt(std::numbers::pi * surface_energy * a / modulus),
          4 * modulus * a * a * a / (3 * effective_radius) -
              2 * std::numbers::pi * a * a *
                  std::sqrt(4 * surface_energy * modulus / (std::numbers::pi * a))};
}

/// By the overlap: Hertz, and a tension on the area of the contact.
Contact sjkr(double energy_density, double overlap) {
  return {overlap, 4.0 / 3 * modulus * std::sqrt(effective_radius) * std::pow(overlap, 1.5) -
                       energy_density * 2 * std::numbers::pi * effective_radius * overlap};
}

/// The law's contact is that with the greatest tension, and the last with any.
template <class Law>
void check_against(Law law, double cohesion, const CohesiveContact &found, double most) {
  double tension = 0, overlap = 0;
  constexpr int steps = 1000000;
  for (int i = 1; i <= steps; ++i) {
    const Contact c = law(cohesion, most * i / steps);
    tension = std::max(tension, -c.force);
    if (c.force < 0)
      overlap = c.overlap;
  }
  CHECK(found.pull_off == Approx(tension).epsilon(1e-5));
  CHECK(found.overlap == Approx(overlap).epsilon(1e-4));
}

} // namespace

TEST_CASE("grains part at the greatest tension of their law", "[cohesion]") {
  for (const double surface_energy : {1e-4, 1e-3, 1e-2})
    check_against(jkr, surface_energy, jkr_contact(surface_energy, radius, soft),
                  4 * std::cbrt(surface_energy * effective_radius * effective_radius / modulus) * 2);
  for (const double energy_density : {1e3, 1e4, 1e5}) {
    const CohesiveContact found = sjkr_contact(energy_density, radius, soft);
    check_against(sjkr, energy_density, found, 2 * found.overlap);
  }
}

TEST_CASE("stiffer grains of a surface energy part at the same tension, and overlap less", "[cohesion]") {
  const CohesiveContact found = jkr_contact(1e-3, radius, soft),
                        stiffer = jkr_contact(1e-3, radius, {50000000, ratio(1, 4)});
  CHECK(found.pull_off == Approx(3 * std::numbers::pi * 1e-3 * effective_radius));
  CHECK(stiffer.pull_off == found.pull_off);
  CHECK(stiffer.overlap < found.overlap / 4);
}

} // namespace cohesion_test

#include "particles/cohesion.hpp"

#include <cmath>
#include <numbers>

namespace mdm {
namespace {

/// Of two grains of the material.
double effective_modulus(const Elasticity &e) {
  const double poisson = e.poisson.convert_to<double>();
  return e.young.convert_to<double>() / (2 * (1 - poisson * poisson));
}

} // namespace

CohesiveContact jkr_contact(double surface_energy, double radius, const Elasticity &elasticity) {
  const double r = radius / 2;
  const double cube_of_contact =
      9 * std::numbers::pi * surface_energy * r * r / effective_modulus(elasticity);
  return {3 * std::numbers::pi * surface_energy * r, std::pow(cube_of_contact, 2.0 / 3) / (3 * r)};
}

CohesiveContact sjkr_contact(double energy_density, double radius, const Elasticity &elasticity) {
  const double r = radius / 2;
  const double strain = std::numbers::pi * energy_density / effective_modulus(elasticity);
  return {2 * std::numbers::pi / 3 * energy_density * r * r * strain * strain, r * std::pow(1.5 * strain, 2)};
}

} // namespace mdm

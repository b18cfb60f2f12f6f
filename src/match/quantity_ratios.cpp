#include "match/quantity_ratios.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

std::size_t reference_class(const Gradation &g) {
  std::size_t j = g.classes() - 1;
  while (g.mass(j) == 0)
    --j;
  return j;
}

void check_rational(const MassLaw &law) {
  if (law.b != 1)
    throw InputError("the law x^(" + law.exponent() +
                     ") has no exact masses: the published algorithms need a whole exponent");
}

std::vector<Rational> particle_masses(const Gradation &g, const MassLaw &law, const SizeChoice &choice) {
  check_rational(law);
  std::vector<Rational> masses;
  masses.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const Rational f = choice.position
                           ? law.powered(g.lower(j) + *choice.position * (g.upper(j) - g.lower(j)))
                           : Rational((law.powered(g.lower(j)) + law.powered(g.upper(j))) / 2);
    masses.push_back(g.factor(j) * f);
  }
  return masses;
}

std::vector<Rational> mass_ratios(const Gradation &g) {
  const Rational &reference = g.mass(reference_class(g));
  std::vector<Rational> phi;
  phi.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j)
    phi.push_back(g.mass(j) / reference);
  return phi;
}

std::vector<Rational> volume_ratios(const std::vector<Rational> &particle_masses, std::size_t reference) {
  std::vector<Rational> zeta;
  zeta.reserve(particle_masses.size());
  for (const Rational &mass : particle_masses)
    zeta.push_back(particle_masses[reference] / mass);
  return zeta;
}

std::vector<Rational> quantity_ratios(const std::vector<Rational> &phi, const std::vector<Rational> &zeta) {
  std::vector<Rational> kappa;
  kappa.reserve(phi.size());
  for (std::size_t j = 0; j < phi.size(); ++j)
    kappa.push_back(phi[j] * zeta[j]);
  return kappa;
}

} // namespace mdm

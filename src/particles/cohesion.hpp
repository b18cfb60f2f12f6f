#pragma once
/// \file
/// How strongly two grains of one size and material hold each other by cohesion.

#include "particles/cost.hpp"

namespace mdm {

/// Two equal grains without damping.
struct CohesiveContact {
  double pull_off = 0; ///< the greatest tension, N
  double overlap = 0;  ///< where there is no force, m
};

/// By the law of Johnson, Kendall and Roberts (1971, Proc. R. Soc. A 324, 301-313), as LAMMPS has it.
/// \param surface_energy  J/m^2, of each of both surfaces
/// \param radius  in m
CohesiveContact jkr_contact(double surface_energy, double radius, const Elasticity &elasticity);

/// By its simplification SJKR, as LIGGGHTS has it: beside Hertz's force the density times the area of the
/// contact, 2 pi R overlap with the effective radius R, for small overlaps.
/// \param energy_density  J/m^3
CohesiveContact sjkr_contact(double energy_density, double radius, const Elasticity &elasticity);

/// A law that an engine has.
struct CohesionLaw {
  const char *option; ///< of mdm export
  const char *model;  ///< the engine's word
  const char *unit;   ///< of its number
  CohesiveContact (*contact)(double number, double radius, const Elasticity &elasticity);
};

inline constexpr CohesionLaw jkr_law{"surface-energy", "jkr", "J/m^2", jkr_contact},
    sjkr_law{"cohesion-energy-density", "sjkr", "J/m^3", sjkr_contact};

} // namespace mdm

#pragma once
/// \file
/// The rough cost of a simulation of a set.

#include "particles/particle_set.hpp"

namespace mdm {

/// Elastic constants that set the Rayleigh time.
struct Elasticity {
  Rational young = 70000000000; ///< E in Pa; quartz
  Rational poisson = ratio(1, 4);
};

/// The Rayleigh time, the least over all sizes of pi R sqrt(rho / G) / (0.1631 nu + 0.8766) with G = E / (2
/// (1 + nu)), in s; explicit time steps are some 10 to 30 % of it. A lower bound, within 1e-12 of it.
/// \pre E > 0, -1 < nu <= 1/2
Rational rayleigh_time(const ParticleSet &set, const Elasticity &elasticity = {});

/// The Rayleigh time of a class alone, which may have a material of its own.
Rational rayleigh_time(const ParticleSet &set, const ParticleClass &c, const Elasticity &elasticity);

/// Side of a cube that holds all of them loosely, (2 sum q x^3)^(1/3) in m, rounded down to um.
Rational loose_side(const ParticleSet &set);

/// x in m, for a length in the unit of the set.
Rational in_metres(const ParticleSet &set, const Rational &length);

} // namespace mdm

#pragma once
/// \file
/// The ratios that the published algorithms work with: Phi, Z and K (Arnold, Eq. 15-17).

#include <mdm/gradation/gradation.hpp>
#include <mdm/gradation/mass_law.hpp>

#include <optional>

namespace mdm {

/// The size of a class (x_j, x_{j+1}] that stands for it: x_j + t (x_{j+1} - x_j) at the position t, 0 < t <=
/// 1, or, without one, the size with the mean of the bounds' volumes, f(x) = (f(x_j) + f(x_{j+1})) / 2.
struct SizeChoice {
  std::optional<Rational> position;
};

/// The class whose mass the others are measured by: the coarsest with mass. That is the one retained on the
/// second largest sieve, as Eq. 15 has it, unless nothing is.
std::size_t reference_class(const Gradation &g);

/// \throws InputError if f(x) is no fraction for every x: b > 1
void check_rational(const MassLaw &law);

/// c_j f(x) for the chosen size x of every class.
/// \throws InputError if the law is not rational
std::vector<Rational> particle_masses(const Gradation &g, const MassLaw &law, const SizeChoice &choice);

/// Phi: mass of each class over that of the reference class (Eq. 15); 0 for an empty class.
std::vector<Rational> mass_ratios(const Gradation &g);

/// Z: mass of a particle of the class `reference` over that of one of each class (Eq. 16).
std::vector<Rational> volume_ratios(const std::vector<Rational> &particle_masses, std::size_t reference);

/// K = Phi * Z, class by class (Eq. 17): particles of each class for one of the reference class.
std::vector<Rational> quantity_ratios(const std::vector<Rational> &phi, const std::vector<Rational> &zeta);

} // namespace mdm

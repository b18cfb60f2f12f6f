#pragma once
// What a model measures of its grains at each look, and what it says of them at the end: whether they are at
// rest, and whether they are jammed. README.md has the definitions and their sources.

#include "particles/settle_script.hpp"

namespace mdm {

/// Limits of rest and of jamming.
struct SettleLimits {
  /// Kinetic energy by p V, under gravity and in a cell.
  static constexpr double at_rest_on_floor = 1e-4, at_rest_in_cell = 1e-6;
  static constexpr double unbalanced = 0.01;      ///< net force by contact force
  static constexpr double stiffness_share = 1e-7; ///< pressure by Young's modulus
};

/// The part of p V that the kinetic energy is below at rest.
double energy_at_rest(const SettleScript &s);

/// Variables that may be changed, in the language of LIGGGHTS and LAMMPS.
std::string state_settings(const SettleScript &s);

/// What is computed of the grains there, which have diameters `c_d` and a lid at `v_lid`.
/// \param stress  the compute of their stresses, in the engine's words
std::string state_measures(const SettleScript &s, const char *stress);

/// The words of `thermo_style custom` that keep it current.
std::string state_columns();

/// What is printed of the state: ` Z 4.5, ...`.
std::string state_words(const SettleScript &s);

/// The same of YADE: the settings, and functions `measured`, `words`, `is_at_rest` and `is_jammed`.
std::string yade_limits(const SettleScript &s);
std::string yade_measures(const SettleScript &s);

} // namespace mdm

#pragma once
// The course of a model in the language that LIGGGHTS and LAMMPS share.

#include "particles/settle_script.hpp"

namespace mdm {

/// What the engines do in words of their own.
struct PhaseCommands {
  std::string contact;           ///< gives grains and walls the friction of each type
  std::string move;              ///< moves the lid, or the faces of the cell, at the strain rate `rate`
  std::string lower_lid;         ///< puts the lid on the highest grain
  bool keeps_lid_offset = false; ///< the way of the lid before a restart, `lid_moved`, is told after it
  const char *quit;              ///< ends with an error
};

/// The variables that may be changed, those of the course, and what is computed at each look. The engine adds
/// `lid_height` (or of the cell its `volume`), `top`, the highest point of a grain, and `pressure`.
std::string phase_variables(const SettleScript &s);

/// The friction of a pair of materials, as the words of a variable: the lesser of both once grains have their
/// own.
std::string friction_of_pair(const SettleScript &s, const GrainMaterial &a, const GrainMaterial &b);

/// Phases fill, compact, hold: each runs some steps, looks, and decides.
std::string phase_loops(const SettleScript &s, const PhaseCommands &commands);

} // namespace mdm

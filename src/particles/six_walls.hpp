#pragma once
// Six walls that move, in the language of LIGGGHTS: meshes, two across each axis. Each is read from the same
// file, turned and moved into its place. The stress across an axis is the mean of both by the area between
// the other walls.

#include "particles/settle_script.hpp"

namespace mdm {

/// Room for the walls, which are wider than the box and may come apart.
std::string six_walls_room(const SettleScript &s);

/// The walls, where they were before a restart, and `volume`, `pressure`, `sigma_x`, `sigma_y`, `sigma_z`,
/// `length_z`.
/// \param contact  the fix of their contact with grains, in the engine's words
std::string six_walls_setting(const SettleScript &s, const std::string &contact);

/// The words of `thermo_style custom` that keep their forces and ways current.
std::string six_walls_columns();

/// The number of walls that a grain touches, as the words of a variable.
std::string six_walls_touched();

/// Moves each pair at its own rate, and the two of a pair against each other.
std::string six_walls_move();

/// Adds where they are to the state beside the restart.
std::string six_walls_save(const SettleScript &s);

/// Takes them away, and makes the box that of the space between them.
std::string six_walls_removal();

} // namespace mdm

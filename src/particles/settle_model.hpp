#pragma once
/// \file
/// Complete models of LIGGGHTS, LAMMPS and YADE that let a set settle in a box.

#include "particles/cost.hpp"

#include <mdm/particles/placement.hpp>

#include <cstdint>

namespace mdm {

/// Inner sizes of a box with a corner at the origin, in m; z is upwards.
struct ModelBox {
  double x = 0, y = 0, z = 0;
};

/// A set that is to settle, and the names of the files of its model, which lie side by side.
struct SettleModel {
  const ParticleSet &set; ///< in m
  ModelBox box;
  std::string particles;                   ///< what LAMMPS (a data file) and YADE (`x y z r` a line) read
  std::string dump;                        ///< what the model writes at its end, for `mdm verify`
  std::uint64_t seed = 1;                  ///< of the insertion of LIGGGHTS
  std::optional<std::uint64_t> steps = {}; ///< instead of those of Settling
  std::optional<Rational> young = {};      ///< instead of that of Settling
  Rational poisson = ratio(1, 4);
  /// The options with which `mdm verify` takes the gradation as it was asked for, for example ` --law
  /// power:2`; nothing: there is none, but a band.
  std::optional<std::string> verify_options = "";
  /// An answer's question in words, which `verify_options` may lack.
  std::string question = {};
  /// The particles are a deposit: LIGGGHTS, too, reads them, as LAMMPS does, and inserts none.
  bool deposited = false;
  /// Of the box, for LIGGGHTS and LAMMPS; models of YADE have walls.
  Sides sides = Sides::walls;
};

/// The material and the time of a model, in SI units.
struct Settling {
  static constexpr double friction = 0.5, restitution = 0.5, gravity = 9.81;
  /// The time step is this part of the Rayleigh time.
  static constexpr double part_of_rayleigh = 0.2;

  /// Young's modulus is softer than that of rock to save steps, and stiff enough for overlaps of some percent
  /// of a size at the impact of a fall from the top: 10^4 rho g height, and 5 MPa at least.
  Elasticity elasticity;
  double rayleigh = 0; ///< of the set, s
  double step = 0;     ///< s
  /// Three times as many as for a fall from the top of the box; of a deposit, as many.
  std::uint64_t steps = 0;
  /// LAMMPS and LIGGGHTS refuse longer runs.
  static constexpr std::uint32_t most_steps = 2147483647;
};

/// The material and the time of the model. \throws InputError if it has more steps than most_steps
Settling settling(const SettleModel &model);

/// Percentage points by which no share can be off the gradation's in a sample with these sizes, rounded up:
/// what to give to `mdm verify --tolerance`.
std::string share_tolerance(const ParticleSet &set);

/// Each is an input script that is run in its folder; it stops with a message where a count is wrong.
/// LIGGGHTS and LAMMPS take `-var steps N`, YADE the number of steps as its argument.
/// \throws InputError if the set is not in m, a file's name has characters that scripts could take for their
/// own, or LIGGGHTS cannot count so many
std::string liggghts_model(const SettleModel &model);
/// The same for LAMMPS.
std::string lammps_model(const SettleModel &model);
/// The same for YADE.
std::string yade_model(const SettleModel &model);

} // namespace mdm

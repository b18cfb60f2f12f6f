#pragma once
/// \file
/// Complete models of LIGGGHTS, LAMMPS and YADE that let a set settle in a specimen, compact it, and shear
/// it.

#include "particles/cohesion.hpp"
#include "particles/placement.hpp"

#include <cstdint>

namespace mdm {

/// Inner sizes of a box with a corner at the origin, in m; z is upwards. Of a plane y is the length of the
/// discs.
struct ModelBox {
  double x = 0, y = 0, z = 0;
};

/// The space that grains are in.
enum class Space {
  box,           ///< with four walls, floor and lid
  cylinder,      ///< with a round wall, floor and lid
  pillar,        ///< with floor and lid, repeated in x and y
  plane,         ///< of discs, whose axes are along y: with two walls, floor and lid
  periodic_cell, ///< repeated on all sides, without gravity
  six_walls      ///< between walls that move, without gravity
};

/// The density that a model is to reach: a void ratio, or else a pressure.
struct DensityTarget {
  std::optional<double> void_ratio;
  double pressure = 0; ///< Pa, where there is no void ratio
  /// Of the void ratio; of the pressure this part of itself.
  double tolerance = 0.01;
};

/// The stress that is constant in a shear: that on the sides, or the mean of all faces.
enum class ConstantStress { sigma_3, p };

/// Shear of a specimen after its isotropic compression: the height shrinks, and the sides move so that a
/// stress is constant.
struct TriaxialShear {
  double axial_strain = 0.2; ///< at the end, of the height
  ConstantStress constant = ConstantStress::sigma_3;
  /// At the pressure, before the shear, within the tolerance of the target: by friction while compacted.
  std::optional<double> void_ratio = {};
};

/// What grains are made of, beside their density.
struct GrainMaterial {
  Elasticity elasticity;
  double restitution = 0.5, friction = 0.5;
  double rolling_friction = 0; ///< most moment of a contact over its normal force and effective radius
};

/// A set that is to settle, and the names of the files of its model, which lie side by side.
struct SettleModel {
  const ParticleSet &set; ///< in m
  ModelBox box;           ///< of the start
  std::string particles;  ///< what LAMMPS, LIGGGHTS (a data file) and YADE (`x y z r` a line) read
  std::string name;       ///< files that the model writes begin with it
  Space space = Space::box;
  std::optional<DensityTarget> target = {};
  /// \pre the space is a periodic cell or six walls, and the target a pressure
  std::optional<TriaxialShear> shear = {};
  std::optional<std::uint64_t> steps = {}; ///< while settling at most, instead of those of Settling
  std::optional<Rational> young = {};      ///< instead of that of Settling
  Rational poisson = ratio(1, 4);
  double friction = 0.5;
  std::optional<double> friction_while_filling = {}; ///< and while compacting; open: friction
  double rolling_friction = 0;                       ///< always
  /// Of grains, by the engine's law: a surface energy in J/m^2 (LAMMPS), or an energy density in J/m^3
  /// (LIGGGHTS).
  double cohesion = 0;
  /// Of the classes of the set, one each; empty: all are of one material.
  std::vector<GrainMaterial> materials = {};
  /// Each class has a type of its own, 1 for the smallest, and walls the next; else all are of type 1.
  /// \pre true where there are six walls
  bool types_of_classes = false;
  bool unjammed = false; ///< what is not at rest or not jammed is a result, too
  /// The options with which `mdm verify` takes the gradation as it was asked for, for example ` --law
  /// power:2`; nothing: there is none, but a band.
  std::optional<std::string> verify_options = "";
  /// An answer's question in words, which `verify_options` may lack.
  std::string question = {};

  /// True if there are gravity, a floor and a lid.
  bool has_lid() const { return space != Space::periodic_cell && !has_six_walls(); }
  bool has_six_walls() const { return space == Space::six_walls; }
  bool has_discs() const { return space == Space::plane; }
  /// Of the space: 2 or 3.
  int dimension() const { return has_discs() ? 2 : 3; }
  /// True if some grains, or the walls, have rolling friction.
  bool resists_rolling() const;
  /// That of the class with the least Young's modulus, where classes have materials.
  Elasticity softest(const Elasticity &without_materials) const;
};

/// The material, the time and the scales of a model, in SI units.
struct Settling {
  static constexpr double restitution = 0.5, gravity = 9.81;
  /// The time step is this part of the Rayleigh time.
  static constexpr double part_of_rayleigh = 0.2;
  /// LAMMPS and LIGGGHTS refuse longer runs.
  static constexpr std::uint32_t most_steps = 2147483647;

  /// Young's modulus is softer than that of rock to save steps, and stiff enough for overlaps of some percent
  /// of a size: 10^4 rho g height, 2000 times the pressure that is asked for, and 5 MPa at least.
  Elasticity elasticity;
  double rayleigh = 0; ///< of the set, s
  double step = 0;     ///< s
  /// While settling at most: five times as many as for a fall from the top of the box.
  std::uint64_t steps = 0;
  std::uint64_t look = 0;        ///< steps between two looks: a fall by a tenth of the smallest size
  double solids = 0;             ///< volume of the grains, m^3
  double floor_moment = 0;       ///< weight by the smallest radius, J
  double least_pressure = 0;     ///< of jammed grains in a cell, Pa
  double most_pressure = 0;      ///< while compacting, Pa: overlaps of a percent
  double rate = 0;               ///< of compaction at most, 1/s: compaction_inertia() at that pressure
  std::uint64_t compacting = 0;  ///< steps of compaction that are expected
  std::uint64_t most_compacting; ///< and at most
};

/// Steps between two looks while compacting: some contact times.
inline constexpr std::uint64_t compaction_look = 200;

/// The inertial number of compaction at most, at the pressure that is asked for. Discs weigh less than
/// spheres of their sizes and are as stiff: at a rate as high a look's strain is too much for the pressure to
/// settle.
double compaction_inertia(const SettleModel &model);

/// The material and the time of the model. \throws InputError if it has more steps than most_steps
Settling settling(const SettleModel &model);

/// Of two of the smallest grains, if they are of the softest material.
/// \param elasticity  that of settling()
CohesiveContact smallest_contact(const SettleModel &model, const Elasticity &elasticity,
                                 const CohesionLaw &law);

/// Length of the discs of a set, in m: two thirds of the smallest diameter. The smallest has then the mass of
/// a sphere of its diameter, and larger ones less: the Rayleigh time of spheres serves the discs.
double disc_length(const ParticleSet &set);

/// Height of the specimen at a void ratio, in m. \pre it has a lid
double specimen_height(const SettleModel &model, double void_ratio);

/// Percentage points by which no share can be off the gradation's in a sample with these sizes, rounded up.
std::string share_tolerance(const ParticleSet &set);
/// What to give to `mdm verify`: the same, and within a tolerance also what passes, and all classes together.
std::string tolerance_options(const ParticleSet &set);

/// Each is an input script that is run in its folder; it stops with a message where a count is wrong, the
/// density that is asked for cannot be reached, or the grains are not at rest or not jammed at the end.
/// \throws InputError if the set is not in m, a file's name has characters that scripts could take for their
/// own, the engine has no such space, or there are more steps than most_steps
std::string liggghts_model(const SettleModel &model);
/// The same for LAMMPS.
std::string lammps_model(const SettleModel &model);
/// The same for YADE.
std::string yade_model(const SettleModel &model);

/// The lid of LIGGGHTS' models, which they read from the file `NAME-lid.stl`: a square at height 0.
std::string lid_stl(const ModelBox &box);
/// Each of their six walls, which they turn and move into its place, from `NAME-wall.stl`: a square around
/// the origin, wider than the box, so that walls may come apart.
std::string wall_stl(const ModelBox &box);
/// The side of that square, in longest sides of the box.
inline constexpr double wall_by_box = 1.6;

} // namespace mdm

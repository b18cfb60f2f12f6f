#pragma once
// A drained triaxial test in a periodic cell or between six walls, as part of a settle model: after the
// isotropic compression each face is brought to the pressure by itself; then the height shrinks at a constant
// rate, while a servo moves the sides so that sigma_3 is constant, or p: then the sides are to have (3 p -
// sigma_1) / 2.

#include "particles/settle_script.hpp"

namespace mdm {

struct TriaxialLimits {
  /// Of the shear at the pressure, with d50; as p grows it falls. Above the most there is flow, and no
  /// result.
  static constexpr double inertial_number = 8e-4, most_inertial_number = 1e-3;
  static constexpr double held_within = 0.02; ///< what is constant in a row of the log, a part of it
  /// Part of the rows in which it may be off by more, or grains not jammed: few grains slip now and then.
  static constexpr double rows_off = 0.05;
  static constexpr int rows = 200; ///< of the log, and one more
  static constexpr int look = 50;  ///< steps between two moves of the servo
};

/// The shear in SI units.
struct ShearCourse {
  explicit ShearCourse(const SettleModel &model);

  double median = 0;       ///< d50, by mass
  double density = 0;      ///< of the grains, on average
  double axial_rate = 0;   ///< 1/s, of the height that there is
  std::uint64_t steps = 0; ///< of time
};

/// What is constant, `sigma_3` or `p`.
std::string constant_stress(const SettleScript &s);
bool is_p_constant(const SettleScript &s);

/// What is said of it in the model's first lines, and at the end of its purpose.
std::string triaxial_lines(const SettleScript &s);
std::string triaxial_purpose(const SettleScript &s);

/// \throws InputError if the largest grain does not fit twice into the height at the end
void check_triaxial(const SettleScript &s);

/// The parts in the language that LIGGGHTS and LAMMPS share. The course comes to `judge` once each face has
/// its pressure, and to `shearing` behind it. The engine adds `sigma_x`, `sigma_y`, `sigma_z` and `length_z`,
/// and moves each pair of faces at its own rate, `rate` and `rate_x`, `rate_y` or `rate_z`.
std::string triaxial_phases_settings(const SettleScript &s);
std::string triaxial_phases_variables(const SettleScript &s);
/// Writes the restart, and what is kept of the course beside it, with the log as it is then.
std::string triaxial_phases_save(const SettleScript &s);
/// Going on from there, the log is that one again.
extern const char *const triaxial_phases_log_again;
/// Going on, rows are judged as those before.
extern const char *const triaxial_phases_same_limits;
std::string triaxial_phases_faces(const SettleScript &s);
std::string triaxial_phases_shear(const SettleScript &s);
/// Instead of the compaction to a pressure alone, before the friction is lowered: until the void ratio is
/// there, too.
extern const char *const triaxial_phases_compaction;
/// Added to the result.
extern const char *const triaxial_phases_words;

/// The parts of YADE's model.
std::string triaxial_yade_settings(const SettleScript &s);
std::string triaxial_yade_shear(const SettleScript &s);
/// Behind each look of the compaction, where a void ratio is asked for, too.
extern const char *const triaxial_yade_friction;
/// Behind each phase of it.
extern const char *const triaxial_yade_still_loose;
extern const char *const triaxial_yade_phases;
/// Added to the result: words, and their values.
extern const char *const triaxial_yade_words, *const triaxial_yade_values;

} // namespace mdm

#include "particles/contact_table.hpp"
#include "particles/settle_phases.hpp"
#include "particles/settle_state.hpp"
#include "particles/six_walls.hpp"
#include "particles/triaxial_shear.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

const char *const liggghts_setting = R"(
atom_style granular
atom_modify map array
boundary @boundary@
newton off
communicate single vel yes
units si
# Any stiffness is wanted.
soft_particles yes
hard_particles yes
if "${go_on} == 0" then "read_data @particles@" else "read_restart @base@.restart"
@room@neighbor @skin@ bin
neigh_modify delay 0

@properties@pair_style gran @contact@
pair_coeff * *
timestep @dt@
compute d all property/atom diameter

@walls@fix motion all nve/sphere

@state@@columns@thermo 0
thermo_modify lost error norm no
)";

const char *const room_for_lid = R"(# The lid is on top of the start at first. There is room above it.
variable top_of_start equal zhi
variable top_of_start equal ${top_of_start}
if "${go_on} == 0" then "variable lid_now equal ${top_of_start}" "variable ceiling equal 1.01*${top_of_start}" "change_box all z final 0 ${ceiling} units box"
)";

const char *const floor_and_lid = R"(@side@fix floor @wall@ primitive type @wall_type@ zplane 0
# The lid: a mesh that sinks from where it is.
fix lid all mesh/surface/stress file @base@-lid.stl type @wall_type@ move 0 0 ${lid_now}
fix lids @wall@ mesh n_meshes 1 meshes lid
variable lid_start equal ${lid_now}
# Its way since then: a restart has the way that it had before.
variable lid_moved equal f_lid[9]
variable lid equal v_lid_start+f_lid[9]-v_lid_offset
variable area equal @area@
variable volume equal v_area*v_lid
variable pressure equal abs(f_lid[3])/v_area
fix gravity all gravity @gravity@ vector 0 0 -1
variable up atom z+c_d/2
compute top all reduce max v_up
variable top equal c_top
)";

const char *const hertz = "model hertz tangential history";

std::string rolling_model(const SettleScript &s) {
  return s.model.resists_rolling() ? " rolling_friction epsd2" : "";
}

/// The contact of grains.
std::string liggghts_contact(const SettleScript &s) {
  return hertz + std::string(s.model.cohesion > 0 ? " cohesion sjkr" : "") + rolling_model(s);
}

std::string liggghts_wall(const SettleScript &s) {
  return std::string("all wall/gran ") + hertz + rolling_model(s);
}

/// The walls at the sides.
std::string liggghts_sides(const SettleScript &s) {
  if (s.model.space == Space::pillar)
    return "";
  if (s.model.space == Space::cylinder)
    return filled("variable half equal xhi/2\n"
                  "fix side @wall@ primitive type @type@ zcylinder ${half} ${half} ${half}\n",
                  {{"wall", liggghts_wall(s)}, {"type", std::to_string(s.types())}});
  return filled("variable x equal xhi\nvariable y equal yhi\n"
                "fix west @wall@ primitive type @type@ xplane 0\n"
                "fix east @wall@ primitive type @type@ xplane ${x}\n"
                "fix south @wall@ primitive type @type@ yplane 0\n"
                "fix north @wall@ primitive type @type@ yplane ${y}\n",
                {{"wall", liggghts_wall(s)}, {"type", std::to_string(s.types())}});
}

/// A value for each pair of types, line after line of their table.
template <class Value>
std::string pairs(const SettleScript &s, Value value) {
  std::string text;
  for (std::size_t i = 1; i <= s.types(); ++i)
    for (std::size_t j = 1; j <= s.types(); ++j)
      text += " " + value(i, j);
  return text;
}

/// True if grains of a type touch one of six walls, which have a friction of their own.
bool is_at_free_wall(const SettleScript &s, std::size_t i, std::size_t j) {
  return s.has_six_walls() && std::max(i, j) == s.types();
}

/// Grains of one material have that of the variable; else those of the classes, the lesser of both.
std::string friction_of_types(const SettleScript &s, std::size_t i, std::size_t j) {
  if (is_at_free_wall(s, i, j))
    return "${wall_friction}";
  return s.model.materials.empty() ? "${grip}" : friction_of_pair(s, s.material(i), s.material(j));
}

std::string friction_of_pairs(const SettleScript &s) {
  const std::string fix =
      fmt::format("fix friction all property/global coefficientFriction peratomtypepair {}", s.types());
  if (s.model.materials.empty())
    return fix + pairs(s, [&s](std::size_t i, std::size_t j) { return friction_of_types(s, i, j); }) + "\n";
  std::string text, all;
  std::size_t n = 0;
  for (std::size_t i = 1; i <= s.types(); ++i)
    for (std::size_t j = 1; j <= s.types(); ++j) {
      text += fmt::format("variable grip{} equal {}\n", ++n, friction_of_types(s, i, j));
      all += fmt::format(" ${{grip{}}}", n);
    }
  return text + fix + all + "\n";
}

/// Of a pair the lesser of both.
std::string rolling_friction(const SettleScript &s) {
  if (!s.model.resists_rolling())
    return "";
  const auto of_types = [&s](std::size_t i, std::size_t j) {
    const double least = std::min(s.material(i).rolling_friction, s.material(j).rolling_friction);
    return digits6(is_at_free_wall(s, i, j) ? 0 : least);
  };
  return fmt::format("fix rolling all property/global coefficientRollingFriction peratomtypepair {}{}\n",
                     s.types(), pairs(s, of_types));
}

std::string cohesion_of_pairs(const SettleScript &s) {
  if (s.model.cohesion == 0)
    return "";
  return fmt::format("fix cohesion all property/global cohesionEnergyDensity peratomtypepair {}{}\n",
                     s.types(),
                     pairs(s, [&s](std::size_t, std::size_t) { return digits6(s.model.cohesion); }));
}

/// Constants of the types and of their pairs.
std::string properties(const SettleScript &s) {
  std::string young, poisson;
  for (std::size_t type = 1; type <= s.types(); ++type) {
    const Elasticity &e = s.material(type).elasticity;
    young += " " + digits6(e.young.convert_to<double>());
    poisson += " " + digits6(e.poisson.convert_to<double>());
  }
  return fmt::format("fix young all property/global youngsModulus peratomtype{}\n"
                     "fix poisson all property/global poissonsRatio peratomtype{}\n"
                     "fix restitution all property/global coefficientRestitution peratomtypepair {}{}\n"
                     "variable grip equal ${{mu}}\n",
                     young, poisson, s.types(),
                     pairs(s,
                           [&s](std::size_t i, std::size_t j) {
                             return digits6((s.material(i).restitution + s.material(j).restitution) / 2);
                           })) +
         friction_of_pairs(s) + rolling_friction(s) + cohesion_of_pairs(s);
}

/// The floor, the lid and the sides, or six walls.
std::string liggghts_walls(const SettleScript &s) {
  if (s.has_six_walls())
    return six_walls_setting(s, liggghts_wall(s));
  return filled(floor_and_lid, {{"side", liggghts_sides(s)},
                                {"wall", liggghts_wall(s)},
                                {"wall_type", std::to_string(s.types())},
                                {"base", s.name},
                                {"area", s.model.space == Space::cylinder ? "PI*xhi^2/4" : "xhi*yhi"},
                                {"gravity", fmt::format("{}", Settling::gravity)}});
}

/// The line that keeps what is computed current.
std::string liggghts_columns(const SettleScript &s) {
  return "thermo_style custom step atoms ke" +
         (s.has_six_walls() ? six_walls_columns() : " c_top f_lid[3] f_lid[9]") + state_columns() + "\n";
}

/// The count of each class among the grains that were read.
std::string liggghts_counts(const SettleScript &s) {
  std::string text = R"(
# Each class, largest first: its sizes, as they are in the data file, and its count.
)";
  for (auto c = s.set.classes.rbegin(); c != s.set.classes.rend(); ++c)
    text += fmt::format(R"(
variable inside{number} atom "c_d >= {least} && c_d <= {most}"
compute inside{number} all reduce sum v_inside{number}
thermo_style custom step atoms ke c_inside{number}
run 0
variable n equal c_inside{number}
if "$n != {quantity}" then "print 'STOP: {class_}: $n grains are there, not {quantity}'" quit
variable n delete
)",
                        fmt::arg("number", c->number), fmt::arg("least", c->sizes.front().diameter.text),
                        fmt::arg("most", c->sizes.back().diameter.text),
                        fmt::arg("quantity", to_string(c->quantity())), fmt::arg("class_", c->text()));
  return text + "\n" + liggghts_columns(s) + "thermo_modify lost error norm no\nvariable n equal atoms\n";
}

const char *const liggghts_ending =
    R"(if "$n != @total@" then "print 'STOP: $n grains are there at the end, not @total@'" quit
@removal@write_dump all custom @dump@ id type x y z radius modify format "%d %d %.17g %.17g %.17g %.17g"
@restart@# For ParaView: glyphs of type sphere, scaled by radius.
write_dump all custom/vtk @result@.vtp id type radius vx vy vz
)";

/// What moves the lid, or the walls.
void set_motion(const SettleScript &s, PhaseCommands &commands) {
  if (s.has_six_walls()) {
    commands.move = six_walls_move();
    return;
  }
  commands.keeps_lid_offset = true;
  commands.move =
      "variable speed equal -${rate}*${lid}\nfix sinking all move/mesh mesh lid linear 0 0 ${speed}\n";
  commands.lower_lid = "variable down equal ${top}-${lid}\n"
                       "variable speed equal ${down}/dt\n"
                       "fix sinking all move/mesh mesh lid linear 0 0 ${speed}\nrun 1\n";
}

} // namespace

std::string liggghts_model(const SettleModel &model) {
  if (model.space == Space::periodic_cell)
    throw InputError("LIGGGHTS has no model of a box that is repeated on all sides: take lammps or yade");
  check_simulated(model.set);
  const SettleScript s(model, ".dump");
  if (s.is_sheared())
    check_triaxial(s);
  PhaseCommands commands;
  set_motion(s, commands);
  commands.contact = "unfix friction\n" + friction_of_pairs(s);
  commands.quit = "quit";
  return s.head({"LIGGGHTS", "liggghts -in THIS_FILE", "-var steps 1000",
                 "liggghts -in THIS_FILE -var go_on 1",
                 "With P processes: mpirun -np P liggghts -in THIS_FILE", ""},
                contact_table(s, {"of Hertz and Mindlin: " + liggghts_contact(s), restitution_of(s), "epsd2",
                                  &sjkr_law})) +
         phase_variables(s) +
         filled(liggghts_setting, {{"boundary", model.space == Space::pillar ? "p p f" : "f f f"},
                                   {"particles", file_word(model.particles)},
                                   {"room", s.has_six_walls() ? six_walls_room(s) : room_for_lid},
                                   {"skin", digits6(s.set.smallest().radius.value)},
                                   {"properties", properties(s)},
                                   {"contact", liggghts_contact(s)},
                                   {"dt", digits6(s.physics.step)},
                                   {"walls", liggghts_walls(s)},
                                   {"base", s.name},
                                   {"state", state_measures(s, "all stress/atom pair")},
                                   {"columns", liggghts_columns(s)}}) +
         liggghts_counts(s) + phase_loops(s, commands) +
         // Between six walls the restart of the last row goes with its state.
         filled(liggghts_ending, {{"total", to_string(s.particles)},
                                  {"removal", s.has_six_walls() ? six_walls_removal() : ""},
                                  {"restart", s.has_six_walls() ? "" : "write_restart @base@.restart\n"},
                                  {"dump", s.dump},
                                  {"result", s.result},
                                  {"base", s.name}});
}

} // namespace mdm

#include "particles/contact_table.hpp"
#include "particles/settle_phases.hpp"
#include "particles/settle_state.hpp"
#include "particles/triaxial_shear.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mdm {
namespace {

const char *const lammps_setting = R"(
units si
@dimension@atom_style sphere
boundary @boundary@
newton off
comm_modify vel yes
if "${go_on} == 0" then "read_data @particles@" else "read_restart @base@.restart"
@volume@
pair_style granular
neighbor @skin@ bin
neigh_modify delay 0 every 1 check yes
timestep @dt@
fix motion all nve/sphere@motion@
@gravity@
compute d all property/atom diameter
compute least all reduce min c_d
thermo 0
)";

/// What is computed of a lid, which presses on the grains.
const char *const lammps_lid = R"(
# The lid: a plane that sinks from where it is.
variable since equal ${now}
variable speed equal 0
variable lid_start equal ${lid_now}
variable lid equal v_lid_now-v_speed*(step-v_since)*dt
variable sunk equal v_lid-v_lid_start
region lid plane @lid@ units box
@round@variable up atom @up@+c_d/2
compute top all reduce max v_up
variable top equal c_top
)";

const char *const volume_below_lid = R"(# The lid is on top of the start at first. There is room above it.
variable top_of_start equal @up@hi
variable top_of_start equal ${top_of_start}
if "${go_on} == 0" then "variable lid_now equal ${top_of_start}" "variable ceiling equal 1.01*${top_of_start}" "change_box all @up@ final 0 ${ceiling} units box"
variable area equal @area@
variable volume equal v_area*v_lid)";

const char *const begin_lid =
    R"(if "${begun} == 0" then "compute push all reduce sum f_lid[@push@]" "variable pressure equal (0-c_push)/v_area" "thermo_style custom step atoms ke c_least c_top c_push v_void_ratio v_pressure v_mu@columns@" "thermo_modify lost error norm no" "variable begun equal 1"
)";

const char *const move_faces =
    "variable strain equal -${rate}\n"
    "fix faces all deform 1 x trate ${strain} y trate ${strain} z trate ${strain} remap x\n";

const char *const move_each_face =
    "variable strain_x equal -(v_rate+v_rate_x)\n"
    "variable strain_y equal -(v_rate+v_rate_y)\n"
    "variable strain_z equal -(v_rate+v_rate_z)\n"
    "fix faces all deform 1 x trate ${strain_x} y trate ${strain_y} z trate ${strain_z} remap x\n";

const char *const stress_on_faces = R"(variable sigma_x equal c_stress[1]
variable sigma_y equal c_stress[2]
variable sigma_z equal c_stress[3]
variable length_z equal lz
)";

const char *const begin_cell = R"(
compute stress all pressure NULL virial
variable pressure equal c_stress
@stresses@thermo_style custom step atoms ke c_least c_stress@faces@ v_void_ratio v_mu@columns@
thermo_modify lost error norm no
)";

/// The axis upwards: the engine's plane is x y.
const char *up(const SettleScript &s) {
  return s.model.has_discs() ? "y" : "z";
}

/// The walls' contact is that of the type which stands for walls.
std::string lammps_walls(const SettleScript &s) {
  std::string text = fmt::format("fix floor all wall/gran granular ${{wall}} {}plane 0 NULL\n"
                                 "fix lid all wall/gran/region granular ${{wall}} region lid contacts\n",
                                 up(s));
  if (s.model.space == Space::box || s.model.has_discs())
    text += "fix x all wall/gran granular ${wall} xplane 0 $(xhi:%.17g)\n";
  if (s.model.space == Space::box)
    text += "fix y all wall/gran granular ${wall} yplane 0 $(yhi:%.17g)\n";
  if (s.model.space == Space::cylinder)
    text += "fix side all wall/gran/region granular ${wall} region inside\n";
  return text + filled(begin_lid, {{"columns", state_columns()}, {"push", s.model.has_discs() ? "3" : "4"}});
}

/// A spring as stiff as the tangential one of two smallest grains that overlap by some percent, so that the
/// time step serves it, and a damper of half the critical damping of such a grain.
std::string rolling_of(const SettleScript &s, const GrainMaterial &m) {
  if (!s.model.resists_rolling())
    return "";
  const double size = s.set.smallest().diameter.value;
  const double mass =
      std::numbers::pi / 6 * s.set.classes.front().density.convert_to<double>() * std::pow(size, 3);
  constexpr double part_of_young = 0.05;
  const double stiffness = part_of_young * m.elasticity.young.convert_to<double>() * size;
  return fmt::format(" rolling sds {} {} {}", digits6(stiffness), digits6(std::sqrt(stiffness * mass)),
                     digits6(m.rolling_friction));
}

/// \param surface_energy  0: none
std::string contact_of(const SettleScript &s, const GrainMaterial &m, const std::string &friction,
                       double surface_energy) {
  return fmt::format("\"{} {} {} {}{} tangential mindlin NULL 1.0 {}{} damping tsuji\"",
                     surface_energy > 0 ? "jkr" : "hertz/material",
                     digits6(m.elasticity.young.convert_to<double>()), digits6(m.restitution),
                     digits6(m.elasticity.poisson.convert_to<double>()),
                     surface_energy > 0 ? " " + digits6(surface_energy) : "", friction, rolling_of(s, m));
}

/// Of grains.
std::string contact_of_grains(const SettleScript &s, const GrainMaterial &m) {
  return contact_of(s, m, "${grip}", s.model.cohesion);
}

/// The contact of grains of two classes, when they have their own friction: the lesser of both; stiffness and
/// restitution are in between.
std::string contacts_of_classes(const SettleScript &s) {
  std::string text;
  for (std::size_t i = 1; i <= s.types(); ++i)
    for (std::size_t j = i; j <= s.types(); ++j) {
      const GrainMaterial a = s.material(i), b = s.material(j);
      const auto mean = [](const Rational &x, const Rational &y) { return Rational((x + y) / 2); };
      const double young_a = a.elasticity.young.convert_to<double>(),
                   young_b = b.elasticity.young.convert_to<double>();
      GrainMaterial both;
      both.elasticity = {Rational(2 * young_a * young_b / (young_a + young_b)),
                         mean(a.elasticity.poisson, b.elasticity.poisson)};
      both.restitution = (a.restitution + b.restitution) / 2;
      both.rolling_friction = std::min(a.rolling_friction, b.rolling_friction);
      text +=
          fmt::format("variable grip equal {}\nvariable contact string {}\npair_coeff {} {} ${{contact}}\n",
                      friction_of_pair(s, a, b), contact_of_grains(s, both), i, j);
    }
  return text;
}

std::string lammps_contact(const SettleScript &s) {
  const GrainMaterial wall = s.material(s.types());
  std::string text;
  if (s.model.materials.empty())
    text = "variable contact string " + contact_of_grains(s, s.material(1)) + "\npair_coeff * * ${contact}\n";
  else
    text = contacts_of_classes(s);
  if (s.has_lid())
    text += "variable wall string " + contact_of(s, wall, "${mu}", 0) + "\n" + lammps_walls(s);
  return text;
}

/// Cylinders stand in the box and touch its sides.
std::string round_wall(const SettleScript &s) {
  if (s.model.space != Space::cylinder)
    return "";
  return "variable half equal xhi/2\nvariable half equal ${half}\n"
         "region inside cylinder z ${half} ${half} ${half} INF INF side in units box\n";
}

/// The count of each class.
std::string lammps_counts(const SettleScript &s) {
  std::string text =
      "\n# Each class, largest first: its sizes, as they are in the data file, and its count.\n"
      "run 0\n";
  for (auto c = s.set.classes.rbegin(); c != s.set.classes.rend(); ++c)
    text += fmt::format(R"(
variable inside atom "c_d >= {least} && c_d <= {most}"
group class variable inside
variable n equal count(class)
if "$n != {quantity}" then "print 'STOP: {class_}: $n grains are there, not {quantity}'" "quit 1"
group class delete
)",
                        fmt::arg("least", c->sizes.front().diameter.text),
                        fmt::arg("most", c->sizes.back().diameter.text),
                        fmt::arg("quantity", to_string(c->quantity())), fmt::arg("class_", c->text()));
  return text + fmt::format(R"(
variable n equal atoms
if "$n != {total}" then "print 'STOP: $n grains are there, not {total}'" "quit 1"
)",
                            fmt::arg("total", to_string(s.particles)));
}

const char *const lammps_ending =
    R"(if "$n != @total@" then "print 'STOP: $n grains are there at the end, not @total@'" "quit 1"
write_dump all custom @dump@ id type x y z radius modify format float %.17g
write_restart @base@.restart
# OVITO reads the dump. For ParaView, where LAMMPS has the package VTK: glyphs of type sphere, scaled by radius.
variable vtk index 0   # or -var vtk 1
if "${vtk} > 0" then "write_dump all vtk @result@.vtp id type radius vx vy vz"
)";

std::string volume(const SettleScript &s) {
  if (!s.has_lid())
    return "variable volume equal vol\nvariable lid equal 0";
  return filled(volume_below_lid, {{"area", s.model.space == Space::cylinder ? "PI*xhi^2/4"
                                            : s.model.has_discs()            ? "xhi*" + digits17(s.box.y)
                                                                             : "xhi*yhi"},
                                   {"up", up(s)}});
}

} // namespace

std::string lammps_model(const SettleModel &model) {
  if (model.has_six_walls())
    throw InputError("LAMMPS has no model with six walls that move: take liggghts");
  const SettleScript s(model, ".dump");
  if (s.is_sheared())
    check_triaxial(s);
  const bool has_lid = s.has_lid();
  std::string text =
      s.head({"LAMMPS", "lmp -in THIS_FILE", "-var steps 1000", "lmp -in THIS_FILE -var go_on 1",
              "With P processes: mpirun -np P lmp -in THIS_FILE", ""},
             contact_table(s, {fmt::format("of Hertz and Mindlin: {} tangential mindlin",
                                           model.cohesion > 0 ? "jkr" : "hertz/material"),
                               restitution_of(s) + ": damping tsuji", "sds", &jkr_law}));
  text += phase_variables(s);
  text += filled(lammps_setting,
                 {{"dimension", model.has_discs() ? "dimension 2\n" : ""},
                  {"motion", model.has_discs() ? " disc\nfix plane all enforce2d" : ""},
                  {"boundary", !has_lid                       ? "p p p"
                               : model.space == Space::pillar ? "p p f"
                               : model.has_discs()            ? "f f p"
                                                              : "f f f"},
                  {"particles", file_word(model.particles)},
                  {"base", s.name},
                  {"volume", volume(s)},
                  {"skin", digits6(s.set.smallest().radius.value)},
                  {"dt", digits6(s.physics.step)},
                  {"gravity", has_lid ? fmt::format("fix gravity all gravity {} vector {}", Settling::gravity,
                                                    model.has_discs() ? "0 -1 0" : "0 0 -1")
                                      : ""}});
  if (has_lid)
    text += filled(lammps_lid, {{"round", round_wall(s)},
                                {"lid", model.has_discs() ? "0 ${lid_start} 0 0 -1 0 move NULL v_sunk NULL"
                                                          : "0 0 ${lid_start} 0 0 -1 move NULL NULL v_sunk"},
                                {"up", up(s)}}) +
            "variable begun equal 0\n";
  text += state_measures(s, "all stress/atom NULL pair");
  PhaseCommands commands;
  commands.contact = lammps_contact(s);
  commands.quit = "\"quit 1\"";
  if (has_lid) {
    commands.move = "variable lid_is equal ${lid}\nvariable lid_now equal ${lid_is}\n"
                    "variable since equal ${now}\nvariable speed equal ${rate}*${lid_now}\n";
    commands.lower_lid = "variable lid_is equal ${top}\nvariable lid_now equal ${lid_is}\n"
                         "variable since equal ${now}\n";
  } else {
    commands.move = "# Contacts across the faces push the whole a little: it would run away.\n"
                    "velocity all zero linear\n";
    commands.move += s.is_sheared() ? move_each_face : move_faces;
    text += filled(begin_cell, {{"stresses", s.is_sheared() ? stress_on_faces : ""},
                                {"faces", s.is_sheared() ? " c_stress[1] c_stress[2] c_stress[3]" : ""},
                                {"columns", state_columns()}});
  }
  // The first contact, for the lammps_counts; the loop repeats it.
  text += "\nvariable grip equal ${mu}\n" + commands.contact;
  text += lammps_counts(s) + phase_loops(s, commands);
  return text +
         filled(
             lammps_ending,
             {{"total", to_string(s.particles)}, {"dump", s.dump}, {"result", s.result}, {"base", s.name}});
}

} // namespace mdm

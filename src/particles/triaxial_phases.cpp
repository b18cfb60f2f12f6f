#include "particles/six_walls.hpp"
#include "particles/triaxial_columns.hpp"
#include "particles/triaxial_shear.hpp"

namespace mdm {
namespace {

/// The servo is fast where a look's strain makes up for what is off: the stiffness of grains under a pressure
/// p is some E^(2/3) p^(1/3).
const char *const shear_variables = R"script(
# Shear. Faces x and y are the sides, z is the height; sigma, rate and hold of each, the part of the rate that is kept.
variable height equal 1         # before the shear, m
variable volume_before equal 1  # m^3
variable row equal 0            # of the log, the next one
variable lines equal 0          # of the log so far
variable off equal 0            # @constant@ in them, at most
variable off_rows equal 0       # of them, those that are off by more than they may
variable inertia equal 0        # the inertial number, at most
variable loose_rows equal 0     # those that are not jammed
variable judged_within equal 0  # held_within and target, by which they were judged
variable judged_target equal 0
variable rate_x equal 0
variable rate_y equal 0
variable rate_z equal 0
variable hold_x equal 0
variable hold_y equal 0
variable hold_z equal 0
variable sigma_3 equal (v_sigma_x+v_sigma_y)/2
variable q equal v_sigma_z-v_sigma_3
variable constant equal @constant_now@
variable axial equal floor(1e12*(1-v_length_z/v_height)+0.5)/1e12
variable volumetric equal 1-v_volume/v_volume_before
variable axial_rate equal v_inertial_number/(@d50@*sqrt(@density@/v_target))
variable off_now equal abs(v_constant/v_target-1)
variable inertia_now equal v_axial_rate*@d50@*sqrt(@density@/(abs(v_pressure)+1e-200))
@travel@variable gain equal (v_target/@young@)^(2/3)/(@look@*dt@delay@)
variable is_held equal "(v_off_rows <= v_most_rows_off*v_lines)*(v_off_now <= v_held_within)"
variable is_carried equal "(v_loose_rows <= v_most_rows_off*v_lines)*v_jammed"
variable row_due equal "v_axial+1e-9 >= v_row*v_axial_strain/@rows@"
variable is_sheared equal "v_axial+1e-9 >= v_axial_strain"
variable next_row equal floor(v_axial/v_axial_strain*@rows@+1e-9)+1
variable is_even_x equal "abs(v_sigma_x/v_target-1) < v_tolerance"
variable is_even_y equal "abs(v_sigma_y/v_target-1) < v_tolerance"
variable is_even_z equal "abs(v_sigma_z/v_target-1) < v_tolerance"
variable is_even equal "v_is_even_x*v_is_even_y*v_is_even_z*(v_restless < 1)"
)script";

const char *const shear_by_void_ratio =
    R"script(variable is_pressed equal "(v_missing < v_tolerance)*(v_missing > -v_tolerance)*(v_restless < 10)"
variable beyond equal (v_void_ratio-v_asked_void_ratio)/v_tolerance
variable is_dense equal "(v_beyond <= 0.4) || (v_beyond <= 2 && v_pressure < 0.9*v_target)"
variable is_loose equal "v_beyond > 1"
variable is_other equal "abs(v_beyond) > 1"
variable less equal "0.99-0.04*(v_beyond > 4)"
)script";

/// What a wall does reaches the middle after a time only: a servo that is faster swings.
const char *const shear_travel = R"script(# s of a wave from a wall to the middle
variable travel equal v_length_z/2/sqrt(@young@^(2/3)*v_target^(1/3)/@density@)
)script";

/// Proportional and integral; no face is faster than while compacting.
const char *const shear_servo = R"script(variable off_face equal (v_sigma_@a@-@goal@)/v_target
variable hold_@a@ equal ${hold_@a@}-0.1*${gain}*${off_face}
variable wish equal ${hold_@a@}-${gain}*${off_face}
variable rate_@a@ equal "(abs(v_wish) <= v_most_rate)*v_wish+(v_wish > v_most_rate)*v_most_rate-(v_wish < -v_most_rate)*v_most_rate"
variable rate_@a@ equal ${rate_@a@}
)script";

const char *const shear_faces = R"script(
# Each face is brought to the target by itself.
variable rate equal 0
variable look equal @look@
variable last equal ${now}+${most_compacting}
variable phase delete
variable phase string even
label even
if "${is_even} > 0" then "jump SELF is_even"
if "${now} >= ${last}" then "print 'STOP: the faces do not have ${target} Pa each after ${now} steps: ${sigma_x}, ${sigma_y} and ${sigma_z} Pa; @state@'" @quit@
@servos@jump SELF look
label is_even
)script";

const char *const shear_still_loose = R"script(
# With their own friction they may be too loose: they slide on.
if "${is_loose} < 1" then "jump SELF dense"
variable own equal 0
variable last equal ${now}+${most_compacting}
variable phase delete
variable phase string compact
jump SELF slide
label dense
)script";

const char *const shear_other_void_ratio =
    R"script(if "${is_other} > 0" then "print 'STOP: void ratio ${void_ratio} at ${target} Pa is not within ${tolerance} of ${asked_void_ratio}; the friction while compacted was ${mu} at last: a higher friction_while_filling is looser, and more grains come nearer'" @quit@
)script";

const char *const shear_rows = R"script(
# ---- The shear --------------------------------------------------------------------------------------------
label shearing
variable height equal ${length_z}
variable volume_before equal ${volume}
variable rate_z equal ${axial_rate}
variable judged_within equal ${held_within}
variable judged_target equal ${target}
variable phase delete
variable phase string shear
print "@columns@" file @log@ screen no
label shear
variable looks equal 0
if "${row_due} < 1" then "jump SELF steer"
# A row, and with the next look the restart.
variable looks equal 19
print "${axial},${volumetric},${pressure},${q},${void_ratio},${z},${unbalanced},@constant@" append @log@ screen no
variable off equal (${off}>=${off_now})*${off}+(${off}<${off_now})*${off_now}
variable inertia equal (${inertia}>=${inertia_now})*${inertia}+(${inertia}<${inertia_now})*${inertia_now}
variable loose_rows equal ${loose_rows}+(1-${jammed})
variable off_rows equal ${off_rows}+(${off_now}>${held_within})
variable lines equal ${lines}+1
variable row equal ${next_row}
if "${is_sheared} > 0" then "jump SELF sheared"
label steer
@servos@jump SELF look

label sheared
if "${is_held} < 1" then "print 'STOP: @constant@ was not constant: in ${off_rows} of ${lines} rows of @log@ it is off by more than ${held_within} of ${target} Pa, by ${off} at most, and by ${off_now} at the end: more grains or a lower inertial_number make it steadier'" @quit@
if "${inertia} > @most@" then "print 'STOP: the inertial number was ${inertia}, above @most@: lower inertial_number'" @quit@
if "${is_carried} < 1 && ${unjammed} < 1" then "print 'STOP: not jammed in ${loose_rows} of ${lines} rows of @log@: a grain that is carried has fewer contacts than ${isostatic}, ${carrying} at the end; take it as it is with -var unjammed 1'" @quit@
)script";

/// \param goal  the stress that each face is to have
std::string servos(const char *axes, const char *goal) {
  std::string text;
  for (const char *axis = axes; *axis != 0; ++axis)
    text += filled(shear_servo, {{"a", std::string(1, *axis)}, {"goal", goal}});
  return text;
}

} // namespace

const char *const triaxial_phases_compaction = R"script(
# Under the pressure the friction is lowered, and the grains slide into denser places. Where they are dense enough, or nearly so
# and in a slide, they get their own at once.
label compact
if "${is_dense} > 0" then "jump SELF reached"
if "${now} >= ${last}" then "print 'STOP: void ratio ${asked_void_ratio} at ${target} Pa is not reached after ${now} steps: ${void_ratio} at ${pressure} Pa: raise most_compacting'" @quit@
if "${is_pressed} < 1" then "jump SELF servo"
label slide
if "${mu} < 0.01" then "print 'STOP: void ratio ${asked_void_ratio} is beyond the densest that this run finds at ${target} Pa, ${void_ratio} without friction: ask for less density'" @quit@
variable mu equal ${less}*${mu}
)script";

const char *const triaxial_phases_log_again =
    "if \"${lines} > 0\" then \"shell cp @base@.restart.csv @base@-triaxial.csv\"\n";

const char *const triaxial_phases_same_limits =
    R"script(if "${lines} > 0 && (${judged_within} != ${held_within} || ${judged_target} != ${target})" then "print 'STOP: the ${lines} rows of @base@-triaxial.csv were judged with held_within ${judged_within} and target ${judged_target}: go on with these, or begin anew'" @quit@
)script";

const char *const triaxial_phases_words =
    "; sheared to axial strain ${axial}, volumetric strain "
    "${volumetric}, q ${q} Pa; of ${lines} rows ${off_rows} "
    "have @constant@ more than ${held_within} off ${target} Pa, ${off} at "
    "most, and ${loose_rows} are not jammed; "
    "inertial number at most ${inertia}";

std::string triaxial_phases_settings(const SettleScript &s) {
  const TriaxialShear &asked = *s.model.shear;
  std::string text;
  if (asked.void_ratio)
    text += script_setting("asked_void_ratio", digits6(*asked.void_ratio),
                           "at that pressure, before the shear, within the tolerance");
  return text + script_setting("axial_strain", digits6(asked.axial_strain), "at the end of the shear") +
         script_setting("inertial_number", digits6(TriaxialLimits::inertial_number),
                        "of the shear where p is the target") +
         script_setting("held_within", digits6(TriaxialLimits::held_within),
                        constant_stress(s) + " in the rows of the log, a part of it") +
         script_setting("most_rows_off", digits6(TriaxialLimits::rows_off),
                        "part of the rows that may be off by more, or not jammed; the last is neither");
}

std::string triaxial_phases_variables(const SettleScript &s) {
  const ShearCourse course(s.model);
  return filled(shear_variables, {{"constant", constant_stress(s)},
                                  {"constant_now", is_p_constant(s) ? "v_pressure" : "v_sigma_3"},
                                  {"travel", s.has_six_walls() ? shear_travel : ""},
                                  {"delay", s.has_six_walls() ? "+2*v_travel" : ""},
                                  {"d50", digits17(course.median)},
                                  {"density", digits17(course.density)},
                                  {"young", digits6(s.physics.elasticity.young.convert_to<double>())},
                                  {"look", std::to_string(TriaxialLimits::look)},
                                  {"rows", std::to_string(TriaxialLimits::rows)}}) +
         (s.model.shear->void_ratio ? shear_by_void_ratio : "");
}

std::string triaxial_phases_save(const SettleScript &s) {
  // The files take their places when they are whole: a run may be stopped at any time.
  std::string text = "print \"variable phase string ${phase}\" file @base@.restart.state.next screen no\n";
  for (const char *const name : {"mu", "own", "look", "height", "volume_before", "row", "lines", "off",
                                 "off_rows", "inertia", "loose_rows", "judged_within", "judged_target",
                                 "rate_x", "rate_y", "rate_z", "hold_x", "hold_y", "hold_z"})
    text += filled("print \"variable @name@ equal ${@name@}\" append @base@.restart.state.next screen no\n",
                   {{"name", name}});
  if (s.has_six_walls())
    text += six_walls_save(s);
  // LAMMPS mixes contacts up where grains have moved since its list of neighbours was made: run 0 makes it
  // anew.
  text += "run 0\n"
          "write_restart @base@.restart.next\n"
          "if \"${lines} > 0\" then \"shell cp @base@-triaxial.csv @base@.restart.csv\"\n"
          "shell mv @base@.restart.state.next @base@.restart.state\n"
          "shell mv @base@.restart.next @base@.restart\n";
  return filled(text, {{"base", s.name}});
}

std::string triaxial_phases_faces(const SettleScript &s) {
  return (s.model.shear->void_ratio ? shear_still_loose : "") +
         filled(shear_faces,
                {{"look", std::to_string(TriaxialLimits::look)}, {"servos", servos("xyz", "v_target")}}) +
         (s.model.shear->void_ratio ? shear_other_void_ratio : "");
}

std::string triaxial_phases_shear(const SettleScript &s) {
  return filled(shear_rows,
                {{"columns", triaxial_columns},
                 {"log", s.name + "-triaxial.csv"},
                 {"constant", constant_stress(s)},
                 {"servos", servos("xy", is_p_constant(s) ? "(3*v_target-v_sigma_z)/2" : "v_target")},
                 {"most", digits6(TriaxialLimits::most_inertial_number)}});
}

} // namespace mdm

#include "particles/settle_phases.hpp"

#include "particles/settle_state.hpp"
#include "particles/triaxial_shear.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

/// What friction_while_filling is, beside the grains' own while they settle.
std::string while_filling(const SettleScript &s) {
  const std::string grains =
      s.keeps_friction() ? "and at most while they are compacted" : "and while they are compacted";
  if (!s.has_lid())
    return grains;
  return grains + (s.keeps_friction() ? "; of the walls" : "; of the walls, too");
}

std::string settings_of_all(const SettleScript &s) {
  return "\n# What may be changed, here or behind the command as -var NAME VALUE.\n" +
         script_setting("go_on", "0", "1: from " + s.name + ".restart") +
         script_setting("steps", std::to_string(s.physics.steps),
                        "while the grains settle, at most, in whole looks") +
         script_setting("friction", digits6(s.model.friction), "of the grains at the end") +
         script_setting("friction_while_filling", digits6(s.friction_while_filling()), while_filling(s)) +
         (s.has_six_walls() ? script_setting("wall_friction", "0", "of the walls, at all times") : "") +
         state_settings(s);
}

std::string settings_of_target(const SettleScript &s, const DensityTarget &target) {
  const bool to_density = target.void_ratio.has_value();
  return script_setting("target", digits6(to_density ? *target.void_ratio : target.pressure),
                        to_density ? "void ratio" : "Pa") +
         script_setting("tolerance", digits6(target.tolerance), to_density ? "of it" : "of it, a part") +
         script_setting("most_pressure", digits6(s.physics.most_pressure),
                        to_density ? "Pa: overlaps of a percent; where it comes near, the friction is lowered"
                                   : "Pa") +
         script_setting("most_rate", digits6(s.physics.rate),
                        "1/s, of the strain: inertial number " + digits6(compaction_inertia(s.model)) +
                            " at that pressure") +
         script_setting("most_compacting", std::to_string(s.physics.most_compacting), "steps");
}

const char *const looks_at = R"script(
# What is found at each look. Phases: fill, compact, hold.
variable now equal step
variable void_ratio equal v_volume/@solids@-1
variable mu equal ${friction_while_filling}
variable own equal 0   # 1: grains have their own friction
variable held equal 0  # looks since compaction has ended
variable rate equal 0  # 1/s, of compaction
variable looks equal 0
variable lid_offset equal 0
variable is_time equal "v_looks == 20*floor(v_looks/20)"
variable look equal "(v_steps < @look@)*v_steps+(v_steps >= @look@)*@look@"
variable look equal ${look}
variable last equal ${steps}
)script";

const char *const start_of_course = R"script(if "${go_on} == 0" then "jump SELF anew"
include @base@.restart.state
@go_on@jump SELF setting
label anew
@anew@label setting
)script";

const char *const anew_filling = "variable phase string fill\n";

const char *const anew_compacting = R"script(variable phase string compact
variable look equal @look@
variable last equal ${most_compacting}
)script";

/// Where the pressure is low, compaction is five times as fast; near the highest it becomes slower. At the
/// end of a look it is no denser than asked.
const char *const to_void_ratio = R"script(variable enough equal v_target+0.05*v_tolerance
variable crowded equal "v_pressure > 0.7*v_most_pressure"
variable ease equal 3*(1-v_pressure/v_most_pressure)
variable slower equal "(v_ease > 0)*((v_ease > 1)+(v_ease <= 1)*v_ease)"
variable faster equal "1+4*(v_pressure < 0.01*v_most_pressure)"
variable room equal (v_void_ratio-v_target)/(1+v_void_ratio)/(@axes@*v_look*dt)
variable wish equal v_most_rate*v_faster*v_slower
variable next_rate equal "(v_wish < v_room)*v_wish+(v_wish >= v_room)*v_room"
)script";

const char *const to_pressure = R"script(variable missing equal 1-v_pressure/v_target
variable is_there equal "(v_missing < v_tolerance)*(v_missing > -v_tolerance)*(v_restless < 1)"
variable slower equal "(v_missing > -1)*v_missing-(v_missing <= -1)"
variable faster equal "1+4*(v_pressure < 0.01*v_target)"
variable next_rate equal v_most_rate*v_faster*v_slower
)script";

const char *const begin_of_loop = R"script(
# ---- The course -------------------------------------------------------------------------------------------
if "${go_on} > 0" then "variable last equal ${now}+@more@"
label contact
variable grip equal ${own}*${friction}+(1-${own})*${mu}
@contact@
label look
variable looks equal ${looks}+1
@move@if "${is_time} < 1" then "jump SELF steps"
# The state of the course goes beside the restart.
@save@label steps
run ${look}
jump SELF ${phase}
)script";

/// Where a density is asked for, it is enough that grains are nearly at rest.
const char *const settle_nearly = R"script(
label fill
if "${restless} > 10 && ${now} < ${last}" then "jump SELF look"
if "${restless} > 10" then "print 'NOTE: not nearly at rest after ${now} steps: kinetic energy ${energy} of p V, unbalanced force ${unbalanced} of the contact force'"
print "SETTLED after ${now} steps: void ratio ${void_ratio_at_top} below the highest grain"
)script";

const char *const settle_wholly = R"script(
label fill
if "${restless} > 1 && ${now} < ${last}" then "jump SELF look"
if "${restless} > 1 && ${unjammed} < 1" then "jump SELF restless"
print "SETTLED after ${now} steps: void ratio ${void_ratio_at_top} below the highest grain"
)script";

/// Both engines write a line of a file by a fix alone, while they run.
std::string course_save(const SettleScript &s, bool keeps_lid_offset) {
  std::string text;
  std::vector<std::pair<const char *, const char *>> kept = {{"phase string", "phase"},
                                                             {"mu equal", "mu"},
                                                             {"own equal", "own"},
                                                             {"look equal", "look"},
                                                             {"lid_now equal", "lid"}};
  if (s.seeks_jamming())
    kept.insert(kept.end(), {{"loose_z equal", "loose_z"}, {"loose_pressure equal", "loose_pressure"}});
  if (keeps_lid_offset)
    kept.emplace_back("lid_offset equal", "lid_moved");
  for (const auto &[variable, value] : kept)
    text += fmt::format("fix state all print 1 \"variable {} ${{{}}}\" {} {}.restart.state screen no\n"
                        "run 1\nunfix state\n",
                        variable, value, text.empty() ? "file" : "append", s.name);
  return text + "write_restart " + s.name + ".restart\n";
}

const char *const refuse_loosest =
    R"script(if "${too_dense} > 0" then "print 'STOP: void ratio ${target} is above the loosest that this run finds, ${void_ratio_at_top}: raise friction_while_filling, or take --start mixed'" @quit@
)script";

const char *const begin_compaction = R"script(@lower@variable phase delete
variable phase string compact
variable look equal @look@
variable last equal ${now}+${most_compacting}
jump SELF look
)script";

/// The end of a compaction by friction: it has been lowered, or the servo goes on.
const char *const with_friction = R"script(variable rate equal ${next_rate}
jump SELF contact
label servo
variable rate equal ${next_rate}
jump SELF look
)script";

/// Where the lid meets resistance, the friction is lowered, and the grains slide into denser places.
const char *const compact_to_void_ratio = R"script(
label compact
if "${void_ratio} <= ${enough}" then "jump SELF reached"
if "${now} >= ${last}" then "print 'STOP: void ratio ${target} is not reached after ${now} steps: ${void_ratio} at ${pressure} Pa: raise most_compacting'" @quit@
if "${crowded} < 1" then "jump SELF servo"
if "${mu} < 0.01" then "print 'STOP: void ratio ${target} is beyond the densest that this run finds, ${void_ratio} at ${pressure} Pa without friction: raise most_pressure, or ask for less'" @quit@
variable mu equal 0.95*${mu}
)script";

const char *const compact_to_pressure = R"script(
label compact
if "${is_there} > 0" then "jump SELF reached"
if "${now} >= ${last}" then "print 'STOP: ${target} Pa are not reached after ${now} steps: ${pressure} Pa at void ratio ${void_ratio}: raise most_compacting'" @quit@
variable rate equal ${next_rate}
jump SELF look
)script";

const char *const course_reached = R"script(
# The grains come to rest with their own friction.
label reached
variable rate equal 0
variable own equal 1
variable held equal 0
variable last equal ${now}+@more@
variable phase delete
variable phase string hold
jump SELF contact
)script";

const char *const hold_still = R"script(
label hold
variable held equal ${held}+1
if "${restless} > 1 && ${now} < ${last}@is_carried@" then "jump SELF look"
if "${restless} > 1 && ${unjammed} < 1@is_carried@" then "jump SELF restless"
)script";

const char *const hold_pressure = R"script(
label hold
variable rate equal ${next_rate}
if "${is_there} < 1 && ${now} < ${last}" then "jump SELF look"
if "${is_there} < 1" then "print 'STOP: ${target} Pa are not held after ${now} steps: ${pressure} Pa at void ratio ${void_ratio}: @state@'" @quit@
)script";

const char *const judge_rest = R"script(
label restless
print "STOP: not at rest after ${now} steps: @state@; go on with -var go_on 1, or take it as it is with -var unjammed 1"
@save@@stop@)script";

const char *const judge = R"script(
label judge
if "${jammed} > 0 || ${unjammed} > 0" then "jump SELF @judged@"
)script";

const char *const not_jammed =
    R"script(print "STOP: not jammed at void ratio ${@void_ratio@}: ${carrying} contacts of a grain that is carried, fewer than ${isostatic}; @state@; take it as it is with -var unjammed 1"
@stop@)script";

/// The cell is compressed on, until its grains carry each other.
const char *const seek_jamming = R"script(variable loose_z equal ${carrying}
variable loose_pressure equal ${pressure}
variable last equal ${now}+@more@
variable phase delete
variable phase string seek
label seek
variable carries equal "(v_carrying >= v_isostatic)*(v_pressure > 0.01*v_most_pressure)"
if "${carries} > 0" then "print 'STOP: @loose@: with friction ${grip} they jam at void ratio ${void_ratio}, compressed on: ask for that or less, or take it as it is with -var unjammed 1'" @quit@
if "${now} >= ${last}" then "print 'STOP: @loose@, nor do they jam in as many steps at void ratio ${void_ratio}: take it as it is with -var unjammed 1'" @quit@
variable rate equal v_most_rate*(1+4*(v_pressure<0.01*v_most_pressure))
jump SELF look
)script";

/// What a cell at the void ratio that is asked for lacks.
const char *const loose =
    "of void ratio ${target} the grains are not jammed: ${loose_z} contacts of a grain that is no "
    "rattler, jammed ${isostatic} or more, and ${loose_pressure} Pa, jammed ${least_pressure} Pa or more";

const char *const course_end = R"script(
label end
print "RESULT after ${now} steps: void ratio ${@void_ratio@}, pressure ${@pressure@} Pa, @state@@sheared@"
)script";

} // namespace

std::string friction_of_pair(const SettleScript &s, const GrainMaterial &a, const GrainMaterial &b) {
  const std::string own = digits6(std::min(a.friction, b.friction));
  const std::string on_the_way =
      s.keeps_friction() ? fmt::format("(({0}<${{mu}})*{0}+({0}>=${{mu}})*${{mu}})", own) : "${mu}";
  return fmt::format("${{own}}*{}+(1-${{own}})*{}", own, on_the_way);
}

std::string phase_variables(const SettleScript &s) {
  const Settling &p = s.physics;
  std::string text = settings_of_all(s);
  const std::optional<DensityTarget> &target = s.model.target;
  if (target)
    text += settings_of_target(s, *target);
  if (s.is_sheared())
    text += triaxial_phases_settings(s);
  text += filled(looks_at, {{"solids", digits17(p.solids)}, {"look", std::to_string(p.look)}});
  if (s.has_lid())
    text += "variable void_ratio_at_top equal v_area*v_top/" + digits17(p.solids) + "-1\n";
  if (s.has_lid() && target && target->void_ratio)
    text += "variable too_dense equal \"v_void_ratio_at_top < v_target-v_tolerance\"\n";
  if (target)
    text += filled(target->void_ratio ? to_void_ratio : to_pressure, {{"axes", s.has_lid() ? "1" : "3"}});
  if (s.is_sheared())
    text += triaxial_phases_variables(s);
  if (s.seeks_jamming())
    text += "variable loose_z equal 0\nvariable loose_pressure equal 0\n";
  text += filled(start_of_course, {{"anew", s.has_lid() ? anew_filling : anew_compacting},
                                   {"go_on", s.is_sheared() ? triaxial_phases_log_again : ""},
                                   {"look", std::to_string(compaction_look)},
                                   {"base", s.name}});
  return text;
}

std::string phase_loops(const SettleScript &s, const PhaseCommands &c) {
  const std::optional<DensityTarget> &target = s.model.target;
  const bool to_density = target && target->void_ratio;
  const std::string saving = s.is_sheared() ? triaxial_phases_save(s) : course_save(s, c.keeps_lid_offset);
  std::string text = s.is_sheared() ? triaxial_phases_same_limits : "";
  text += begin_of_loop;
  if (s.has_lid())
    text += target ? settle_nearly : settle_wholly;
  if (target && s.has_lid()) {
    text += to_density ? refuse_loosest : "";
    text += begin_compaction;
  }
  if (!target)
    text += s.changes_friction() ? "jump SELF reached\n" : "jump SELF judge\n";
  if (target) {
    const bool by_friction = to_density || (s.is_sheared() && s.model.shear->void_ratio);
    text += to_density    ? compact_to_void_ratio
            : by_friction ? triaxial_phases_compaction
                          : compact_to_pressure;
    text += by_friction ? with_friction : "";
  }
  if (s.changes_friction()) {
    text += course_reached;
    text += target && !to_density ? hold_pressure : hold_still;
  }
  text += s.is_sheared() ? triaxial_phases_faces(s) : "";
  text += judge;
  text += s.seeks_jamming() ? seek_jamming : not_jammed;
  if (!target || to_density)
    text += judge_rest;
  text += s.is_sheared() ? triaxial_phases_shear(s) : "";
  text += course_end;
  return filled(text, {{"loose", loose},
                       {"judged", s.is_sheared() ? "shearing" : "end"},
                       {"sheared", s.is_sheared() ? triaxial_phases_words : ""},
                       {"constant", s.is_sheared() ? constant_stress(s) : ""},
                       {"contact", c.contact},
                       {"move", target ? c.move : ""},
                       {"lower", c.lower_lid},
                       {"save", saving},
                       {"base", s.name},
                       {"quit", c.quit},
                       {"state", state_words(s)},
                       {"stop", std::string(c.quit) == "quit" ? "quit\n" : "quit 1\n"},
                       {"pressure", s.has_lid() && !target ? "mean_pressure" : "pressure"},
                       {"is_carried",
                        s.seeks_jamming() ? " && (${held} < 20 || ${pressure} >= ${least_pressure})" : ""},
                       {"look", std::to_string(compaction_look)},
                       {"more", target ? "${most_compacting}" : "${steps}"},
                       {"void_ratio", s.has_lid() && !target ? "void_ratio_at_top" : "void_ratio"}});
}

} // namespace mdm

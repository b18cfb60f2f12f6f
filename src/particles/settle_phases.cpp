#include "particles/settle_phases.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

/// `variable steps index 300      # at most`
std::string setting(const char *name, const std::string &value, const std::string &meaning) {
  return fmt::format("{:<46}# {}\n", fmt::format("variable {} index {}", name, value), meaning);
}

std::string settings_of_all(const SettleScript &s) {
  return "\n# What may be changed, here or behind the command as -var NAME VALUE.\n" +
         setting("go_on", "0", "1: from " + s.name + ".restart") +
         setting("steps", std::to_string(s.physics.steps),
                 "while the grains settle, at most, in whole looks") +
         setting("friction", digits6(s.model.friction), "of the grains at the end") +
         setting("friction_while_filling", digits6(s.friction_while_filling()),
                 "and while they are compacted; of the walls, too") +
         setting("at_rest", digits6(s.physics.rest_energy), "kinetic energy, J");
}

std::string settings_of_target(const SettleScript &s, const DensityTarget &target) {
  const bool to_density = target.void_ratio.has_value();
  return setting("target", digits6(to_density ? *target.void_ratio : target.pressure),
                 to_density ? "void ratio" : "Pa") +
         setting("tolerance", digits6(target.tolerance), to_density ? "of it" : "of it, a part") +
         setting("most_pressure", digits6(s.physics.most_pressure),
                 to_density ? "Pa: overlaps of a percent; where it comes near, the friction is lowered"
                            : "Pa") +
         setting("most_rate", digits6(s.physics.rate),
                 "1/s, of the strain: inertial number 0.003 at that pressure") +
         setting("most_compacting", std::to_string(s.physics.most_compacting), "steps");
}

const char *const looks_at = R"script(
# What is found at each look. Phases: fill, compact, hold.
variable now equal step
variable agitation equal ke/v_at_rest
variable void_ratio equal v_volume/@solids@-1
variable mu equal ${friction_while_filling}
variable own equal 0   # 1: grains have their own friction
variable rate equal 0  # 1/s, of compaction
variable looks equal 0
variable is_time equal "v_looks == 20*floor(v_looks/20)"
variable look equal "(v_steps < @look@)*v_steps+(v_steps >= @look@)*@look@"
variable look equal ${look}
variable last equal ${steps}
)script";

const char *const start_of_course = R"script(if "${go_on} == 0" then "jump SELF anew"
include @base@.restart.state
jump SELF setting
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
variable is_there equal "(v_missing < v_tolerance)*(v_missing > -v_tolerance)*(v_agitation < 1)"
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

const char *const course_settle = R"script(
label fill
if "${agitation} > @calm@ && ${now} < ${last}" then "jump SELF look"
if "${agitation} > @calm@" then "print 'NOTE: not at rest yet after ${now} steps: the kinetic energy is ${agitation} times that at rest'"
print "SETTLED after ${now} steps: void ratio ${void_ratio_at_top} below the highest grain"
)script";

/// Both engines write a line of a file by a fix alone, while they run.
std::string course_save(const std::string &name) {
  std::string text;
  for (const auto &[variable, value] : {std::pair("phase string", "phase"),
                                        {"mu equal", "mu"},
                                        {"own equal", "own"},
                                        {"look equal", "look"},
                                        {"lid_now equal", "lid"}})
    text += fmt::format("fix state all print 1 \"variable {} ${{{}}}\" {} {}.restart.state screen no\n"
                        "run 1\nunfix state\n",
                        variable, value, text.empty() ? "file" : "append", name);
  return text + "write_restart " + name + ".restart\n";
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

/// Where the lid meets resistance, the friction is lowered, and the grains slide into denser places.
const char *const compact_to_void_ratio = R"script(
label compact
if "${void_ratio} <= ${enough}" then "jump SELF reached"
if "${now} >= ${last}" then "print 'STOP: void ratio ${target} is not reached after ${now} steps: ${void_ratio} at ${pressure} Pa: raise most_compacting'" @quit@
if "${crowded} < 1" then "jump SELF servo"
if "${mu} < 0.01" then "print 'STOP: void ratio ${target} is beyond the densest that this run finds, ${void_ratio} at ${pressure} Pa without friction: raise most_pressure, or ask for less'" @quit@
variable mu equal 0.95*${mu}
variable rate equal ${next_rate}
jump SELF contact
label servo
variable rate equal ${next_rate}
jump SELF look
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
variable last equal ${now}+@more@
variable phase delete
variable phase string hold
jump SELF contact
)script";

const char *const hold_still = R"script(
label hold
if "${agitation} > 1 && ${now} < ${last}" then "jump SELF look"
if "${agitation} > 1" then "print 'NOTE: not at rest yet after ${now} steps: the kinetic energy is ${agitation} times that at rest'"
)script";

const char *const hold_pressure = R"script(
label hold
variable rate equal ${next_rate}
if "${is_there} < 1 && ${now} < ${last}" then "jump SELF look"
if "${is_there} < 1" then "print 'STOP: ${target} Pa are not held after ${now} steps: ${pressure} Pa at void ratio ${void_ratio}'" @quit@
)script";

const char *const course_end = R"script(
label end
print "RESULT after ${now} steps: void ratio ${@void_ratio@}, pressure ${pressure} Pa"
)script";

} // namespace

std::string phase_variables(const SettleScript &s) {
  const Settling &p = s.physics;
  std::string text = settings_of_all(s);
  const std::optional<DensityTarget> &target = s.model.target;
  if (target)
    text += settings_of_target(s, *target);
  text += filled(looks_at, {{"solids", digits17(p.solids)}, {"look", std::to_string(p.look)}});
  if (s.has_lid())
    text += "variable void_ratio_at_top equal v_area*v_top/" + digits17(p.solids) + "-1\n";
  if (s.has_lid() && target && target->void_ratio)
    text += "variable too_dense equal \"v_void_ratio_at_top < v_target-v_tolerance\"\n";
  if (target)
    text += filled(target->void_ratio ? to_void_ratio : to_pressure, {{"axes", s.has_lid() ? "1" : "3"}});
  text += filled(start_of_course, {{"anew", s.has_lid() ? anew_filling : anew_compacting},
                                   {"look", std::to_string(compaction_look)},
                                   {"base", s.name}});
  return text;
}

std::string phase_loops(const SettleScript &s, const PhaseCommands &c) {
  const std::optional<DensityTarget> &target = s.model.target;
  const bool to_density = target && target->void_ratio;
  const std::string saving = course_save(s.name);
  std::string text = begin_of_loop;
  if (s.has_lid())
    text += course_settle;
  if (target && s.has_lid()) {
    text += to_density ? refuse_loosest : "";
    text += begin_compaction;
  }
  if (!target)
    text += s.changes_friction() ? "jump SELF reached\n" : "jump SELF end\n";
  if (target)
    text += to_density ? compact_to_void_ratio : compact_to_pressure;
  if (s.changes_friction()) {
    text += course_reached;
    text += target && !to_density ? hold_pressure : hold_still;
  }
  text += course_end;
  return filled(text, {{"contact", c.contact},
                       {"move", target ? c.move : ""},
                       {"lower", c.lower_lid},
                       {"save", saving},
                       {"base", s.name},
                       {"quit", c.quit},
                       {"calm", target ? "10" : "1"},
                       {"look", std::to_string(compaction_look)},
                       {"more", target ? "${most_compacting}" : "${steps}"},
                       {"void_ratio", s.has_lid() && !target ? "void_ratio_at_top" : "void_ratio"}});
}

} // namespace mdm

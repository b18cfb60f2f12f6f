#include "particles/yade_course.hpp"

#include "particles/triaxial_shear.hpp"

namespace mdm {
namespace {

/// Where a density is asked for, it is enough that grains are nearly at rest.
const char *const yade_settle_nearly = R"(
if state['phase'] == 'fill':
    if not rest(steps, 10):
        print('NOTE: not nearly at rest after %d steps: %s' % (O.iter, words(measured())), flush=True)
    print('SETTLED after %d steps: void ratio %g below the highest grain' % (O.iter, void_ratio(top())), flush=True)
)";

const char *const yade_settle_wholly = R"(
if state['phase'] == 'fill':
    stay(steps)
    print('SETTLED after %d steps: void ratio %g below the highest grain' % (O.iter, void_ratio(top())), flush=True)
)";

const char *const yade_loosest = R"(    if void_ratio(top()) < target - tolerance:
        stop('void ratio %g is above the loosest that this run finds, %g: raise friction_while_filling, or take '
             '--start mixed' % (target, void_ratio(top())))
)";

const char *const yade_compaction = R"(    O.bodies[lid].state.pos = (0, 0, top())
    state['phase'] = 'compact'
)";

const char *const yade_to_void_ratio = R"(
# Where the pressure is low, compaction is five times as fast; near the highest it becomes slower, and the friction is
# lowered: the grains slide into denser places.
last = O.iter + most_compacting
while state['phase'] == 'compact':
    found, pressure = density()
    if found <= target + 0.05 * tolerance:
        state.update(phase='hold', own=True)
        set_friction()
        break
    if O.iter >= last:
        stop('void ratio %g is not reached after %d steps: %g at %g Pa: raise most_compacting' % (target, O.iter, found, pressure))
    if pressure > 0.7 * most_pressure:
        if state['friction'] < 0.01:
            stop('void ratio %g is beyond the densest that this run finds, %g at %g Pa without friction: raise '
                 'most_pressure, or ask for less' % (target, found, pressure))
        state['friction'] *= 0.95
        set_friction()
    slower = min(1, max(0, 3 * (1 - pressure / most_pressure)))
    room = (found - target) / (1 + found) / (@axes@ * @compaction_look@ * O.dt)
    compact(min(most_rate * (5 if pressure < 0.01 * most_pressure else 1) * slower, room))
    run(@compaction_look@)
compact(0)
)";

const char *const yade_hold_still = R"(stay(O.iter + most_compacting)
judge()
)";

/// The cell is compressed on, until its grains carry each other.
const char *const yade_seek_jamming = R"(last, held = O.iter + most_compacting, 0
while O.iter < last and not is_at_rest() and (held < 20 or density()[1] >= least_pressure):
    run(@compaction_look@)
    held += 1
if not is_at_rest() and density()[1] >= least_pressure:
    stay(last)
if not unjammed and not is_jammed():
    loose = 'of void ratio %g the grains are not jammed: %g contacts of a grain that is no rattler, jammed %g or more, and %g Pa, jammed %g Pa or more' % (
        target, measured()['carrying'], isostatic, density()[1], least_pressure)
    last = O.iter + most_compacting
    while O.iter < last and not (measured()['carrying'] >= isostatic and density()[1] > 0.01 * most_pressure):
        compact(most_rate * (5 if density()[1] < 0.01 * most_pressure else 1))
        run(@compaction_look@)
    if O.iter >= last:
        stop('%s, nor do they jam in as many steps at void ratio %g: take it as it is with unjammed = True' % (loose, density()[0]))
    stop('%s: with friction %g they jam at void ratio %g, compressed on: ask for that or less, or take it as it is with unjammed = True' % (
        loose, friction_of(classes[0]), density()[0]))
)";

const char *const yade_to_pressure = R"(
# Where the pressure is low, compaction is five times as fast. At the end grains have their own friction.
def holds():
    return abs(1 - density()[1] / target) < tolerance and is_at_rest()@dense@


phases = @phases@
for phase in phases:
    state.update(phase=phase, own=phase == 'hold')
    set_friction()
    last = O.iter + most_compacting
    while not holds():
        found, pressure = density()
        if O.iter >= last:
            stop('%g Pa are not reached after %d steps: %g Pa at void ratio %g: %s' % (
                target, O.iter, pressure, found, words(measured())))
@lower_friction@        missing = max(-1, 1 - pressure / target)
        compact(most_rate * (5 if pressure < 0.01 * target else 1) * missing)
        run(@compaction_look@)
    compact(0)
@still_loose@)";

const char *const friction_at_end = R"(    state.update(phase='hold', own=True)
    set_friction()
if state['phase'] == 'hold':
    stay(O.iter + steps)
)";

std::string course_to_pressure(const SettleScript &s) {
  const bool is_sheared = s.is_sheared();
  const bool to_density = is_sheared && s.model.shear->void_ratio;
  return filled(yade_to_pressure,
                {{"phases", is_sheared ? triaxial_yade_phases
                                       : "['hold'] if state['phase'] == 'hold' else ['compact', 'hold']"},
                 {"dense", to_density ? " and phase == 'hold'" : ""},
                 {"lower_friction", to_density ? triaxial_yade_friction : ""},
                 {"still_loose", to_density ? triaxial_yade_still_loose : ""}}) +
         (is_sheared ? triaxial_yade_shear(s) : "judge()\n");
}

} // namespace

std::string yade_course(const SettleScript &s) {
  const std::optional<DensityTarget> &target = s.model.target;
  std::string text;
  if (s.has_lid())
    text += target ? yade_settle_nearly : yade_settle_wholly;
  if (s.has_lid() && target) {
    text += target->void_ratio ? yade_loosest : "";
    text += yade_compaction;
  }
  if (target && target->void_ratio)
    text += yade_to_void_ratio;
  else if (target)
    text += course_to_pressure(s);
  else if (s.changes_friction())
    text += friction_at_end;
  if (s.seeks_jamming())
    text += yade_seek_jamming;
  else if (target && target->void_ratio)
    text += yade_hold_still;
  else if (!target)
    text += "judge()\n";
  return text;
}

} // namespace mdm

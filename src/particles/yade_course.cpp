#include "particles/yade_course.hpp"

namespace mdm {
namespace {

const char *const yade_settle = R"(
if state['phase'] == 'fill':
    rest(steps@calm@)
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
rest(O.iter + most_compacting)
)";

const char *const yade_to_pressure = R"(
# Where the pressure is low, compaction is five times as fast. At the end grains have their own friction.
def holds():
    return abs(1 - density()[1] / target) < tolerance and is_at_rest()


for phase in ['hold'] if state['phase'] == 'hold' else ['compact', 'hold']:
    state.update(phase=phase, own=phase == 'hold')
    set_friction()
    last = O.iter + most_compacting
    while not holds():
        found, pressure = density()
        if O.iter >= last:
            stop('%g Pa are not reached after %d steps: %g Pa at void ratio %g' % (target, O.iter, pressure, found))
        missing = max(-1, 1 - pressure / target)
        compact(most_rate * (5 if pressure < 0.01 * target else 1) * missing)
        run(@compaction_look@)
    compact(0)
)";

const char *const friction_at_end = R"(    state.update(phase='hold', own=True)
    set_friction()
if state['phase'] == 'hold':
    rest(O.iter + steps)
)";

} // namespace

std::string yade_course(const SettleScript &s) {
  const std::optional<DensityTarget> &target = s.model.target;
  std::string text;
  if (s.has_lid())
    text += yade_settle;
  if (s.has_lid() && target) {
    text += target->void_ratio ? yade_loosest : "";
    text += yade_compaction;
  }
  if (target)
    text += target->void_ratio ? yade_to_void_ratio : yade_to_pressure;
  else if (s.changes_friction())
    text += friction_at_end;
  return text;
}

} // namespace mdm

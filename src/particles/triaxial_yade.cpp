#include "particles/triaxial_columns.hpp"
#include "particles/triaxial_shear.hpp"

namespace mdm {
namespace {

const char *const yade_shear_settings =
    R"script(axial_strain = @strain@  # at the end of the shear
inertial_number = @inertia@  # of the shear where p is the target
held_within = @within@  # @constant@ in the rows of the log, a part of it
most_rows_off = @rows_off@  # part of the rows that may be off by more, or not jammed; the last is neither
)script";

const char *const yade_other_void_ratio =
    R"script(    if abs(density()[0] - asked_void_ratio) > tolerance:
        stop('void ratio %g at %g Pa is not within %g of %g; the friction while compacted was %g at last: a higher '
             'friction_while_filling is looser, and more grains come nearer' % (density()[0], target, tolerance, asked_void_ratio, state['friction']))
)script";

/// The gain makes up for what is off in a look: the stiffness of grains under a pressure p is some
/// E^(2/3) p^(1/3).
const char *const yade_shear = R"script(
# Each face is brought to the target by itself; then the height, along z, shrinks, and the sides keep @constant@ there.
gain = (target / @young@)**(2 / 3) / (@look@ * O.dt)
axial_rate = inertial_number / (@d50@ * (@density@ / target)**0.5)


def stresses():
    """On the faces x, y and z."""
    tensor = getStress()
    return [-tensor[i, i] for i in range(3)]


def steer(faces, goal, rate_z):
    """Moves the faces that are to have the stress goal for a look, none faster than while compacting."""
    rates, found = [0, 0, rate_z], stresses()
    for i in faces:
        off = (found[i] - goal) / target
        state['rates'][i] -= 0.1 * gain * off
        rates[i] = max(-most_rate, min(most_rate, state['rates'][i] - gain * off))
    O.cell.velGrad = Matrix3(-rates[0], 0, 0, 0, -rates[1], 0, 0, 0, -rates[2])
    O.run(@look@, True)


def axial():
    return 1 - O.cell.size[2] / state['height']


def volumetric():
    return 1 - O.cell.volume / state['volume']


def sigma_3():
    return sum(stresses()[:2]) / 2


def q():
    return stresses()[2] - sigma_3()


def constant():
    """What is to be the target."""
    return @constant_now@


def goal():
    """Of the sides."""
    return @goal@


def write_row():
    found = measured()
    with open('@log@', 'a') as file:
        file.write(','.join('%.9g' % value for value in (
            axial(), volumetric(), density()[1], q(), density()[0], found['z'], found['unbalanced'])) + ',@constant@\n')
    inertia = axial_rate * @d50@ * (@density@ / (abs(density()[1]) + 1e-200))**0.5
    off = abs(constant() / target - 1)
    state['off'] = max(state['off'], off)
    state['off_rows'] += off > held_within
    state['inertia'] = max(state['inertia'], inertia)
    state['loose_rows'] += not is_jammed()
    state['lines'] += 1
    state['row'] = int(axial() / axial_strain * @rows@ + 1e-9) + 1
    if state['lines'] % 20 == 0:
        print('step %d, shear: axial strain %g, q %g Pa' % (O.iter, axial(), q()), flush=True)
        save()


if state['phase'] == 'shear':
    if state['limits'] != [held_within, target]:
        stop('the %d rows of @log@ were judged with held_within %g and target %g: go on with these, or begin anew' % (
            state['lines'], *state['limits']))
    # What was written after the restart is written again.
    with open('@log@') as file:
        lines = file.readlines()
    with open('@log@', 'w') as file:
        file.writelines(lines[:state['lines'] + 1])
else:
    state.update(phase='even', rates=[0, 0, 0])
    last = O.iter + most_compacting
    while not (all(abs(stress / target - 1) < tolerance for stress in stresses()) and is_at_rest()):
        if O.iter >= last:
            stop('the faces do not have %g Pa each after %d steps: %g, %g and %g Pa; %s' % (
                target, O.iter, *stresses(), words(measured())))
        steer((0, 1, 2), target, 0)
@other@    judge()
    state.update(
        phase='shear', height=O.cell.size[2], volume=O.cell.volume, row=0, lines=0, off=0, off_rows=0,
        loose_rows=0, inertia=0, limits=[held_within, target])
    with open('@log@', 'w') as file:
        file.write('@columns@\n')
while True:
    if axial() + 1e-9 >= state['row'] * axial_strain / @rows@:
        write_row()
    if axial() + 1e-9 >= axial_strain:
        break
    steer((0, 1), goal(), axial_rate)
def is_rare(rows):
    return rows <= most_rows_off * state['lines']


if not is_rare(state['off_rows']) or abs(constant() / target - 1) > held_within:
    stop('@constant@ was not constant: in %d of %d rows of @log@ it is off by more than %g of %g Pa, by %g at most, and by %g at the '
         'end: more grains or a lower inertial_number make it steadier' % (
             state['off_rows'], state['lines'], held_within, target, state['off'], abs(constant() / target - 1)))
if state['inertia'] > @most@:
    stop('the inertial number was %g, above @most@: lower inertial_number' % state['inertia'])
if not unjammed and not (is_rare(state['loose_rows']) and is_jammed()):
    stop('not jammed in %d of %d rows of @log@: a grain that is carried has fewer contacts than %g, %g at the end; take it '
         'as it is with unjammed = True' % (state['loose_rows'], state['lines'], isostatic, measured()['carrying']))
)script";

} // namespace

const char *const triaxial_yade_friction =
    R"script(        # Under the pressure the friction is lowered, and the grains slide into denser places. Where they are dense enough,
        # or nearly so and in a slide, they get their own at once.
        beyond = (found - asked_void_ratio) / tolerance
        if phase == 'compact' and (beyond <= 0.4 or (beyond <= 2 and pressure < 0.9 * target)):
            break
        if phase == 'compact' and abs(1 - pressure / target) < tolerance and is_at_rest(10):
            if state['friction'] < 0.01:
                stop('void ratio %g is beyond the densest that this run finds at %g Pa, %g without friction: ask for less '
                     'density' % (asked_void_ratio, target, found))
            state['friction'] *= 0.95 if beyond > 4 else 0.99
            set_friction()
)script";

const char *const triaxial_yade_still_loose =
    R"script(    # With their own friction they may be too loose: they slide on.
    if phase == 'hold' and density()[0] > asked_void_ratio + tolerance:
        state['friction'] *= 0.99
        phases += ['compact', 'hold']
)script";

const char *const triaxial_yade_phases =
    "['compact', 'hold'][('compact', 'hold', 'even', 'shear').index(state['phase']):]";

const char *const triaxial_yade_words = "; sheared to axial strain %g, volumetric strain %g, q %g Pa; of %d "
                                        "rows %d have @constant@ more than %g off %g Pa, "
                                        "%g at most, and %d are not jammed; inertial number at most %g";
const char *const triaxial_yade_values =
    ", axial(), volumetric(), q(), state['lines'], state['off_rows'], held_within, target, state['off'],\n"
    "    state['loose_rows'], state['inertia']";

std::string triaxial_yade_settings(const SettleScript &s) {
  const TriaxialShear &asked = *s.model.shear;
  std::string text;
  if (asked.void_ratio)
    text = filled("asked_void_ratio = @e@  # at that pressure, before the shear, within the tolerance\n",
                  {{"e", digits6(*asked.void_ratio)}});
  return text + filled(yade_shear_settings, {{"strain", digits6(asked.axial_strain)},
                                             {"inertia", digits6(TriaxialLimits::inertial_number)},
                                             {"constant", constant_stress(s)},
                                             {"within", digits6(TriaxialLimits::held_within)},
                                             {"rows_off", digits6(TriaxialLimits::rows_off)}});
}

std::string triaxial_yade_shear(const SettleScript &s) {
  const ShearCourse course(s.model);
  return filled(yade_shear, {{"other", s.model.shear->void_ratio ? yade_other_void_ratio : ""},
                             {"columns", triaxial_columns},
                             {"constant", constant_stress(s)},
                             {"constant_now", is_p_constant(s) ? "density()[1]" : "sigma_3()"},
                             {"goal", is_p_constant(s) ? "(3 * target - stresses()[2]) / 2" : "target"},
                             {"log", s.name + "-triaxial.csv"},
                             {"d50", digits17(course.median)},
                             {"density", digits17(course.density)},
                             {"look", std::to_string(TriaxialLimits::look)},
                             {"rows", std::to_string(TriaxialLimits::rows)},
                             {"most", digits6(TriaxialLimits::most_inertial_number)}});
}

} // namespace mdm

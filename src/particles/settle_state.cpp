#include "particles/settle_state.hpp"

#include "particles/six_walls.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

/// Sums over the grains, in the order of `c_sums`.
constexpr int sums = 12;

/// `counted`: 1 for the grains that are to be at rest. `bearing`: 1 for those that the count of contacts is
/// of.
const char *const measures = R"script(
# The state at a look: rest, jamming.
compute touch all contact/atom
compute stresses @stress@
variable walls atom @walls@
variable counted atom @counted@
variable several atom "c_touch > 1"
variable of_several atom c_touch*v_several
variable kinetic atom 0.5*mass*(vx^2+vy^2+vz^2)*v_counted
variable net atom sqrt(fx^2+fy^2+fz^2)*c_d/2*v_counted
variable width atom c_d/2*v_counted
variable ends atom "c_d/2*(c_touch+v_walls)"
variable bearing atom "(c_touch+v_walls) > (1+@more_held@*@frictionless@)"
variable of_bearing atom "(c_touch+@of_wall@*v_walls)*v_bearing"
compute sums all reduce sum c_touch v_several v_of_several v_kinetic v_net v_width v_ends c_stresses[1] c_stresses[2] c_stresses[3] v_bearing v_of_bearing
variable fl equal -(c_sums[8]+c_sums[9]+c_sums[10])
variable pv equal "((v_fl > 0)*v_fl@floor@)/@dimension@"
variable z equal c_sums[1]/atoms
variable z_others equal "c_sums[3]/(c_sums[2]+(c_sums[2] == 0))"
variable rattlers equal 1-c_sums[2]/atoms
variable energy equal c_sums[4]/(v_pv+1e-200)
variable unbalanced equal c_sums[5]*c_sums[7]/(@dimension@*v_pv*c_sums[6]+1e-200)
variable restless_energy equal v_energy/v_at_rest
variable restless_force equal v_unbalanced/v_most_unbalanced
variable restless equal "(v_restless_energy > v_restless_force)*v_restless_energy+(v_restless_energy <= v_restless_force)*v_restless_force"
variable isostatic equal "@isostatic@+(@slippery@-@isostatic@)*@frictionless@"
variable carrying equal "c_sums[12]/(c_sums[11]+(c_sums[11] == 0))"
variable jammed equal "@jammed@"
@mean@)script";

const char *const yade_functions = R"script(def measured():
    """The state at a look: rest, jamming."""
    grains = [body for body in O.bodies if isinstance(body.shape, Sphere)]
    touch = {body.id: 0 for body in grains}
    walls = dict.fromkeys(touch, 0)
    fl = length = 0
    for contact in O.interactions:
        if not contact.isReal:
            continue
        pair = contact.id1, contact.id2
        if all(i in touch for i in pair):
            distance = sum(O.bodies[i].shape.radius for i in pair) - contact.geom.penetrationDepth
            fl += contact.phys.normalForce.norm() * distance
            for i in pair:
                touch[i] += 1
        else:
            walls[max(pair, key=lambda i: i in touch)] += 1
    energy = net = width = 0
    for body in grains:
        length += body.shape.radius * (touch[body.id] + walls[body.id])
        if @counted@:
            energy += 0.5 * body.state.mass * (body.state.vel@velocity@).squaredNorm()
            net += (O.forces.f(body.id)@weight@).norm() * body.shape.radius
            width += body.shape.radius
    several = [n for n in touch.values() if n > 1]
    held = [touch[i] + 2 * walls[i] for i in touch if touch[i] + walls[i] > @least@]
    pv = (fl@floor@) / @dimension@
    return dict(
        pv=pv, z=sum(touch.values()) / total, z_others=sum(several) / max(1, len(several)),
        rattlers=1 - len(several) / total, energy=energy / (pv + 1e-200),
        unbalanced=net * length / (@dimension@ * pv * width + 1e-200), carrying=sum(held) / max(1, len(held)))


def words(found):
    return ('Z %g, without rattlers %g, rattlers %g of the grains, unbalanced force %g of the contact force, kinetic '
            'energy %g of p V, friction @friction@' % (
                found['z'], found['z_others'], found['rattlers'], found['unbalanced'], found['energy']@values@))


def is_at_rest(times=1):
    """Two looks at least after the friction was set: a state that was at rest with another one is none with this."""
    found = measured()
    return state['since'] >= 2 and found['energy'] < times * at_rest and found['unbalanced'] < times * most_unbalanced


def is_jammed():
    return measured()['carrying'] >= isostatic@pressed@


def judge():
    """Stops where the grains are not jammed."""
    if unjammed or is_jammed():
        return
    found = measured()
    stop('not jammed: %g contacts of a grain that is carried, fewer than %g; %s; take it as it is with unjammed = True' % (
        found['carrying'], isostatic, words(found)))


def stay(last):
    """Runs until the grains are at rest, but no further than the step last: then it is no result."""
    if not rest(last) and not unjammed:
        save()
        stop('not at rest after %d steps: %s; go on from @base@.restart.gz, or take it as it is with unjammed = True' % (
            O.iter, words(measured())))


)script";

std::string walls_touched(const SettleScript &s) {
  if (s.has_six_walls())
    return six_walls_touched();
  if (!s.has_lid())
    return "0";
  if (s.model.has_discs()) // whose plane is x y there
    return "\"(y-c_d/2 < 0)+(y+c_d/2 > v_lid)+(x-c_d/2 < 0)+(x+c_d/2 > xhi)\"";
  std::string text = "(z-c_d/2 < 0)+(z+c_d/2 > v_lid)";
  if (s.model.space == Space::box)
    text += "+(x-c_d/2 < 0)+(x+c_d/2 > xhi)+(y-c_d/2 < 0)+(y+c_d/2 > yhi)";
  if (s.model.space == Space::cylinder)
    text += "+(sqrt((x-v_half)^2+(y-v_half)^2)+c_d/2 > v_half)";
  return "\"" + text + "\"";
}

/// Contacts of grains that a contact with a wall is worth. A wall with friction shares no force with a second
/// grain; one without has a single force, of the three or six equations of a grain.
std::string worth_of_wall(const SettleScript &s) {
  return s.has_six_walls() ? "v_isostatic/(6-3*@frictionless@)" : "2";
}

/// Of discs, or of spheres.
const char *of_dimension(const SettleScript &s, const char *discs, const char *spheres) {
  return s.model.has_discs() ? discs : spheres;
}

} // namespace

double energy_at_rest(const SettleScript &s) {
  return s.has_lid() ? SettleLimits::at_rest_on_floor : SettleLimits::at_rest_in_cell;
}

std::string state_settings(const SettleScript &s) {
  std::string text = script_setting("at_rest", digits6(energy_at_rest(s)), "kinetic energy by p V") +
                     script_setting("most_unbalanced", digits6(SettleLimits::unbalanced),
                                    "at rest: net force on a grain by contact force") +
                     script_setting("unjammed", s.model.unjammed ? "1" : "0",
                                    "1: what is not at rest, or not jammed, is a result too");
  if (s.seeks_jamming())
    text += script_setting("least_pressure", digits6(s.physics.least_pressure), "Pa, of jammed grains");
  return text;
}

std::string state_measures(const SettleScript &s, const char *stress) {
  return filled(measures, {{"stress", stress},
                           {"mean", s.has_lid() ? "variable mean_pressure equal v_pv/(v_area*v_top)\n" : ""},
                           {"walls", walls_touched(s)},
                           {"of_wall", worth_of_wall(s)},
                           {"frictionless", s.model.materials.empty() ? "(v_friction == 0)"
                                            : s.is_frictionless()     ? "1"
                                                                      : "0"},
                           {"isostatic", s.all_resist_rolling() ? "2.4" : of_dimension(s, "3", "4")},
                           {"slippery", of_dimension(s, "4", "6")},
                           {"more_held", of_dimension(s, "1", "2")},
                           {"dimension", std::to_string(s.model.dimension())},
                           {"counted", s.has_lid() ? "1" : "\"(c_touch+v_walls) > 1\""},
                           {"floor", s.has_lid() ? "+" + digits6(s.physics.floor_moment) : ""},
                           {"jammed", std::string("(v_carrying >= v_isostatic)") +
                                          (s.seeks_jamming() ? "*(v_pressure >= v_least_pressure)" : "")}});
}

std::string state_columns() {
  std::string text;
  for (int i = 1; i <= sums; ++i)
    text += fmt::format(" c_sums[{}]", i);
  return text;
}

std::string yade_limits(const SettleScript &s) {
  std::string text = fmt::format("at_rest = {}  # kinetic energy by p V\n"
                                 "most_unbalanced = {}  # at rest: net force on a grain by contact force\n"
                                 "unjammed = {}  # what is not at rest, or not jammed, is a result too\n"
                                 "isostatic = {}  # contacts of a grain that carry it\n",
                                 digits6(energy_at_rest(s)), digits6(SettleLimits::unbalanced),
                                 s.model.unjammed ? "True" : "False",
                                 s.is_frictionless() ? of_dimension(s, "4", "6") : of_dimension(s, "3", "4"));
  if (s.seeks_jamming())
    text += fmt::format("least_pressure = {}  # Pa, of jammed grains\n", digits6(s.physics.least_pressure));
  return text;
}

std::string yade_measures(const SettleScript &s) {
  const bool has_lid = s.has_lid(), of_classes = !s.model.materials.empty();
  return filled(
      yade_functions,
      {{"counted", has_lid ? "True" : "touch[body.id] > 1"},
       {"velocity", has_lid ? "" : " - O.cell.velGrad * body.state.pos"},
       {"weight", has_lid ? fmt::format(" + body.state.mass * Vector3(0, 0, -{})", Settling::gravity) : ""},
       {"least", s.is_frictionless() ? of_dimension(s, "2", "3") : "1"},
       {"dimension", std::to_string(s.model.dimension())},
       {"floor", has_lid ? " + " + digits6(s.physics.floor_moment) : ""},
       {"friction",
        std::string(of_classes ? "of each class" : "%g") + (s.model.target ? " (%g while compacted)" : "")},
       {"values", std::string(of_classes ? "" : ", friction_of(classes[0])") +
                      (s.model.target ? ", state['friction']" : "")},
       {"pressed", s.seeks_jamming() ? " and density()[1] >= least_pressure" : ""},
       {"base", s.name}});
}

std::string state_words(const SettleScript &s) {
  std::string text =
      "Z ${z}, without rattlers ${z_others}, rattlers ${rattlers} of the grains, unbalanced force "
      "${unbalanced} of the contact force, kinetic energy ${energy} of p V, friction ";
  text += s.model.materials.empty() ? "${grip}" : "of each class";
  return text + (s.model.target ? " (${mu} while compacted)" : "");
}

} // namespace mdm

#include "particles/contact_table.hpp"
#include "particles/settle_state.hpp"
#include "particles/triaxial_shear.hpp"
#include "particles/yade_course.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

const char *const yade_begin = R"(
import json
import sys
from math import atan, cos, hypot, pi, tan

from yade import export, geom

# What may be changed.
steps = int(sys.argv[1]) if len(sys.argv) > 1 else @steps@  # while the grains settle, at most, in whole looks
go_on = sys.argv[2] if len(sys.argv) > 2 else None  # restart file
friction_while_filling = @filling@  # @filling_means@
@limits@look = min(steps, @look@)  # steps between two looks
@target@solids = @solids@  # m^3
x, y, z = @x@, @y@, @z@  # of the start

# Each class, largest first: its name, density, least and greatest radius as they are in the file, its count, and its
# grains' Young's modulus, Poisson's ratio, friction and restitution.
classes = [
@classes@]
total = sum(row[4] for row in classes)


def stop(message):
    print('STOP: ' + message, flush=True)
    sys.exit('STOP: ' + message)


def friction_of(row):
    """Of a class: its own, or that of the state."""
    return row[7] if state['own'] else @while_filling@


def set_friction():
    state['since'] = 0
    for number, row in enumerate(classes):
        O.materials[number + 1].frictionAngle = atan(friction_of(row))
    for contact in O.interactions:
        pair = (O.bodies[contact.id1].material, O.bodies[contact.id2].material)
        contact.phys.tangensOfFrictionAngle = tan(min(material.frictionAngle for material in pair))


@measures@def save():
    O.tags['state'] = json.dumps(state).replace(' ', '')
    O.save('@base@.restart.gz')


def run(count):
    O.run(count, True)
    state['looks'] += 1
    state['since'] += 1
    print('step %d, %s: kinetic energy %g J@show@' % (O.iter, state['phase'], kineticEnergy()@shown@), flush=True)
    if state['looks'] % 20 == 0:
        save()


def rest(last, times=1):
    """Runs until the grains are at rest, or so many times above it, but no further than the step last."""
    while O.iter < last and not is_at_rest(times):
        run(look)
    return is_at_rest(times)


@pairs@def build():
@space@    with open('@particles@') as file:
        grains = [tuple(map(float, line.split())) for line in file if line.strip() and not line.startswith('#')]
    O.materials.append(FrictMat(young=@young@, poisson=@nu@, frictionAngle=atan(friction_while_filling), density=@density@))
@walls@    without_grains = len(O.bodies)
    found = 0
    for number, row in enumerate(classes):
        name, density, least, most, count, young, poisson = row[:7]
        material = O.materials.append(FrictMat(
            young=young, poisson=poisson, frictionAngle=atan(friction_of(row)), density=density, label=name))
        color = (1 - number / len(classes), 0.5, number / len(classes))
        O.bodies.append([
            sphere((x, y, z), r, material=material, color=color) for x, y, z, r in grains if least <= r <= most])
        found += count
        if len(O.bodies) - without_grains != found:
            stop('%s: %d grains are there, not %d' % (name, len(O.bodies) - without_grains, found))
@discs@    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()@bounds@]),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom()@geometry@],
            [Ip2_FrictMat_FrictMat_MindlinPhys(en=@restitution@, es=@restitution@)],
            [Law2_ScGeom_MindlinPhys_Mindlin()]),
        NewtonIntegrator(gravity=(0, 0, @gravity@), damping=0),
    ]
    O.dt = @dt@


if go_on:
    O.load(go_on)
    state = json.loads(O.tags['state'])
    state.setdefault('since', 2)
else:
    state = dict(phase='@phase@', friction=friction_while_filling, own=False, looks=0, since=0)
    build()
)";

/// Where classes have materials of their own.
const char *const restitution_of_pairs = R"(def restitution():
    """Of two materials their mean; that of the walls is the first."""
    of_materials = [@e@] + [row[8] for row in classes]
    return MatchMaker(matches=tuple(
        (i, j, (a + b) / 2) for i, a in enumerate(of_materials) for j, b in enumerate(of_materials) if i <= j))


)";

const char *const lid_functions = R"(
lid = 1


def height():
    return O.bodies[lid].state.pos[2]


def top():
    return max(body.state.pos[2] + body.shape.radius for body in O.bodies if isinstance(body.shape, Sphere))


def void_ratio(of_height):
    return @area@ * of_height / solids - 1


def density():
    """Void ratio, and pressure on the lid."""
    return void_ratio(height()), O.forces.f(lid)[2] / @area@


def compact(rate):
    O.bodies[lid].state.vel = (0, 0, -rate * height())

)";

const char *const cell_functions = R"(

def density():
    """Void ratio, and mean pressure."""
    return O.cell.volume / solids - 1, -getStress().trace() / 3


def compact(rate):
    O.cell.velGrad = Matrix3(-rate, 0, 0, 0, -rate, 0, 0, 0, -rate)

)";

const char *const yade_ending = R"(
found = measured()
print('RESULT after %d steps: void ratio %g, pressure %g Pa, %s@sheared@' % (O.iter, @reached@, words(found)@shear@), flush=True)
settled = [body for body in O.bodies if isinstance(body.shape, Sphere)]
@inside@if len(inside) != total:
    stop('%d grains are in the box at the end, not %d' % (len(inside), total))
with open('@dump@', 'w') as file:
    file.write('# x y z r in m; box %r %r %r@repeated@\n' % (@box@))
    for body in settled:
        file.write('%r %r %r %r\n' % (*@position@, body.shape.radius))
save()
# For ParaView: glyphs of type sphere, scaled by radius.
export.VTKExporter('@result@').exportSpheres()
)";

std::string class_rows(const SettleScript &s) {
  std::string text;
  for (std::size_t i = s.set.classes.size(); i > 0; --i) {
    const ParticleClass &c = s.set.classes[i - 1];
    const GrainMaterial m = s.material(i);
    text += fmt::format("    ('{}', {}, {}, {}, {}, {}, {}, {}, {}),\n", c.text(), short_decimal(c.density),
                        c.sizes.front().radius.text, c.sizes.back().radius.text, to_string(c.quantity()),
                        digits6(m.elasticity.young.convert_to<double>()),
                        digits6(m.elasticity.poisson.convert_to<double>()), digits6(m.friction),
                        digits6(m.restitution));
  }
  return text;
}

std::string target_lines(const SettleScript &s) {
  if (!s.model.target)
    return "";
  const DensityTarget &t = *s.model.target;
  const std::string shear = s.is_sheared() ? triaxial_yade_settings(s) : "";
  return filled("target = @target@  # @quantity@\n"
                "tolerance = @tolerance@  # of it@relative@\n"
                "most_pressure = @pressure@  # Pa\n"
                "most_rate = @rate@  # 1/s, of the strain: inertial number @inertia@ at that pressure\n"
                "most_compacting = @compacting@  # steps\n@shear@",
                {{"target", digits6(t.void_ratio ? *t.void_ratio : t.pressure)},
                 {"quantity", t.void_ratio ? "void ratio" : "Pa"},
                 {"tolerance", digits6(t.tolerance)},
                 {"relative", t.void_ratio ? "" : ", a part"},
                 {"pressure", digits6(s.physics.most_pressure)},
                 {"rate", digits6(s.physics.rate)},
                 {"inertia", digits6(compaction_inertia(s.model))},
                 {"compacting", std::to_string(s.physics.most_compacting)},
                 {"shear", shear}});
}

/// Facets around a cylinder: a prism that touches it.
constexpr int facets = 60;

std::string yade_walls(const SettleScript &s) {
  if (!s.has_lid())
    return "";
  std::string text =
      "    O.bodies.append([wall(0, 2, sense=1, material=0), wall(z, 2, sense=-1, material=0)])\n";
  if (s.model.has_discs())
    return text +
           "    O.bodies.append([wall(0, 0, sense=1, material=0), wall(x, 0, sense=-1, material=0)])\n";
  if (s.model.space == Space::cylinder)
    return text +
           fmt::format(
               "    # A prism of {0} sides, which the cylinder touches: its area is by 0.09 % larger.\n"
               "    O.bodies.append(geom.facetCylinder(\n"
               "        (x / 2, x / 2, z / 2), x / 2 / cos(pi / {0}), z, segmentsNumber={0}, wallMask=4,\n"
               "        material=0))\n",
               facets);
  return text +
         "    for axis, length in enumerate((x, y)):\n"
         "        O.bodies.append([\n"
         "            wall(0, axis, sense=1, material=0), wall(length, axis, sense=-1, material=0)])\n";
}

const char *const inside_walls = "inside = [body for body in settled if all(0 < p < length for p, length in "
                                 "zip(body.state.pos, (x, y, z)))]\n";

const char *const inside_two_walls =
    "inside = [body for body in settled if 0 < body.state.pos[0] < x and 0 < body.state.pos[2] < z]\n";

/// Discs stay in their plane, and have masses and moments of inertia of their own.
const char *const yade_discs =
    R"(    for body in [body for body in O.bodies if isinstance(body.shape, Sphere)]:
        body.state.mass = pi * body.shape.radius**2 * y * body.material.density
        body.state.inertia = Vector3.Ones * body.state.mass * body.shape.radius**2 / 2
        body.state.blockedDOFs = 'yXZ'
)";

} // namespace

std::string yade_model(const SettleModel &model) {
  if (model.has_six_walls())
    throw InputError("YADE has no model with six walls that move: take liggghts");
  if (model.space == Space::pillar)
    throw InputError("YADE has no model of a box that is repeated in x and y alone: take lammps or liggghts");
  const SettleScript s(model, ".xyzr");
  if (s.is_sheared())
    check_triaxial(s);
  const bool has_lid = s.has_lid(), is_round = model.space == Space::cylinder;
  const std::string area =
      is_round ? fmt::format("({} * tan(pi / {}) * x**2 / 4)", facets, facets) : "(x * y)";
  std::string text = s.head({"YADE", "yade -n -x THIS_FILE", "yade -n -x THIS_FILE 1000",
                             "yade -n -x THIS_FILE STEPS NAME.restart.gz, STEPS in all",
                             "On P cores: yade -n -j P -x THIS_FILE", " --size-unit m"},
                            contact_table(s, {"of Hertz and Mindlin: MindlinPhys", restitution_of(s)}));
  text += yade_begin;
  text += has_lid ? lid_functions : cell_functions;
  text += yade_course(s);
  text += yade_ending;
  const bool is_compacted = model.target.has_value();
  return filled(
      text,
      {{"steps", std::to_string(s.physics.steps)},
       {"filling", digits6(s.friction_while_filling())},
       {"limits", yade_limits(s)},
       {"measures", yade_measures(s)},
       {"filling_means", s.keeps_friction() ? "and at most while they are compacted; of the walls"
                                            : "and while they are compacted; of the walls, too"},
       {"while_filling", s.keeps_friction() ? "min(row[7], state['friction'])" : "state['friction']"},
       {"look", std::to_string(s.physics.look)},
       {"target", target_lines(s)},
       {"solids", digits17(s.physics.solids)},
       {"x", fmt::format("{}", s.box.x)},
       {"y", fmt::format("{}", s.box.y)},
       {"z", fmt::format("{}", s.box.z)},
       {"classes", class_rows(s)},
       {"base", s.name},
       {"show", is_compacted ? ", void ratio %g at %g Pa" : ""},
       {"shown", is_compacted ? ", *density()" : ""},
       {"space", has_lid ? "" : "    O.periodic = True\n    O.cell.setBox(x, y, z)\n"},
       {"particles", file_word(model.particles)},
       {"young", digits6(s.physics.elasticity.young.convert_to<double>())},
       {"nu", digits6(s.physics.elasticity.poisson.convert_to<double>())},
       {"density", short_decimal(s.set.classes.back().density)},
       {"walls", yade_walls(s)},
       {"bounds", !has_lid   ? ""
                  : is_round ? ", Bo1_Wall_Aabb(), Bo1_Facet_Aabb()"
                             : ", Bo1_Wall_Aabb()"},
       {"geometry", !has_lid   ? ""
                    : is_round ? ", Ig2_Wall_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()"
                               : ", Ig2_Wall_Sphere_ScGeom()"},
       {"pairs", s.model.materials.empty() ? "" : restitution_of_pairs},
       {"restitution", s.model.materials.empty() ? digits6(Settling::restitution) : "restitution()"},
       {"e", digits6(Settling::restitution)},
       {"gravity", has_lid ? fmt::format("-{}", Settling::gravity) : "0"},
       {"dt", digits6(s.physics.step)},
       {"phase", has_lid ? "fill" : "compact"},
       {"area", area},
       {"axes", has_lid ? "1" : "3"},
       {"compaction_look", std::to_string(compaction_look)},
       {"reached",
        is_compacted ? "*density()" : "void_ratio(top()), found['pv'] / ((void_ratio(top()) + 1) * solids)"},
       {"sheared", s.is_sheared() ? triaxial_yade_words : ""},
       {"constant", s.is_sheared() ? constant_stress(s) : ""},
       {"shear", s.is_sheared() ? triaxial_yade_values : ""},
       {"result", s.result},
       {"discs", model.has_discs() ? yade_discs : ""},
       {"inside", model.has_discs() ? inside_two_walls
                  : has_lid         ? inside_walls
                                    : "inside = settled\n"},
       {"dump", s.dump},
       {"repeated", has_lid ? "" : ", repeated in x y z"},
       {"box", model.has_discs() ? "x, 2 * settled[0].state.pos[1], z" // which is around their centres
               : has_lid         ? "x, y, z"
                                 : "*O.cell.size,"},
       {"position", has_lid ? "body.state.pos" : "O.cell.wrap(body.state.pos)"}});
}

} // namespace mdm

#include "particles/settle_script.hpp"

#include <fmt/core.h>

namespace mdm {

std::string yade_model(const SettleModel &model) {
  const SettleScript s(model);
  std::string text = s.head("YADE", "yade -n -x THIS_FILE", "yade -n -x THIS_FILE 1000", " --size-unit m");
  text += fmt::format(R"(
import sys
from math import atan

steps = int(sys.argv[1]) if len(sys.argv) > 1 else {steps}


def material(density):
    return FrictMat(young={young:.6g}, poisson={nu}, frictionAngle=atan({mu}), density=density)


box = O.materials.append(material({density}))
for axis, length in enumerate(({x}, {y}, {z})):
    O.bodies.append([wall(0, axis, sense=1, material=box), wall(length, axis, sense=-1, material=box)])
walls = len(O.bodies)

# Each class, largest first: its name, density, least and greatest radius as they are in the file, and its count.
classes = [
)",
                      fmt::arg("steps", s.physics.steps), fmt::arg("young", s.young),
                      fmt::arg("nu", s.poisson), fmt::arg("mu", s.physics.friction),
                      fmt::arg("density", short_decimal(s.set.classes.back().density)),
                      fmt::arg("x", s.box.x), fmt::arg("y", s.box.y), fmt::arg("z", s.box.z));
  for (auto c = s.set.classes.rbegin(); c != s.set.classes.rend(); ++c)
    text += fmt::format("    ('{}', {}, {}, {}, {}),\n", class_name(*c), short_decimal(c->density),
                        c->sizes.front().radius.text, c->sizes.back().radius.text, to_string(c->quantity()));
  return text + fmt::format(R"(]
with open('{particles}') as file:
    grains = [tuple(map(float, line.split())) for line in file if line.strip() and not line.startswith('#')]
total = 0
for name, density, least, most, count in classes:
    of_class = O.materials.append(material(density))
    O.bodies.append([sphere((x, y, z), r, material=of_class) for x, y, z, r in grains if least <= r <= most])
    total += count
    if len(O.bodies) - walls != total:
        sys.exit('STOP: %s: %d grains are there, not %d' % (name, len(O.bodies) - walls, total))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en={e}, es={e})],
        [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(gravity=(0, 0, -{gravity}), damping=0),
]
O.dt = {dt:.6g}
for done in range(0, steps, 10000):
    O.run(min(10000, steps - done), True)
    print('step %d: kinetic energy %g J' % (O.iter, kineticEnergy()), flush=True)

settled = [body for body in O.bodies if isinstance(body.shape, Sphere)]
inside = [body for body in settled if all(0 < p < length for p, length in zip(body.state.pos, ({x}, {y}, {z})))]
if len(inside) != total:
    sys.exit('STOP: %d grains are in the box at the end, not %d' % (len(inside), total))
with open('{dump}', 'w') as file:
    file.write('# x y z r in m\n')
    for body in settled:
        file.write('%r %r %r %r\n' % (*body.state.pos, body.shape.radius))
)",
                            fmt::arg("particles", file_word(model.particles)),
                            fmt::arg("e", s.physics.restitution), fmt::arg("gravity", s.physics.gravity),
                            fmt::arg("dt", s.physics.step), fmt::arg("x", s.box.x), fmt::arg("y", s.box.y),
                            fmt::arg("z", s.box.z), fmt::arg("dump", s.dump));
}

} // namespace mdm

#include "particles/settle_script.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

/// The walls at the sides.
const char *sides(Sides sides) {
  if (sides == Sides::periodic)
    return "# The box is that of the data file, repeated in x and y.\n";
  if (sides == Sides::cylinder)
    return R"(# The round wall touches the sides of the box in the data file.
variable half equal (xhi-xlo)/2
region inside cylinder z $(v_half:%.17g) $(v_half:%.17g) $(v_half:%.17g) INF INF side in units box
fix side all wall/gran/region granular ${contact} region inside
)";
  return R"(# The walls are the sides of the box in the data file.
fix x all wall/gran granular ${contact} xplane $(xlo:%.17g) $(xhi:%.17g)
fix y all wall/gran granular ${contact} yplane $(ylo:%.17g) $(yhi:%.17g)
)";
}

} // namespace

std::string lammps_model(const SettleModel &model) {
  const SettleScript s(model);
  std::string text = s.head("LAMMPS", "lmp -in THIS_FILE", "-var steps 1000", "");
  text +=
      fmt::format(R"(
variable steps index {steps}

units si
atom_style sphere
boundary {boundary}
newton off
comm_modify vel yes
read_data {particles}

variable contact string "hertz/material {young:.6g} {e} {nu} tangential mindlin NULL 1.0 {mu} damping tsuji"
pair_style granular
pair_coeff * * ${{contact}}
neighbor {skin:.4g} bin
neigh_modify delay 0 every 1 check yes
timestep {dt:.6g}

{sides}fix z all wall/gran granular ${{contact}} zplane $(zlo:%.17g) $(zhi:%.17g)
fix motion all nve/sphere
fix gravity all gravity {gravity} vector 0 0 -1

compute d all property/atom diameter
compute least all reduce min c_d
thermo_style custom step atoms ke c_least
thermo_modify lost error norm no
thermo 10000

# Each class, largest first: its sizes, as they are in the data file, and its count.
run 0
)",
                  fmt::arg("steps", s.physics.steps), fmt::arg("boundary", s.boundary()),
                  fmt::arg("sides", sides(s.sides)), fmt::arg("particles", file_word(model.particles)),
                  fmt::arg("young", s.young), fmt::arg("e", s.physics.restitution), fmt::arg("nu", s.poisson),
                  fmt::arg("mu", s.physics.friction), fmt::arg("skin", s.set.smallest().radius.value),
                  fmt::arg("dt", s.physics.step), fmt::arg("gravity", s.physics.gravity));

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
                        fmt::arg("quantity", to_string(c->quantity())), fmt::arg("class_", class_name(*c)));

  return text + fmt::format(R"(
variable n equal atoms
if "$n != {total}" then "print 'STOP: $n grains are there, not {total}'" "quit 1"
run ${{steps}}
if "$n != {total}" then "print 'STOP: $n grains are there at the end, not {total}'" "quit 1"
write_dump all custom {dump} id type x y z radius modify format float %.17g
)",
                            fmt::arg("total", to_string(s.particles)), fmt::arg("dump", s.dump));
}

} // namespace mdm

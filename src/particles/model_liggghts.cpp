#include "particles/liggghts_insertion.hpp"
#include "particles/settle_script.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

/// The walls at the sides.
std::string sides(const SettleScript &s) {
  const std::string wall = "all wall/gran model hertz tangential history primitive type 1";
  if (s.sides == Sides::periodic)
    return "";
  if (s.sides == Sides::cylinder)
    return fmt::format("fix side {} zcylinder {} {} {}\n", wall, s.box.x / 2, s.box.x / 2, s.box.x / 2);
  return fmt::format("fix west {0} xplane 0\nfix east {0} xplane {1}\n"
                     "fix south {0} yplane 0\nfix north {0} yplane {2}\n",
                     wall, s.box.x, s.box.y);
}

/// Units, the box, which is empty or read with its grains, material and walls.
std::string setting(const SettleScript &s, const std::string &box) {
  return fmt::format(R"(
variable steps index {steps}

atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
units si
# Any stiffness is wanted.
soft_particles yes
hard_particles yes

{box}
neighbor {skin:.4g} bin
neigh_modify delay 0

fix young all property/global youngsModulus peratomtype {young:.6g}
fix poisson all property/global poissonsRatio peratomtype {nu}
fix restitution all property/global coefficientRestitution peratomtypepair 1 {e}
fix friction all property/global coefficientFriction peratomtypepair 1 {mu}
pair_style gran model hertz tangential history
pair_coeff * *
timestep {dt:.6g}

{sides}fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix lid all wall/gran model hertz tangential history primitive type 1 zplane {z}
fix motion all nve/sphere

thermo_style custom step atoms ke
thermo 10000
thermo_modify lost error norm no
)",
                     fmt::arg("steps", s.physics.steps), fmt::arg("box", box),
                     fmt::arg("boundary", s.boundary()), fmt::arg("sides", sides(s)), fmt::arg("z", s.box.z),
                     fmt::arg("skin", s.set.smallest().diameter.value / 2), fmt::arg("young", s.young),
                     fmt::arg("nu", s.poisson), fmt::arg("e", s.physics.restitution),
                     fmt::arg("mu", s.physics.friction), fmt::arg("dt", s.physics.step));
}

std::string empty_box(const ModelBox &box) {
  return fmt::format("# LIGGGHTS takes regions of micrometres for mistakes unless told otherwise.\n"
                     "region mdm_region block 0 {} 0 {} 0 {} units box volume_limit {:.2g}\n"
                     "create_box 1 mdm_region",
                     box.x, box.y, box.z, box.x * box.y * box.z / 1000);
}

std::string insertion(const SettleScript &s) {
  std::string text = R"(
# Insertion, largest first: one template and one insertion a size, its count as the running total. The largest
# template takes part with a weight of 0, because insert/pack finds overlaps with grains up to the largest of its
# distribution alone. Seeds are distinct primes.
)";
  const Sink sink = [&text](std::string_view more) { text += more; };
  TextBuffer insertion(sink);
  add_liggghts_insertion(s.set, s.seed - 1, insertion);
  insertion.finish();
  return text;
}

/// The count of each class among the grains that were read.
std::string counts(const SettleScript &s) {
  std::string text = R"(
# Each class, largest first: its sizes, as they are in the data file, and its count.
compute d all property/atom diameter
)";
  for (auto c = s.set.classes.rbegin(); c != s.set.classes.rend(); ++c)
    text += fmt::format(R"(
variable inside{number} atom "c_d >= {least} && c_d <= {most}"
compute inside{number} all reduce sum v_inside{number}
thermo_style custom step atoms ke c_inside{number}
run 0
variable n equal c_inside{number}
if "$n != {quantity}" then "print 'STOP: {class_}: $n grains are there, not {quantity}'" quit
variable n delete
)",
                        fmt::arg("number", c->number), fmt::arg("least", c->sizes.front().diameter.text),
                        fmt::arg("most", c->sizes.back().diameter.text),
                        fmt::arg("quantity", to_string(c->quantity())), fmt::arg("class_", class_name(*c)));
  return text + R"(
thermo_style custom step atoms ke
variable mdm_count equal atoms
run 1
)";
}

} // namespace

std::string liggghts_model(const SettleModel &model) {
  const SettleScript s(model);
  const std::string head = s.head("LIGGGHTS", "liggghts -in THIS_FILE", "-var steps 1000", "");
  const std::string begin = model.deposited
                                ? setting(s, "read_data " + file_word(model.particles)) + counts(s)
                                : setting(s, empty_box(s.box)) + insertion(s);
  return head + begin +
         fmt::format(R"(
# There was no gravity yet: what moves was put into another.
variable energy equal ke
if "${{energy}} > 0" then "print 'STOP: grains overlap'" quit

fix gravity all gravity {gravity} vector 0 0 -1
run ${{steps}}
if "${{mdm_count}} != {total}" then "print 'STOP: ${{mdm_count}} grains are there at the end, not {total}'" quit
write_dump all custom {dump} id type x y z radius modify format "%d %d %.17g %.17g %.17g %.17g"
)",
                     fmt::arg("gravity", s.physics.gravity), fmt::arg("total", to_string(s.particles)),
                     fmt::arg("dump", s.dump));
}

} // namespace mdm

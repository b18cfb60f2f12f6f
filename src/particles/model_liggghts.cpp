#include "particles/liggghts_insertion.hpp"
#include "particles/settle_script.hpp"

#include <fmt/core.h>

namespace mdm {

std::string liggghts_model(const SettleModel &model) {
  const SettleScript s(model);
  const double least = s.set.smallest().diameter.value;
  std::string text = s.head("LIGGGHTS", "liggghts -in THIS_FILE", "-var steps 1000", "");
  text += fmt::format(R"(
variable steps index {steps}

atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
# Any stiffness is wanted.
soft_particles yes
hard_particles yes

# LIGGGHTS takes regions of micrometres for mistakes unless told otherwise.
region mdm_region block 0 {x} 0 {y} 0 {z} units box volume_limit {limit:.2g}
create_box 1 mdm_region
neighbor {skin:.4g} bin
neigh_modify delay 0

fix young all property/global youngsModulus peratomtype {young:.6g}
fix poisson all property/global poissonsRatio peratomtype {nu}
fix restitution all property/global coefficientRestitution peratomtypepair 1 {e}
fix friction all property/global coefficientFriction peratomtypepair 1 {mu}
pair_style gran model hertz tangential history
pair_coeff * *
timestep {dt:.6g}

fix west all wall/gran model hertz tangential history primitive type 1 xplane 0
fix east all wall/gran model hertz tangential history primitive type 1 xplane {x}
fix south all wall/gran model hertz tangential history primitive type 1 yplane 0
fix north all wall/gran model hertz tangential history primitive type 1 yplane {y}
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0
fix lid all wall/gran model hertz tangential history primitive type 1 zplane {z}
fix motion all nve/sphere

thermo_style custom step atoms ke
thermo 10000
thermo_modify lost error norm no

# Insertion, largest first: one template and one insertion a size, its count as the running total. The largest
# template takes part with a weight of 0, because insert/pack finds overlaps with grains up to the largest of its
# distribution alone. Seeds are distinct primes.
)",
                      fmt::arg("steps", s.physics.steps), fmt::arg("x", s.box.x), fmt::arg("y", s.box.y),
                      fmt::arg("z", s.box.z), fmt::arg("limit", s.box.x * s.box.y * s.box.z / 1000),
                      fmt::arg("skin", least / 2), fmt::arg("young", s.young), fmt::arg("nu", s.poisson),
                      fmt::arg("e", s.physics.restitution), fmt::arg("mu", s.physics.friction),
                      fmt::arg("dt", s.physics.step));

  const Sink sink = [&text](std::string_view more) { text += more; };
  TextBuffer insertion(sink);
  add_liggghts_insertion(s.set, s.seed - 1, insertion);
  insertion.finish();

  return text + fmt::format(R"(
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

#include "settle_script.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace mdm {
namespace {

/// Primes above 10000, each once: LIGGGHTS refuses other seeds, and two of one value.
class Seeds {
public:
  explicit Seeds(std::uint64_t seed) : last_(10000 + seed % 200000 * 10000) {}

  std::uint64_t next() {
    do
      ++last_;
    while (!is_prime(last_));
    return last_;
  }

private:
  static bool is_prime(std::uint64_t n) {
    for (std::uint64_t d = 2; d * d <= n; ++d)
      if (n % d == 0)
        return false;
    return true;
  }

  std::uint64_t last_;
};

} // namespace

std::string liggghts_model(const SettleModel &model) {
  const SettleScript s(model);
  Seeds seeds(s.seed);
  const double least = s.set.smallest().diameter.value;
  // LIGGGHTS refuses volumes below 1e-12 m^3, sizes below 0.124 mm, unless told otherwise.
  const double volume_limit = 1e-3 * std::numbers::pi / 6 * std::pow(least, 3);

  std::string text = s.head("LIGGGHTS", "liggghts -in THIS_FILE", "-var steps 1000", "");
  text += fmt::format(R"(
variable steps index {steps}

atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si

region box block 0 {x} 0 {y} 0 {z} units box
create_box 1 box
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
variable n equal atoms
variable ke equal ke

# Insertion, largest first: one template and one insertion a size, its count as the running total. The largest
# template takes part with a weight of 0, because insert/pack finds overlaps with grains up to the largest of its
# distribution alone. Seeds are distinct primes. There is no gravity yet: what moves has been put into another.
)",
                      fmt::arg("steps", s.steps), fmt::arg("x", s.box.x), fmt::arg("y", s.box.y),
                      fmt::arg("z", s.box.z), fmt::arg("skin", least / 2), fmt::arg("young", s.physics.young),
                      fmt::arg("nu", s.physics.poisson), fmt::arg("e", s.physics.restitution),
                      fmt::arg("mu", s.physics.friction), fmt::arg("dt", s.physics.step));

  Integer total = 0;
  for (auto c = s.set.classes.rbegin(); c != s.set.classes.rend(); ++c)
    for (auto size = c->sizes.rbegin(); size != c->sizes.rend(); ++size) {
      const bool is_largest = total == 0;
      total += size->quantity;
      const std::string name = is_largest ? "largest" : "size";
      const std::uint64_t seed1 = seeds.next(), seed2 = seeds.next(), seed3 = seeds.next();
      text += fmt::format(
          R"(
# {class_}: {quantity} of diameter {diameter}
fix {name} all particletemplate/sphere {seed1} atom_type 1 volume_limit {limit:.3g} density constant {density} radius constant {radius}
fix sizes all particledistribution/discrete/numberbased {seed2} {weights}
fix insertion all insert/pack seed {seed3} distributiontemplate sizes maxattempt 500 insert_every once overlapcheck yes all_in yes vel constant 0 0 0 region box particles_in_region {total}
run 1
if "$n != {total}" then "print 'STOP: {class_}: $n grains are there, not {total}: give a higher --box'" quit
if "${{ke}} > 0" then "print 'STOP: {class_}: grains overlap'" quit
unfix insertion
unfix sizes
)",
          fmt::arg("class_", class_name(*c)), fmt::arg("quantity", to_string(size->quantity)),
          fmt::arg("diameter", size->diameter.text), fmt::arg("name", name), fmt::arg("seed1", seed1),
          fmt::arg("seed2", seed2), fmt::arg("seed3", seed3), fmt::arg("limit", volume_limit),
          fmt::arg("density", short_decimal(c->density)), fmt::arg("radius", size->radius.text),
          fmt::arg("weights", is_largest ? "1 largest 1" : "2 size 1 largest 0"),
          fmt::arg("total", to_string(total)));
      if (!is_largest)
        text += "unfix size\n";
    }

  return text + fmt::format(R"(
fix gravity all gravity {gravity} vector 0 0 -1
run ${{steps}}
if "$n != {total}" then "print 'STOP: $n grains are there at the end, not {total}'" quit
write_dump all custom {dump} id type x y z radius modify format "%d %d %.17g %.17g %.17g %.17g"
)",
                            fmt::arg("gravity", s.physics.gravity), fmt::arg("total", to_string(total)),
                            fmt::arg("dump", s.dump));
}

} // namespace mdm

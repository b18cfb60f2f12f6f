// Packings of discs that mdm export writes, read by the engines themselves: LAMMPS in two dimensions,
// LIGGGHTS in a thin slab, YADE with spheres kept in their plane. What they have is what was written, and
// stays in its plane for some steps.

#include "cli/answer.hpp"
#include "tools.hpp"

#include <cmath>
#include <sstream>

namespace packing_test {

using namespace cli_test;

namespace {

struct Disc {
  double x, y, z, r;

  bool operator==(const Disc &) const = default;
};

/// The discs of a packing file, as the doubles next to its decimals.
std::vector<Disc> discs_of(const std::string &packing) {
  std::istringstream text(packing);
  std::string word;
  unsigned places = 0;
  while (text >> word && word != "places") {
  }
  text >> places;
  while (text >> word && word != "right") {
  }
  // Strings, so that each double is the nearest one.
  const auto length = [places](const std::string &units) {
    return std::stod(units + "e-" + std::to_string(places));
  };
  std::vector<Disc> discs;
  std::string x, y, r, left, right;
  while (text >> x >> y >> r >> left >> right)
    discs.push_back({length(x), length(y), 0, length(r)});
  return discs;
}

/// Rows `x y z r` below lines that begin with letters or signs.
std::vector<Disc> rows_of(const std::string &path) {
  std::istringstream text(read_file(path));
  std::vector<Disc> rows;
  for (std::string line; std::getline(text, line);) {
    std::istringstream row(line);
    Disc d{};
    std::string more;
    if (row >> d.x >> d.y >> d.z >> d.r && !(row >> more))
      rows.push_back(d);
  }
  return rows;
}

struct Engine {
  std::string name, package, program, command, input, script;
};

const std::string in_lammps = R"(units si
dimension 2
atom_style sphere
boundary SIDES f p
newton off
comm_modify vel yes
read_data discs
pair_style gran/hooke/history 1e6 NULL 0 NULL 0.5 0
pair_coeff * *
neighbor 0.1 bin
timestep 1e-5
fix motion all nve/sphere disc
fix plane all enforce2d
run 0
write_dump all custom read x y z radius modify sort id format line "%.17g %.17g %.17g %.17g"
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran hooke/history 1e6 NULL 0 NULL 0.5 0 yplane 0 NULL
run 200
write_dump all custom after x y z radius modify sort id format line "%.17g %.17g %.17g %.17g"
)";

const std::string in_liggghts = R"(units si
atom_style granular
atom_modify map array sort 0 0
boundary SIDES f p
newton off
communicate single vel yes
soft_particles yes
read_data discs
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
neighbor 0.1 bin
timestep 1e-5
fix motion all nve/sphere
run 0
write_dump all custom read x y z radius modify sort id format "%.17g %.17g %.17g %.17g"
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran model hertz tangential history primitive type 1 yplane 0
run 200
write_dump all custom after x y z radius modify sort id format "%.17g %.17g %.17g %.17g"
)";

const std::string in_yade = R"(from yade import ymport
O.bodies.append(ymport.text('discs', material=FrictMat(young=5e6, density=2650)))
def write(name):
    with open(name, 'w') as file:
        for b in O.bodies:
            if isinstance(b.shape, Sphere):
                file.write('%r %r %r %r\n' % (*b.state.pos, b.shape.radius))
write('read')
for b in O.bodies:
    b.state.blockedDOFs = 'zXY'
O.bodies.append(wall(0, 1, sense=1))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                    [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(gravity=(0, -9.81, 0), damping=0)]
O.dt = 1e-5
O.run(200, True)
write('after')
)";

const std::initializer_list<Engine> engines = {
    {"lammps", "lammps", "lmp", "lmp -in ", "run.in", in_lammps},
    {"liggghts", "liggghts", "liggghts", "liggghts -in ", "run.in", in_liggghts},
    {"yade", "yade", "yade", "yade -n -x ", "run.py", in_yade}};

/// Packs, exports, and lets the engine read the discs and move them for some steps.
void check_runs(const Engine &engine, const Arguments &pack, const std::string &sides) {
  if (!mdm_test::has_tool(engine.program, engine.package))
    return;
  INFO(engine.name << ", sides " << sides);
  const TemporaryFolder folder;
  Arguments packing{"pack", "-o", folder / "a.packing"};
  packing.insert(packing.end(), pack.begin(), pack.end());
  REQUIRE(mdm(packing).exit_code == 0);
  REQUIRE(mdm({"export", folder / "a.packing", "--to", engine.name, "-o", folder / "discs"}).exit_code == 0);
  std::string script = engine.script;
  if (const std::size_t at = script.find("SIDES"); at != std::string::npos)
    script.replace(at, 5, sides);
  folder.write(engine.input, script);
  const Outcome run =
      Process("/bin/sh", {"-c", "cd '" + (folder / ".") + "' && exec " + engine.command + engine.input})
          .end();
  INFO(run.out.substr(0, 20000) << run.err.substr(0, 2000));
  REQUIRE(run.exit_code == 0);
  const std::vector<Disc> written = discs_of(read_file(folder / "a.packing")),
                          read = rows_of(folder / "read"), after = rows_of(folder / "after");
  REQUIRE(written.size() > 50);
  CHECK(read == written);
  REQUIRE(after.size() == written.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    CHECK(after[i].z == 0);
    CHECK(after[i].r == written[i].r);
    // 2 ms of a fall.
    CHECK(std::abs(after[i].y - written[i].y) < 1e-4);
    moved += after[i].y != written[i].y ? 1U : 0U;
  }
  CHECK(moved > 0);
}

} // namespace

TEST_CASE("engines read a periodic packing of discs as it was written", "[engines]") {
  for (const Engine &engine : engines)
    check_runs(engine, {"--beta", "1,1", "--span", "0.6", "--classing", "geometric", "--at-least", "150"},
               "p");
}

TEST_CASE("engines read a packing of discs between walls as it was written", "[engines]") {
  for (const Engine &engine : engines)
    check_runs(engine,
               {"--beta", "1,1", "--span", "0.3", "--classing", "geometric", "--at-least", "150", "--walls"},
               "f");
}

TEST_CASE("engines read an Apollonian packing as it was written", "[engines]") {
  for (const Engine &engine : engines)
    check_runs(engine, {"--apollonian", "-1,2,2,3", "--smallest", "1/60"}, "f");
}

} // namespace packing_test

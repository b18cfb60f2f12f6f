// The models that mdm export writes, run by the engines themselves: LIGGGHTS, LAMMPS and YADE settle real
// sands for a bounded number of steps, and mdm verify reads back what they have.

#include "support.hpp"

#include <cmath>

namespace settle_test {

using namespace cli_test;

namespace {

void check_settles(const Engine &engine, const std::string &gradation) {
  if (is_there(engine))
    Model(engine, gradation).check_settles();
}

std::string athabasca() {
  return read_file(example("athabasca-sand"));
}

std::string c778() {
  return read_file(example("c778-graded-sand"));
}

// Nothing between 0.2 and 0.6 mm, the finest below the 0.124 mm that LIGGGHTS takes by itself.
const std::string gap_graded = "size_mm,mass\n0.075,12\n0.15,8\n0.2,0\n0.4,0\n0.6,50\n0.85,30\n1.18,0\n";
const std::string silt = "size_um,passing_percent\n60,100\n40,91\n20,52\n10,20\n6,7.5\n3,0\n";

} // namespace

TEST_CASE("LIGGGHTS settles Athabasca sand", "[engines]") {
  check_settles(liggghts, athabasca());
}

TEST_CASE("LAMMPS settles Athabasca sand", "[engines]") {
  check_settles(lammps, athabasca());
}

TEST_CASE("YADE settles Athabasca sand", "[engines]") {
  check_settles(yade, athabasca());
}

TEST_CASE("LIGGGHTS settles C778 graded sand", "[engines]") {
  check_settles(liggghts, c778());
}

TEST_CASE("LAMMPS settles C778 graded sand", "[engines]") {
  check_settles(lammps, c778());
}

TEST_CASE("YADE settles C778 graded sand", "[engines]") {
  check_settles(yade, c778());
}

TEST_CASE("all engines settle a gap-graded sand with empty classes", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade})
    check_settles(engine, gap_graded);
}

TEST_CASE("all engines settle a silt given in micrometres", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade})
    check_settles(engine, silt);
}

TEST_CASE("all engines settle a deposit", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade})
    if (is_there(engine))
      Model(engine, c778(), {"--start", "deposit", "--steps", "300", "--unjammed"}).check_settles();
}

TEST_CASE("LIGGGHTS and LAMMPS settle a deposit in a cylinder and in a periodic box", "[engines]") {
  for (const Engine &engine : {liggghts, lammps})
    for (const std::string sides : {"cylinder", "periodic"}) {
      if (!is_there(engine))
        continue;
      const Model model(engine, c778(),
                        {"--start", "deposit", "--sides", sides, "--box", "2x2", "--at-least", "300",
                         "--steps", "2000", "--unjammed"});
      model.check_settles({"--at-least", "300"});
      if (sides == "cylinder")
        for (const Grain &g : grains(read_file(model.dump())))
          CHECK(std::hypot(g.x - 0.001, g.y - 0.001) + g.r < 0.00101);
    }
}

TEST_CASE("LIGGGHTS stops where a grain of a deposit is missing", "[engines]") {
  if (!is_there(liggghts))
    return;
  const Model model(liggghts, c778(), {"--start", "deposit"});
  const std::string data = read_file(model.path("sand.data"));
  model.replace("sand.data", data.substr(data.rfind('\n', data.size() - 2)), "\n");
  model.replace("sand.data", "141 atoms", "140 atoms");
  const Outcome outcome = model.run();
  CHECK(outcome.exit_code != 0);
  CHECK(outcome.out.find("STOP: class 1 ") != std::string::npos);
  CHECK_FALSE(model.has_dump());
}

TEST_CASE("a start without steps has no overlaps", "[engines]") {
  if (!is_there(liggghts))
    return;
  const Model model(liggghts, athabasca(), {"--steps", "0", "--unjammed"});
  REQUIRE(model.run().exit_code == 0);
  const std::vector<Grain> all = grains(read_file(model.dump()));
  REQUIRE(all.size() == 1485);
  double least = INFINITY;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, std::hypot(all[i].x - all[j].x, all[i].y - all[j].y, all[i].z - all[j].z) /
                                  (all[i].r + all[j].r));
  CHECK(least >= 1);
}

TEST_CASE("a whole run lets the grains come to rest on the floor", "[engines]") {
  if (!is_there(lammps))
    return;
  const Model model(lammps, c778(), {});
  model.check_settles();
  const std::vector<Grain> all = grains(read_file(model.dump()));
  REQUIRE(all.size() == 141);
  const std::string data = read_file(model.path("sand.data"));
  const double height = std::stod(data.substr(data.rfind('\n', data.find(" zlo")) + 3));
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].z < height / 2);
    // Each touches the floor or others, and none is pressed into another by more than 3 % of the smaller.
    bool is_in_touch = all[i].z < 1.001 * all[i].r;
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double distance = std::hypot(all[i].x - all[j].x, all[i].y - all[j].y, all[i].z - all[j].z);
      const double gap = distance - all[i].r - all[j].r;
      is_in_touch = is_in_touch || (j != i && gap < 0.001 * all[i].r);
      if (j != i)
        CHECK(gap > -0.03 * std::min(all[i].r, all[j].r));
    }
    CHECK(is_in_touch);
  }
}

TEST_CASE("another seed puts the grains elsewhere, the same does not", "[engines]") {
  if (!is_there(liggghts))
    return;
  std::vector<std::string> dumps;
  for (const char *seed : {"1", "1", "2"}) {
    const Model model(liggghts, c778(), {"--steps", "0", "--unjammed", "--seed", seed});
    REQUIRE(model.run().exit_code == 0);
    dumps.push_back(read_file(model.dump()));
  }
  CHECK(dumps[0] == dumps[1]);
  CHECK(dumps[0] != dumps[2]);
}

TEST_CASE("LAMMPS stops where a grain is missing or has another size", "[engines]") {
  if (!is_there(lammps))
    return;
  {
    const Model model(lammps, c778());
    const std::string data = read_file(model.path("sand.data"));
    const std::size_t last = data.rfind('\n', data.size() - 2);
    model.replace("sand.data", data.substr(last), "\n");
    model.replace("sand.data", "141 atoms", "140 atoms");
    const Outcome outcome = model.run();
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.find("STOP: class 1 ") != std::string::npos);
    CHECK_FALSE(model.has_dump());
  }
  const Model model(lammps, c778());
  model.replace("sand.data", " 1 6.00", " 1 5.99");
  const Outcome outcome = model.run();
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find("STOP: class 5 ") != std::string::npos);
}

TEST_CASE("YADE stops where a grain is missing", "[engines]") {
  if (!is_there(yade))
    return;
  const Model model(yade, c778());
  const std::string list = read_file(model.path("sand.xyzr"));
  model.replace("sand.xyzr", list.substr(list.rfind('\n', list.size() - 2)), "\n");
  const Outcome outcome = model.run();
  CHECK(outcome.exit_code == 1);
  CHECK((outcome.out + outcome.err).find("STOP: class 1 ") != std::string::npos);
  CHECK_FALSE(model.has_dump());
}

namespace {

/// Exports Athabasca sand into a folder with a user's script, runs that, and judges the dump that it leaves.
void check_reads(const Engine &engine, const std::string &to, const std::string &script,
                 const Arguments &verification) {
  if (!is_there(engine))
    return;
  const TemporaryFolder folder;
  const Outcome exported = mdm({"export", example("athabasca-sand"), "--to", to, "-o", folder / "grains"});
  INFO(exported.err);
  REQUIRE(exported.exit_code == 0);
  folder.write(engine.model, script);
  const Outcome run =
      Process("/bin/sh", {"-c", "cd '" + (folder / ".") + "' && exec " + engine.command + engine.model})
          .end();
  INFO(run.out.substr(0, 20000) << run.err.substr(0, 2000));
  REQUIRE(run.exit_code == 0);
  Arguments arguments{"verify", example("athabasca-sand"), folder / "dump", "--tolerance", "1e-6"};
  arguments.insert(arguments.end(), verification.begin(), verification.end());
  const Outcome verdict = mdm(arguments);
  INFO(verdict.out << verdict.err);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find("particles: 1485;") != std::string::npos);
}

const std::string liggghts_material =
    "fix m1 all property/global youngsModulus peratomtype 5e6\n"
    "fix m2 all property/global poissonsRatio peratomtype 0.3\n"
    "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5\n"
    "fix m4 all property/global coefficientFriction peratomtypepair 1 0.5\n"
    "pair_style gran model hertz tangential history\n"
    "pair_coeff * *\n"
    "timestep 1e-7\n"
    "fix motion all nve/sphere\n";

const std::string liggghts_begin = "atom_style granular\n"
                                   "atom_modify map array\n"
                                   "boundary f f f\n"
                                   "newton off\n"
                                   "communicate single vel yes\n"
                                   "units si\n"
                                   "neighbor 1e-4 bin\n";

const std::string liggghts_dump =
    "write_dump all custom dump id type x y z radius modify format \"%d %d %.17g %.17g %.17g %.17g\"\n";

} // namespace

TEST_CASE("a user's model of LIGGGHTS includes the insertion", "[engines]") {
  check_reads(liggghts, "liggghts",
              liggghts_begin +
                  "region mdm_region block 0 0.002 0 0.002 0 0.012 units box\n"
                  "create_box 1 mdm_region\n" +
                  liggghts_material + "include grains\n" + liggghts_dump,
              {});
}

TEST_CASE("LIGGGHTS reads the data file of LAMMPS", "[engines]") {
  check_reads(liggghts, "lammps",
              liggghts_begin + "read_data grains\n" + liggghts_material + "run 1\n" + liggghts_dump, {});
}

TEST_CASE("a user's model of YADE reads the places", "[engines]") {
  check_reads(yade, "yade",
              "from yade import ymport\n"
              "O.bodies.append(ymport.text('grains'))\n"
              "with open('dump', 'w') as file:\n"
              "    for b in O.bodies:\n"
              "        file.write('%r %r %r %r\\n' % (*b.state.pos, b.shape.radius))\n",
              {"--size-unit", "m"});
}

} // namespace settle_test

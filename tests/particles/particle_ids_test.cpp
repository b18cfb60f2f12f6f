// Ids of particles: each is there once, in every format that has them.

#include "particles/particle_ids.hpp"
#include "replaced.hpp"
#include "support.hpp"

#include <set>

namespace particle_ids_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

std::string dump(const std::string &columns, const std::vector<std::string> &rows) {
  std::string text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(rows.size()) +
                     "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS " + columns + "\n";
  for (const std::string &row : rows)
    text += row + "\n";
  return text;
}

constexpr const char *again = "is there a second time";

} // namespace

TEST_CASE("a set of ids finds what is there twice, as a set of numbers does") {
  ParticleIds ids;
  std::set<std::uint64_t> numbers;
  std::uint64_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t id = i % 2 == 0 ? (state >> 33U) % 20000 : state >> 40U << 38U;
    CHECK(ids.insert(id) == numbers.insert(id).second);
  }
  ids.clear();
  CHECK(ids.insert(0));
  CHECK(ids.insert(UINT64_MAX));
  CHECK(ids.insert(63));
  CHECK(ids.insert(64));
  CHECK_FALSE(ids.insert(0));
  CHECK_FALSE(ids.insert(UINT64_MAX));
}

TEST_CASE("dumps: an id that is there twice in a timestep is refused with its line") {
  const std::string twice = dump("id radius", {"1 1", "3 2", "3 2"});
  CHECK(contains(refusal(twice), "file:12: id 3 is there a second time"));
  CHECK(read(replaced(twice, "3 2\n3 2", "3 2\n2 2")).particles == "2000 4000 4000");
  CHECK(contains(refusal(replaced(twice, "3 2\n3 2", "3 2\n2.5 2")), "file:12: id '2.5' is not a whole"));
  // Each timestep has all ids; one that is not asked for may be wrong.
  CHECK(read(dump("id radius", {"1 1"}) + dump("radius id", {"2 1", "2 2"})).particles == "4000 4000");
  const std::string other = replaced(dump("id radius", {"7 5"}), "TIMESTEP\n0", "TIMESTEP\n9");
  ParticleOptions options;
  options.timestep = 9;
  CHECK(read(twice + other, options).particles == "10000");
  CHECK(contains(refusal(dump("id id radius", {"1 2 1"})), "file:9: there are several columns id"));
  CHECK(contains(refusal(dump("id x x y z radius", {"1 2 1 1 1 1"})), "file:9: there are several columns x"));
}

TEST_CASE("an id that is there twice is refused in LAMMPS data, ESyS-Particle, MUSEN and extended XYZ") {
  const std::string data = "t\n\n2 atoms\n\nAtoms # sphere\n\n5 1 1e-3 2650 0 0 0\n6 1 1e-3 2650 1 1 1\n";
  CHECK(read(data).particles == "1 1");
  CHECK(contains(refusal(replaced(data, "6 1 1e-3", "5 1 1e-3")), "file:8: id 5 is there a second time"));
  const std::string snapshot = "2\n1 1 1 0.5 0 3 0.52\n2.5 1 1 .25 1 4 0.06\n";
  CHECK(read(snapshot).particles == "1000 500");
  CHECK(contains(refusal(replaced(snapshot, ".25 1 4", ".25 0 4")), "file:3: id 0 is there a second time"));
  const std::string scene = "0 1 1 1 5 0.5 0.5 23 KEY\n0 1 1 14 5 23 KEY\n0 2 1 1 5 0.25 0.3 23 KEY\n";
  CHECK(read(scene).particles == "1000 500");
  CHECK(contains(refusal(replaced(scene, "0 2 1 1", "0 1 1 1")), "file:3: id 1 is there a second time"));
  const std::string beads = "2\nProperties=id:I:1:radius:R:1\n8 1\n9 2\n";
  CHECK(read(beads).particles == "2 4");
  CHECK(contains(refusal(replaced(beads, "9 2", "8 2")), "file:4: id 8 is there a second time"));
  CHECK(read("2\nProperties=id:S:1:radius:R:1\na 1\na 2\n").particles == "2 4");
}

TEST_CASE("an id that is there twice is refused in CSV and in balls of PFC; of words that is said") {
  CHECK(read("id,size_mm\n7,1\n8,1\n").particles == "1 1");
  CHECK(contains(refusal("id,size_mm\n7,1\n7,1\n"), "file:3: id 7 is there a second time"));
  CHECK(contains(refusal("EVENT_LABEL,PFC_BALL_LOCX,PFC_BALL_LOCY,PFC_BALL_LOCZ,PFC_BALL_RADIUS\n1,0,0,0,1\n"
                         "2,0,0,3,1\n1,0,0,6,1\n"),
                 "file:4: id 1 is there a second time"));
  const Result words = read("id,size_mm\na,1\na,1\nb,1\n");
  CHECK(words.particles == "1 1 1");
  REQUIRE(words.notes.size() == 1);
  CHECK(contains(words.notes[0], "has words, such as 'a'"));
  // Rows of several particles have the id of a class.
  CHECK(read("id,size_mm,quantity\n7,1,3\n7,2,3\n").particles == "1*3 2*3");
}

TEST_CASE("Kratos: a node or an element that is there twice is refused, and a particle without its radius") {
  const std::string part =
      "Begin Nodes\n1 0 0 0\n2 0 0 3\n3 9 9 9\nEnd Nodes\nBegin Elements SphericParticle3D\n"
      "1 0 1\n2 0 2\nEnd Elements\nBegin NodalData RADIUS\n1 0 1\n2 0 1\nEnd NodalData\n";
  CHECK(read(part).particles == "2000 2000");
  CHECK(contains(refusal(replaced(part, "3 9 9 9", "2 0 0 3")), "file:4: node 2 is there a second time"));
  CHECK(contains(refusal(replaced(part, "2 0 2", "1 0 2")), std::string("file:8: id 1 ") + again));
  CHECK(contains(refusal(replaced(part, "2 0 2", "2 0 1")), "file:8: node 1 has a particle above"));
  CHECK(
      contains(refusal(replaced(part, "2 0 1\nEnd", "3 0 1\nEnd")), "the particle of node 2 has no radius"));
}

TEST_CASE("VTK: an id that is there twice among whole numbers is refused") {
  const std::string points =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 1 1\n"
      "POINT_DATA 2\nSCALARS id int 1\nLOOKUP_TABLE default\n4 5\n"
      "SCALARS radius double 1\nLOOKUP_TABLE default\n1 2\n";
  CHECK(read(points).particles == "2000 4000");
  CHECK(contains(refusal(replaced(points, "4 5", "4 4")), "file:10: id 4 is there a second time"));
  CHECK(read(replaced(replaced(points, "id int", "id float"), "4 5", "4 4")).particles == "2000 4000");
  CHECK(contains(refusal(replaced(points, "4 5", "4")), "file:11: id 'SCALARS' is not a whole number"));
}

} // namespace particle_ids_test

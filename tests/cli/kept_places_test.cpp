// mdm export of files of particles: their places stay, and their classes are those of a gradation or of
// groups of sizes.

#include "count.hpp"
#include "run.hpp"

#include <array>
#include <sstream>

namespace kept_places_test {

using namespace cli_test;
using mdm_test::count;

namespace {

/// Of LAMMPS: four grains, two of which overlap by 0.1 mm, in a box that begins at 1 m; diameters 2, 2, 1 and
/// 0.4 mm.
const std::string dump =
    "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS ff ff ff\n1 1.01\n0 0.01\n"
    "0 0.02\nITEM: ATOMS id type x y z radius\n1 1 1.002 0.002 0.001 0.001\n"
    "2 1 1.0039 0.002 0.001 0.001\n3 1 1.005 0.005 0.005 0.0005\n"
    "4 1 1.008 0.008 0.015 0.0002\n";
const std::string gradation = "size_mm,mass\n0.3,1\n0.5,1\n1.5,1\n2,0\n";

/// Rows `x y z r`.
std::vector<std::array<double, 4>> rows(const std::string &text) {
  std::vector<std::array<double, 4>> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::array<double, 4> row{};
    if (line[0] != '#' && words >> row[0] >> row[1] >> row[2] >> row[3])
      all.push_back(row);
  }
  return all;
}

} // namespace

TEST_CASE("a dump that is exported keeps its places, and says so", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.dump", dump);
  const Outcome outcome = mdm({"export", file, "--to", "yade"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.find("note: the particles stay where they lie in FILE") != std::string::npos);
  CHECK(outcome.out.find("no two particles overlap") == std::string::npos);
  const std::vector<std::array<double, 4>> all = rows(outcome.out);
  REQUIRE(all.size() == 4);
  const std::vector<std::array<double, 4>> expected = {{0.002, 0.002, 0.001, 0.001},
                                                       {0.0039, 0.002, 0.001, 0.001},
                                                       {0.005, 0.005, 0.005, 0.0005},
                                                       {0.008, 0.008, 0.015, 0.0002}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(all[i][j] == Approx(expected[i][j]).epsilon(1e-9));
  // With another start they are drawn anew, and do not overlap.
  const Outcome drawn = mdm({"export", file, "--to", "yade", "--start", "mixed"});
  REQUIRE(drawn.exit_code == 0);
  CHECK(drawn.out.find("no two particles overlap") != std::string::npos);
}

TEST_CASE("a dump keeps its places in a model, in the box that it has", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.dump", dump);
  const Outcome outcome = mdm({"export", file, "--to", "lammps", "--model", "settle", "--gradation",
                               folder.write("g.csv", gradation), "--types", "class", "-o", folder / "a.in"});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string data = read_file(folder / "a.data"), script = read_file(folder / "a.in");
  CHECK(data.find("\n0 0.01 xlo xhi\n0 0.01 ylo yhi\n0 0.02 zlo zhi\n") != std::string::npos);
  // Classes 1 and 3 have a grain and two; class 2 one.
  CHECK(data.find("\n4 atom types\n") != std::string::npos);
  CHECK(count(script, "grains are there, not 1'") == 2);
  CHECK(count(script, "class 3 (0.0015, 2e-3]: $n grains are there, not 2'") == 1);
}

TEST_CASE("particles of a file are in the classes of a gradation, or it says that they are not", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.dump", dump);
  const std::string narrow = folder.write("n.csv", "size_mm,mass\n0.5,1\n1.5,1\n2,0\n");
  check_refused(mdm({"export", file, "--to", "yade", "--gradation", narrow, "--quiet"}),
                "outside of all classes");
  const std::string sand = folder.write("sand.csv", gradation);
  check_refused(mdm({"export", sand, "--to", "yade", "--gradation", narrow}),
                "--gradation: it is of files of");
}

TEST_CASE("a set with a size a particle starts in a box that is no tower", "[cli]") {
  const TemporaryFolder folder;
  std::string sizes = "diameter_mm\n";
  for (int i = 0; i < 400; ++i)
    sizes += std::to_string(0.1 + 0.002 * i) + "\n" + std::to_string(0.1 + 0.0001 * i) + "\n";
  sizes += "3\n";
  const std::string file = folder.write("sizes.csv", sizes);
  const Outcome outcome =
      mdm({"export", file, "--to", "lammps", "--types", "class", "-o", folder / "a.data"});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string data = read_file(folder / "a.data");
  double x = 0, z = 0;
  REQUIRE(std::sscanf(data.c_str() + data.find("\n0 ") + 1, "0 %lf xlo", &x) == 1);
  REQUIRE(std::sscanf(data.c_str() + data.rfind("\n0 ", data.find(" zlo")) + 1, "0 %lf zlo", &z) == 1);
  CHECK(z < 3 * x);
  // 0.1 .. 0.141, .. 0.2, .. 0.283, .. 0.4, .. 0.566, .. 0.8, .. 0.9, and 3.
  CHECK(data.find("\n9 atom types\n") != std::string::npos);
}

TEST_CASE("places are kept where there are some, in the box that they have", "[cli]") {
  const TemporaryFolder folder;
  const std::string sizes = folder.write("sizes.csv", "diameter_mm\n1\n2\n");
  check_refused(mdm({"export", sizes, "--to", "yade", "--start", "as-is"}), "--start as-is");
  const std::string file = folder.write("a.dump", dump);
  check_refused(mdm({"export", file, "--to", "yade", "--start", "as-is", "--box", "5x5"}), "--box");
  std::string far = dump;
  far.replace(far.find("1.008"), 5, "1.018");
  check_refused(mdm({"export", folder.write("far.dump", far), "--to", "yade", "--quiet"}),
                "outside of the file's box");
  std::string cell = dump;
  cell.replace(cell.find("ff ff ff"), 8, "pp pp pp");
  check_refused(mdm({"export", folder.write("cell.dump", cell), "--to", "lammps", "--model", "settle",
                     "--quiet", "-o", folder / "a.in"}),
                "--periodic");
}

TEST_CASE("a tilted box is none that is known: the places are left out, and a tilt of 0 is none", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", "size_mm,mass\n1,1\n2,3\n4,0\n");
  const auto written = [&folder](const std::string &bounds) {
    return folder.write("tilted.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " +
                                           bounds +
                                           "ITEM: ATOMS id type x y z radius\n"
                                           "1 1 0.0008 0.002 0.0015 0.000833055\n"
                                           "2 1 0.0088 0.002 0.0015 0.001201473\n");
  };
  const auto verified = [&g](const std::string &file) {
    return mdm({"verify", g, file, "--tolerance", "1e-2"});
  };
  const std::string upright = verified(written("pp pp pp\n0 0.01\n0 0.01\n0 0.01\n")).out;
  CHECK(contains(upright, "periodic"));
  const std::string zero =
      verified(written("xy xz yz pp pp pp\n0 0.01 0\n0 0.01 -0.0\n0 0.01 0.0e+00\n")).out;
  CHECK(zero == upright);
  for (const std::string bounds : {"xy xz yz pp pp pp\n0 0.013 0.003\n0 0.01 0\n0 0.01 0\n",
                                   "abc origin pp pp pp\n0.01 0 0 0\n0.003 0.01 0 0\n0 0 0.01 0\n"}) {
    const Outcome tilted = verified(written(bounds));
    CHECK(tilted.exit_code == 0);
    CHECK(contains(tilted.out, "The box is tilted: the places are left out"));
    CHECK_FALSE(contains(tilted.out, "void ratio"));
    CHECK(mdm({"verify", g, folder / "tilted.dump", "--packing"}).exit_code == 2);
  }
  const std::string lattice =
      folder.write("t.xyz", "1\nLattice=\"0.01 0 0 0.003 0.01 0 0 0 0.01\" "
                            "Properties=pos:R:3:radius:R:1\n0.001 0.002 0.003 0.00075\n");
  CHECK(contains(mdm({"verify", g, lattice, "--size-unit", "m"}).out, "The box is tilted"));
  const std::string data =
      folder.write("t.data", "tilted\n\n1 atoms\n0 0.01 xlo xhi\n0 0.01 ylo yhi\n0 0.01 zlo zhi\n"
                             "0.003 0 0 xy xz yz\n\nAtoms # sphere\n\n1 1 0.0015 2650 0.0115 0.002 0.003\n");
  const Outcome outside = mdm({"verify", g, data, "--tolerance", "100%"});
  CHECK(contains(outside.out, "The box is tilted"));
  CHECK_FALSE(contains(outside.out, "outside the space"));
}

TEST_CASE("a box that is repeated stays so in other formats", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", "size_mm,mass\n1,1\n2,3\n4,0\n"),
                    repeated = folder.write("per.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n"
                                                        "ITEM: BOX BOUNDS pp pp pp\n0 0.01\n0 0.01\n0 0.01\n"
                                                        "ITEM: ATOMS id type x y z radius\n"
                                                        "1 1 0.0008 0.002 0.0015 0.000833055\n"
                                                        "2 1 0.0088 0.002 0.0015 0.001201473\n");
  const auto packing = [&](const std::string &file) {
    const std::string out = mdm({"verify", g, file, "--tolerance", "1e-2", "--packing"}).out;
    return out.substr(out.find("packing, "), 400);
  };
  const std::string xyz = folder / "per.xyz", esys = folder / "per.geo";
  REQUIRE(mdm({"export", repeated, "--to", "extxyz", "-o", xyz, "--quiet"}).exit_code == 0);
  REQUIRE(mdm({"export", repeated, "--to", "esys", "-o", esys, "--quiet"}).exit_code == 0);
  CHECK(contains(read_file(xyz), "pbc=\"T T T\""));
  CHECK(contains(read_file(esys), "PeriodicBoundaries 1 1 1\n"));
  CHECK(packing(xyz) == packing(repeated));
  CHECK(contains(mdm({"export", g, "--to", "gsd", "-o", folder / "g.gsd"}).err, "GSD has no walls"));
}

} // namespace kept_places_test

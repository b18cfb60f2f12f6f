// Files of particles that say two things, or something beside what is read.

#include "replaced.hpp"
#include "support.hpp"

namespace contradicting_files_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

ParticleOptions in(SizeUnit unit) {
  ParticleOptions options;
  options.unit = unit;
  return options;
}

const std::string script = "units si\n"
                           "fix t1 all particletemplate/sphere 11 atom_type 1 density constant 2650 radius "
                           "constant 0.001\n"
                           "fix t2 all particletemplate/sphere 13 atom_type 1 density constant 2650 radius "
                           "constant 0.002\n"
                           "fix d1 all particledistribution/discrete/numberbased 17 1 t1 1\n"
                           "fix d2 all particledistribution/discrete/numberbased 19 1 t2 1\n"
                           "fix i1 all insert/pack seed 5 distributiontemplate d1 region r "
                           "particles_in_region 24\n"
                           "fix i2 all insert/pack seed 7 distributiontemplate d2 region r "
                           "particles_in_region 29\n";

const std::string points = "<VTKFile type=\"PolyData\"><PolyData>\n"
                           "<Piece NumberOfPoints=\"1\"><PointData>\n"
                           "<DataArray Name=\"radius\" format=\"ascii\">0.001</DataArray></PointData>\n"
                           "<Points><DataArray format=\"ascii\">0 0 0</DataArray></Points></Piece>\n"
                           "</PolyData></VTKFile>\n";

} // namespace

TEST_CASE("insertions of LIGGGHTS: what may bring other particles is refused") {
  CHECK(read(script).particles == "2*24 4*5");
  CHECK(contains(refusal(replaced(script, " 17 1 t1 1", " 17 2 t1 0.5 &\n t2 0.5")),
                 "file:4: the line goes on in the next one"));
  CHECK(contains(refusal(replaced(script, " 17 1 t1", " 17 2 t1")),
                 "file:4: the distribution has '2' templates by its number"));
  CHECK(contains(refusal(replaced(script, "d2 region r", "d2 region other")),
                 "file:7: the region is 'other', and 'r' above"));
  for (const char *line : {"set type 1 diameter 0.005", "delete_atoms group all", "create_atoms 1 box",
                           "read_data start.data", "include more.in", "jump SELF loop"})
    CHECK(contains(refusal(script + line + "\n"), "file:8: what '"));
  CHECK(contains(refusal(script + "if \"$n > 3\" then \"fix i3 all insert/pack\"\n"),
                 "file:8: what an if does is not known"));
  CHECK(read(script + "# set and jump\nif \"$n > 3\" then \"print 'too few'\" quit\nrun 1\n").particles ==
        "2*24 4*5");
}

TEST_CASE("CSV: bounds of sizes and of their class are in one unit, and agree") {
  CHECK(read("lower_mm,upper_mm,size_lo_mm,size_hi_mm,quantity\n1,2,1.2,1.3,4\n").particles == "[1.2,1.3]*4");
  CHECK(contains(refusal("size_lo_um,size_hi_mm\n1.2,1.3\n"), "the columns of sizes have different units"));
  CHECK(contains(refusal("size_lo_um,size_hi\n1.2,1.3\n"), "the columns of sizes have different units"));
  CHECK(contains(refusal("lower_um,size_lo_mm,size_hi_mm\n2,1,1.3\n"), "lower and upper have another unit"));
  CHECK(contains(refusal("lower_um,upper_mm,size_lo_mm,size_hi_mm\n2,2,1,1.3\n"), "the other bound has"));
  CHECK(contains(refusal("lower_mm,size_lo_mm,size_hi_mm\n2,1,1.5\n"),
                 "file:2: a size between '1' and '1.5' is in no class of that lower and upper"));
  CHECK(contains(refusal("upper_mm,size_lo_mm,size_hi_mm\n1,1.1,1.5\n"), "file:2: a size between '1.1'"));
}

TEST_CASE("CSV: a row of no particles has a size or nothing") {
  CHECK(read("size_mm,quantity\n1.5,1\n,0\n3,0\n").particles == "1.5");
  CHECK(contains(refusal("size_mm,quantity\n1.5,1\nabc,0\n"), "file:3: diameter 'abc' is not a number"));
  CHECK(read("lower_mm,upper_mm,size_lo_mm,size_hi_mm,quantity\n1,2,1.2,1.3,4\n2,3,,,0\n").particles ==
        "[1.2,1.3]*4");
}

TEST_CASE("CSV: ids beside quantities are named in a note") {
  const Result result = read("id,size_mm,quantity\na,1.5,1\nb,1.2,4\n");
  CHECK(result.particles == "1.5 1.2*4");
  REQUIRE(result.notes.size() == 1);
  CHECK(contains(result.notes[0], "names 'a' and 'b': all rows were taken as one sample"));
  CHECK(read("id,size_mm,quantity\na,1.5,1\na,1.2,4\n").notes.empty());
}

TEST_CASE("x y z r: a heading says the unit, and names the columns that are read") {
  const std::string row = "0 0 0 0.75\n";
  CHECK(read("# x y z r in mm\n" + row).particles == "1.5");
  CHECK(read("# x y z r in micrometres\n" + row).particles == "0.0015");
  CHECK(read("# x y z r in m; box 1 2 3\n" + row).particles == "1500");
  CHECK(read("#x y z r in mm\n" + row).particles == "1.5");
  CHECK(read("# x y z r in mm\n" + row, in(SizeUnit::mm)).particles == "1.5");
  CHECK(contains(refusal("# x y z r in cubits\n" + row), "file:1: 'cubits' is no unit of lengths"));
  CHECK(contains(refusal("# x y z r in um\n" + row, in(SizeUnit::mm)), "the file says um in its heading"));
  for (const char *heading : {"# x y z d", "# x y z vx vy vz r", "# x y radius id", "# id x y z r",
                              "# id x y z r\n# of a box", "#x y z diameter"})
    CHECK(contains(refusal(std::string(heading) + "\n0 0 0 0.75 1 1 1\n", from(ParticleFormat::xyzr)),
                   "file:1: the columns are '"));
  ParticleOptions diameters;
  diameters.meaning = SizeMeaning::diameter;
  CHECK(read("# x y z d\n" + row, diameters).particles == "0.75");
  CHECK(contains(read("1 2 3 0.5 7 8\n").notes.at(0), "The lines have 6 numbers; the first four were taken"));
  CHECK(read("# x y z r u v w\n1 2 3 0.5 7 8 9\n").notes.size() == 1);
}

TEST_CASE("comments that name another unit ask for --size-unit") {
  for (const char *comment :
       {"# radii in um", "# units: um", "# length_unit=um", "# (um)", "# diameter in m"}) {
    CHECK(contains(refusal(std::string(comment) + "\n1.5\n2.5\n"), "file:1: the comment names "));
    CHECK(read(std::string(comment) + "\n1.5\n2.5\n", in(SizeUnit::mm)).particles == "1.5 2.5");
  }
  for (const char *comment : {"# of a box of 20 mm", "# mass m in kg, made in May", "# u v w"})
    CHECK(read(std::string(comment) + "\n1.5\n2.5\n").particles == "1.5 2.5");
  CHECK(contains(refusal("# radius_um\n1.5\n2.5\n"), "file:1: the comment names a column, 'radius_um'"));
}

TEST_CASE("diameters: a first number that counts the others is refused") {
  CHECK(contains(refusal("2\n1.5\n1.5\n"), "file:3: 2 is the number of the lines below it"));
  CHECK(read("2.0\n1.5\n1.5\n").particles == "2 1.5 1.5");
  CHECK(read("1\n1.5\n").particles == "1 1.5");
  CHECK(read("3\n1.5\n1.5\n").particles == "3 1.5 1.5");
}

TEST_CASE("VTP: numbers that would be passed over are refused") {
  CHECK(read(points).particles == "2");
  CHECK(contains(refusal(replaced(points, "0.001<", "0.001 <!-- more --> 0.9<")),
                 "file:3: the array 'radius' has a comment, or another tag, among"));
  CHECK(contains(refusal(replaced(points, "NumberOfPoints=\"1\"", "NumberOfPoints=\"0\"")),
                 "file:3: the array 'radius' has 1 numbers, and 0 points have 0"));
  CHECK(contains(refusal(replaced(points, "<Points>", "<PointData/>\n<Points>")),
                 "file:4: PointData is there a second time"));
}

TEST_CASE("other formats: what contradicts itself, or lacks a part, is refused") {
  CHECK(
      contains(refusal("X,Y,Z,r,clump_type\n0,0,0,0.00075,r0.5\n"), "file:1: there are columns r and clump"));
  CHECK(contains(refusal("Begin Nodes\n1 0 0 0\nEnd Elements\n"), "file:3: a block ends that did not begin"));
  const std::string data = "sample\n\n1 atoms\n0 1 xlo xhi\n\nAtoms # sphere\n\n1 1 0.0015 2650 0 0 0\n";
  CHECK(read(data).particles == "1.5");
  CHECK(contains(refusal(replaced(data, "1 atoms\n", "2 atoms\n1 atoms\n")),
                 "file:4: the number of atoms is there twice"));
  CHECK(contains(refusal(replaced(data, "sample", "sample, units=real")), "file:1: the units are 'real'"));
  CHECK(read(replaced(data, "sample", "sample, units=cgs")).particles == "0.015");
  const std::string dump =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 "
      "1\nITEM: ATOMS id radius\n1 0.00075\n";
  CHECK(contains(refusal(replaced(dump, "0 1\n0 1\n0 1\n", "0 1\n0 1\n")),
                 "file:8: the bounds of the box have fewer than three lines"));
  CHECK(contains(refusal("ITEM: UNITS\n" + dump), "file:2: there is no unit below ITEM: UNITS"));
  const std::string xyz = "1\nProperties=pos:R:3:radius:R:1\n0 0 0 0.75\n";
  for (const char *key : {"Units", "length_unit", "Length_Units"})
    CHECK(read(replaced(xyz, "R:1\n", std::string("R:1 ") + key + "=um\n")).particles == "0.0015");
  CHECK(contains(refusal("2\n0 0 0 0.1 0 1 1 0 0\n0 0 1 0.1 1 1 1 0 0\n0 0 2 5 2 1 1 0\n"),
                 "file:4: there are more particles than the 2"));
  CHECK(contains(refusal("p_x; p_y; p_z; diameters;\n0; 0; 0; 0.0015;\n0; 0; 1; 0.001\n"),
                 "file:3: the line does not end as the first one"));
  CHECK(read("p_x; p_y; p_z; diameters\n0; 0; 0; 0.0015\n").particles == "1.5");
}

TEST_CASE("dumps: a timestep that was not asked for may be cut off anywhere") {
  const std::string first = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id radius\n1 0.00075\n";
  const std::string last = "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id radius\n1";
  ParticleOptions options;
  options.timestep = 0;
  CHECK(read(first + last, options).particles == "1.5");
  CHECK(contains(refusal(first + last), "file:12: the line has 1 values"));
}

TEST_CASE("particle files: what could not be told is said") {
  CHECK(contains(refusal("0 0 0 0,75\n"), "file:1: the format is not one that is known"));
  CHECK(contains(refusal("\xFF\xFEs\n"), "file:1: the file is in UTF-16: save it in UTF-8"));
}

} // namespace contradicting_files_test

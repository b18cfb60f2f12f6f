// The places and boxes that files of each format give.

#include "particles/placed_sink.hpp"
#include "support.hpp"

namespace places_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Gradation two_classes() {
  Gradation::Data d;
  d.sizes = {1, 2, 4};
  d.masses = {1, 1, 0};
  return Gradation(std::move(d));
}

std::string text(const Rational &r) {
  return exact_decimal(abs(r)).value().insert(0, r < 0 ? "-" : "");
}

/// `x y z diameter class` of each particle, in mm, `;` between them, and then the box, `|` before each axis,
/// with a p where it is periodic. Class 0 is none.
std::string places(const std::string &content, const ParticleOptions &options = {}) {
  Recorder recorder;
  PlacedSink sink(two_classes(), recorder);
  ParticleReader reader("file", sink, options);
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    reader.line(std::string_view(content).substr(begin, end - begin));
    begin = end + 1;
  }
  reader.end();
  const SphereSample &sample = sink.sample();
  std::string all;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    all += i == 0 ? "" : "; ";
    for (std::size_t axis = 0; axis < 3; ++axis)
      all += text(sample.exact_coordinate(i, axis)) + " ";
    all += text(sample.exact_diameter(i)) + " ";
    all += std::to_string(sample.group(i) == SphereSample::no_group ? 0 : sample.group(i) + 1);
  }
  if (sink.box())
    for (std::size_t axis = 0; axis < 3; ++axis)
      all += "|" + text(sink.box()->sides.low[axis]) + " " + text(sink.box()->sides.high[axis]) +
             (sink.box()->periodic[axis] ? " p" : "");
  return all;
}

/// The message of what refuses the content.
std::string refused(const std::string &content) {
  try {
    places(content);
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

const std::string two = "1 -2.5 0.3 2 1; 4 5 6 3 2";

} // namespace

TEST_CASE("places of x y z r, of CSV, of ESyS-Particle, Lethe and Kratos") {
  CHECK(places("1 -2.5 .3 1\n4 5 6 1.5\n") == two);
  CHECK(places("x,y,z,size_mm\n1,-2.5,.3,2\n4,5,6,3\n") == two);
  CHECK(places("id,x_mm,y_mm,z_mm,radius_mm\n1,1,-2.5,.3,1\n2,4,5,6,1.5\n") == two);
  CHECK(places("x;y;z;diameter_um\n1000;-2500;300;2000\n4e3;5e3;6e3;3e3\n") == two);
  CHECK(places("size_m;x;y;z\n0,002;0,001;-0,0025;0,0003\n0,003;0,004;0,005;0,006\n") == two);
  CHECK(
      places(
          "LSMGeometry 1.2\nBoundingBox 0 -3e-3 0 9e-3 9e-3 9e-3\nPeriodicBoundaries 1 0 0\nBeginParticles\n"
          "Simple\n2\n1e-3 -2.5e-3 .3e-3 1e-3 0 0\n4e-3 5e-3 6e-3 1.5e-3 1 0\nEndParticles\n") ==
      two + "|0 9 p|-3 9|0 9");
  CHECK(places("2\n1e-3 -2.5e-3 .3e-3 1e-3 0 0 5\n4e-3 5e-3 6e-3 1.5e-3 1 0 5\n") == two);
  CHECK(places("diameters; p_z; p_y; p_x;\n2e-3; .3e-3; -2.5e-3; 1e-3;\n3e-3; 6e-3; 5e-3; 4e-3;\n",
               from(ParticleFormat::lethe)) == two);
  CHECK(
      places(
          "Begin Nodes\n2 4e-3 5e-3 6e-3\n1 1e-3 -2.5e-3 .3e-3\nEnd Nodes\nBegin Elements SphericParticle3D\n"
          "1 0 1\n2 0 2\nEnd Elements\nBegin NodalData RADIUS\n1 0 1e-3\n2 0 1.5e-3\nEnd NodalData\n") ==
      two);
  CHECK(places("X,Y,Z,clump_type\n1e-3,-2.5e-3,.3e-3,r1e-3\n4e-3,5e-3,6e-3,r1.5e-3\n") == two);
  CHECK(places("0 0 1 1 5 1e-3 1e-3 23 K 2 0 12 1e-3 -2.5e-3 .3e-3\n0 1 1 1 5 1.5e-3 1 23 K 2 0 12 4e-3 5e-3 "
               "6e-3\n") == two);
}

TEST_CASE("places and boxes of LAMMPS data files") {
  const std::string atoms =
      "\nAtoms # sphere\n\n1 1 2e-3 2650 1e-3 -2.5e-3 .3e-3\n2 1 3e-3 2650 4e-3 5e-3 6e-3\n";
  const std::string head = "title\n\n2 atoms\n1 atom types\n";
  const std::string box = "-1e-3 9e-3 xlo xhi\n-3e-3 9e-3 ylo yhi # side\n0 8e-3 zlo zhi\n";
  CHECK(places(head + box + atoms) == two + "|-1 9|-3 9|0 8");
  CHECK(places(head + atoms) == two);
}

TEST_CASE("places and boxes of the timestep that is taken of a dump") {
  const auto step = [](const std::string &number, const std::string &bounds, const std::string &atoms) {
    return "ITEM: TIMESTEP\n" + number + "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS " + bounds +
           "\nITEM: ATOMS " + atoms + "\n";
  };
  const std::string walls = "ff pp ff\n-1e-3 9e-3\n-3e-3 9e-3\n0 8e-3", plain = "\n0 1\n0 1\n0 1";
  const std::string here = "z radius y x\n.3e-3 1e-3 -2.5e-3 1e-3\n6e-3 1.5e-3 5e-3 4e-3";
  const std::string there = "id xu yu zu diameter\n1 1 1 1 2e-3\n2 2 2 2 2e-3";
  CHECK(places(step("1", plain, there) + step("2", walls, here)) == two + "|-1 9|-3 9 p|0 8");
  ParticleOptions first;
  first.timestep = 1;
  CHECK(places(step("1", walls, here) + step("2", plain, there), first) == two + "|-1 9|-3 9 p|0 8");
  CHECK(places(step("1", plain, there)) == "1000 1000 1000 2 1; 2000 2000 2000 2 1|0 1000|0 1000|0 1000");
  // Places in a tilted box say nothing without it.
  CHECK(contains(refused(step("1", "xy xz yz pp pp pp\n0 1 0.1\n0 1 0\n0 1 0", here)),
                 "without a place of their own"));
}

TEST_CASE("places and boxes of extended XYZ and of VTK") {
  const std::string properties = "Properties=species:S:1:pos:R:3:radius:R:1";
  const std::string atoms = "\nX 1 -2.5 .3 1\nX 4 5 6 1.5\n";
  CHECK(places("2\n" + properties + atoms) == two);
  CHECK(places("2\nLattice=\"9 0 0 0 8.5 0 0.0 0 7\" " + properties + atoms) == two + "|0 9 p|0 8.5 p|0 7 p");
  CHECK(places("2\nOrigin=\"-1 -3 0\" Lattice=\"9 0 0 0 8.5 0 0 0 7\" pbc=\"T F F\" " + properties + atoms) ==
        two + "|-1 8 p|-3 5.5|0 7");
  CHECK(contains(refused("2\nLattice=\"9 0 0 1 8 0 0 0 7\" " + properties + atoms),
                 "without a place of their own"));
  CHECK(places("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 double\n1e-3 -2.5e-3\n.3e-3 "
               "4e-3 5e-3 "
               "6e-3\nPOINT_DATA 2\nSCALARS radius double 1\nLOOKUP_TABLE default\n1e-3 1.5e-3\n") == two);
}

TEST_CASE("particles in no class are in no group, on a sieve in the finer one") {
  CHECK(places("0 0 0 0.5\n0 0 0 1\n0 0 0 1.0000001\n0 0 0 3\n") ==
        "0 0 0 1 0; 0 0 0 2 1; 0 0 0 2.0000002 2; 0 0 0 6 0");
}

TEST_CASE(
    "a coordinate that is no finite number is refused with its line, whether places are wanted or not") {
  const auto dump = [](const std::string &x) {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z radius\n" + x + " 0 0 1\n";
  };
  for (const char *x : {"nan", "-nan", "inf", "-inf", "NaN", "1,5,2", "0x1p3", ""})
    if (*x != '\0')
      CHECK(contains(refusal(dump(x)), "file:6: coordinate '" + std::string(x) + "' is not a finite number"));
  CHECK(read(dump("-1.5e-3")).particles == "2000");
  CHECK(contains(refusal("x,y,z,r\n0,0,0,1\n0,nan,0,1\n"), "file:3: coordinate 'nan' is not a finite"));
  CHECK(contains(refusal("x,y,z,r,quantity\n0,nan,0,1,2\n"), "file:2: coordinate 'nan' is not a finite"));
  CHECK(
      contains(refusal("0 0 0 1\ninf 0 0 1\n", from(ParticleFormat::xyzr)), "file:2: 'inf' is not a number"));
}

TEST_CASE("centres outside the box of a file are counted, also beyond the places that are kept") {
  const auto dump = [](const std::string &sides, const std::string &atoms, int n) {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + std::to_string(n) + "\nITEM: BOX BOUNDS " + sides +
           "\n0 3e-3\n0 3e-3\n0 3e-3\nITEM: ATOMS x y z radius\n" + atoms;
  };
  const auto objection = [](const std::string &content, std::optional<std::size_t> most = std::nullopt) {
    Recorder recorder;
    PlacedSink sink(two_classes(), recorder, most);
    ParticleReader reader("file", sink, {});
    for (std::size_t begin = 0; begin < content.size(); begin = content.find('\n', begin) + 1)
      reader.line(std::string_view(content).substr(begin, content.find('\n', begin) - begin));
    reader.end();
    return sink.objection("--periodic").value_or("");
  };
  const std::string inside = "0.001 0.001 0.001 1e-3\n";
  CHECK(objection(dump("ff ff ff", inside, 1)).empty());
  CHECK(objection(dump("ff ff ff", "0 0.003 0.003 1e-3\n", 1)).empty()); // on the sides
  CHECK(contains(objection(dump("ff ff ff", inside + "0.001 0.001 -5 1e-3\n", 2)),
                 "the centre of 1 particle is outside the space of the sample, the first at 0.001 0.001 -5"));
  CHECK(
      contains(objection(dump("ff ff ff", "0.001 0.001 0.00300000000000000000001 1e-3\n", 1)), "1 particle"));
  CHECK(objection(dump("ff ff pp", "0.001 0.001 -5 1e-3\n", 1)).empty());
  CHECK(contains(objection(dump("pp ff pp", "1 -1 1 1e-3\n1 1 1 1e-3\n", 2)),
                 "the centres of 2 particles are"));
  CHECK(contains(objection(dump("ff ff ff", inside + inside + "0 0 9 1e-3\n", 3), 1), "the first at 0 0 9"));
  // A timestep that is not the last does not count.
  CHECK(objection(dump("ff ff ff", "9 9 9 1e-3\n", 1) + dump("ff ff ff", inside, 1)).empty());
}

TEST_CASE("a cylinder holds what lies in its circle; a box without a top what lies high") {
  SampleSpace space;
  space.box = SpaceBox{{0, 0, 0}, {2, 2, 5}};
  const auto holds = [&space](const char *x, const char *y, const char *z) {
    return Container(space).holds({x, y, z}, 1);
  };
  CHECK(holds("0.1", "0.1", "5"));
  CHECK_FALSE(holds("0.1", "0.1", "5.1"));
  space.has_top = false;
  CHECK(holds("0.1", "0.1", "5.1"));
  CHECK_FALSE(holds("0.1", "0.1", "-0.1"));
  space.is_cylinder = true;
  CHECK_FALSE(holds("0.1", "0.1", "1"));
  CHECK(holds("0", "1", "1"));
  CHECK_FALSE(holds("-0.0000000000000000001", "1", "1"));
}

} // namespace places_test

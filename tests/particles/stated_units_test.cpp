// Units that a file of particles states, and sizes that it states twice.

#include "replaced.hpp"
#include "support.hpp"

namespace stated_units_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

std::string dump(const std::string &columns, const std::string &row) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: "
         "ATOMS " +
         columns + "\n" + row + "\n";
}

ParticleOptions in(SizeUnit unit) {
  ParticleOptions options;
  options.unit = unit;
  return options;
}

ParticleOptions as(SizeMeaning meaning) {
  ParticleOptions options;
  options.meaning = meaning;
  return options;
}

} // namespace

TEST_CASE("dumps: ITEM: UNITS says the unit of lengths") {
  const auto with = [](const std::string &style) {
    return "ITEM: UNITS\n" + style + "\n" + dump("diameter", "3");
  };
  CHECK(read(with("si")).particles == "3000");
  CHECK(read(with("cgs")).particles == "30");
  CHECK(read(with("micro")).particles == "0.003");
  CHECK(read(with("nano")).particles == "0.000003");
  CHECK(contains(read(with("cgs")).notes.at(0), "diameters in cm, as the file says."));
  for (const char *style : {"lj", "real", "metal", "electron", "furlong"})
    CHECK(
        contains(refusal(with(style)), "file:2: the units are '" + std::string(style) + "', whose lengths"));
  // A later timestep of the same run does not say it again.
  CHECK(read(with("cgs") + dump("diameter", "4")).particles == "40");
  CHECK(contains(refusal(with("cgs") + with("micro")), "units micro below particles in cm"));
}

TEST_CASE("a unit that is given beside another one that the file states is refused") {
  const std::string cgs = "ITEM: UNITS\ncgs\n" + dump("diameter", "3");
  CHECK(contains(refusal(cgs, in(SizeUnit::m)),
                 "file:2: the file says units cgs, which is lengths in cm, and m was given: leave that out"));
  CHECK(read(replaced(cgs, "cgs", "micro"), in(SizeUnit::um)).particles == "0.003");
  CHECK(read(dump("diameter", "3"), in(SizeUnit::um)).particles == "0.003");
}

TEST_CASE("LAMMPS data: the title of write_data says the unit of lengths") {
  const std::string data =
      "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 7, units = cgs\n\n1 atoms\n\n"
      "Atoms # sphere\n\n1 1 3 2650 0 0 0\n";
  CHECK(read(data).particles == "30");
  CHECK(read(replaced(data, "units = cgs", "units = micro, made by me")).particles == "0.003");
  CHECK(read(replaced(data, "units = cgs", "no units")).particles == "3000");
  CHECK(contains(refusal(replaced(data, "= cgs", "= lj")), "file:1: the units are 'lj'"));
  CHECK(contains(refusal(data, in(SizeUnit::mm)), "file:1: the file says units cgs"));
}

TEST_CASE("scripts of LIGGGHTS: the command units says the unit of lengths") {
  const std::string script =
      "units cgs\nfix t all particletemplate/sphere 1 atom_type 1 density constant 1 radius constant 3\n"
      "fix d all particledistribution/discrete/numberbased 3 1 t 1\n"
      "fix i all insert/pack seed 5 distributiontemplate d particles_in_region 2 region r\n";
  const ParticleOptions scripts = from(ParticleFormat::liggghts_insertion);
  CHECK(read(script, scripts).particles == "60*2");
  CHECK(read(replaced(script, "units cgs\n", ""), scripts).particles == "6000*2");
  CHECK(contains(refusal(replaced(script, "cgs", "lj"), scripts), "file:1: the units are 'lj'"));
  CHECK(contains(refusal(replaced(script, "units cgs\n", "") + "units cgs\n", scripts),
                 "units cgs below particles in m"));
}

TEST_CASE("extended XYZ: a unit in its comment is taken or refused") {
  CHECK(read("1\nunits=um Properties=radius:R:1\n3\n").particles == "0.006");
  CHECK(read("1\nProperties=radius:R:1 unit=\"m\"\n3\n").particles == "6000");
  CHECK(contains(refusal("1\nunits=sigma Properties=radius:R:1\n3\n"),
                 "file:2: units='sigma' is no unit of lengths"));
}

TEST_CASE("a radius and a diameter of a particle agree, or are refused unless one is asked for") {
  const auto check = [](const std::string &both, const std::string &good, const std::string &where) {
    INFO(both);
    CHECK(contains(refusal(both), where + "radius '1.5' is not half of diameter '2'"));
    CHECK(read(both, as(SizeMeaning::radius)).particles == "3000");
    CHECK(read(both, as(SizeMeaning::diameter)).particles == "2000");
    CHECK(read(good).particles == "3000");
  };
  const std::string columns = dump("id radius diameter", "1 1.5 2");
  check(columns, replaced(columns, "1 1.5 2", "1 1.5 3.0e0"), "file:10: ");
  const std::string beads = "1\nunit=m Properties=diameter:R:1:radius:R:1\n2 1.5\n";
  check(beads, replaced(beads, "2 1.5", "3.00 1.5"), "file:3: ");
}

TEST_CASE("VTK: arrays radius and diameter agree; none is there twice") {
  const auto file = [](const std::string &arrays) {
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 1 1\nPOINT_DATA "
           "2\n" +
           arrays;
  };
  const std::string radius = "SCALARS radius double 1\nLOOKUP_TABLE default\n1 2\n";
  const std::string both = file(radius + "FIELD f 1\ndiameter 1 2 double\n2 4\n");
  CHECK(read(both).particles == "2000 4000");
  CHECK(contains(refusal(replaced(both, "2 4", "2 5")), "file:13: radius '2' is not half of diameter '5'"));
  CHECK(contains(refusal(both, as(SizeMeaning::diameter)), "choose none: leave one out"));
  CHECK(contains(refusal(file(radius + radius)), "file:11: there are several arrays of that name"));
  const std::string diameter = "SCALARS diameter double 1\nLOOKUP_TABLE default\n2 4\n";
  CHECK(read(file(diameter + radius)).particles == "2000 4000");
  CHECK(contains(refusal(file(replaced(diameter, "2 4", "2 2") + radius)),
                 "radius '2' is not half of diameter '2'"));
}

TEST_CASE("CSV of particles: no column is there twice") {
  CHECK(contains(refusal("x,x,y,z,r\n0,0,0,0,1\n"), "file:1: column 'x': there is one of this meaning"));
  CHECK(contains(refusal("x_mm,x_m,y_m,z_m,radius_m\n0,0,0,0,1\n"), "file:1: column 'x_m': there is one"));
  CHECK(contains(refusal("id,id,r\n1,1,1\n"), "file:1: column 'id': there is one of this meaning"));
}

TEST_CASE("dumps: of a timestep that is there several times the last counts, and a note says so") {
  const std::string twice = dump("radius", "1") + dump("radius", "2");
  ParticleOptions zero;
  zero.timestep = 0;
  const Result result = read(twice, zero);
  CHECK(result.particles == "4000");
  CHECK(contains(result.notes.at(0), "Timestep 0 is there 2 times; the last was taken."));
  CHECK(read(dump("radius", "1"), zero).notes.size() == 1);
}

} // namespace stated_units_test

// x y z r and lists of diameters.

#include "support.hpp"

namespace particle_list_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("x y z r: radii in the unit of the gradation") {
  const Result result = read("# x_y_z_r\n0 0 0 0.5\n\n 1\t2 3.5e-3 .25 \r\n");
  CHECK(result.particles == "1 0.5");
  CHECK(result.format == ParticleFormat::xyzr);
  REQUIRE(result.notes.size() == 1);
  CHECK(contains(result.notes[0], "radii in mm"));
  ParticleOptions options;
  options.unit = SizeUnit::m;
  options.meaning = SizeMeaning::diameter;
  CHECK(read("0 0 0 0.5\n", options).particles == "500");
  CHECK(read("0 0 0 0.5\n", options).notes.empty());
  options.target = SizeUnit::um;
  CHECK(read("0 0 0 5e-4\n", options).particles == "500");
  CHECK(read("#format x_y_z_r_matId\n0 0 0 1 7\n").particles == "2");
  CHECK(contains(refusal("#format id_x_y_z_r_matId\n1 0 0 0 1 7\n"), "file:1: the columns are"));
  CHECK(contains(refusal("0 0 0 1\n0 0 0\n"), "file:2: the line has 3 numbers, the first has 4"));
  CHECK(contains(refusal("0 0 0 1\n0 0 0 nan\n"), "file:2: radius 'nan' is not a number"));
  CHECK(contains(refusal("0 0 0 1\na b c 1\n"), "file:2: 'a' is not a number: write x y z r"));
  CHECK(contains(refusal("nan 0 0 1\n", from(ParticleFormat::xyzr)), "file:1: 'nan' is not a number"));
  for (const char *number : {"1", "-1.", "+.5", "1e3", "-2.5E-03"})
    CHECK(read(number + std::string(" 0 0 1\n"), from(ParticleFormat::xyzr)).particles == "2");
  for (const char *word : {"-", ".", "1e", "1e+", "e5", "1.2.3", "0x1", "inf", "1,5"})
    CHECK(contains(refusal(word + std::string(" 0 0 1\n"), from(ParticleFormat::xyzr)), "is not a number"));
  CHECK(contains(refusal("0 0 1\n", from(ParticleFormat::xyzr)), "file:1: the line has fewer than four"));
}

TEST_CASE("diameters: one a line, radii if told so") {
  CHECK(read("1.5\n# comment\n2e-1\n").particles == "1.5 0.2");
  CHECK(read("1.5\n").format == ParticleFormat::diameters);
  ParticleOptions options;
  options.meaning = SizeMeaning::radius;
  options.unit = SizeUnit::um;
  CHECK(read("1.5\n", options).particles == "0.003");
  CHECK(contains(refusal("1\n2 3\n"), "file:2: the line is not one number"));
  CHECK(contains(refusal("1\n0\n"), "file:2: diameter '0' is not above 0"));
  CHECK(contains(refusal("1\n" + std::string(1001, '1') + "\n"), "more than 1000 digits"));
}

TEST_CASE("particle files: an unknown format names those there are") {
  CHECK(contains(refusal(""), "there are no particles"));
  CHECK(contains(refusal("# only\n#comments\n"), "file:2: there are no particles"));
  CHECK(contains(refusal("title\nsome text\n"),
                 "file:2: the format is not one that is known: say it with --from, "
                 "one of csv, answer, xyzr"));
  CHECK(contains(refusal("1 2\n"), "file:1: the format is not one"));
  CHECK(contains(refusal(std::string(3000, '\n')), "file:1000: the format is not clear by now"));
  CHECK(contains(refusal("#" + std::string(10000, ' ') + "\n"), "file:1: the format is not clear by now"));
  CHECK(contains(refusal("{}\n"), "an answer of mdm"));
  ParticleOptions options;
  options.timestep = 3;
  CHECK(contains(refusal("1\n", options), "--timestep is for dumps, and this is diameters"));
  for (const char *name : {"csv", "answer", "xyzr", "lammps-data", "lammps-dump", "liggghts-dump",
                           "liggghts-insertion", "mercurydpm", "vtk", "diameters", "extxyz", "esys", "lethe",
                           "kratos", "dem-engine", "musen", "gsd", "phasicflow", "vtp"})
    CHECK(mdm::name(parse_particle_format(name).value()) == name);
  CHECK_FALSE(parse_particle_format("xyz"));
}

TEST_CASE("particle files: what is packed or binary is refused with what to do") {
  using namespace std::string_literals;
  for (const ParticleOptions &options : {ParticleOptions{}, from(ParticleFormat::lammps_dump)}) {
    CHECK(contains(refusal("LammpS RestartT\0\1\n1\n"s, options),
                   "file:1: the file is binary, which is not read"));
  }
  CHECK(read("1\n2\n").particles == "1 2");
}

} // namespace particle_list_test

// Files of LAMMPS, LIGGGHTS and VTK.

#include "replaced.hpp"
#include "support.hpp"

namespace engine_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

const std::string data = "LAMMPS data file via write_data, timestep = 100\n"
                         "\n"
                         "3 atoms\n"
                         "2 atom types\n"
                         "\n"
                         "0.0 0.02 xlo xhi\n"
                         "0.0 0.02 ylo yhi\n"
                         "0.0 0.02 zlo zhi\n"
                         "\n"
                         "Atoms # sphere\n"
                         "\n"
                         "1 1 0.001 2650 0.01 0.01 0.01 0 0 0\n"
                         "2 1 0.002 2650 0.012 0.01 0.01 0 0 0 # the second\n"
                         "3 2 0.0025 2650 0.01 0.015 0.01 0 0 0\n";

std::string timestep(const std::string &number, const std::string &columns,
                     const std::vector<std::string> &rows) {
  std::string text = "ITEM: TIMESTEP\n" + number + "\nITEM: NUMBER OF ATOMS\n" + std::to_string(rows.size()) +
                     "\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\nITEM: ATOMS " + columns + " \n";
  for (const std::string &row : rows)
    text += row + " \n";
  return text;
}

const std::string vtk_points = "# vtk DataFile Version 3.0\n"
                               "radius radius radius radius\n"
                               "ASCII\n"
                               "DATASET POLYDATA\n"
                               "POINTS 3 float\n"
                               "0 0 0 1 1 1\n"
                               "2 2 2\n"
                               "VERTICES 3 6\n"
                               "1 0\n1 1\n1 2\n"
                               "POINT_DATA 3\n";

} // namespace

TEST_CASE("LAMMPS data: diameters in metres") {
  const Result result = read(data);
  CHECK(result.particles == "1 2 2.5");
  CHECK(result.format == ParticleFormat::lammps_data);
  REQUIRE(result.notes.size() == 1);
  CHECK(contains(result.notes[0], "diameters in m."));
  CHECK(read(data + "\nVelocities\n\n1 0 0 0 0 0 0\n2 0 0 0 0 0 0\n").particles == "1 2 2.5");
  CHECK(read(replaced(data, "Atoms # sphere", "Velocities\n\n1 0 0 0\n\nAtoms # sphere")).particles ==
        "1 2 2.5");
  // LIGGGHTS writes no style.
  const Result nameless = read(replaced(data, " # sphere", ""));
  CHECK(nameless.particles == "1 2 2.5");
  CHECK(contains(nameless.notes[0], "names no style"));
}

TEST_CASE("LAMMPS data: broken files") {
  const auto broken = [](const std::string &part, const std::string &by) {
    return refusal(replaced(data, part, by), from(ParticleFormat::lammps_data));
  };
  CHECK(contains(broken("3 atoms", "4 atoms"), "file:14: the section Atoms ends after 3 of 4 atoms"));
  CHECK(contains(broken("3 atoms", "2 atoms"), "file:14: there are more atoms than the 2"));
  CHECK(contains(broken("3 atoms", "x atoms"), "file:3: 'x' is no number of atoms"));
  CHECK(contains(broken("3 atoms", ""), "file:10: the header has no number of atoms"));
  CHECK(contains(broken("# sphere", "# full"), "file:10: atom_style 'full' has no diameters"));
  CHECK(contains(broken("0.002 ", ""), "file:13: the line has 9 numbers"));
  CHECK(contains(broken("0.002 ", "zero "), "file:13: diameter 'zero' is not a number"));
  CHECK(contains(broken("0.012 0.01 0.01", "0.012 a 0.01"), "file:13: 'a' is not a number"));
  CHECK(contains(broken("2 1 0.002", "2 sand 0.002"), "file:13: 'sand' is not a number"));
  CHECK(contains(broken("0.002 ", "0 "), "file:13: diameter '0' is not above 0"));
  CHECK(contains(broken("Atoms # sphere", "Particles"), "the section Atoms is missing"));
  CHECK(contains(refusal(data + "\nAtoms\n\n"), "file:16: the section Atoms is there twice"));
  check_truncations(data, from(ParticleFormat::lammps_data));
}

TEST_CASE("dumps: the column says whether sizes are radii") {
  const std::string radii = timestep("100", "id type x y z radius", {"1 1 0 0 0 0.001", "2 1 0 0 0 0.002"});
  CHECK(read(radii).particles == "2 4");
  CHECK(read(radii).format == ParticleFormat::lammps_dump);
  CHECK(read(radii, from(ParticleFormat::liggghts_dump)).particles == "2 4");
  CHECK(contains(read(radii).notes.at(0), "radii in m."));
  CHECK(read(timestep("0", "diameter id", {"0.001 7"})).particles == "1");
  const std::string both = timestep("0", "id radius diameter", {"1 0.5 2"});
  ParticleOptions options;
  options.meaning = SizeMeaning::diameter;
  CHECK(read(both, options).particles == "2000");
  CHECK(read(radii, options).particles == "1 2");
  CHECK(contains(refusal(timestep("0", "id x y z", {})), "file:9: there is no column radius or diameter"));
}

TEST_CASE("dumps: a column of sizes that is named") {
  ParticleOptions options;
  options.size_column = "c_r";
  options.meaning = SizeMeaning::radius;
  const std::string dump = timestep("0", "id radius c_r", {"1 9 0.001", "2 9 0.002"});
  CHECK(read(dump, options).particles == "2 4");
  options.meaning = SizeMeaning::diameter;
  CHECK(read(dump, options).particles == "1 2");
  options.size_column = "v_d";
  CHECK(contains(refusal(dump, options), "there is no column 'v_d'"));
}

TEST_CASE("dumps: the last timestep, or the one that is asked for") {
  const std::string steps = "ITEM: UNITS\nsi\nITEM: TIME\n0\n" + timestep("0", "radius", {"1", "2"}) +
                            "ITEM: TIME\n1\n" + timestep("50", "id radius", {"1 3"}) +
                            timestep("100", "radius", {"4", "5"});
  const Result last = read(steps);
  CHECK(last.particles == "8000 10000");
  CHECK(contains(last.notes.at(0), "3 timesteps; the last, 100"));
  ParticleOptions options;
  options.timestep = 50;
  CHECK(read(steps, options).particles == "6000");
  options.timestep = 0;
  CHECK(read(steps, options).particles == "2000 4000");
  CHECK(read(steps, options).notes.size() == 1);
  options.timestep = 7;
  CHECK(contains(refusal(steps, options), "there is no timestep 7: there are 3, from 0 to 100"));
  // A dump that was cut off still has its earlier timesteps.
  const std::string cut = steps.substr(0, steps.size() - 4);
  CHECK(contains(refusal(cut), "the timestep ends after 1 of 2 atoms"));
  options.timestep = 50;
  CHECK(read(cut, options).particles == "6000");
  CHECK(contains(refusal(timestep("0", "radius", {"1"}) + timestep("1", "radius", {})),
                 "there are no particles"));
}

TEST_CASE("dumps: broken files") {
  const std::string good = timestep("0", "id radius", {"1 1", "2 1"});
  const auto broken = [&good](const std::string &part, const std::string &by) {
    return refusal(replaced(good, part, by), from(ParticleFormat::lammps_dump));
  };
  CHECK(contains(broken("ATOMS\n2", "ATOMS\n3"), "file:11: the timestep ends after 2 of 3 atoms"));
  CHECK(contains(broken("ATOMS\n2", "ATOMS\n1"), "file:11: there are more atoms than the 1"));
  CHECK(contains(broken("ATOMS\n2", "ATOMS\nmany"), "file:4: the number of atoms is not a whole number"));
  CHECK(contains(broken("TIMESTEP\n0", "TIMESTEP\nx"), "file:2: the timestep is not a whole number"));
  CHECK(contains(broken("2 1", "2"), "file:11: the line has 1 values, there are 2 columns"));
  CHECK(contains(broken("2 1", "2 1e999"), "file:11: radius '1e999' has an exponent beyond 400"));
  CHECK(contains(broken("ITEM: NUMBER OF ATOMS\n2\n", ""), "ITEM: ATOMS has no ITEM: TIMESTEP"));
  CHECK(contains(broken("ITEM: TIMESTEP\n0\n", ""), "ITEM: ATOMS has no ITEM: TIMESTEP"));
  CHECK(contains(broken("ITEM: TIMESTEP", "0"), "file:1: the line is not below an ITEM"));
  CHECK(
      contains(refusal(timestep("0", "radius radius", {"1 2"})), "file:9: there are several columns radius"));
  CHECK(contains(refusal(good + "ITEM: ATOMS id radius\n"), "ITEM: ATOMS has no ITEM: TIMESTEP"));
  CHECK(contains(refusal("ITEM: UNITS\nsi\n"), "there is no ITEM: TIMESTEP"));
  check_truncations(good, from(ParticleFormat::lammps_dump));
  // A timestep that begins and has no atoms is cut off, even behind a good one.
  const std::string header = "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\n";
  for (const std::size_t end : {15U, 17U, 39U})
    CHECK(contains(refusal(good + header.substr(0, end)), "the timestep ends after 0 of its atoms"));
  CHECK(contains(refusal(good + header), "ends after 0 of 2 atoms"));
}

TEST_CASE("VTK: an array radius or diameter") {
  const std::string scalars = vtk_points +
                              "SCALARS id int 1\nLOOKUP_TABLE default\n1 2 3\n"
                              "SCALARS radius double 1\nLOOKUP_TABLE default\n0.001 0.002\n0.003\n"
                              "VECTORS v float\n0 0 0 1 1 1 2 2 2\n";
  const Result result = read(scalars);
  CHECK(result.particles == "2 4 6");
  CHECK(result.format == ParticleFormat::vtk);
  CHECK(contains(result.notes.at(0), "radii in m."));
  CHECK(read(vtk_points + "scalars Diameter double\n1 2 3\n").particles == "1000 2000 3000");
  std::string many = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 5000 float\n";
  for (int i = 0; i < 5000; ++i)
    many += "0 1 -2e-3 ";
  many += "\nPOINT_DATA 5000\nSCALARS radius float\nLOOKUP_TABLE default\n";
  for (int i = 0; i < 5000; ++i)
    many += "0.5 ";
  CHECK(read(many).particles.size() == 5000 * 5 - 1); // 1000 each
  const std::string field = vtk_points + "FIELD FieldData 2\nid 1 3 int\n1 2 3\ndiameter 1 3 double\n1 2 3\n";
  CHECK(read(field).particles == "1000 2000 3000");
  CHECK(read(replaced(scalars, "POLYDATA", "UNSTRUCTURED_GRID")).particles == "2 4 6");
  ParticleOptions options;
  options.meaning = SizeMeaning::diameter;
  options.unit = SizeUnit::mm;
  CHECK(read(scalars, options).particles == "0.001 0.002 0.003");
}

TEST_CASE("VTK: broken files") {
  const std::string good = vtk_points + "SCALARS radius double 1\nLOOKUP_TABLE default\n1 2\n3\n";
  CHECK(read(good).particles == "2000 4000 6000");
  const auto broken = [&good](const std::string &part, const std::string &by) {
    return refusal(replaced(good, part, by), from(ParticleFormat::vtk));
  };
  CHECK(contains(broken("# vtk", "#"), "file:1: the first line is not"));
  CHECK(contains(broken("ASCII", "BINARY"), "file:3: the file is not ASCII"));
  CHECK(contains(broken("POLYDATA", "STRUCTURED_POINTS"), "file:4: the data set is not of points"));
  CHECK(contains(broken("SCALARS radius", "SCALARS r"), "there is no array radius or diameter"));
  CHECK(contains(broken("double 1", "double 3"), "file:13: the array has several values a point"));
  CHECK(contains(broken("POINT_DATA 3", "POINT_DATA x"), "file:12: POINT_DATA has no number of values"));
  CHECK(contains(broken("POINT_DATA 3\n", ""), "file:12: the array is not below POINT_DATA"));
  CHECK(contains(broken("1 2\n3\n", "1 2\n"), "file:15: the values of the array end after 2 of 3"));
  CHECK(contains(broken("1 2\n3\n", "1 2\n3\n4\n"), "file:17: there are more than the 3 values"));
  CHECK(
      contains(broken("POINTS 3", "POINTS 5"), "file:8: 'VERTICES' is not a number, but there are 9 of 15"));
  CHECK(
      contains(broken("POINTS 3", "POINTS 2"), "file:7: there are more than the 6 coordinates of 2 points"));
  CHECK(contains(broken("2 2 2\n", "2 2 2\n0 0 0\n"), "file:8: there are more than the 9 coordinates"));
  CHECK(contains(broken("POINTS 3", "POINTS x"), "file:5: POINTS has no number of points"));
  CHECK(contains(broken("POINT_DATA 3", "POINT_DATA 4"), "file:12: POINT_DATA has 4 values, there are 3"));
  CHECK(contains(broken("POINT_DATA 3", "CELL_DATA 3"), "file:13: the sizes are below CELL_DATA"));
  CHECK(contains(broken("0 0 0", "0 nan 0"), "file:6: 'nan' is not a number"));
  CHECK(contains(refusal("# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINT_DATA 1\n"
                         "SCALARS radius float\n1\n"),
                 "file:5: there are no POINTS above POINT_DATA"));
  const std::string field = vtk_points + "FIELD FieldData 1\nradius 1 2 double\n1 2\n";
  CHECK(contains(refusal(field), "file:14: the array has 2 values, there are 3 points"));
  // Sizes of cells do not matter beside those of points.
  CHECK(read(replaced(good, "POINT_DATA 3\n", "CELL_DATA 3\nSCALARS radius float\n7 8 9\nPOINT_DATA 3\n"))
            .particles == "2000 4000 6000");
  CHECK(contains(broken("1 2\n3\n", "1 2\n3 4\n"), "file:16: there are more than the 3 values"));
  CHECK(contains(broken("1 2\n3\n", "1 nan\n3\n"), "file:15: radius 'nan' is not a number"));
  check_truncations(good, from(ParticleFormat::vtk));
}

} // namespace engine_test

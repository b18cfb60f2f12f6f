// mdm export of files of particles: the classes and materials that they say stay, and sizes are read as
// asked.

#include "run.hpp"

namespace kept_classes_test {

using namespace cli_test;

namespace {

const std::string types = "type,x_mm,y_mm,z_mm,radius_mm\n9,1,1,1,1\n4,5,5,5,1.1\n4,8,5,5,1.2\n";

std::string pfc(const std::string &file, const Arguments &more = {}) {
  Arguments arguments{"export", file, "--to", "pfc", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = mdm(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

} // namespace

TEST_CASE("classes that a file says are kept, whatever their sizes", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", types);
  const std::string out = pfc(file);
  CHECK(contains(out, ",0.0012,4\n"));
  CHECK(contains(out, ",0.0011,4\n"));
  CHECK(contains(out, ",1e-3,9\n"));
  CHECK(contains(mdm({"export", file, "--to", "pfc"}).err,
                 "the classes are those that the particles in FILE say"));
  // A gradation has classes of its own.
  const std::string g = folder.write("g.csv", "size_mm,mass\n1,1\n2.1,1\n3,0\n");
  CHECK(contains(pfc(file, {"--gradation", g}), ",1e-3,1\n"));
}

TEST_CASE("in a legacy VTK file the array class counts, wherever an array type is", "[cli]") {
  const TemporaryFolder folder;
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
                           "0 0 0 1 1 1\nPOINT_DATA 2\nSCALARS radius double 1\nLOOKUP_TABLE default\n"
                           "0.1 0.2\n",
                    type = "SCALARS type int 1\nLOOKUP_TABLE default\n5 6\n",
                    named = "SCALARS class int 1\nLOOKUP_TABLE default\n7 8\n";
  for (const std::string &arrays : {type + named, named + type, named}) {
    const std::string out = pfc(folder.write("a.vtk", head + arrays));
    CHECK(contains(out, ",0.1,7\n"));
    CHECK(contains(out, ",0.2,8\n"));
  }
  CHECK(contains(pfc(folder.write("a.vtk", head + type)), ",0.2,6\n"));
  for (const std::string &array : {type, named})
    check_refused(mdm({"export", folder.write("a.vtk", head + array + array), "--to", "pfc"}),
                  "there are several arrays of that name");
}

TEST_CASE("types whose sizes overlap are no classes, which is said", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", types + "9,1,5,9,1.2\n");
  const Outcome outcome = mdm({"export", file, "--to", "pfc"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.err, "have sizes in common"));
  CHECK_FALSE(contains(outcome.out, ",9\n"));
}

TEST_CASE("materials of a file are kept, each with classes of its own", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "material,x_mm,y_mm,z_mm,radius_mm\nquartz,1,1,1,1\n"
                                                 "gold,5,5,5,1\nquartz,8,5,5,1\n");
  const Outcome sizes = mdm({"export", file, "--to", "csv", "--unit", "mm", "--quiet"});
  INFO(sizes.err);
  REQUIRE(sizes.exit_code == 0);
  CHECK(contains(sizes.out, "\n2,1,gold\n2,2,quartz\n"));
  const std::string out = pfc(file);
  CHECK(contains(out, ",1e-3,2\n"));
  CHECK(contains(out, ",1e-3,1\n"));
  check_refused(mdm({"export", file, "--to", "pfc", "--gradation",
                     folder.write("g.csv", "size_mm,mass\n1,1\n3,0\n"), "--quiet"}),
                "several materials");
  check_refused(
      mdm({"export", file, "--to", "lammps", "--model", "settle", "--quiet", "-o", folder / "a.in"}),
      "--model");
}

TEST_CASE("a column of sizes with a name of its own is read for an export", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "x,y,z,c_r\n1,1,1,0.5\n5,5,5,0.25\n");
  const std::string out = pfc(file, {"--size-column", "c_r", "--radius", "--size-unit", "mm"});
  CHECK(contains(out, "2.5e-4"));
  check_refused(mdm({"export", file, "--to", "pfc", "--size-column", "c_r"}), "--radius or --diameter");
  check_refused(
      mdm({"export", folder.write("t.csv", types), "--to", "pfc", "--size-column", "c_d", "--radius"}),
      "no column 'c_d'");
  const std::string g = folder.write("g.csv", "size_mm,mass\n1,1\n2,0\n");
  for (const Arguments &option : {Arguments{"--radius"}, {"--diameter"}, {"--timestep", "3"}}) {
    Arguments arguments{"export", g, "--to", "csv"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    check_refused(mdm(arguments), option.front() + ": it is of files of particles");
  }
}

} // namespace kept_classes_test

// mdm export --model: the files that it writes and what it refuses. tests/engines runs them.

#include "run.hpp"

using namespace cli_test;

namespace {

const std::string sand = example("c778-graded-sand");

Outcome export_model(const std::string &to, const std::string &out, const Arguments &more = {}) {
  Arguments arguments{"export", sand, "--to", to, "--model", "settle", "-o", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments);
}

} // namespace

TEST_CASE("a model is one file for LIGGGHTS, and two for LAMMPS and YADE", "[cli]") {
  const TemporaryFolder folder;
  CHECK(export_model("liggghts", folder / "a.in").exit_code == 0);
  CHECK(folder.entries() == 1);
  CHECK(export_model("lammps", folder / "b.in").exit_code == 0);
  CHECK(folder.entries() == 3);
  CHECK(read_file(folder / "b.in").find("\nread_data b.data\n") != std::string::npos);
  CHECK(read_file(folder / "b.data").find("\n141 atoms\n") != std::string::npos);
  CHECK(export_model("yade", folder / "c.py").exit_code == 0);
  CHECK(folder.entries() == 5);
  CHECK(read_file(folder / "c.py").find("with open('c.xyzr') as file:\n") != std::string::npos);
  CHECK(mdm({"verify", sand, folder / "c.xyzr", "--size-unit", "m", "--tolerance", "1e-6"}).exit_code == 0);
}

TEST_CASE("a model's box is the one that was asked for, in the unit of the gradation", "[cli]") {
  const TemporaryFolder folder;
  REQUIRE(export_model("liggghts", folder / "a.in", {"--box", "3x2.5x20"}).exit_code == 0);
  CHECK(read_file(folder / "a.in").find(" block 0 0.003 0 0.0025 0 0.02 units") != std::string::npos);
  REQUIRE(export_model("lammps", folder / "b.in", {"--box", "3x2.5x20"}).exit_code == 0);
  CHECK(read_file(folder / "b.data").find("\n0 0.003 xlo xhi\n0 0.0025 ylo yhi\n0 0.02 zlo zhi\n") !=
        std::string::npos);
  REQUIRE(export_model("yade", folder / "c.py", {"--box", "3x2.5x20"}).exit_code == 0);
  CHECK(read_file(folder / "c.py").find("enumerate((0.003, 0.0025, 0.02))") != std::string::npos);
}

TEST_CASE("what is no model is refused with a remedy, and leaves nothing", "[cli]") {
  const TemporaryFolder folder;
  const std::string out = folder / "a.in";
  check_refused(mdm({"export", sand, "--to", "lammps", "--model", "sieve", "-o", out}), "there is settle");
  check_refused(export_model("csv", out), "--to liggghts, lammps or yade");
  check_refused(export_model("liggghts", "-"), "-o FILE");
  check_refused(export_model("yade", out), "end in .py");
  check_refused(export_model("lammps", folder / "a.data"), "a.data");
  check_refused(export_model("lammps", folder / "a b.in"), "letters, digits");
  check_refused(export_model("liggghts", out, {"--unit", "mm"}), "--unit");
  check_refused(export_model("liggghts", out, {"--steps", "-1"}), "--steps");
  check_refused(export_model("liggghts", out, {"--box", "0.6x1"}), "--box");
  check_refused(mdm({"export", sand, "--to", "liggghts", "--steps", "5", "-o", out}), "--model settle");
  CHECK(folder.entries() == 0);
}

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

TEST_CASE("particles start in layers or mixed, the largest first in the file", "[cli]") {
  const TemporaryFolder folder;
  // Height of the last particle, of the finest class, by that of the box.
  const auto height_of_last = [&folder](const Arguments &more) {
    Arguments arguments{"export", sand, "--to", "lammps", "--quiet", "-o", folder / "a.data"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(mdm(arguments).exit_code == 0);
    const std::string text = read_file(folder / "a.data");
    const double height = std::stod(text.substr(text.rfind('\n', text.find(" zlo")) + 3));
    return std::stod(text.substr(text.find_last_of(' '))) / height;
  };
  CHECK(height_of_last({}) > 0.9);
  CHECK(height_of_last({}) == height_of_last({"--start", "layers"}));
  double least = 1;
  for (const char *seed : {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"})
    least = std::min(least, height_of_last({"--start", "mixed", "--seed", seed}));
  CHECK(least < 0.6);
  REQUIRE(export_model("lammps", folder / "b.in").exit_code == 0);
  REQUIRE(export_model("lammps", folder / "c.in", {"--start", "mixed"}).exit_code == 0);
  REQUIRE(export_model("lammps", folder / "d.in", {"--start", "layers"}).exit_code == 0);
  CHECK(read_file(folder / "b.data") == read_file(folder / "c.data"));
  CHECK(read_file(folder / "b.data") != read_file(folder / "d.data"));
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
  for (const std::string to : {"liggghts", "lammps"}) {
    check_refused(export_model(to, out, {"--steps", "2147483648"}), "fewer --steps");
    check_refused(export_model(to, out, {"--steps", "18446744073709551616"}), "fewer --steps");
    check_refused(export_model(to, out, {"--young", "1e30"}), "softer --young"); // 10^17 steps
    check_refused(export_model(to, out, {"--box", "2x100001"}), "more than 100 m");
    check_refused(export_model(to, out, {"--box", "2x2x100001"}), "more than 100 m");
    check_refused(export_model(to, "/dev/null"), "no regular file");
  }
  CHECK(!std::filesystem::exists("/dev/null.data"));
  check_refused(export_model("liggghts", out, {"--start", "mixed"}), "--start");
  check_refused(export_model("lammps", out, {"--start", "shaken"}), "layers nor mixed");
  check_refused(mdm({"export", sand, "--to", "csv", "--start", "mixed", "-o", out}), "--start");
  check_refused(export_model("liggghts", out, {"--box", "0.6x1"}), "--box");
  check_refused(mdm({"export", sand, "--to", "liggghts", "--steps", "5", "-o", out}), "--model settle");
  CHECK(folder.entries() == 0);
}

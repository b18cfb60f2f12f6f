// mdm export --model settle --dimension 2: what it writes and what it refuses. tests/engines runs the models.

#include "answer.hpp"
#include "count.hpp"

#include <array>
#include <cmath>
#include <sstream>

namespace disc_model_test {

using namespace cli_test;
using mdm_test::count;

namespace {

const std::string two_classes = "size_mm,mass\n0.3,1\n0.4,1\n0.6,0\n";

Outcome export_discs(const std::string &gradation, const std::string &to, const std::string &out,
                     const Arguments &more = {}) {
  Arguments arguments{"export",      gradation, "--to",  to,        "--model", "settle",
                      "--dimension", "2",       "--law", "power:2", "-o",      out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments);
}

/// x, z and radius of the rows `x y z r`; y is the same in all.
std::vector<std::array<double, 3>> in_plane(const std::string &text) {
  std::vector<std::array<double, 3>> all;
  std::istringstream lines(text);
  std::string plane;
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == '#')
      continue;
    std::istringstream words(line);
    std::string y;
    std::array<double, 3> row{};
    words >> row[0] >> y >> row[1] >> row[2];
    plane = plane.empty() ? y : plane;
    CHECK(y == plane);
    all.push_back(row);
  }
  return all;
}

} // namespace

TEST_CASE("discs start in a plane without overlaps, in the box that is asked for", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", two_classes);
  const Outcome outcome = export_discs(g, "yade", folder / "a.py", {"--at-least", "300", "--box", "8x30"});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto all = in_plane(read_file(folder / "a.xyzr"));
  REQUIRE(all.size() == 300);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i][0] >= all[i][2]);
    CHECK(all[i][0] + all[i][2] <= 0.008);
    CHECK(all[i][1] + all[i][2] <= 0.03);
    for (std::size_t j = 0; j < i; ++j)
      CHECK(std::hypot(all[i][0] - all[j][0], all[i][1] - all[j][1]) >= all[i][2] + all[j][2]);
  }
}

TEST_CASE("a model of discs says what they are", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", two_classes);
  for (const std::string to : {"lammps", "yade"}) {
    const std::string model = folder / (to == "yade" ? "a.py" : "a.in");
    REQUIRE(export_discs(g, to, model).exit_code == 0);
    const std::string text = read_file(model);
    CHECK(count(text, "discs settle between two walls") == 1);
    CHECK(count(text, "The masses are those of discs") == 1);
    CHECK(count(text, "x^3") == 0);
    CHECK(count(text, "@") == 0);
  }
  const std::string data = read_file(folder / "a.data");
  CHECK(count(data, " 0\n") > 2);
  CHECK(count(data, "x^3") == 0);
}

TEST_CASE("discs are no packing of spheres", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", two_classes);
  REQUIRE(export_discs(g, "yade", folder / "a.py", {"--at-least", "30"}).exit_code == 0);
  const Arguments verify{"verify", g,         folder / "a.xyzr", "--size-unit", "m",
                         "--law",  "power:2", "--tolerance",     "1e-6"};
  const Outcome outcome = mdm(verify);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("void ratio") == std::string::npos);
  CHECK((outcome.out + outcome.err).find("all centres are in a plane, as of discs") != std::string::npos);
  Arguments asked = verify;
  asked.emplace_back("--packing");
  check_refused(mdm(asked), "all centres are in a plane, as of discs, and a packing is of spheres");
}

TEST_CASE("discs are refused where an engine, or the question, has none", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", two_classes), out = folder / "a.in";
  check_refused(export_discs(g, "liggghts", out), "LIGGGHTS has no second dimension");
  check_refused(export_discs(g, "lammps", out, {"--periodic", "--stress", "1000"}), "leave --periodic out");
  check_refused(export_discs(g, "lammps", out, {"--sides", "cylinder"}), "leave --sides out");
  check_refused(export_discs(g, "lammps", out, {"--start", "deposit"}), "leave --start out");
  check_refused(export_discs(g, "lammps", out, {"--rolling-friction", "0.1"}),
                "leave --rolling-friction out");
  check_refused(export_discs(g, "lammps", out, {"--types", "class"}), "leave --types out");
  check_refused(export_discs(g, "lammps", out, {"--box", "1x1x1"}), "write AxB");
  check_refused(mdm({"export", g, "--to", "lammps", "--model", "settle", "--dimension", "2", "-o", out}),
                "--law power:2");
  check_refused(mdm({"export", g, "--to", "lammps", "--dimension", "2"}), "--dimension is for a model");
  CHECK(mdm({"export", g, "--to", "lammps", "--model", "settle", "--dimension", "4", "-o", out}).exit_code ==
        2);
  CHECK_FALSE(std::filesystem::exists(out));
}

} // namespace disc_model_test

// Drained triaxial tests of a real sand in periodic cells, by LAMMPS and YADE, and between six walls, by
// LIGGGHTS: what the log says is held against the grains that are left, anew here, and by mdm verify,
// state.py, rows.py and walls.py. The strain is small, to be quick.

#include "support.hpp"

#include <cmath>

namespace triaxial_test {

using namespace cli_test;

namespace {

constexpr double stress = 100000, strain = 0.05;

std::string c778() {
  return read_file(example("c778-graded-sand"));
}

Engine sheared(Engine engine) {
  engine.dump = engine.name == "yade" ? "sand-sheared.xyzr" : "sand-sheared.dump";
  return engine;
}

std::string end_of(const Outcome &outcome) {
  const std::string text = outcome.out + outcome.err;
  return text.substr(text.size() < 3000 ? 0 : text.size() - 3000);
}

struct Row {
  double axial, volumetric, p, q, void_ratio, coordination, unbalanced;
};

std::vector<Row> log_of(const Model &model) {
  std::istringstream text(read_file(model.path("sand-triaxial.csv")));
  std::string line;
  std::getline(text, line);
  CHECK(line == "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force,constant");
  std::vector<Row> rows;
  while (std::getline(text, line)) {
    Row r{};
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &r.axial, &r.volumetric, &r.p, &r.q,
                        &r.void_ratio, &r.coordination, &r.unbalanced) == 7);
    rows.push_back(r);
  }
  return rows;
}

/// What engines leave: the sides of the cell, and the sum of the radii's cubes.
struct Cell {
  std::array<double, 3> sides{};
  double cubes = 0;

  double void_ratio() const { return sides[0] * sides[1] * sides[2] / (4 * std::acos(-1.0) / 3 * cubes) - 1; }
};

Cell cell_of(const Engine &engine, const std::string &dump) {
  Cell cell;
  if (engine.name == "yade") {
    REQUIRE(std::sscanf(dump.c_str(), "# x y z r in m; box %lf %lf %lf", &cell.sides[0], &cell.sides[1],
                        &cell.sides[2]) == 3);
    std::istringstream text(dump.substr(dump.find('\n')));
    for (Grain g{}; text >> g.x >> g.y >> g.z >> g.r;)
      cell.cubes += g.r * g.r * g.r;
    return cell;
  }
  std::istringstream bounds(dump.substr(dump.find('\n', dump.find("BOX BOUNDS"))));
  for (double &side : cell.sides) {
    double low = 0, high = 0;
    bounds >> low >> high;
    side = high - low;
  }
  for (const Grain &g : grains(dump))
    cell.cubes += g.r * g.r * g.r;
  return cell;
}

/// LIGGGHTS writes the box of a dump with six digits.
double error_of_dump(const Engine &engine) {
  return engine.name == "liggghts" ? 2e-5 : 1e-6;
}

void check_log(const std::vector<Row> &rows) {
  REQUIRE(rows.size() > 150);
  CHECK(rows.size() <= 201);
  CHECK(rows.front().axial == 0);
  CHECK(rows.front().volumetric == Approx(0).margin(1e-9));
  CHECK(std::abs(rows.front().q) < 0.02 * stress);
  CHECK(rows.back().axial >= strain - 1e-8);
  CHECK(rows.back().axial < strain + 0.001);
  for (const Row &r : rows) {
    // The strain of the volume is what the void ratio says.
    CHECK((1 + r.void_ratio) / (1 + rows.front().void_ratio) == Approx(1 - r.volumetric).margin(1e-6));
    CHECK(r.unbalanced >= 0);
  }
  const double ratio = rows.back().q / rows.back().p;
  CHECK(ratio > 0.3);
  CHECK(ratio < 1.5);
}

/// mdm verify counts the contacts and measures the space by itself.
void check_places(const Model &model, const Engine &engine, const Cell &cell, const Row &last) {
  Arguments arguments{
      "verify", model.path("sand.csv"), model.dump(), "--packing", "--tolerance", "1e-6", "--format", "json"};
  if (engine.name == "yade") {
    std::ostringstream box;
    box.precision(17);
    box << 1000 * cell.sides[0] << "x" << 1000 * cell.sides[1] << "x" << 1000 * cell.sides[2];
    arguments.insert(arguments.end(), {"--size-unit", "m", "--periodic", "xyz", "--box", box.str()});
  }
  const Outcome verdict = mdm(arguments);
  INFO(verdict.out << verdict.err);
  REQUIRE(verdict.exit_code == 0);
  const Json packing = Json::parse(verdict.out).at("packing");
  CHECK(packing.at("periodic") == (engine.name == "liggghts" ? "" : "xyz"));
  const auto number = [](const Json &value) {
    return std::stod((value.is_array() ? value.at(0) : value).get<std::string>());
  };
  CHECK(number(packing.at("void_ratio")) == Approx(last.void_ratio).epsilon(1e-4));
  const double contacts = std::stod(packing.at("contacts").get<std::string>());
  CHECK(2 * contacts / 500 == Approx(last.coordination).epsilon(0.01));
}

void check_by_python(const Arguments &arguments) {
  const Outcome found = Process("/usr/bin/python3", arguments).end();
  INFO(found.out << found.err);
  CHECK(found.exit_code == 0);
}

void check_triaxial(const Engine &engine, const std::string &constant) {
  if (!is_there(engine))
    return;
  const Model model(
      engine, c778(),
      {"--stress", "100000", "--at-least", "500", "--axial-strain", "0.05", "--constant", constant},
      "triaxial");
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  const std::size_t result = outcome.out.find("\nRESULT after ");
  REQUIRE(result != std::string::npos);
  CHECK(outcome.out.find("friction 0.5 (0.5 while compacted); sheared to axial strain 0.05", result) !=
        std::string::npos);
  CHECK(outcome.out.find(" have " + constant + " more than 0.02 off 100000 Pa, ", result) !=
        std::string::npos);
  model.check_grains({"--at-least", "500"});
  const std::vector<Row> rows = log_of(model);
  check_log(rows);
  const Cell cell = cell_of(engine, read_file(model.dump()));
  CHECK(cell.void_ratio() == Approx(rows.back().void_ratio).epsilon(error_of_dump(engine)));
  check_places(model, engine, cell, rows.back());
  const TemporaryFolder folder;
  const std::string log = model.path("sand-triaxial.csv");
  Arguments state{MDM_SOURCE_DIR "/tests/engines/state.py", model.dump(), folder.write("log", outcome.out),
                  "2e8", "0.25"};
  if (engine.name == "liggghts") {
    state.insert(state.end(), {"--wall", "six"});
    check_by_python({MDM_SOURCE_DIR "/tests/engines/walls.py", model.dump(), log, "2e8", "0.25"});
  }
  check_by_python(state);
  check_by_python({MDM_SOURCE_DIR "/tests/engines/rows.py", log, constant, "100000"});
  CHECK(mdm({"plot", log, "-o", folder / "log.svg"}).exit_code == 0);
}

/// With these options it is no result, and says why.
void check_stops(const Model &model, const std::string &options, const std::string &message) {
  const Outcome outcome = model.run("", options);
  INFO(end_of(outcome));
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find(message) != std::string::npos);
  CHECK(outcome.out.find("\nRESULT ") == std::string::npos);
  CHECK(!model.has_dump());
}

} // namespace

TEST_CASE("LAMMPS shears a cell of 500 grains at constant sigma_3", "[engines]") {
  check_triaxial(sheared(lammps), "sigma_3");
}

TEST_CASE("LAMMPS shears a cell of 500 grains at constant p", "[engines]") {
  check_triaxial(sheared(lammps), "p");
}

TEST_CASE("YADE shears a cell of 500 grains at constant sigma_3", "[engines]") {
  check_triaxial(sheared(yade), "sigma_3");
}

TEST_CASE("YADE shears a cell of 500 grains at constant p", "[engines]") {
  check_triaxial(sheared(yade), "p");
}

TEST_CASE("LIGGGHTS shears 500 grains between six walls at constant sigma_3", "[engines]") {
  check_triaxial(sheared(liggghts), "sigma_3");
}

TEST_CASE("LIGGGHTS shears 500 grains between six walls at constant p", "[engines]") {
  check_triaxial(sheared(liggghts), "p");
}

TEST_CASE("LIGGGHTS stops where a triaxial test is none", "[engines]") {
  if (!is_there(liggghts))
    return;
  const Model model(sheared(liggghts), c778(),
                    {"--stress", "100000", "--at-least", "300", "--axial-strain", "0.005"}, "triaxial");
  check_stops(model, "-var held_within 1e-9", "STOP: sigma_3 was not constant: in ");
  check_stops(model, "-var inertial_number 0.0015 -var held_within 0.9",
              "STOP: the inertial number was 0.001");
  check_stops(model, "-var friction 0 -var most_compacting 2000", "STOP: 100000 Pa are not reached");
}

/// A shear that was no result is one with other limits: it goes on from the last row.
void check_goes_on_to_result(const Engine &engine) {
  if (!is_there(engine))
    return;
  const Model model(engine, c778(), {"--stress", "100000", "--at-least", "300", "--axial-strain", "0.005"},
                    "triaxial");
  const Outcome stopped = model.run("", "-var most_rows_off -1");
  CHECK(stopped.exit_code == 1);
  const std::vector<Row> before = log_of(model);
  check_stops(model, "-var go_on 1 -var held_within 0.5",
              "were judged with held_within 0.02 and target 100000: go on with these");
  const Outcome outcome = model.run("", "-var go_on 1");
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  const std::vector<Row> rows = log_of(model);
  REQUIRE(rows.size() == before.size());
  CHECK(rows.back().axial == Approx(before.back().axial).epsilon(1e-6));
  CHECK(rows.back().p == Approx(before.back().p).epsilon(0.001));
  CHECK(cell_of(engine, read_file(model.dump())).void_ratio() ==
        Approx(rows.back().void_ratio).epsilon(error_of_dump(engine)));
}

TEST_CASE("a shear of LAMMPS goes on from its restart", "[engines]") {
  check_goes_on_to_result(sheared(lammps));
}

TEST_CASE("a shear of LIGGGHTS goes on from its restart", "[engines]") {
  check_goes_on_to_result(sheared(liggghts));
}

TEST_CASE("LAMMPS stops where a triaxial test is none", "[engines]") {
  if (!is_there(lammps))
    return;
  const Model model(sheared(lammps), c778(),
                    {"--stress", "100000", "--at-least", "400", "--axial-strain", "0.005"}, "triaxial");
  check_stops(model, "-var held_within 1e-9", "STOP: sigma_3 was not constant: in ");
  check_stops(model, "-var inertial_number 0.0015 -var held_within 0.9",
              "STOP: the inertial number was 0.001");
}

TEST_CASE("LAMMPS brings a cell to a pressure and a void ratio by friction, or says that it cannot",
          "[engines]") {
  if (!is_there(lammps))
    return;
  const auto model = [](const char *void_ratio) {
    return Model(
        sheared(lammps), c778(),
        {"--stress", "100000", "--void-ratio", void_ratio, "--at-least", "400", "--axial-strain", "0.005"},
        "triaxial");
  };
  const Outcome dense = model("0.45").run();
  INFO(end_of(dense));
  REQUIRE(dense.exit_code == 0);
  CHECK(dense.out.find(", friction 0.5 (0.") != std::string::npos);
  CHECK(dense.out.find(", friction 0.5 (0.5 while") == std::string::npos);
  const Outcome loose = model("0.8").run();
  CHECK(loose.exit_code == 1);
  CHECK(loose.out.find("is not within 0.01 of 0.8") != std::string::npos);
}

} // namespace triaxial_test

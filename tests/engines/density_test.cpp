// Specimens at the density that was asked for, in the engines themselves. Grains are soft and few, to be
// quick.

#include "support.hpp"

#include <cmath>
#include <cstdio>

namespace density_test {

using namespace cli_test;

namespace {

std::string c778() {
  return read_file(example("c778-graded-sand"));
}

/// A cylinder of some 2,000 grains.
const Arguments cylinder{"--specimen", "cylinder:5x4.5", "--void-ratio", "0.65", "--friction-while-filling",
                         "0.2",        "--young",        "1e6"};
const Arguments cylinder_question{"--specimen", "cylinder:5x4.5", "--void-ratio", "0.65"};

/// The numbers of `RESULT after N steps: void ratio E, pressure P Pa`.
struct Result {
  double steps = 0, void_ratio = 0, pressure = 0;
};

Result result(const std::string &log) {
  const std::size_t at = log.find("\nRESULT after ");
  REQUIRE(at != std::string::npos);
  Result r;
  REQUIRE(std::sscanf(log.c_str() + at, "\nRESULT after %lf steps: void ratio %lf, pressure %lf Pa", &r.steps,
                      &r.void_ratio, &r.pressure) == 3);
  return r;
}

/// Void ratio of a round specimen, from the grains that the engine left.
double void_ratio_below_highest(const std::vector<Grain> &all, double diameter) {
  double solids = 0, top = 0;
  for (const Grain &g : all) {
    solids += 4 * std::pow(g.r, 3) / 3;
    top = std::max(top, g.z + g.r);
  }
  return diameter * diameter / 4 * top / solids - 1;
}

void check_cylinder(const Engine &engine, const std::string &before = "") {
  if (!is_there(engine) || !mdm_test::has_tool("mpirun", "mpi-default-bin"))
    return;
  const Model model(engine, c778(), cylinder);
  const Outcome outcome = model.run(before);
  INFO(outcome.out.substr(outcome.out.size() < 4000 ? 0 : outcome.out.size() - 4000)
       << outcome.err.substr(0, 2000));
  REQUIRE(outcome.exit_code == 0);
  const Result found = result(outcome.out);
  CHECK(std::abs(found.void_ratio - 0.65) < 0.01);
  CHECK(found.pressure > 0);
  model.check_grains(cylinder_question);
  const std::vector<Grain> all = grains(read_file(model.dump()));
  CHECK(all.size() > 1900);
  CHECK(all.size() < 2100);
  // The lid is where the engine says, a little below the highest grains, which it presses on.
  CHECK(std::abs(void_ratio_below_highest(all, 0.005) - 0.65) < 0.02);
  for (const Grain &g : all)
    CHECK(std::hypot(g.x - 0.0025, g.y - 0.0025) + g.r < 0.0025 + 0.1 * g.r);
}

/// The last lines of what an engine says.
std::string end_of(const Outcome &outcome) {
  const std::string text = outcome.out + outcome.err;
  return text.substr(text.size() < 3000 ? 0 : text.size() - 3000);
}

/// Stopped on its way, a model goes on from its restart to the same end.
void check_goes_on(const Engine &engine, const std::string &stopping, const std::string &going_on) {
  if (!is_there(engine))
    return;
  const Arguments specimen{"--specimen", "cylinder:3.5x3", "--void-ratio", "0.7"};
  Arguments arguments = specimen;
  arguments.insert(arguments.end(), {"--friction-while-filling", "0.2", "--young", "1e6"});
  const Model model(engine, c778(), arguments);
  const Outcome whole = model.run();
  INFO(end_of(whole));
  REQUIRE(whole.exit_code == 0);
  std::filesystem::remove(model.dump());
  const Outcome stopped = model.run("", stopping);
  CHECK(stopped.exit_code != 0);
  CHECK((stopped.out + stopped.err).find("STOP: void ratio 0.7 is not reached") != std::string::npos);
  CHECK(!model.has_dump());
  const Outcome rest = model.run("", going_on);
  INFO(end_of(rest));
  REQUIRE(rest.exit_code == 0);
  CHECK(std::abs(result(rest.out).void_ratio - result(whole.out).void_ratio) < 0.001);
  CHECK(std::abs(result(rest.out).steps - result(whole.out).steps) < 0.3 * result(whole.out).steps);
  model.check_grains(specimen);
}

void check_periodic(const Engine &engine) {
  if (!is_there(engine))
    return;
  const Arguments specimen{"--specimen", "box:2.5x2.5x2.5", "--void-ratio", "0.6"};
  Arguments arguments = specimen;
  arguments.insert(arguments.end(), {"--periodic", "--young", "1e6"});
  const Model model(engine, c778(), arguments);
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  CHECK(std::abs(result(outcome.out).void_ratio - 0.6) < 0.01);
  CHECK(result(outcome.out).pressure > 0);
  model.check_grains(specimen);
}

/// Exit code and message where the density cannot be reached.
void check_stops(const Engine &engine, const Arguments &arguments, const std::string &message) {
  if (!is_there(engine))
    return;
  Arguments all{"--young", "1e6"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Model model(engine, c778(), all);
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  CHECK(outcome.exit_code != 0);
  CHECK((outcome.out + outcome.err).find(message) != std::string::npos);
  CHECK(!model.has_dump());
}

} // namespace

TEST_CASE("LIGGGHTS brings a cylinder of 2,000 grains to void ratio 0.65", "[engines]") {
  check_cylinder(liggghts);
}

TEST_CASE("LAMMPS brings a cylinder of 2,000 grains to void ratio 0.65, in two processes", "[engines]") {
  check_cylinder(lammps, "mpirun --allow-run-as-root --oversubscribe -np 2 ");
}

TEST_CASE("LIGGGHTS settles in two processes", "[engines]") {
  if (!is_there(liggghts) || !mdm_test::has_tool("mpirun", "mpi-default-bin"))
    return;
  const Model model(liggghts, c778(), {"--at-least", "1000", "--steps", "2000", "--unjammed"});
  const Outcome outcome = model.run("mpirun --allow-run-as-root --oversubscribe -np 2 ");
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  model.check_grains({"--at-least", "1000"});
}

TEST_CASE("LAMMPS and YADE compress a periodic box to void ratio 0.6", "[engines]") {
  check_periodic(lammps);
  check_periodic(yade);
}

TEST_CASE("LAMMPS, LIGGGHTS and YADE compact a box to a pressure", "[engines]") {
  for (const Engine &engine : {lammps, liggghts, yade}) {
    if (!is_there(engine))
      continue;
    const Model model(
        engine, c778(),
        {"--at-least", "300", "--stress", "1000", "--target-tolerance", "0.05", "--young", "1e6"});
    const Outcome outcome = model.run();
    INFO(end_of(outcome));
    REQUIRE(outcome.exit_code == 0);
    CHECK(std::abs(result(outcome.out).pressure / 1000 - 1) < 0.05);
    model.check_grains({"--at-least", "300"});
  }
}

TEST_CASE("YADE brings a cylinder to a void ratio", "[engines]") {
  if (!is_there(yade))
    return;
  const Arguments specimen{"--specimen", "cylinder:3x2.5", "--void-ratio", "0.75"};
  Arguments arguments = specimen;
  arguments.insert(arguments.end(), {"--friction-while-filling", "0.2", "--young", "1e6"});
  const Model model(yade, c778(), arguments);
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  CHECK(std::abs(result(outcome.out).void_ratio - 0.75) < 0.01);
  std::istringstream lines(read_file(model.dump()));
  for (std::string line; std::getline(lines, line);) {
    double x = 0, y = 0, z = 0, r = 0;
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf", &x, &y, &z, &r) == 4)
      CHECK(std::hypot(x - 0.0015, y - 0.0015) + r < 0.0015 + 0.1 * r);
  }
  model.check_grains(specimen);
}

TEST_CASE("a model goes on from its restart to the same end", "[engines]") {
  check_goes_on(lammps, "-var most_compacting 5000", "-var go_on 1");
  check_goes_on(liggghts, "-var most_compacting 5000", "-var go_on 1");
}

TEST_CASE("YADE compacts a box, stopped and from its restart", "[engines]") {
  if (!is_there(yade))
    return;
  const Arguments specimen{"--specimen", "box:2.5x2.5x2.5", "--void-ratio", "0.75"};
  Arguments arguments = specimen;
  arguments.insert(arguments.end(), {"--friction-while-filling", "0.2", "--young", "1e6"});
  const Model model(yade, c778(), arguments);
  const std::string script = read_file(model.path("sand.py"));
  const std::size_t at = script.find("\nmost_compacting = ") + 1;
  const std::string limit = script.substr(at, script.find(' ', script.find("= ", at) + 2) - at);
  model.replace("sand.py", limit, "most_compacting = 4500");
  CHECK(model.run().exit_code != 0);
  CHECK(!model.has_dump());
  model.replace("sand.py", "most_compacting = 4500", limit);
  const Outcome outcome = model.run("", "100000 sand.restart.gz");
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  CHECK(std::abs(result(outcome.out).void_ratio - 0.75) < 0.01);
  model.check_grains(specimen);
}

TEST_CASE("a void ratio beyond the loosest and the densest is said, and ends with an error", "[engines]") {
  for (const Engine &engine : {lammps, liggghts, yade})
    check_stops(engine, {"--void-ratio", "3"}, "is above the loosest that this run finds");
  check_stops(lammps, {"--void-ratio", "0.2", "--periodic", "--at-least", "200"},
              "is beyond the densest that this run finds");
}

TEST_CASE("LIGGGHTS reads a spread of 20,000 sizes, with a type for each class", "[engines]") {
  if (!is_there(liggghts))
    return;
  const Arguments question{"--at-least", "20000"};
  const Model model(liggghts, c778(),
                    {"--at-least", "20000", "--spread", "--types", "class", "--steps", "100", "--unjammed"});
  CHECK(std::filesystem::file_size(model.path("sand.in")) < 20000);
  model.check_settles(question);
  // The classes are there to follow: the type of the last grain is that of the finest, of the first the
  // coarsest.
  const std::string dump = read_file(model.dump());
  CHECK(dump.find("\n1 5 ") != std::string::npos);
}

TEST_CASE("each class has its own material in the engines", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade}) {
    if (!is_there(engine))
      continue;
    const TemporaryFolder folder;
    const std::string material =
        folder.write("material.csv", "class,young_modulus,friction,restitution\n1,5e6,0.3,0.3\n2,5e6,0.4,0."
                                     "4\n3,6e6,0.5,0.5\n4,5e6,0.6,0.6\n5,7e6,0.7,0.7\n");
    Model(engine, c778(),
          {"--material", material, "--steps", "500", "--unjammed", "--friction-while-filling", "0.1"})
        .check_settles();
  }
}

} // namespace density_test

// The geometry that mdm export writes for ESyS-Particle, read by the engine, and its snapshot read back.

#include "support.hpp"

#include <map>
#include <sstream>

namespace esys_test {

using namespace cli_test;

namespace {

/// Reads particles.geo, gives each class its density, and writes snapshots of the start and of 5 steps.
const char *const script = R"(from esys.lsm import *
sim = LsmMpi(numWorkerProcesses=1, mpiDimList=[1, 1, 1])
sim.initNeighbourSearch(particleType="NRotSphere", gridSpacing=0.004, verletDist=0.0001)
sim.setNumTimeSteps(5)
sim.setTimeStepSize(1e-8)
sim.readGeometry("particles.geo")
sim.createInteractionGroup(NRotElasticPrms(name="elastic", normalK=1000.0, scaling=False))
sim.createCheckPointer(CheckPointPrms(fileNamePrefix="snap", beginTimeStep=0, endTimeStep=5, timeStepIncr=5))
sim.run()
)";

} // namespace

TEST_CASE("ESyS-Particle reads the geometry of a sand, and its snapshot is read back", "[engines]") {
  if (!mdm_test::has_tool("esysparticle", "esys-particle") || !mdm_test::has_tool("mpirun", "openmpi-bin"))
    return;
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", read_file(example("c778-graded-sand")));
  export_start(sand, "esys", folder / "particles.geo");
  folder.write("run.py", script);
  const Outcome run =
      Process("/bin/sh",
              {"-c", "cd '" + (folder / ".") +
                         "' && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 120 "
                         "mpirun --oversubscribe -np 2 esysparticle run.py"})
          .end();
  INFO(run.out.substr(0, 5000) << run.err.substr(0, 5000));
  REQUIRE(run.exit_code == 0);
  for (const std::string name : {"particles.geo", "snap_t=0_1.txt", "snap_t=5_1.txt"})
    check_places(sand, {folder / name}, "1e-6%");
  // Tags are the numbers of the classes.
  const Json asked = solve_json({sand});
  std::istringstream lines(read_file(folder / "snap_t=0_1.txt"));
  std::string line;
  std::map<std::size_t, std::size_t> of_tag;
  std::getline(lines, line);
  for (std::size_t n = std::stoul(line); n > 0 && std::getline(lines, line); --n) {
    std::istringstream words(line);
    double x, y, z, r;
    std::size_t id, tag;
    REQUIRE(words >> x >> y >> z >> r >> id >> tag);
    ++of_tag[tag];
  }
  std::string counts;
  for (std::size_t j = 0; j < asked.at("classes").size(); ++j)
    counts += (j == 0 ? "" : " ") + std::to_string(of_tag[j + 1]);
  CHECK(counts == quantities(asked));
}

} // namespace esys_test

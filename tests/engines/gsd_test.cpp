// GSD that mdm export writes, read by the format's own library, and what that writes read back.

#include "support.hpp"

namespace gsd_test {

using namespace cli_test;

namespace {

/// Prints the particles of each type, writes the frame again, and a second one of grains twice as large.
const char *const script = R"(
import collections, gsd.hoomd, gsd.pygsd, numpy
frame = gsd.hoomd.open("start.gsd", "rb")[0]
p = frame.particles
counts = collections.Counter(p.types[i] for i in p.typeid)
print(" ".join(f"{name}:{counts[name]}" for name in p.types))
half = numpy.array(frame.configuration.box[:3]) / 2
assert (abs(p.position) + p.diameter[:, None] / 2 <= half * (1 + 1e-6)).all()
assert numpy.allclose(p.mass, 2650 * numpy.pi / 6 * p.diameter.astype(float) ** 3, rtol=1e-6)
with gsd.hoomd.open("again.gsd", "wb") as file:
    file.append(frame)
    frame.configuration.step = 7
    p.diameter = p.diameter * 2
    file.append(frame)
)";

} // namespace

TEST_CASE("GSD is read by its own library, and what that writes is read back", "[engines]") {
  if (!mdm_test::has_tool("gsd", "python3-gsd"))
    return;
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", read_file(example("c778-graded-sand")));
  export_start(sand, "gsd", folder / "start.gsd");
  folder.write("read.py", script);
  const Outcome run =
      Process("/bin/sh", {"-c", "cd '" + (folder / ".") + "' && /usr/bin/python3 read.py"}).end();
  INFO(run.out << run.err);
  REQUIRE(run.exit_code == 0);
  const Json asked = solve_json({sand});
  std::string types;
  for (std::size_t j = 0; j < asked.at("classes").size(); ++j)
    types += (j == 0 ? "" : " ") + std::to_string(j + 1) + ":" +
             asked.at("classes").at(j).at("quantity").get<std::string>();
  CHECK(run.out == types + "\n");
  check_places(sand, {folder / "start.gsd"}, "2e-5%");
  check_places(sand, {folder / "again.gsd", "--timestep", "0"}, "2e-5%");
  CHECK(mdm({"verify", sand, folder / "again.gsd"}).exit_code == 1);
}

} // namespace gsd_test

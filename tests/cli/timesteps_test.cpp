// mdm verify --over-time: a line for each timestep of a dump.

#include "answer.hpp"
#include "replaced.hpp"

namespace timesteps_test {

using namespace cli_test;
using mdm_test::replaced;

namespace {

/// Classes (1, 2] and (2, 4] mm; a grain of 4 mm weighs as much as eight of 2 mm.
const std::string two = "size_mm,mass\n1,8\n2,64\n4,0\n";

/// A timestep with these grains, `x y z diameter` in m.
std::string timestep(const std::string &number, const std::vector<std::string> &grains) {
  std::string text = "ITEM: TIMESTEP\n" + number + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(grains.size()) +
                     "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS x y z diameter\n";
  for (const std::string &grain : grains)
    text += grain + "\n";
  return text;
}

const std::string coarse = "0.5 0.5 0.002 0.004", fine = "0.5 0.503 0.002 0.002",
                  other = "0.2 0.2 0.001 0.002";
/// One of each; then the fine one is away; then the coarse one has broken into eight of 2 mm.
const std::string run =
    timestep("0", {coarse, fine}) + timestep("500", {coarse}) +
    timestep("1000", {fine, other, "0.1 0.1 0.1 0.002", "0.2 0.1 0.1 0.002", "0.3 0.1 0.1 0.002",
                      "0.4 0.1 0.1 0.002", "0.5 0.1 0.1 0.002", "0.6 0.1 0.1 0.002", "0.7 0.1 0.1 0.002"});

Outcome verify(const std::string &dump, Arguments options = {}) {
  const TemporaryFolder folder;
  options.insert(options.begin(), {"verify", folder.write("g.csv", two), "-", "--over-time"});
  return mdm(options, dump);
}

} // namespace

TEST_CASE("over time: a row for each timestep, the verdict of all", "[timesteps]") {
  const Outcome done = verify(run, {"--format", "json"});
  INFO(done.err);
  CHECK(done.exit_code == 1);
  const Json report = Json::parse(done.out);
  CHECK(report.at("schema") == "mdm-timesteps-1");
  CHECK(report.at("verdict") == "no match");
  const Json &rows = report.at("timesteps");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("timestep") == "0");
  CHECK(rows[0].at("verdict") == "match");
  CHECK(rows[0].at("found") == Json::array({"1/9", "8/9"}));
  CHECK(rows[0].at("fines_lost") == "0");
  CHECK(rows[0].at("coordination") == "1"); // 3 mm apart
  CHECK(rows[0].at("breakage_hardin") == "0");
  CHECK(rows[1].at("verdict") == "no match");
  CHECK(rows[1].at("particles") == "1");
  CHECK(rows[1].at("fines_lost") == "1");
  CHECK(rows[1].at("largest_error") == "1/9");
  CHECK(rows[2].at("timestep") == "1000");
  CHECK(rows[2].at("found") == Json::array({"1", "0"}));
  CHECK(rows[2].at("fines_lost") == "-8");
  CHECK(rows[2].at("segregation").is_null()); // one class alone is there
}

TEST_CASE("over time: text and CSV say the same", "[timesteps]") {
  const Outcome text = verify(run, {"--tolerance", "12%"});
  CHECK(text.exit_code == 1);
  CHECK(contains(
      text.out, "matches at 2 of 3 timesteps; at 1000, the first of the others: does not match within 12 %"));
  const Outcome all = verify(timestep("0", {coarse, fine}) + timestep("7", {fine, coarse}));
  CHECK(all.exit_code == 0);
  CHECK(contains(all.out, "matches at all 2 timesteps"));
  const Outcome csv = verify(run, {"--format", "csv"});
  const std::vector<std::string> lines = lines_of(csv.out);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0].starts_with(
      "timestep,verdict,particles,below,above,fines_lost_percent,largest_error_percent"));
  CHECK(lines[0].ends_with(",found_percent_1_2_mm,found_percent_2_4_mm"));
  CHECK(lines[1].starts_with("0,match,2,0,0,0,0,0,"));
  CHECK(lines[1].ends_with(",0,0,11.1111,88.8888"));
  CHECK(lines[2].starts_with("500,no match,1,0,0,100,11.1111,22.2222,"));
}

TEST_CASE("over time: what broke to less than the finest sieve is outside, and counts as broken",
          "[timesteps]") {
  const Outcome done = verify(timestep("0", {coarse, fine}) + timestep("9", {fine, "0.1 0.1 0.1 0.0005"}),
                              {"--format", "json"});
  const Json last = Json::parse(done.out).at("timesteps").at(1);
  CHECK(last.at("verdict") == "no match");
  CHECK(last.at("below") == "1");
  CHECK(
      std::stod(last.at("breakage_hardin").at(0).get<std::string>()) <
      std::stod(
          last.at("breakage_hardin").at(1).get<std::string>())); // finer than 1 mm, and who knows by how much
}

TEST_CASE("over time: a picture", "[timesteps]") {
  const TemporaryFolder folder;
  const std::string picture = (folder.path() / "run.svg").string();
  CHECK(verify(run, {"--plot", picture}).exit_code == 1);
  const std::string svg = read_file(picture);
  CHECK(contains(svg, "relative breakage"));
  CHECK(contains(svg, "Z, all particles"));
  check_refused(verify(timestep("0", {coarse, fine}), {"--plot", picture}), "one timestep alone");
  check_refused(mdm({"verify", folder.write("g.csv", two), "-", "--plot", picture}, run), "--over-time");
}

TEST_CASE("over time: what has no timesteps is refused", "[timesteps]") {
  check_refused(verify("size_mm\n2\n"), "--over-time is for dumps and GSD, and this is csv");
  check_refused(verify("{}"), "it has no timesteps: leave out --over-time");
  check_refused(verify(run, {"--timestep", "500"}), "--timestep");
  check_refused(verify(run, {"--proof", "p"}), "--proof");
  check_refused(verify(timestep("0", {coarse}) + timestep("5", {}) + timestep("6", {coarse})),
                ":20: timestep 5 has no particles: take it out");
  check_refused(verify(replaced(run, other + "\n", "")), "the timestep ends after 8 of 9 atoms");
  check_refused(verify(replaced(run, "\n500\n", "\nx\n")), "the timestep is not a whole number");
}

} // namespace timesteps_test

#include "cli/run.hpp"

#include <nlohmann/json.hpp>

namespace pack_test {

using namespace cli_test;

namespace {

const Arguments small = {"pack", "--beta", "1,1", "--span", "0.5", "--at-least", "300"};

Arguments with(Arguments arguments, const Arguments &more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

void check_refused(const Arguments &arguments, const std::string &what) {
  const Outcome outcome = mdm(with({"pack"}, arguments));
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(has(outcome.err, what));
}

} // namespace

TEST_CASE("pack of a curve is the packing of the set that generate draws with the seed") {
  const TemporaryFolder folder;
  const std::string sizes = folder / "sizes.csv", one = folder / "one.packing", two = folder / "two.packing",
                    set = folder / "set.json", three = folder / "three.packing";
  CHECK(mdm(with(small, {"--seed", "7", "-o", one})).exit_code == 0);
  Arguments generate = {"generate",   "--beta", "1,1",         "--dmin", "1",       "--span", "0.5",
                        "--at-least", "300",    "--dimension", "2",      "--sizes", "--seed", "7"};
  CHECK(mdm(with(generate, {"--format", "csv", "-o", sizes})).exit_code == 0);
  CHECK(mdm(with(generate, {"--format", "json", "-o", set})).exit_code == 0);
  CHECK(mdm({"pack", "--sizes", sizes, "--seed", "7", "-o", two}).exit_code == 0);
  CHECK(mdm({"pack", set, "--seed", "7", "-o", three}).exit_code == 0);
  CHECK(read_file(one) == read_file(two));
  CHECK(read_file(one) == read_file(three));
  CHECK(mdm(with(small, {"--seed", "7", "-o", "-"})).out == read_file(one));

  const Outcome accepted = mdm({"verify", sizes, one});
  CHECK(accepted.exit_code == 0);
  CHECK(has(accepted.out, "accepted"));
  const std::string other = folder / "other.packing";
  CHECK(mdm(with(small, {"--seed", "8", "-o", other})).exit_code == 0);
  const Outcome refused = mdm({"verify", sizes, other});
  CHECK(refused.exit_code == 1);
  CHECK(has(refused.out, "refused: its radii"));
  CHECK(mdm({"verify", sizes, sizes}).exit_code == 2);

  const auto judgement = [&](const std::string &packing, int exit_code) {
    const Outcome outcome = mdm({"verify", sizes, packing, "--format", "json"});
    CHECK(outcome.exit_code == exit_code);
    return nlohmann::json::parse(outcome.out)["judgement"];
  };
  CHECK(judgement(one, 0)["verdict"] == "accepted");
  CHECK(judgement(one, 0)["objections"].empty());
  CHECK(judgement(other, 1)["verdict"] == "refused");
  CHECK(judgement(other, 1)["objections"].size() == 1);
  CHECK(judgement(other, 1)["packing"] == other);
  const Outcome csv = mdm({"verify", sizes, other, "--format", "csv"});
  CHECK(csv.exit_code == 1);
  CHECK(has(csv.out, "discs,packing_fraction_lo"));
  CHECK(has(csv.err, "refused: its radii"));
}

TEST_CASE("verify refuses a packing whose discs were moved") {
  const TemporaryFolder folder;
  const std::string sizes = folder.write("sizes.csv", "class,size_lo,size_hi\n1,2,2\n1,2,2\n"),
                    packing = folder / "a.packing";
  CHECK(mdm({"pack", sizes, "--width", "8", "--walls", "--floor", "left", "-o", packing}).exit_code == 0);
  CHECK(mdm({"verify", sizes, packing}).exit_code == 0);
  std::string text = read_file(packing);
  // The second disc touches the first on the floor; now it is one unit nearer to it, then far away.
  const std::size_t line = text.rfind('\n', text.size() - 2) + 1, space = text.find(' ', line);
  const long long x = std::stoll(text.substr(line, space - line));
  const auto moved = [&](long long by) {
    std::string changed = text;
    return folder.write("moved.packing", changed.replace(line, space - line, std::to_string(x + by)));
  };
  CHECK(has(mdm({"verify", sizes, moved(-20)}).out, "refused: 1 pairs of discs overlap"));
  const Outcome loose = mdm({"verify", sizes, moved(1000)});
  CHECK(loose.exit_code == 1);
  CHECK(has(loose.out, "does not touch"));
}

TEST_CASE("verify derives the front of a packing, and names what of its header it does not look at") {
  const TemporaryFolder folder;
  const std::string sizes = folder / "sizes.csv", packing = folder / "a.packing";
  REQUIRE(mdm({"generate", "--beta", "1,1", "--dmin", "1", "--span", "0.5", "--at-least", "300",
               "--dimension", "2", "--sizes", "--format", "csv", "-o", sizes})
              .exit_code == 0);
  for (const Arguments &how : {Arguments{},
                               {"--walls"},
                               {"--rule", "drop"},
                               {"--walls", "--rule", "drop"},
                               {"--floor", "left"},
                               {"--walls", "--floor", "left", "--width", "9"}}) {
    Arguments pack{"pack", sizes, "-o", packing};
    pack.insert(pack.end(), how.begin(), how.end());
    REQUIRE(mdm(pack).exit_code == 0);
    const Outcome accepted = mdm({"verify", sizes, packing});
    INFO(accepted.out.substr(0, 200));
    CHECK(accepted.exit_code == 0);
    CHECK(has(accepted.out, "(not verified: that they came there by rule "));
    CHECK(has(accepted.out, ", seed 1)\n"));
    const std::string text = read_file(packing);
    const std::size_t at = text.find("\nfront ") + 7, end = text.find('\n', at);
    const long long front = std::stoll(text.substr(at, end - at));
    for (const long long wrong : {2 * front, front - 1, 0LL}) {
      std::string changed = text;
      changed.replace(at, end - at, std::to_string(wrong));
      const Outcome refused = mdm({"verify", sizes, folder.write("front.packing", changed)});
      CHECK(refused.exit_code == 1);
      CHECK(has(refused.out, "its front is " + std::to_string(wrong)));
    }
  }
  std::string gasket = read_file(packing);
  gasket.replace(gasket.find("rule lowest"), 11, "rule apollonian");
  CHECK(has(mdm({"verify", sizes, folder.write("gasket.packing", gasket)}).out, "is carried, as no circle"));
  std::string metres = read_file(packing);
  metres.replace(metres.find("unit any"), 8, "unit m");
  CHECK(has(mdm({"verify", sizes, folder.write("metres.packing", metres)}).out, "its lengths are in m"));
}

TEST_CASE("pack says at once that the match of a sheet has too many discs", "[cli]") {
  const TemporaryFolder folder;
  const std::string clay =
      folder.write("clay.csv", "size_mm,retained_percent\n0.0001,20\n0.0005,20\n0.063,30\n2,30\n20,0\n");
  check_refused({clay, "--spread", "-o", folder / "a.packing"}, "more than 10^7");
}

TEST_CASE("export writes packings in every format for them, and mdm verify reads the sizes back") {
  const TemporaryFolder folder;
  const std::string packing = folder / "a.packing";
  const std::string sand = folder.write("sand.csv", "size_mm,mass\n1,2\n2,0\n");
  CHECK(mdm({"pack", sand, "--spread", "--at-least", "100", "-o", packing}).exit_code == 0);
  for (const std::string format : {"lammps", "liggghts", "yade", "lmgc90", "vtk", "csv"})
    CHECK(mdm({"export", packing, "--to", format, "-o", folder / format}).exit_code == 0);
  for (const std::string format : {"lammps", "liggghts", "vtk"})
    CHECK(mdm({"verify", sand, folder / format}).exit_code == 0);
  CHECK(mdm({"export", packing, "--to", "mercurydpm"}).exit_code == 2);
  CHECK(mdm({"export", packing, "--to", "vtk", "--box", "1x1"}).exit_code == 2);
}

TEST_CASE("exported packings hold the discs exactly, as another program reads them") {
  const TemporaryFolder folder;
  const std::string packing = folder / "a.packing";
  const std::string sand = folder.write("sand.csv", "size_mm,mass\n1,2\n2,0\n");
  const auto check = [&](const Arguments &pack, const Arguments &unit, const std::string &factor) {
    REQUIRE(mdm(with(with({"pack"}, pack), {"-o", packing})).exit_code == 0);
    Arguments files{MDM_SOURCE_DIR "/tests/packing/check_exports.py", packing, factor};
    for (const std::string format : {"lmgc90", "vtk", "csv"}) {
      const std::string file = folder / format;
      REQUIRE(mdm(with({"export", packing, "--to", format, "-o", file}, unit)).exit_code == 0);
      CHECK_FALSE(has(read_file(file), "lengths in any"));
      files.push_back(file);
    }
    const Outcome verdict = Process("/usr/bin/python3", files).end();
    INFO(verdict.err);
    CHECK(verdict.out == "ok\n");
  };
  check({"--beta", "1,1", "--span", "0.5", "--at-least", "200"}, {}, "1");
  check({"--beta", "1,1", "--span", "0.5", "--at-least", "200", "--walls"}, {"--unit", "mm"}, "1");
  check({sand, "--spread", "--at-least", "100"}, {}, "1/1000");
  check({sand, "--spread", "--at-least", "100"}, {"--unit", "um"}, "1000");
  check({"--apollonian", "-1,2,2,3", "--smallest", "1/50"}, {}, "1");
}

TEST_CASE("pack reports in text, JSON and CSV") {
  const Outcome text = mdm(small);
  CHECK(text.exit_code == 0);
  CHECK(has(text.out, "packing fraction [0.8"));
  CHECK(has(text.out, "no two discs overlap"));
  CHECK(has(text.out, "coordination"));
  const nlohmann::json json =
      nlohmann::json::parse(mdm(with(small, {"--format", "json", "--positions"})).out);
  CHECK(json["schema"] == "mdm-packing-1");
  CHECK(json["packing_fraction"].size() == 2);
  CHECK(std::to_string(json["positions"].size()) == json["discs"]);
  const std::string csv = mdm(with(small, {"--format", "csv"})).out;
  CHECK(has(csv, "discs,packing_fraction_lo,packing_fraction_hi,"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 2);
}

TEST_CASE("a gradation is packed as its match of discs") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", "size_mm,mass\n1,2\n1.5,1\n2,0\n");
  const Outcome outcome = mdm({"pack", sand, "--spread", "--at-least", "200", "--format", "json"});
  CHECK(outcome.exit_code == 0);
  CHECK(nlohmann::json::parse(outcome.out)["unit"] == "mm");
}

TEST_CASE("pack counts the circles of Apollonian packings") {
  CHECK(mdm({"pack", "--apollonian", "equal", "--smallest", "1/1000", "--count-only"}).out == "9070\n");
  CHECK(mdm({"pack", "--apollonian", "-1,2,2,3", "--smallest", "0.001", "--count-only"}).out == "3328\n");
  CHECK(has(mdm({"pack", "--apollonian", "-11,21,24,28", "--smallest", "1/1000"}).out, "144 circles"));
  CHECK(
      has(mdm({"pack", "--apollonian", "-11,21,24,28", "--smallest", "1/1000"}).out, "covered: [0.9666999"));
  const std::string csv =
      mdm({"pack", "--apollonian", "-1,2,2,3", "--smallest", "1/100", "--format", "csv"}).out;
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 168 + 2);
  const Outcome packing = mdm({"pack", "--apollonian", "equal", "--smallest", "1/100", "-o", "-"});
  CHECK(has(packing.out, "rule apollonian\n"));
  CHECK(has(packing.out, "discs 451\n"));
}

TEST_CASE("what pack cannot do is refused with what to do") {
  check_refused(Arguments{}, "one way");
  check_refused({"--beta", "1,1"}, "two sizes");
  check_refused(
      {"--beta", "1,1", "--span", "0.5", "--at-least", "10", "--classes", "1", "--min-per-class", "3"},
      "too few");
  check_refused({"--beta", "1,1", "--span", "0.5", "--width", "2"}, "--width");
  check_refused({"--beta", "1,1", "--span", "0.5", "--periodic", "--walls"}, "exclude");
  check_refused({"--beta", "1,1", "--span", "0.5", "--positions"}, "--format json");
  check_refused({"--beta", "1,1", "--span", "0.5", "--count-only"}, "--apollonian");
  check_refused({"--beta", "1,1", "--span", "0.99999", "--classing", "regular"}, "10^7");
  check_refused({"--dmin", "1"}, "one way");
  check_refused({"missing.csv"}, "missing.csv");
  check_refused({"--apollonian", "equal"}, "--smallest");
  check_refused({"--apollonian", "0,0,1,1", "--smallest", "0.1"}, "strip");
  check_refused({"--apollonian", "-1,2,3,6", "--smallest", "0.1"}, "-1,2,2,3");
  check_refused({"--apollonian", "1,2,3", "--smallest", "0.1"}, "four curvatures");
  check_refused({"--apollonian", "equal", "--smallest", "0"}, "--smallest");
  check_refused({"--apollonian", "equal", "--smallest", "1e-13"}, "10^12");
  for (const Arguments &of_deposit : {Arguments{"--width", "5"},
                                      {"--seed", "5"},
                                      {"--walls"},
                                      {"--periodic"},
                                      {"--rule", "drop"},
                                      {"--floor", "left"},
                                      {"--order", "given"}}) {
    Arguments asked{"--apollonian", "equal", "--smallest", "0.1"};
    asked.insert(asked.end(), of_deposit.begin(), of_deposit.end());
    check_refused(asked, "its own sizes");
  }
  check_refused({"--beta", "1,1", "--span", "0.5", "--unit", "um"}, "options of reading");
}

TEST_CASE("sizes that are no sizes of discs are refused with their file") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", "size_mm,mass\n1,2\n2,0\n");
  check_refused({sand}, "--spread");
  check_refused({folder.write("a.csv", "class,size_lo,size_hi\n1,1,0\n")}, "a.csv:2: ");
}

} // namespace pack_test

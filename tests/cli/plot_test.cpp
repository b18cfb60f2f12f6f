// mdm plot. Pictures are drawn where there is gnuplot; scripts need none.

#include "run.hpp"
#include "tools.hpp"

#include <cstdlib>

using namespace cli_test;

namespace {

const std::string sand = example("athabasca-sand");

bool can_draw() {
  return mdm_test::has_tool("gnuplot", "gnuplot-nox");
}

/// A PATH for the programs that are started, as long as it lives.
class Path {
public:
  explicit Path(const std::string &path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }
  Path(const Path &) = delete;
  Path &operator=(const Path &) = delete;

private:
  std::string before_;
};

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

/// Done, with nothing but notes said.
std::string drawn(const TemporaryFolder &folder, const std::string &name, Arguments arguments) {
  arguments.insert(arguments.begin(), "plot");
  arguments.insert(arguments.end(), {"-o", folder / name});
  const Outcome outcome = mdm(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  return read_file(folder / name);
}

} // namespace

TEST_CASE("the ending of the file chooses the format of the picture", "[cli]") {
  if (!can_draw())
    return;
  const TemporaryFolder folder;
  CHECK(drawn(folder, "a.svg", {sand}).substr(0, 5) == "<?xml");
  CHECK(drawn(folder, "a.png", {sand}).substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(drawn(folder, "a.pdf", {sand}).substr(0, 5) == "%PDF-");
  CHECK(drawn(folder, "picture", {sand, "--format", "pdf"}).substr(0, 5) == "%PDF-");
  CHECK(folder.entries() == 4);
}

TEST_CASE("a picture goes to standard output, and is the same each time", "[cli]") {
  if (!can_draw())
    return;
  const TemporaryFolder folder;
  for (const std::string &format : Arguments{"svg", "png", "pdf"}) {
    const Outcome outcome = mdm({"plot", sand, "--match", "--format", format, "-o", "-"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == drawn(folder, "again." + format, {sand, "--match"}));
  }
}

TEST_CASE("the picture has the sieves, the indices, the bands and the counts", "[cli]") {
  if (!can_draw())
    return;
  const TemporaryFolder folder;
  const std::string svg = drawn(folder, "a.svg", {sand, "--match", "--sieve-names", "astm"});
  for (const char *text :
       {"athabasca-sand", "No. 400", "0.076", "percent passing", "percent retained, cumulative", "size (mm)",
        "D10", "D60", "Cu = 1.96", "USCS SP", "fine sand", "N = 1485", ">819<", "set of particles"}) {
    INFO(text);
    CHECK(contains(svg, text));
  }
  const std::string limits =
      std::string(MDM_SOURCE_DIR) + "/examples/gradations/c33-fine-aggregate-limits.csv";
  const std::string band = drawn(folder, "b.svg", {sand, "--band", limits, "--bands", "iso"});
  CHECK(contains(band, "allowed: c33"));
  CHECK(contains(band, "silt"));
}

TEST_CASE("an answer is drawn as --match draws it", "[cli]") {
  const TemporaryFolder folder;
  CHECK(mdm({"solve", sand, "--format", "json", "-o", folder / "answer.json"}).exit_code == 0);
  CHECK(mdm({"plot", sand, folder / "answer.json", "--script", folder / "a"}).exit_code == 0);
  CHECK(mdm({"plot", sand, "--match", "--script", folder / "b"}).exit_code == 0);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK(
      mdm({"solve", sand, "--size-factor", "2", "--format", "json", "-o", folder / "other.json"}).exit_code ==
      0);
  const Outcome other = mdm({"plot", sand, folder / "other.json", "--script", folder / "c"});
  CHECK(other.exit_code == 0);
  CHECK(contains(other.err, "its classes are not all of"));
}

TEST_CASE("names in a figure are shown as they are and never executed", "[cli]") {
  const TemporaryFolder folder;
  const std::string mark = folder / "executed";
  const std::string gradation = folder.write("g.json", R"({"id":"x\n!touch )" + mark +
                                                           R"(\nx","sizes":["0.1","1"],"masses":["1","0"]})");
  CHECK(mdm({"plot", gradation, "--script", folder / "script"}).exit_code == 0);
  CHECK_FALSE(contains(read_file(folder / "script"), "\n!touch"));
  if (!can_draw())
    return;
  for (const std::string &name :
       {"`touch " + mark + "`", std::string("a_b^2{x} @y &amp;"), std::string("it's \"\\n %d"),
        std::string("'.system('touch x').'"), std::string("<b>")}) {
    std::string text;
    for (const char c : name)
      text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    const std::string g =
        folder.write("h.json", R"({"id":")" + text + R"(","sizes":["0.1","1"],"masses":["1","0"]})");
    std::string svg = drawn(folder, "h.svg", {g});
    std::string shown;
    for (const char c : name)
      shown += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    INFO(shown);
    CHECK(contains(svg, shown));
    CHECK_FALSE(std::filesystem::exists(mark));
  }
  drawn(folder, "g.svg", {gradation});
  CHECK_FALSE(std::filesystem::exists(mark));
}

TEST_CASE("what fonts may lack is escaped, and said", "[cli]") {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("g.json", R"({"id":"sand \u4e2d","sizes":["0.1","1"],"masses":["1","0"]})");
  const Outcome outcome = mdm({"plot", file, "--script", "-"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, R"("sand \134u4e2d")"));
  CHECK(outcome.err ==
        "note: 'sand \u4E2D' is drawn as 'sand \\u4e2d': gnuplot's fonts may lack its characters\n");
  CHECK(mdm({"plot", file, "--quiet", "--script", "-"}).err.empty());
}

TEST_CASE("without gnuplot there is a remedy, and the script", "[cli]") {
  const TemporaryFolder folder;
  const Path empty("/nonexistent");
  check_refused(mdm({"plot", sand, "-o", folder / "a.svg"}), "gnuplot-nox");
  CHECK(folder.entries() == 0);
  CHECK(mdm({"plot", sand, "--script", folder / "a.gp"}).exit_code == 0);
  CHECK(contains(read_file(folder / "a.gp"), "set terminal svg"));
  CHECK(mdm({"plot", sand, "--format", "pdf", "--script", "-"}).exit_code == 0);
}

TEST_CASE("a gnuplot that fails leaves no file", "[cli]") {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  const auto install = [&programs](const std::string &what) {
    std::filesystem::permissions(programs.write("gnuplot", "#!/bin/sh\n" + what + "\n"),
                                 std::filesystem::perms::owner_all);
  };
  const Path path((programs / "") + ":/usr/bin:/bin");
  install("echo half a picture; echo 'line 3: unknown terminal' >&2; exit 1");
  check_refused(mdm({"plot", sand, "-o", folder / "a.svg"}), "unknown terminal");
  install("exit 0");
  check_refused(mdm({"plot", sand, "-o", folder / "a.png"}), "gnuplot");
  install("kill -9 $$");
  check_refused(mdm({"plot", sand, "-o", folder / "a.pdf"}), "gnuplot");
  CHECK(folder.entries() == 0);
}

TEST_CASE("what makes no picture is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string svg = folder / "a.svg";
  check_refused(mdm({"plot", sand}), "-o OUT.svg");
  check_refused(mdm({"plot", sand, "-o", svg, "--script", folder / "b"}), "--script");
  check_refused(mdm({"plot", sand, "-o", folder / "a.jpg"}), ".svg, .png or .pdf");
  check_refused(mdm({"plot", sand, "-o", "-"}), "--format");
  check_refused(mdm({"plot", sand, "--what", "counts", "-o", svg}), "--match");
  check_refused(mdm({"plot", sand, sand, "-o", svg}), "is of a gradation, and particles are wanted");
  check_refused(mdm({"plot", sand, sand, "--match", "-o", svg}), "one of them");
  check_refused(mdm({"plot", "-", "-", "-o", svg}), "standard input");
  check_refused(mdm({"plot", sand, "--band", sand, "-o", svg}), "a band has the columns");
  check_refused(mdm({"plot", folder / "none.csv", "-o", svg}), "none.csv");
  check_refused(mdm({"plot", sand, "-o", sand + "/x.svg"}), "x.svg");
  const std::string copy = folder.write("copy.svg", read_file(sand));
  check_refused(mdm({"plot", copy, "-o", copy}), "overwritten");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a packing is drawn by the size of its discs, their contacts or its cells", "[cli]") {
  const TemporaryFolder folder;
  const std::string packing = folder / "a.packing";
  CHECK(mdm({"pack", "--beta", "1,1", "--span", "0.5", "--at-least", "200", "-o", packing}).exit_code == 0);
  const auto script = [&](const Arguments &more) {
    Arguments arguments = {"plot", packing, "--script", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK(contains(script({}), "discs by their diameter"));
  CHECK(script({}) == script({"--colour", "size"}));
  CHECK(contains(script({"--colour", "contacts"}), "touches 4 others: "));
  CHECK(contains(script({"--colour", "cells"}), "quadrangles: "));
  CHECK(mdm({"plot", "-", "--script", "-"}, read_file(packing)).out == script({}));
  const std::string gasket = folder / "gasket.packing";
  CHECK(mdm({"pack", "--apollonian", "equal", "--smallest", "1/20", "-o", gasket}).exit_code == 0);
  CHECK(contains(mdm({"plot", gasket, "--script", "-"}).out, "circles by their diameter"));
  if (!can_draw())
    return;
  CHECK(contains(drawn(folder, "a.svg", {packing, "--colour", "cells"}), "triangles: "));
  CHECK(drawn(folder, "a.png", {gasket}).substr(0, 8) == "\x89PNG\r\n\x1a\n");
}

TEST_CASE("what is of gradations is refused for packings, and the other way round", "[cli]") {
  const TemporaryFolder folder;
  const std::string packing = folder / "a.packing", svg = folder / "a.svg";
  CHECK(mdm({"pack", "--beta", "1,1", "--span", "0.5", "--at-least", "200", "-o", packing}).exit_code == 0);
  for (const Arguments &more :
       {Arguments{"--match"}, {"--bands", "none"}, {"--coarse-left"}, {"--what", "curve"}}) {
    Arguments arguments = {"plot", packing, "-o", svg};
    arguments.insert(arguments.end(), more.begin(), more.end());
    check_refused(mdm(arguments), "--colour alone");
  }
  check_refused(mdm({"plot", sand, "--colour", "size", "-o", svg}), "mdm pack");
  check_refused(mdm({"plot", packing, "--colour", "age", "-o", svg}), "--colour");
  check_refused(mdm({"plot", folder.write("b.packing", "mdm-packing 1\nunit ell\n"), "-o", svg}),
                "b.packing:2");
  CHECK(folder.entries() == 2);
}

TEST_CASE("plot draws a section of a sample with places beside the curve", "[cli]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_mm,mass\n1,2\n2,2\n3,0\n");
  const std::string grains = folder.write("grains.txt", "0 0 0.5 0.75\n1.5 0 0.5 1\n1.5 0.5 2 1.2\n");
  const std::string sizes = folder.write("sizes.csv", "size_mm\n1.5\n");
  const Outcome drawn = mdm({"plot", gradation, grains, "--what", "section", "--script", "-"});
  CHECK(drawn.exit_code == 0);
  CHECK(drawn.out.find("section at y = 0.25 mm") != std::string::npos);
  CHECK(drawn.out.find("1 to 2 mm") != std::string::npos);
  CHECK(drawn.out.find("percent passing") != std::string::npos);
  CHECK(
      mdm({"plot", gradation, grains, "--what", "section", "--size-unit", "um", "--script", "-"}).exit_code ==
      2);
  check_refused(mdm({"plot", gradation, sizes, "--what", "section", "--script", "-"}),
                "a place of their own");
  check_refused(mdm({"plot", gradation, "--match", "--what", "section", "--script", "-"}),
                "no places of particles");
  check_refused(mdm({"plot", gradation, "--what", "section", "--script", "-"}),
                "--what section: give a SAMPLE");
  check_refused(mdm({"plot", gradation, "--match", "--size-unit", "m", "--script", "-"}),
                "--size-unit: it is of a SAMPLE");
}

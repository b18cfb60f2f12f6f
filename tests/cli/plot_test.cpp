// mdm plot: the command; what stands where in a picture is in tests/plot.

#include "answer.hpp"

namespace plot_test {

using namespace cli_test;

namespace {

const std::string sand = example("athabasca-sand");

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
  const TemporaryFolder folder;
  CHECK(drawn(folder, "a.svg", {sand}).substr(0, 5) == "<?xml");
  CHECK(drawn(folder, "a.png", {sand}).substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(drawn(folder, "a.pdf", {sand}).substr(0, 5) == "%PDF-");
  CHECK(drawn(folder, "picture", {sand, "--format", "pdf"}).substr(0, 5) == "%PDF-");
  CHECK(folder.entries() == 4);
}

TEST_CASE("a picture goes to standard output, and is the same each time", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string &format : Arguments{"svg", "png", "pdf"}) {
    const Outcome outcome = mdm({"plot", sand, "--match", "--format", format, "-o", "-"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == drawn(folder, "again." + format, {sand, "--match"}));
  }
}

TEST_CASE("the picture has the sieves, the indices, the bands and the counts", "[cli]") {
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

TEST_CASE("limits of the fines and the pan are taken as describe takes them", "[cli]") {
  const TemporaryFolder folder;
  const std::string silty =
      folder.write("silty.csv", "size_mm,passing_percent\n4.75,100\n0.425,60\n0.075,20\n");
  const auto svg = [&](Arguments more) {
    Arguments words = {"plot", silty, "--format", "svg", "-o", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = mdm(words);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK(contains(svg({}), ">USCS SM<"));
  CHECK(contains(svg({}), "low-plasticity silt"));
  const std::string clayey = svg({"--liquid-limit", "40", "--plastic-limit", "20"});
  CHECK(contains(clayey, ">USCS SC<"));
  CHECK_FALSE(contains(clayey, "low-plasticity silt"));
  CHECK(contains(svg({"--pan-size", "0.01"}), ">D10 = 0.0274 mm<"));
  CHECK(contains(svg({"--extrapolate"}), "D10 = "));
  check_refused(mdm({"plot", silty, "--liquid-limit", "40", "--format", "svg", "-o", "-"}), "go together");
  check_refused(
      mdm({"plot", silty, "--liquid-limit", "40", "--plastic-limit", "50", "--format", "svg", "-o", "-"}));
  check_refused(mdm({"plot", silty, "--pan-size", "1", "--format", "svg", "-o", "-"}));
}

TEST_CASE("an answer is drawn as --match draws it", "[cli]") {
  const TemporaryFolder folder;
  CHECK(mdm({"solve", sand, "--format", "json", "-o", folder / "answer.json"}).exit_code == 0);
  CHECK(mdm({"plot", sand, folder / "answer.json", "-o", folder / "a.svg"}).exit_code == 0);
  CHECK(mdm({"plot", sand, "--match", "-o", folder / "b.svg"}).exit_code == 0);
  CHECK(read_file(folder / "a.svg") == read_file(folder / "b.svg"));
  CHECK(
      mdm({"solve", sand, "--size-factor", "2", "--format", "json", "-o", folder / "other.json"}).exit_code ==
      0);
  const Outcome other = mdm({"plot", sand, folder / "other.json", "-o", folder / "c.svg"});
  CHECK(other.exit_code == 0);
  CHECK(contains(other.err, "its classes are not all of"));
}

TEST_CASE("options of solving say which match is drawn", "[cli]") {
  const TemporaryFolder folder;
  const auto drawn_by = [&folder](Arguments options) {
    options.insert(options.begin(), sand);
    return drawn(folder, "picture.svg", options);
  };
  const std::string tolerant = drawn_by({"--tolerance", "retained:1%"});
  CHECK(contains(tolerant, "N = 1021"));
  CHECK(contains(tolerant, "1021 particles: the smallest set that matches (within retained:1%)"));
  CHECK(drawn_by({"--tolerance", "retained:1%", "--match"}) == tolerant);
  CHECK(contains(drawn_by({"--min-per-class", "5"}), "at least 5 particles in each class"));
  const std::string budget = drawn_by({"--particles", "500", "--tolerance", "passing"});
  CHECK(contains(budget, "the tolerance 3.423% suffices, 3.422% does not"));
  CHECK(contains(drawn_by({"--max-steps", "100000"}), "N = 1485"));
}

TEST_CASE("a match that is drawn with a band is in the band", "[cli]") {
  const TemporaryFolder folder;
  const std::string coarse = folder.write("coarse.csv", "size_mm,mass\n1,50\n2,50\n4,0\n");
  const std::string band = folder.write(
      "band.csv", "size_mm,passing_min_percent,passing_max_percent\n1,0,0\n2,20,60\n4,100,100\n");
  const std::string picture = drawn(folder, "picture.svg", {coarse, "--match", "--band", band});
  const Json answer = solve_json({coarse, "--band", band});
  CHECK(answer.at("particles") < solve_json({coarse}).at("particles"));
  CHECK(contains(picture, "N = " + answer.at("particles").get<std::string>()));
  CHECK(contains(picture, "within the band"));
}

TEST_CASE("the target of a match is drawn as it was asked for", "[cli]") {
  const TemporaryFolder folder;
  const std::string coarse = folder.write("coarse.csv", "size_mm,mass\n0,10\n1,40\n2,50\n4,0\n");
  const auto drawn_by = [&](Arguments options) {
    options.insert(options.begin(), coarse);
    return drawn(folder, "picture.svg", options);
  };
  const std::string magnified = drawn_by({"--size-factor", "3"});
  CHECK(contains(magnified, ">12<"));
  CHECK(contains(magnified, "sizes multiplied by 3"));
  CHECK(contains(drawn_by({"--match", "--pan-size", "0.5"}), "pan counted as size 0.5 mm"));
  CHECK(drawn_by({"--digits", "5"}) == drawn_by({}));
  check_refused(mdm({"plot", coarse, "--match", "--what", "section", "-o", folder / "section.svg"}),
                "there are no places of particles in a match");
}

TEST_CASE("a match of a budget that is open is drawn, and its bounds are told", "[cli]") {
  const TemporaryFolder folder;
  const std::string fine = folder.write(
      "fine.csv", "size_mm,mass\n0,95\n1,46\n1.5,89\n2.26,95\n3.4,84\n5.11,68\n7.68,4\n11.55,0\n");
  const Outcome open = mdm({"plot", fine, "--particles", "10", "--tolerance", "total", "--node-limit", "0",
                            "-o", folder / "open.svg"});
  CHECK(open.exit_code == 3);
  CHECK(contains(open.err, "a limit left open which tolerance is the least that suffices"));
  CHECK(std::filesystem::exists(folder / "open.svg"));
}

TEST_CASE("a match that there is none of, or that a limit ends, is not drawn", "[cli]") {
  const TemporaryFolder folder;
  const std::string picture = folder / "picture.svg";
  const Outcome none = mdm({"plot", sand, "--at-most", "100", "-o", picture});
  CHECK(none.exit_code == 1);
  CHECK(contains(none.err, "nothing was drawn: no match within the limit on N"));
  const Outcome limited =
      mdm({"plot", sand, "--tolerance", "total:0.1%", "--node-limit", "1", "-o", picture});
  CHECK(limited.exit_code == 3);
  CHECK(
      contains(limited.err, "nothing was drawn: the smallest match was not found within the limit, N in ["));
  CHECK_FALSE(std::filesystem::exists(picture));
  check_refused(mdm({"plot", sand, sand, "--at-most", "9", "-o", picture}), "SAMPLE and --at-most");
}

TEST_CASE("names in a figure are shown as they are and never executed", "[cli]") {
  const TemporaryFolder folder;
  const std::string mark = folder / "executed";
  const std::string gradation = folder.write("g.json", R"({"id":"x\n!touch )" + mark +
                                                           R"(\nx","sizes":["0.1","1"],"masses":["1","0"]})");
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
      shown += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
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
  const Outcome outcome = mdm({"plot", file, "--format", "svg", "-o", "-"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, ">sand \\u4e2d<"));
  CHECK(outcome.err == "note: 'sand \u4E2D' is drawn as 'sand \\u4e2d': fonts may lack its characters\n");
  CHECK(mdm({"plot", file, "--quiet", "--format", "svg", "-o", "-"}).err.empty());
}

TEST_CASE("what makes no picture is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string svg = folder / "a.svg";
  check_refused(mdm({"plot", sand}), "-o OUT.svg");
  check_refused(mdm({"plot", sand, "-o", folder / "a.jpg"}), ".svg, .png or .pdf");
  check_refused(mdm({"plot", sand, "-o", "-"}), "--format");
  check_refused(mdm({"plot", sand, "--what", "counts", "-o", svg}), "--match");
  check_refused(mdm({"plot", sand, sand, "-o", svg}), "is of a gradation, and particles are wanted");
  check_refused(mdm({"plot", sand, sand, "--match", "-o", svg}), "one of them");
  check_refused(mdm({"plot", "-", "-", "-o", svg}), "standard input");
  check_refused(mdm({"plot", sand, "--band", sand, "-o", svg}), "a band has the columns");
  const std::string crossed =
      folder.write("crossed.csv", "size_mm,passing_min_percent,passing_max_percent\n1,60,50\n");
  check_refused(
      mdm({"plot", sand, "--band", crossed, "-o", svg}),
      "no curve is within this band: at least 60 percent must pass 1 mm, but at most 50 may pass 1 mm");
  check_refused(mdm({"plot", folder / "none.csv", "-o", svg}), "none.csv");
  check_refused(mdm({"plot", sand, "-o", sand + "/x.svg"}), "x.svg");
  const std::string copy = folder.write("copy.svg", read_file(sand));
  check_refused(mdm({"plot", copy, "-o", copy}), "overwritten");
  CHECK(folder.entries() == 2); // the two that the test wrote
}

TEST_CASE("a packing is drawn by the size of its discs, their contacts or its cells", "[cli]") {
  const TemporaryFolder folder;
  const std::string packing = folder / "a.packing";
  CHECK(mdm({"pack", "--beta", "1,1", "--span", "0.5", "--at-least", "200", "-o", packing}).exit_code == 0);
  const auto picture = [&](const Arguments &more) {
    Arguments arguments = {"plot", packing, "--format", "svg", "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
  };
  CHECK(contains(picture({}), "discs by their diameter"));
  CHECK(picture({}) == picture({"--colour", "size"}));
  CHECK(contains(picture({"--colour", "contacts"}), "touches 4 others: "));
  CHECK(contains(picture({"--colour", "cells"}), "quadrangles: "));
  CHECK(mdm({"plot", "-", "--format", "svg", "-o", "-"}, read_file(packing)).out == picture({}));
  const std::string gasket = folder / "gasket.packing";
  CHECK(mdm({"pack", "--apollonian", "equal", "--smallest", "1/20", "-o", gasket}).exit_code == 0);
  CHECK(contains(mdm({"plot", gasket, "--format", "svg", "-o", "-"}).out, "circles by their diameter"));
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
  const Outcome drawn = mdm({"plot", gradation, grains, "--what", "section", "--format", "svg", "-o", "-"});
  CHECK(drawn.exit_code == 0);
  CHECK(drawn.out.find("section at y = 0.25 mm") != std::string::npos);
  CHECK(drawn.out.find("1 to 2 mm") != std::string::npos);
  CHECK(drawn.out.find("percent passing") != std::string::npos);
  CHECK(
      mdm({"plot", gradation, grains, "--what", "section", "--size-unit", "um", "--format", "svg", "-o", "-"})
          .exit_code == 2);
  check_refused(mdm({"plot", gradation, sizes, "--what", "section", "--format", "svg", "-o", "-"}),
                "a place of their own");
  check_refused(mdm({"plot", gradation, "--match", "--what", "section", "--format", "svg", "-o", "-"}),
                "no places of particles");
  check_refused(mdm({"plot", gradation, "--what", "section", "--format", "svg", "-o", "-"}),
                "--what section: give a SAMPLE");
  check_refused(mdm({"plot", gradation, "--match", "--size-unit", "m", "--format", "svg", "-o", "-"}),
                "--size-unit: it is of a SAMPLE");
}

TEST_CASE("a trade-off in JSON is drawn as mdm tradeoff draws it", "[cli]") {
  const TemporaryFolder folder;
  CHECK(mdm({"tradeoff", sand, "--tolerances", "0,1,5", "--plot", folder / "a.svg", "--format", "json", "-o",
             folder / "t.json"})
            .exit_code == 0);
  CHECK(drawn(folder, "b.svg", {folder / "t.json"}) == read_file(folder / "a.svg"));
  const std::string german =
      drawn(folder, "c.svg", {folder / "t.json", "--language", "de", "--width", "400"});
  for (const char *part : {"N (Partikel)", "verlorene Masse (Prozent)", "width=\"400\""})
    CHECK(contains(german, part));
  check_refused(mdm({"plot", folder / "t.json", "--bands", "iso", "-o", folder / "d.svg"}), "is a trade-off");
  check_refused(
      mdm({"plot", folder.write("e.json", "{\"schema\":\"mdm-tradeoff-1\"}"), "-o", folder / "d.svg"}),
      "id is missing");
}

TEST_CASE("the log of a triaxial model is told by its first line and drawn", "[cli]") {
  const TemporaryFolder folder;
  const std::string log =
      folder.write("sand-triaxial.csv",
                   "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force,constant\n"
                   "0,0,100000,0,0.5,4.5,0.003,sigma_3\n0.1,0.01,140000,120000,0.485,4.4,0.01,sigma_3\n");
  const std::string picture = drawn(folder, "a.svg", {log, "--caption", "Loose sand."});
  for (const char *part :
       {"sand-triaxial", "q (kPa)", "volumetric strain (percent)", "constant: sigma_3", "Loose sand."})
    CHECK(contains(picture, part));
  CHECK(mdm({"plot", log, "-o", folder / "a.pdf"}).exit_code == 0);
  check_refused(mdm({"plot", log, "--match", "-o", folder / "b.svg"}), "is the log of a triaxial model");
  check_refused(mdm({"plot", log, "--kind", "passing", "-o", folder / "b.svg"}),
                "is the log of a triaxial model");
  const std::string cut = folder.write("cut.csv", read_file(log) + "0.2,0.0");
  check_refused(mdm({"plot", cut, "-o", folder / "b.svg"}), "cut.csv:4: 2 fields, not 8");
}

TEST_CASE("a picture has the form that is asked for", "[cli]") {
  const TemporaryFolder folder;
  const std::string bare = drawn(folder, "a.svg", {sand, "--match", "--bare", "--width", "500"});
  CHECK(contains(bare, "width=\"500\""));
  CHECK(contains(bare, "<title>athabasca-sand</title>"));
  CHECK_FALSE(contains(bare, ">athabasca-sand</text>"));
  CHECK_FALSE(contains(bare, ">Cu = "));
  check_refused(mdm({"plot", sand, "-o", folder / "b.svg", "--bare", "--caption", "A sand."}), "--caption");
  const std::string german =
      drawn(folder, "b.svg", {sand, "--language", "de", "--caption", "Gelesen: <mm>."});
  CHECK(contains(german, ">Durchgang in Prozent<"));
  CHECK(contains(german, ">Gelesen: &lt;mm&gt;.<"));
  CHECK(drawn(folder, "c.svg", {sand, "--width", "5e2"}) == drawn(folder, "d.svg", {sand, "--width", "500"}));
  check_refused(mdm({"plot", sand, "--width", "199", "-o", folder / "e.svg"}), "--width");
  check_refused(mdm({"plot", sand, "--width", "5001", "-o", folder / "e.svg"}), "--width");
  check_refused(mdm({"plot", sand, "--width", "300.5", "-o", folder / "e.svg"}), "--width");
  check_refused(mdm({"plot", sand, "--language", "fr", "-o", folder / "e.svg"}), "--language");
}

TEST_CASE("several gradations stand on one chart", "[plot]") {
  const TemporaryFolder folder;
  folder.write("a.csv", "size_mm,passing_percent\n1,0\n2,40\n4,100\n");
  folder.write("b.csv", "size_mm,passing_percent\n0.5,0\n1,60\n4,100\n");
  folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n1,0,70\n");
  const Arguments both = {"plot", folder / "a.csv", "--beside", folder / "b.csv", "-o", folder / "p.svg"};
  CHECK(mdm(both).exit_code == 0);
  const std::string picture = read_file(folder / "p.svg");
  CHECK(picture.find(">a<") != std::string::npos);
  CHECK(picture.find(">b<") != std::string::npos);
  Arguments more = both;
  more.insert(more.end(), {"--band", folder / "limits.csv", "--language", "de", "--width", "500"});
  CHECK(mdm(more).exit_code == 0);
  CHECK(read_file(folder / "p.svg").find(": limits") != std::string::npos);
  more = both;
  more.emplace_back("--match");
  check_refused(mdm(more), "--beside shows curves alone");
}

} // namespace plot_test

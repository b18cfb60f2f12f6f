// The options of solving: what they change, and values that make no sense.

#include "answer.hpp"

namespace solve_options_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");

/// The answer to Athabasca sand under a question; its proof is accepted.
Json proved(const Arguments &options, const std::string &gradation = athabasca) {
  const TemporaryFolder folder;
  Arguments arguments{gradation, "--proof", folder / "proof"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  Json answer = solve_json(arguments);
  const Outcome verdict = mdm_check(gradation, folder / "proof");
  INFO(verdict.out << verdict.err);
  CHECK(verdict.exit_code == 0);
  return answer;
}

/// Seven classes of relative width 1e-6: hundreds of thousands of particles, and as many numbers without a
/// match.
std::string narrow_classes() {
  std::string text = "size_mm,mass\n";
  for (int j = 0; j < 8; ++j)
    text += "1.00000" + std::to_string(j) + "," + std::to_string(j < 7 ? 100 + 37 * j * j % 53 : 0) + "\n";
  return text;
}

void check_refused_option(const Arguments &options, const std::string &part_of_message) {
  const TemporaryFolder folder;
  Arguments arguments{"solve", athabasca, "-o", folder / "out", "--proof", folder / "proof"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  check_refused(mdm(arguments), part_of_message);
  CHECK(folder.entries() == 0);
}

} // namespace

TEST_CASE("all commands that solve take the options of solving", "[cli]") {
  const char *const options[] = {
      "--tolerance",  "--band",        "--min-per-class", "--at-least", "--at-most",   "--particles",
      "--grid",       "--specimen",    "--void-ratio",    "--law",      "--cut-below", "--solids-volume",
      "--pan-size",   "--size-factor", "--digits",        "--scale",    "--max-steps", "--node-limit",
      "--time-limit", "--gap",         "--columns",       "--kind",     "--unit",      "--skip",
      "--sheet",      "--round",       "--verbose"};
  for (const char *const command : {"solve", "batch", "export", "tradeoff", "plot"}) {
    const std::string help = mdm({command, "--help"}).out;
    for (const char *const option : options) {
      CAPTURE(command, option);
      CHECK(contains(help, "\n  " + std::string(option) + " "));
    }
  }
}

TEST_CASE("every class with mass holds --min-per-class particles", "[cli]") {
  const Json answer = proved({"--min-per-class", "10"});
  check_match(answer);
  for (const Json &c : answer.at("classes"))
    CHECK(Integer(c.at("quantity").get<std::string>()) >= 10);
  CHECK(proved({"--min-per-class", "1"}).at("particles") == "1485");
  CHECK(proved({"--min-per-class", "0"}).at("particles") == "1485");
}

TEST_CASE("a length without a unit is refused where the file has inches", "[cli]") {
  const TemporaryFolder folder;
  const std::string inches = folder.write("in.csv", "size_in,mass\n0,1\n0.02,3\n0.04,2\n0.08,0\n"),
                    phi = folder.write("phi.csv", "size_phi,mass\npan,1\n2,3\n1,2\n0,0\n"),
                    table = folder.write("table.csv",
                                         "Opening (in),Retained (g)\n0.08,0\n0.04,2\n0.02,3\nPan,1\n"),
                    json = folder.write("a.json",
                                        R"({"unit":"in","sizes":["0","1","2"],"masses":["2","1","0"]})"),
                    names = folder.write("names.csv", "sieve,mass\npan,1\n1 mm,3\n2 mm,2\n4 mm,0\n");
  for (const std::string &file : {inches, table})
    check_refused(
        mdm({"solve", file, "--pan-size", "0.01"}),
        "--pan-size: 0.01 has no unit, and the sizes of the file are in inches: write 0.01in or 0.01mm");
  check_refused(mdm({"solve", json, "--cut-below", "1"}), "write 1in or 1mm");
  check_refused(mdm({"solve", inches, "--specimen", "box:1mmx1x1mm", "--void-ratio", "0.6"}), "--specimen");
  CHECK(contains(mdm({"solve", inches, "--pan-size", "0.01in"}).out, "pan counted as size 0.254 mm"));
  CHECK(contains(mdm({"solve", phi, "--pan-size", "63um"}).out, "pan counted as size 0.063 mm"));
  CHECK(contains(mdm({"solve", names, "--pan-size", "0.01"}).out, "pan counted as size 0.01 mm"));
}

TEST_CASE("option --at-least is met, mostly exactly", "[cli]") {
  CHECK(proved({"--at-least", "1485"}).at("particles") == "1485");
  const Json answer = proved({"--at-least", "100000"});
  check_match(answer);
  CHECK(answer.at("particles") == "100000");
}

TEST_CASE("option --at-least skips the numbers that have no match", "[cli]") {

  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_mm,mass\n10,1\n11,1000\n12,0\n");
  const Json least = proved({}, gradation);
  const Json spectrum = solve_json({gradation, "--spectrum"}).at("spectrum");
  REQUIRE(spectrum.at("intervals").size() >= 1);
  CHECK(spectrum.at("intervals").at(0).at(0) == least.at("particles"));
  const Integer gap = Integer(spectrum.at("intervals").at(0).at(1).get<std::string>()) + 1;
  const std::string after = spectrum.at("intervals").size() > 1
                                ? spectrum.at("intervals").at(1).at(0).get<std::string>()
                                : spectrum.at("all_from").get<std::string>();
  CHECK(proved({"--at-least", gap.str()}, gradation).at("particles") == after);
}

TEST_CASE("option --at-most below the least match is a negative verdict with a report", "[cli]") {
  const Json answer = solve_json({athabasca, "--at-most", "1484"}, 1);
  CHECK(answer.at("status") == "none");
  CHECK(answer.at("particles").is_null());
  CHECK(answer.at("lower_bound") == "1485");
  CHECK(answer.at("scale").is_null());
  const Outcome text = mdm({"solve", athabasca, "--at-most", "1484"});
  CHECK(text.exit_code == 1);
  CHECK(text.out.find("1485") != std::string::npos);
  CHECK(solve_json({athabasca, "--at-most", "1485"}).at("particles") == "1485");
}

TEST_CASE("a scaled specimen is filled with exactly its volume of solids", "[cli]") {
  const Json answer =
      proved({"--specimen", "cylinder:50x24.4", "--void-ratio", "0.683", "--size-factor", "5"});
  check_match(answer);
  CHECK(answer.at("particles") == "69221");
  // pi/6 s W = pi/4 D^2 H / (1 + e), W = 100
  const Rational s = rational(answer.at("scale").at("chosen"));
  CHECK(s * 100 / 6 == Rational(50 * 50) / 4 * Rational(244, 10) / Rational(1683, 1000));
  CHECK(answer.at("classes").at(0).at("lower") == "0.19");
}

TEST_CASE("lengths of options may have units, whatever the unit of the file", "[cli]") {
  const Json alone =
      solve_json({athabasca, "--specimen", "cylinder:5x10.16", "--void-ratio", "0.6", "--cut-below", "0.25"});
  for (const char *shape : {"cylinder:5mmx0.4in", "cylinder:5000umx0.01016m", "cylinder:5 mm x 10.16 mm"}) {
    const Json answer = proved({"--specimen", shape, "--void-ratio", "0.6", "--cut-below", "250um"});
    CHECK(answer.at("particles") == alone.at("particles"));
    CHECK(answer.at("question") == "at least the solids of a cylinder 5 mm x 10.16 mm at void ratio 0.6; "
                                   "classes below 0.25 mm left out");
  }
  const TemporaryFolder folder;
  const std::string fine = folder.write("fine.csv", "size_um,mass\n0,1\n63,2\n125,1\n250,0\n");
  const Json in_um = proved({"--pan-size", "0.002mm", "--cut-below", "0.063mm"}, fine);
  CHECK(in_um.at("question") == "pan counted as size 2 um; classes below 63 um left out");
  CHECK(quantities(in_um) == quantities(proved({"--pan-size", "2", "--cut-below", "63"}, fine)));
}

TEST_CASE("a box and a plain volume are reached and not exceeded by more than the digits", "[cli]") {
  const Json box = proved({"--specimen", "box:10x10x5", "--void-ratio", "0.6"});
  check_match(box);
  const Json volume = proved({"--solids-volume", "312.5"});
  CHECK(quantities(volume) == quantities(box));
  CHECK(rational(volume.at("solids_volume").at(0)) >= Rational(625, 2));
  CHECK(rational(volume.at("solids_volume").at(1)) < Rational(625, 2) + Rational(1, 1000000000));
}

TEST_CASE("other mass laws", "[cli]") {
  for (const char *law : {"power:2", "power:5/2", "power:1/2", "power:1", "power:7/3"}) {
    const Json answer = proved({"--law", law});
    INFO(answer.dump());
    CHECK(answer.at("solids_volume").is_null());
    const std::string text = law;
    if (const std::size_t slash = text.find('/'); slash != std::string::npos)
      CHECK(answer.at("scale").at("scale_power") == text.substr(slash + 1));
    else
      CHECK_FALSE(answer.at("scale").contains("scale_power"));
  }
  CHECK(proved({"--law", "sphere"}).at("particles") == "1485");
  CHECK(proved({"--law", "power:3"}).at("particles") == "1485");
  CHECK(proved({"--law", "power:6/2"}).at("particles") == "1485");
}

TEST_CASE("a law of irrational masses is decided exactly at ties", "[cli]") {
  // x^(5/2): 4 particles of 8 and 128 of 2 weigh the same.
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_mm,mass\n1,1\n2,8\n8,0\n");
  const Json answer = proved({"--law", "power:5/2"}, gradation);
  CHECK(answer.at("status") == "optimal");
}

TEST_CASE("option --size-factor scales the sizes and leaves the quantities", "[cli]") {
  const Json answer = proved({"--size-factor", "0.5"});
  check_match(answer);
  CHECK(quantities(answer) == "819 90 280 268 25 2 1");
  CHECK(answer.at("classes").at(6).at("upper") == "1.2");
}

TEST_CASE("option --cut-below leaves out the finer classes", "[cli]") {
  const Json answer = proved({"--cut-below", "0.11"});
  check_match(answer);
  CHECK(quantities(answer) == "280 268 25 2 1");
}

TEST_CASE("option --pan-size gives the pan a size", "[cli]") {
  const Json answer = proved({"--pan-size", "0.04"}, example("cen-standard-sand"));
  check_match(answer);
  CHECK(answer.at("classes").at(0).at("lower") == "0.04");
}

TEST_CASE("option --digits sets the significant digits, more where a class needs them", "[cli]") {
  const Json many = proved({"--digits", "50"});
  check_match(many);
  CHECK(many.at("classes").at(0).at("size").at(0).get<std::string>().size() >= 52);
  const Json few = solve_json({athabasca, "--digits", "1"});
  check_match(few);
  CHECK_FALSE(few.at("notes").empty());
  const Json within = solve_json({athabasca, "--digits", "2", "--tolerance", "1%"});
  CHECK(contains(within.at("notes").dump(), "class 7: the size is printed with 8 digits"));
}

TEST_CASE("option --scale upper takes the largest sizes", "[cli]") {
  const Json answer = proved({"--scale", "upper"});
  check_match(answer);
  CHECK(answer.at("scale").at("chosen") == answer.at("scale").at("up_to"));
  CHECK(answer.at("scale").at("margin") == "0");
  const Json robust = proved({"--scale", "robust"});
  const Rational lo = rational(robust.at("scale").at("above")), hi = rational(robust.at("scale").at("up_to"));
  const Rational s = rational(robust.at("scale").at("chosen")), hundredth = (hi - lo) / 100;
  CHECK((s - hundredth) * (s - hundredth) <= lo * hi);
  CHECK((s + hundredth) * (s + hundredth) >= lo * hi);
}

TEST_CASE("a window that starts at 0 is halved", "[cli]") {
  const Json answer = solve_json({"-"}, 0, "size_mm,mass\n0,1\n2,0\n");
  check_match(answer);
  CHECK(answer.at("scale").at("above") == "0");
  CHECK(answer.at("scale").at("up_to") == "8");
  CHECK(answer.at("scale").at("chosen") == "4");
}

TEST_CASE("a limit gives what is certain", "[cli]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("narrow.csv", narrow_classes());
  const Json optimal = solve_json({gradation});
  const Integer n(optimal.at("particles").get<std::string>());
  for (const char *steps : {"0", "1", "5", "50"}) {
    const Json answer = solve_json({gradation, "--max-steps", steps, "--proof", folder / "proof"}, 3);
    check_match(answer);
    CHECK(answer.at("status") == "feasible");
    CHECK(Integer(answer.at("lower_bound").get<std::string>()) <= n);
    CHECK(Integer(answer.at("particles").get<std::string>()) >= n);
    CHECK(answer.at("upper_bound") == answer.at("particles"));
    const Outcome checked = mdm_check(gradation, folder / "proof");
    CHECK(checked.out.find(" exactly is between " + answer.at("lower_bound").get<std::string>() + " and " +
                           answer.at("upper_bound").get<std::string>() + " (") != std::string::npos);
  }
  const Json open = solve_json({gradation, "--max-steps", "0", "--at-most", n.str()}, 3);
  CHECK(open.at("status") == "unknown");
  CHECK(open.at("particles").is_null());
  CHECK(Integer(open.at("upper_bound").get<std::string>()) > n);
  CHECK_FALSE(open.contains("question"));
  CHECK(solve_json({gradation, "--max-steps", "0", "--min-per-class", "2"}, 3).at("question") ==
        "at least 2 particles in each class");
  CHECK(mdm({"solve", gradation, "--max-steps", "1"}).out.find("N in [") != std::string::npos);
  CHECK(solve_json({gradation, "--max-steps", "99999999999999999999999"}).at("status") == "optimal");
  CHECK(solve_json({gradation, "--time-limit", "1000"}).at("status") == "optimal");
}

TEST_CASE("option --time-limit ends a long spectrum", "[cli]") {
  const auto start = std::chrono::steady_clock::now();
  const Json answer = solve_json({"-", "--spectrum", "--time-limit", "1"}, 3, narrow_classes());
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
  CHECK(answer.at("status") == "optimal");
  CHECK(answer.at("spectrum").contains("unknown_from"));
}

TEST_CASE("a spectrum of many windows that join ends soon", "[cli]") {
  const Json answer = solve_json({"-", "--spectrum"}, 0,
                                 "size_mm,mass\n0.889,0.00000000000082811\n2.147,0.00000370972\n"
                                 "2.665,0.00000000900691\n3.22,0.000000000000000000169014\n3.775,0\n");
  CHECK(answer.at("spectrum").at("all_from") == "38769659131580");
}

TEST_CASE("the spectrum is all numbers with a match", "[cli]") {
  const Json whole = solve_json({"-", "--spectrum"}, 0, "size_mm,mass\n0,2\n2,1\n3,0\n");
  CHECK(whole.at("spectrum").at("intervals").empty());
  CHECK(whole.at("spectrum").at("all_from") == whole.at("particles"));
  // by enumeration; oracle.py has the general case
  const Json gaps = solve_json({"-", "--spectrum"}, 0, "size_mm,mass\n10,1\n11,1\n12,0\n").at("spectrum");
  std::vector<bool> reached(60);
  for (int q1 = 1; q1 < 60; ++q1)
    for (int q2 = 1; q1 + q2 < 60; ++q2)
      if (std::max(q1 * 1000, q2 * 1331) < std::min(q1 * 1331, q2 * 1728))
        reached.at(static_cast<std::size_t>(q1 + q2)) = true;
  std::vector<bool> told(60);
  for (const Json &interval : gaps.at("intervals"))
    for (Integer n(interval.at(0).get<std::string>());
         n <= Integer(interval.at(1).get<std::string>()) && n < 60; ++n)
      told.at(static_cast<std::size_t>(n)) = true;
  for (Integer n(gaps.at("all_from").get<std::string>()); n < 60; ++n)
    told.at(static_cast<std::size_t>(n)) = true;
  CHECK(told == reached);
}

TEST_CASE("values of options that make no sense are refused and name the option", "[cli]") {
  for (const char *option :
       {"--min-per-class", "--at-least", "--at-most", "--max-steps", "--node-limit", "--digits"})
    for (const char *value : {"x", "-1", "1.5", "1e-3", "", " 1", "0x10", "nan", "inf"})
      check_refused_option({std::string(option) + "=" + value}, option);
  for (const char *option : {"--solids-volume", "--size-factor", "--cut-below", "--pan-size"})
    for (const char *value : {"x", "-1", "0", "nan", "inf", "1e999999999", "1,5", "0x10", "--1"})
      check_refused_option({std::string(option) + "=" + value}, option);
  for (const char *value : {"x", "-1", "nan", "inf", "-inf"})
    check_refused_option({std::string("--time-limit=") + value}, "--time-limit");
  for (const char *value :
       {"cube", "power", "power:", "power:0", "power:-1", "power:1/0", "power:0/1", "power:2/3/4",
        "power:1001", "power:1/1001", "power:x", "power:99999999999999999999", "sphere:3"})
    check_refused_option({"--law", value}, "--law");
  for (const char *value : {"lower", "", "Robust", "0.5"})
    check_refused_option({std::string("--scale=") + value}, "--scale");
  for (const char *value : {"0", "1001", "100000000000000000000"})
    check_refused_option({"--digits", value}, "--digits");
  check_refused_option({"--at-least", std::string(1001, '9')}, "--at-least");
  check_refused_option({"--format", "xml"}, "--format");
}

TEST_CASE("specimens that make no sense are refused", "[cli]") {
  for (const char *shape :
       {"cone:1x1", "cylinder", "cylinder:", "cylinder:1", "cylinder:1x1x1", "cylinder:0x1", "cylinder:1x-1",
        "cylinder:1xinf", "cylinder:x", "box:1x1", "box:1x1x1x1", "box:axbxc"})
    check_refused_option({std::string("--specimen=") + shape, "--void-ratio", "0.5"}, "specimen");
  for (const char *ratio : {"-1", "x", "nan", "inf", ""})
    check_refused_option({"--specimen", "cylinder:1x1", std::string("--void-ratio=") + ratio}, "");
  check_refused_option({"--specimen", "cylinder:1x1"}, "--void-ratio");
  check_refused_option({"--void-ratio", "0.5"}, "--specimen");
  check_refused_option({"--specimen", "box:1x1x1", "--void-ratio", "0.5", "--solids-volume", "1"},
                       "--solids-volume");
  check_refused_option({"--solids-volume", "1", "--law", "power:2"}, "spheres");
}

TEST_CASE("questions that do not fit the gradation are refused", "[cli]") {
  check_refused_option({"--cut-below", "0.1"}, "0.1");
  check_refused_option({"--cut-below", "2.4"}, "2.4");
  check_refused_option({"--pan-size", "0.01"}, "pan");
  const TemporaryFolder folder;
  check_refused(mdm({"solve", example("cen-standard-sand"), "--pan-size", "0.08"}), "0.08");
  check_refused(mdm({"solve", folder.write("g.csv", "size_mm,mass\n1,1\n2,0\n3,0\n"), "--cut-below", "2"}));
}

TEST_CASE("a text hints at the trade-off where fines cost most particles and hold little mass", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("my silt.csv", "size_mm,mass\n0.001,2\n0.002,0\n0.05,98\n0.06,0\n");
  const std::string text = mdm({"solve", file}).out;
  INFO(text);
  CHECK(text.find(" of the particles are finer than 0.002 mm and hold 2 % of the mass: see mdm tradeoff '" +
                  file + "', and --cut-below\n") != std::string::npos);
  CHECK(mdm({"solve", file, "--cut-below", "0.002"}).out.find("hint") == std::string::npos);
  CHECK(mdm({"solve", file, "--format", "json"}).out.find("hint") == std::string::npos);
  for (const char *sand : {"athabasca-sand", "hostun-rf-sand", "limestone-pfc"})
    CHECK(mdm({"solve", example(sand)}).out.find("hint") == std::string::npos);
}

} // namespace solve_options_test

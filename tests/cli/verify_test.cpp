// mdm verify: what matches, what does not and why, from every kind of sample.

#include "answer.hpp"
#include "replaced.hpp"

namespace verify_test {

using namespace cli_test;
using mdm_test::replaced;

namespace {

/// Classes (1, 2], (2, 3], (3, 4]; particles of sizes 2 and 4 weigh 8 and 64.
const std::string three = "size_mm,mass\n1,8\n2,0\n3,64\n4,0\n";

std::string sample(const std::string &rows) {
  return "size_mm,quantity\n" + rows;
}

/// Verifies a sample that comes from standard input.
Outcome verify(const std::string &gradation, const std::string &particles, Arguments options = {}) {
  const TemporaryFolder folder;
  options.insert(options.begin(), {"verify", folder.write("g.csv", gradation), "-"});
  return mdm(options, particles);
}

Json verify_json(const std::string &gradation, const std::string &particles, int exit_code,
                 Arguments options = {}) {
  options.insert(options.end(), {"--format", "json"});
  const Outcome outcome = verify(gradation, particles, options);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.err.empty());
  REQUIRE(Json::accept(outcome.out));
  const Json report = Json::parse(outcome.out);
  CHECK(report.at("schema") == "mdm-verify-1");
  CHECK(report.at("verdict") == (exit_code == 0 ? "match" : exit_code == 1 ? "no match" : "undecided"));
  CHECK(report.at("versions").contains("mdm"));
  return report;
}

int exit_of(const std::string &gradation, const std::string &particles, const Arguments &options = {}) {
  return verify(gradation, particles, options).exit_code;
}

bool holds(const Json &report, const char *condition) {
  return report.at("conditions").at(condition).at("holds").get<bool>();
}

std::string reason(const Json &report, const char *condition) {
  return report.at("conditions").at(condition).at("reason").get<std::string>();
}

/// A line for each particle of an answer, `size` being the middle of its enclosure.
std::string particle_lines(const Json &answer, const std::string &before = "") {
  std::string lines;
  for (const Json &c : answer.at("classes"))
    for (long i = 0; i < std::stol(c.at("quantity").get<std::string>()); ++i)
      lines += before + c.at("size").at(0).get<std::string>() + "\n";
  return lines;
}

} // namespace

TEST_CASE("verify: the least match of a real sand is an exact match of as many particles", "[cli]") {
  for (const char *name : {"athabasca-sand", "c778-graded-sand", "cen-standard-sand", "hostun-rf-sand",
                           "limestone-pfc", "ottawa-f65-sand"}) {
    INFO(name);
    const std::string sand = read_file(example(name));
    for (const Arguments &options :
         {Arguments{}, {"--size-factor", "2.5"}, {"--law", "power:2"}, {"--law", "power:5/2"}}) {
      Arguments to_solve = options;
      to_solve.insert(to_solve.begin(), "-");
      const Json answer = solve_json(to_solve, 0, sand);
      const Json report = verify_json(sand, answer.dump(), 0, options);
      CHECK(report.at("particles") == answer.at("particles"));
      CHECK(report.at("smallest") == Json::array({answer.at("particles"), answer.at("particles")}));
      CHECK(report.at("ratio") == "1");
      CHECK(report.at("maximum_error") == "0");
      CHECK(report.at("total_error") == "0");
      CHECK(report.at("worst_class").is_null());
      for (const char *condition : {"complete", "describes", "articulately", "accurately"})
        CHECK(holds(report, condition));
      CHECK(quantities(report) == quantities(answer));
    }
  }
}

TEST_CASE("verify: an answer that was tampered with is no match", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const std::string answer = solve_json({"-"}, 0, sand).dump();
  const Json fewer = verify_json(sand, replaced(answer, "\"819\"", "\"818\""), 1);
  CHECK(fewer.at("objections").size() == 1);
  CHECK(fewer.at("notes").size() == 1);
  const Json both = verify_json(
      sand,
      replaced(replaced(answer, "\"819\"", "\"818\""), "\"particles\":\"1485\"", "\"particles\":\"1484\""),
      1);
  CHECK(both.at("objections").size() == 1);
  CHECK(both.at("particles") == "1484");
  CHECK(both.at("ratio") == "0.9993");
  // What it says of N is no reason.
  const Json miscounted =
      verify_json(sand, replaced(answer, "\"particles\":\"1485\"", "\"particles\":\"1484\""), 0);
  CHECK(miscounted.at("objections").empty());
  CHECK(miscounted.at("notes").at(0) == "The answer says that it has 1484 particles; its classes have 1485.");
  // The wrong law, and sizes that were not multiplied.
  CHECK(exit_of(sand, answer, {"--law", "power:2"}) == 1);
  CHECK(exit_of(sand, answer, {"--size-factor", "2"}) == 1);
}

TEST_CASE("verify: an answer without a sample is refused", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const Json none = solve_json({"-", "--at-most", "5"}, 1, sand);
  check_refused(verify(sand, none.dump()), "no sample");
  check_refused(verify(sand, replaced(none.dump(), "\"none\"", "\"unknown\"")), "no sample");
  check_refused(verify(sand, solve_json({"-"}, 0, sand).dump(), {"--radius"}), "leave out");
}

TEST_CASE("verify: a hand-made match, and it with one particle less or a size over a sieve", "[cli]") {
  const Json good = verify_json(three, sample("2,1\n4,1\n"), 0);
  CHECK(good.at("conditions").at("accurately_as_given").at("holds") == true);
  CHECK(good.at("classes").at(2).at("found") == "8/9");
  CHECK(good.at("particles") == "2");

  const Json twice = verify_json(three, sample("4,2\n2,2\n"), 0);
  CHECK(twice.at("conditions").at("accurately_as_given").at("holds") == false);
  CHECK(twice.at("classes").at(0).at("error_as_given") == "-8");
  CHECK(twice.at("ratio") == "2");

  const Json less = verify_json(three, sample("4,2\n2,1\n"), 1);
  CHECK(less.at("classes").at(0).at("found") == "1/17");
  CHECK(less.at("classes").at(0).at("error") == "8/153");
  CHECK(less.at("classes").at(0).at("error_percent") == "5.22875");
  CHECK(less.at("maximum_error") == "8/153");
  CHECK(less.at("total_error") == "16/153");
  CHECK(less.at("worst_class") == "1");
  CHECK(reason(less, "accurately") == "class 1 has 5.88235 % of the mass, not 11.1111 %");

  const std::string barely = "size_mm,mass\n1,8.000000001\n2,0\n3,64\n4,0\n";
  CHECK(reason(verify_json(barely, sample("2,1\n4,1\n"), 1), "accurately") ==
        "class 1 has 11.1111 - 1.2e-9 % of the mass, not 11.1111 %");

  const Json moved = verify_json(three, sample("2.000000001,1\n4,1\n"), 1);
  CHECK(moved.at("classes").at(1).at("quantity") == "1");
  CHECK(moved.at("worst_class") == "2");

  const Json above = verify_json(three, sample("2,1\n4.000000001,1\n"), 1);
  CHECK(above.at("outside").at("above") == "1");
  CHECK(reason(above, "describes") ==
        "1 particle larger than the largest opening, 4 mm, the first of 4.000000001 mm");

  const Json below = verify_json(three, sample("2,1\n4,1\n1,7\n"), 1);
  CHECK(below.at("maximum_error") == "0");
  CHECK(below.at("outside").at("below") == "7");
  CHECK_FALSE(holds(below, "describes"));
  CHECK_FALSE(holds(below, "accurately"));
}

TEST_CASE("verify: several sizes in a class are fine, and reported", "[cli]") {
  const std::string g = "size_mm,mass\n1,35\n3,64\n4,0\n";
  const Json report = verify_json(g, sample("2,1\n3,1\n4,1\n"), 0);
  CHECK(holds(report, "accurately"));
  CHECK_FALSE(holds(report, "articulately"));
  CHECK(reason(report, "articulately") == "class 1 has several sizes, such as 2 mm and 3 mm");
}

TEST_CASE("verify: the tolerance is closed and in percentage points", "[cli]") {
  const std::string g = "size_mm,mass\n1,8\n2,8\n4,0\n"; // halves
  const std::string s = sample("2,24\n4,1\n");           // 192 and 64: 3/4 and 1/4
  for (const char *enough : {"25%", "25", "25.0000000001%"})
    CHECK(exit_of(g, s, {"--tolerance", enough}) == 0);
  for (const char *little : {"24.9999999999999999999999%", "0", "0.25"})
    CHECK(exit_of(g, s, {"--tolerance", little}) == 1);
  CHECK(verify_json(g, s, 0, {"--tolerance", "0.25e2"}).at("tolerance_percent") == "25");
  CHECK(exit_of(g, sample("2,24\n4,1\n1,1\n"), {"--tolerance", "100%"}) == 1); // one outside
  for (const char *wrong : {"x", "%", "1%%", "retained:", "passing"})
    check_refused(verify(g, s, {std::string("--tolerance=") + wrong}),
                  "--tolerance: '" + std::string(wrong) + "' is no tolerance");
  for (const char *wrong : {"-1%", "101"})
    check_refused(verify(g, s, {std::string("--tolerance=") + wrong}), "is not between 0 and 100");
}

TEST_CASE("verify: tolerances of all kinds and a band hold together", "[cli]") {
  const std::string g = "size_mm,mass,tolerance_percent\n1,8,25\n2,8,30\n4,0,0\n"; // halves
  const std::string s = sample("2,24\n4,1\n");                                     // 3/4 and 1/4
  const auto exit_within = [&](const Arguments &tolerances) {
    Arguments options;
    for (const std::string &t : tolerances)
      options.insert(options.end(), {"--tolerance", t});
    return exit_of(g, s, options);
  };
  CHECK(exit_within({"passing:25%"}) == 0);
  CHECK(exit_within({"passing:24.999%"}) == 1);
  CHECK(exit_within({"total:50"}) == 0);
  CHECK(exit_within({"total:49"}) == 1);
  CHECK(exit_within({"file"}) == 0);
  CHECK(exit_within({"retained:25", "passing:25"}) == 0);
  CHECK(exit_within({"retained:24", "passing:25"}) == 1);
  CHECK(exit_within({"retained:25", "passing:24"}) == 1);
  CHECK(verify_json(g, s, 0, {"--tolerance", "passing:25%"}).at("within") == "passing:25%");
  CHECK(verify_json(g, s, 0, {"--tolerance", "25%"}).at("within").is_null());

  const TemporaryFolder folder;
  const auto exit_in_band = [&](const char *least, const char *most) {
    const std::string band = folder / "band.csv";
    std::ofstream(band) << "size_mm,passing_min_percent,passing_max_percent\n1,0,0\n2," << least << ","
                        << most << "\n4,100,100\n";
    return exit_of(g, s, {"--band", band});
  };
  CHECK(exit_in_band("75", "75") == 0);
  CHECK(exit_in_band("0", "74.9") == 1);
}

TEST_CASE("verify: sizes computed in double are taken as the sieve with --snap", "[cli]") {
  const std::string s = sample("2.0000000000000004,1\n4.0000000000000009,1\n");
  CHECK(exit_of(three, s) == 1);
  CHECK(verify(three, s).out.find("by less than 1e-12 of it: 2;") != std::string::npos);
  const Json report = verify_json(three, s, 0, {"--snap", "1e-15"});
  CHECK(report.at("notes").empty());
  CHECK(report.at("snapped") == "2");
  CHECK(verify(three, s, {"--snap", "1e-15"}).out.find("taken as an opening near by: 2 particles") !=
        std::string::npos);
  CHECK(exit_of(three, s, {"--snap", "1e-16"}) == 1);
  check_refused(verify(three, s, {"--snap", "0.5"}), "makes one of the openings");
  check_refused(verify(three, s, {"--snap", "-1"}), "--snap");
}

TEST_CASE("verify: options change the gradation as they do for solve", "[cli]") {
  CHECK(exit_of(three, sample("6,1\n3,1\n"), {"--size-factor", "1.5"}) == 0);
  CHECK(exit_of(three, sample("4,5\n"), {"--cut-below", "3"}) == 0);
  CHECK(exit_of(three, sample("2,2\n4,3\n"), {"--law", "power:2"}) == 1);
  CHECK(exit_of(three, sample("2,1\n4,2\n"), {"--law", "power:2"}) == 0);
  const std::string pan = "size_mm,mass\npan,8\n2,64\n4,0\n";
  CHECK(exit_of(pan, sample("2,1\n4,1\n")) == 0);
  CHECK(exit_of(pan, sample("2,1\n4,1\n"), {"--pan-size", "1.5"}) == 0);
  CHECK(exit_of(pan, sample("1,8\n4,1\n"), {"--pan-size", "1.5"}) == 1);
  const std::string dense = "size_mm,mass,factor\n1,24,3\n2,0,1\n3,64,1\n4,0,1\n";
  CHECK(exit_of(dense, sample("2,1\n4,1\n")) == 0);
  check_refused(verify(three, sample("2,1\n"), {"--cut-below", "7"}), "g.csv: there is no sieve of 7 mm");
  check_refused(verify("size_mm,mass\n1,1\n2." + std::string(990, '3') + ",0\n", sample("2,1\n"),
                       {"--law", "power:1000"}),
                "g.csv: the exponent 1000 is too large");
}

TEST_CASE("verify: edge 13: an irrational law is decided exactly", "[cli]") {
  // sqrt 2 and sqrt 8 = 2 sqrt 2.
  const std::string g = "size_mm,mass\n1,1\n2,2\n9,0\n";
  const Json tie = verify_json(g, sample("2,1\n8,1\n"), 0, {"--law", "power:1/2"});
  CHECK(tie.at("maximum_error") == "0");
  CHECK(holds(tie, "accurately"));
  // 1 + sqrt 2 + sqrt 3 beside twice as much.
  const std::string more = "size_mm,mass\n0,1\n3,2\n12,0\n";
  CHECK(exit_of(more, sample("1,1\n2,1\n3,1\n4,1\n8,1\n12,1\n"), {"--law", "power:1/2"}) == 0);
  CHECK(exit_of(more, sample("1,2\n2,1\n3,1\n4,1\n8,1\n12,1\n"), {"--law", "power:1/2"}) == 1);
  CHECK(exit_of("size_mm,mass\n1,1\n9,0\n", sample("2,1\n3,1\n5,1\n8,1\n"), {"--law", "power:1/2"}) == 0);
  CHECK(exit_of(g, sample("2,1\n8,1\n"), {"--law", "power:1/2", "--tolerance", "1e-100"}) == 0);
  CHECK(exit_of(g, sample("2,1\n8.0000000000000000000000001,1\n"), {"--law", "power:1/2"}) == 1);
  CHECK(exit_of(g, sample("1.5625,4\n6.25,4\n"), {"--law", "power:1/2"}) == 0); // rational: 1.25 and 2.5
}

TEST_CASE("verify: particle files of the engines", "[cli]") {
  const std::string sand = read_file(example("hostun-rf-sand"));
  const Json answer = solve_json({"-"}, 0, sand);
  const Arguments within{"--tolerance", "1e-9"};
  const auto with = [&within](Arguments more) {
    more.insert(more.end(), within.begin(), within.end());
    return more;
  };
  CHECK(exit_of(sand, particle_lines(answer), within) == 0);
  CHECK(exit_of(sand, particle_lines(answer)) == 1); // decimals are not the roots
  CHECK(exit_of(sand, particle_lines(answer, "1 2 3 "), with({"--diameter"})) == 0);
  CHECK(exit_of(sand, particle_lines(answer, "1 2 3 "), within) == 1);
  std::string zeros;
  for (int i = 0; i < 31; ++i)
    zeros += "0 0 0\n";
  CHECK(exit_of(sand,
                "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 31 float\n" + zeros +
                    "POINT_DATA 31\nSCALARS diameter float\n"
                    "LOOKUP_TABLE default\n" +
                    particle_lines(answer),
                with({"--size-unit", "mm"})) == 0);
  const std::string dump = "ITEM: TIMESTEP\n9\nITEM: NUMBER OF ATOMS\n31\nITEM: ATOMS type diameter\n" +
                           particle_lines(answer, "1 ");
  for (const char *format : {"lammps-dump", "LIGGGHTS-dump"})
    CHECK(exit_of(sand, dump, with({"--size-unit", "mm", "--from", format, "--timestep", "9"})) == 0);
  const Outcome metres = verify(sand, dump, within);
  CHECK(metres.exit_code == 1);
  CHECK(metres.out.find("in mm the first would: say so by --size-unit") != std::string::npos);
  CHECK(metres.out.find("diameters in m;") != std::string::npos);
}

TEST_CASE("verify: bad files are refused with their line", "[cli]") {
  check_refused(verify(three, sample("2,1\nx,1\n")), "stdin:3: diameter 'x' is not a number");
  check_refused(verify(three, ""), "stdin:1: there are no particles");
  check_refused(verify(three, "size_mm,quantity\n"), "there are no particles");
  check_refused(verify(three, "\x1B[31m\xFF\nabc\n"), "the format is not one that is known");
  check_refused(verify(three, "{\"a\":" + std::string(100000, '[')), "nested deeper");
  check_refused(verify(three, "{}"), "schema is missing");
  check_refused(verify("size_mm,mass\n1,1\n2,1\n", sample("2,1\n")), "add a row");
  check_refused(verify(three, sample("2,1\n"), {"--from", "xyz"}),
                "--from: 'xyz' is no format: use one of csv");
  check_refused(verify(three, sample("2,1\n"), {"--size-unit", "ft"}), "--size-unit");
  check_refused(verify(three, sample("2,1\n"), {"--timestep", "1"}), "--timestep is for dumps");
  check_refused(verify(three, sample("2,1\n"), {"--digits", "0"}), "--digits");
  check_refused(mdm({"verify", "-", "-"}, three), "cannot both be standard input");
  check_refused(mdm({"verify", "/nonexistent", "-"}, three), "/nonexistent");
  check_refused(mdm({"verify", example("athabasca-sand"), "/nonexistent"}), "/nonexistent");
}

TEST_CASE("verify: reports as text and CSV, to a file or standard output", "[cli]") {
  const TemporaryFolder folder;
  const std::string g = folder.write("sand.csv", three), s = folder.write("beads.csv", sample("2,1\n4,2\n"));
  const Outcome text = mdm({"verify", g, s});
  CHECK(text.exit_code == 1);
  CHECK(text.out.find("beads.csv against sand: does not match: the largest error of a share is 5.22875 %, in "
                      "class 1") != std::string::npos);
  CHECK(text.out.find("target - found") != std::string::npos);
  CHECK(text.out.find("the smallest exact match has 2 (ratio 1.5)") != std::string::npos);
  CHECK(mdm({"verify", "-", s}, three).exit_code == 1);
  const Outcome to_file = mdm({"verify", g, s, "-o", folder / "report"});
  CHECK(to_file.exit_code == 1);
  CHECK(to_file.out.empty());
  CHECK(read_file(folder / "report") == text.out);
  const Outcome csv = mdm({"verify", g, s, "--format", "csv", "--digits", "3"});
  CHECK(csv.out == "lower_mm,upper_mm,quantity,target_percent,found_percent,error_percent\n"
                   "1,2,1,11.1,5.88,5.22\n2,3,0,0,0,0\n3,4,2,88.8,94.1,-5.22\n");
  CHECK(csv.err.find("does not match") != std::string::npos);
  check_refused(mdm({"verify", g, s, "-o", s}), "would be overwritten");
  check_refused(mdm({"verify", g, s, "-o", g}), "would be overwritten");
  check_refused(mdm({"verify", g, s}, "", "/dev/full"), "No space left");
}

#if !MDM_IS_SANITIZED
TEST_CASE("verify: memory does not grow with the number of particles", "[cli]") {
  std::string chunk;
  for (int i = 0; i < 5000; ++i)
    chunk += "0.1 0.2 0.3 0." + std::to_string(100000007 + 9973 * i) + "\n";
  const auto most_kib = [&chunk](int chunks) {
    Process process(MDM_PROGRAM, {"verify", example("athabasca-sand"), "-"});
    for (int i = 0; i < chunks; ++i)
      process.send(chunk);
    const Outcome outcome = process.end();
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out.find("particles: " + std::to_string(5000 * chunks)) != std::string::npos);
    return outcome.max_rss_kib;
  };
  CHECK(most_kib(60) < most_kib(2) + 4 * 1024);
}
#endif

TEST_CASE("verify names another way for an answer that is too long for it", "[cli]") {
  const TemporaryFolder folder;
  const std::string long_text(std::size_t{65} << 20, ' ');
  const std::string line = folder.write("line.json", "{" + long_text + "}\n");
  const std::string lines = folder.write("lines.json", "{\n" + long_text.substr(long_text.size() / 2) + "\n" +
                                                           long_text.substr(long_text.size() / 2) + "}\n");
  for (const Arguments &from : {Arguments{}, Arguments{"--from", "answer"}})
    for (const std::string &file : {line, lines}) {
      Arguments arguments{"verify", example("athabasca-sand"), file};
      arguments.insert(arguments.end(), from.begin(), from.end());
      check_refused(mdm(arguments), "mdm export --spread --to csv");
    }
}

TEST_CASE("an answer with more than 1000 digits is read back", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("athabasca-sand");
  const std::string answer = folder / "a.json";
  const std::string gradation = folder / "g.json";
  REQUIRE(mdm({"solve", sand, "--digits", "1000", "--format", "json", "-o", answer}).exit_code == 0);
  CHECK(mdm({"verify", sand, answer}).exit_code == 0);
  REQUIRE(mdm({"convert", sand, "-o", gradation}).exit_code == 0);
  CHECK(mdm({"crosscheck", gradation, answer, "--require-minimal"}).exit_code == 0);
  CHECK(mdm({"export", answer, "--to", "diameters"}).exit_code == 0);
  CHECK(mdm({"plot", sand, answer, "-o", folder / "answer.svg"}).exit_code == 0);
}

TEST_CASE("an answer of one line that ends too early names line 1", "[cli]") {
  check_refused(verify(three, R"({"a":)"), "stdin:1: ");
}

TEST_CASE("verify: sizes of which ranges are known, each with a sieve in it, are undecided", "[cli]") {
  const std::string g = "size_mm,mass\n1,8\n2,8\n4,0\n";
  const Outcome outcome = verify(g, "size_lo_mm,size_hi_mm\n1.5,2.5\n1.9,2.1\n", {});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.find("of which only a range is known, with a sieve in it") != std::string::npos);
}

TEST_CASE("where spheres do not touch, --contact-gap is named", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("g.csv", "size_mm,mass\n0.5,1\n1,0\n");
  const auto report = [&](const std::string &places, const Arguments &more = {}) {
    Arguments arguments{"verify", sand, folder.write("grains", places), "--from", "xyzr", "--packing"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  };
  const std::string cut = "0 0 0 0.333333\n0 0 0.666667 0.333333\n";
  CHECK(report(cut).find("--contact-gap GAP takes") != std::string::npos);
  CHECK(report(cut, {"--contact-gap", "0.00001"}).find("contact-gap") == std::string::npos);
  CHECK(report("0 0 0 0.3\n0 0 0.6 0.3\n").find("contact-gap") == std::string::npos);
  CHECK(report("0 0 0 0.3\n").find("contact-gap") == std::string::npos);
}

TEST_CASE("verify judges places unasked up to 20000, and says where more or odd ones are left", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("g.csv", "size_mm,mass\n0.5,1\n1,0\n");
  const auto report = [&](const std::string &places, const Arguments &more = {}) {
    Arguments arguments{"verify", sand, folder.write("grains", places), "--from", "xyzr", "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out);
  };
  const auto has_note = [](const Json &found, const std::string &part) {
    for (const Json &note : found.at("notes"))
      if (note.get<std::string>().find(part) != std::string::npos)
        return true;
    return false;
  };
  CHECK(report("0 0 0 0.3\n0 0 1 0.3\n").at("packing").at("contacts") == "0");
  std::string row;
  for (int i = 0; i < 20000; ++i)
    row += "0 0 " + std::to_string(i) + " 0.3\n";
  CHECK_FALSE(report(row).at("packing").is_null());
  row += "0 0 20000 0.3\n";
  const Json more = report(row);
  CHECK(more.at("packing").is_null());
  CHECK(has_note(more, "There are more than 20000 places: --packing judges them."));
  CHECK(report(row, {"--packing"}).at("packing").at("space").at("high").size() == 3);
  const Json far = report("0 0 0 0.3\n0 0 1e99 0.3\n");
  CHECK(far.at("packing").is_null());
  check_refused(mdm({"verify", sand, folder / "grains", "--from", "xyzr", "--packing"}), "1e60");
}

TEST_CASE("verify: what is no number, outside, doubled or in another unit than it says never matches",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("g.csv", "size_mm,mass\n1,1\n2,0\n");
  const auto dump = [](const std::string &head, const std::string &rows) {
    return head +
           "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
           "ITEM: ATOMS id x y z diameter\n" +
           rows;
  };
  const auto judged = [&](const std::string &content, const Arguments &more = {}) {
    Arguments arguments{"verify", sand, folder.write("s.dump", content)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mdm(arguments);
  };
  const std::string first = "1 0.5 0.5 0.1 0.0015\n";
  CHECK(judged(dump("", first + "2 0.5 0.5 0.9 0.0015\n")).exit_code == 0);
  check_refused(judged(dump("", first + "2 nan 0.5 0.9 0.0015\n")), "s.dump:11: coordinate 'nan'");
  check_refused(judged(dump("", first + first)), "s.dump:11: id 1 is there a second time");
  const Outcome fallen = judged(dump("", first + "2 0.5 0.5 -5 0.0015\n"));
  CHECK(fallen.exit_code == 1);
  CHECK(fallen.out.find("does not match: the centre of 1 particle is outside the space") !=
        std::string::npos);
  CHECK(judged(dump("", first + "2 0.5 0.5 -5 0.0015\n"), {"--periodic", "z"}).exit_code == 0);
  CHECK(judged(dump("", first + "2 0.5 0.5 0.9 0.0015\n"), {"--specimen", "cylinder:500mm"}).exit_code == 1);
  CHECK(judged(dump("", first + "2 0.5 0.5 0.9 0.0015\n"), {"--specimen", "cylinder:1m"}).exit_code == 0);
  CHECK(judged(dump("", first + "2 0.5 0.5 0.9 0.0015\n"), {"--specimen", "cylinder:1mx0.8m"}).exit_code ==
        1);
  // 0.0015 cm are no 1.5 mm.
  const std::string centimetres = dump("ITEM: UNITS\ncgs\n", first + "2 0.5 0.5 0.9 0.0015\n");
  CHECK(judged(centimetres).exit_code == 1);
  check_refused(judged(centimetres, {"--size-unit", "m"}), "s.dump:2: the file says units cgs");
}

TEST_CASE("verify: all openings at which a band is left are named", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("g.csv", "size_mm,mass\n1,1\n2,1\n4,2\n8,0\n"),
                    sizes = folder.write("s.csv", "size_mm\n2\n4\n8\n"),
                    band = folder.write("b.csv",
                                        "size_mm,passing_min_percent,passing_max_percent\n1,0,0\n2,20,30\n"
                                        "4,45,55\n8,100,100\n");
  const Outcome outcome = mdm({"verify", sand, sizes, "--band", band});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find("what passes 2 mm is ") != std::string::npos);
  CHECK(outcome.out.find("; what passes 4 mm is ") != std::string::npos);
}

TEST_CASE("a LAMMPS data file has comments behind its counts", "[cli]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_m,mass\n1,1\n2,0\n");
  const Outcome outcome = mdm(
      {"verify", gradation, "-"},
      "title\n\n2 atoms # of glass\n1 atom types\n\nAtoms # sphere\n\n1 1 1.5 1 0 0 0\n2 1 1.5 1 2 0 0\n");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
}

} // namespace verify_test

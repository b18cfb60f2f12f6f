// mdm export: files with the counts of the match, which verify reads back; what looks like an accident is
// refused.

#include "all_cases.hpp"
#include "answer.hpp"

#include <cmath>

namespace export_test {

using namespace cli_test;

namespace {

const std::string gap = "size_mm,mass\n0.5,20\n1,0\n2,0\n4,80\n8,0\n";
const std::string fine = "size_mm,mass\n0.02,30\n0.045,25\n0.075,45\n0.12,0\n";
const std::string micrometres = "size_um,mass\n20,30\n45,25\n75,45\n120,0\n";
const std::string inches = "size_in,mass\n0.02,30\n0.045,25\n0.075,45\n0.12,0\n";

/// All formats: verify reads each of them.
const std::vector<std::string> readable = {"lammps",   "yade",       "vtk",        "csv",   "diameters",
                                           "liggghts", "mercurydpm", "esys",       "lethe", "kratos",
                                           "extxyz",   "pfc",        "dem-engine", "musen", "gsd"};

/// Above 2e-9 of a share, in percent; of floats, above 2e-7.
std::string rounding_of(const std::string &format) {
  return format == "gsd" || format == "dem-engine" ? "0.00004" : "0.0000002";
}

/// Exports what comes from standard input.
Outcome export_to(const std::string &format, const std::string &from, Arguments options = {}) {
  options.insert(options.begin(), {"export", "-", "--to", format});
  return mdm(options, from);
}

std::string file_of(const std::string &format, const std::string &from, const Arguments &options = {}) {
  const Outcome outcome = export_to(format, from, options);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  return outcome.out;
}

/// What verify says of a file in that unit.
Json verified(const std::string &gradation, const std::string &file, const std::string &format,
              const std::string &unit, const std::string &tolerance, const Arguments &more = {}) {
  const TemporaryFolder folder;
  Arguments arguments = {"verify",
                         folder.write("g.csv", gradation),
                         folder.write("particles", file),
                         "--tolerance",
                         tolerance,
                         "--format",
                         "json"};
  if (format != "csv" && format != "mercurydpm") // their headings name it
    arguments.insert(arguments.end(), {"--size-unit", unit});
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = mdm(arguments);
  INFO(format << outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  REQUIRE(Json::accept(outcome.out));
  return Json::parse(outcome.out);
}

} // namespace

TEST_CASE("export: verify finds the counts of the match and shares within the stated error", "[cli]") {
  std::size_t turn = 0;
  for (const std::string &gradation :
       {read_file(example("athabasca-sand")), read_file(example("c778-graded-sand")), gap, fine, micrometres,
        inches}) {
    REQUIRE(readable.size() % 2 == 1);
    const Json answer = solve_json({"-"}, 0, gradation);
    for (const std::string &format : readable) {
      ++turn;
      for (const std::string unit : {"m", "um"}) {
        // Some cases: each format in one of the units, and in the other for the next gradation.
        if (!takes_all_cases() && (turn % 2 == 0) != (unit == "m"))
          continue;
        const std::string from_gradation = file_of(format, gradation, {"--unit", unit});
        CHECK(from_gradation == file_of(format, gradation, {"--unit", unit}));
        // Shares of masses that are off by 1e-9 of themselves are off by less than 2e-7 percentage points.
        const Json report = verified(gradation, from_gradation, format, unit, rounding_of(format));
        CHECK(quantities(report) == quantities(answer));
        CHECK(report.at("particles") == answer.at("particles"));
        // The answer has another name for the gradation only where that is its file's.
        CHECK(file_of(format, answer.dump(), {"--unit", unit}) == from_gradation);
      }
    }
  }
}

TEST_CASE("export: errors are as small as they are asked to be", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const std::string coarse = file_of("csv", sand, {"--mass-error", "0.0001"});
  const std::string close = file_of("csv", sand, {"--mass-error", "1e-14"});
  CHECK(coarse.size() < close.size());
  verified(sand, coarse, "csv", "m", "0.02");
  verified(sand, close, "csv", "m", "1e-12");
  check_refused(export_to("csv", sand, {"--mass-error", "1e-30"}), "larger --mass-error");
}

TEST_CASE("export: --digits is taken, changes nothing, and the help says so", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  CHECK(file_of("csv", sand, {"--digits", "3"}) == file_of("csv", sand));
  check_refused(export_to("csv", sand, {"--digits", "0"}), "--digits");
  CHECK(mdm({"export", "--help"}).out.find("without effect here") != std::string::npos);
}

TEST_CASE("export: sizes on sieves stay in their classes as doubles", "[cli]") {
  // Every size of this match is an upper sieve; as doubles some sieves are above themselves.
  const std::string on_sieves = "size_mm,mass\n0.038,0.438976\n0.076,1.331\n0.11,3.375\n0.15,0\n";
  for (const std::string unit : {"m", "mm", "um", "in"}) {
    const std::string file = file_of("yade", on_sieves, {"--scale", "upper", "--unit", unit});
    CHECK(export_to("csv", on_sieves, {"--scale", "upper"}).err.find("double precision") ==
          std::string::npos);
    const Json report = verified(on_sieves, file, "yade", unit, "0.0000002");
    CHECK(quantities(report) == "1 1 1");
  }
}

TEST_CASE("export: matches within a tolerance, other laws and other solving options", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const Json answer = solve_json({"-", "--tolerance", "retained:1%"}, 0, sand);
  for (const std::string &file :
       {file_of("lammps", sand, {"--tolerance", "retained:1%"}), file_of("lammps", answer.dump())}) {
    const Json report = verified(sand, file, "lammps", "m", "1.0000002");
    CHECK(quantities(report) == quantities(answer));
  }
  const Json flat = solve_json({"-", "--law", "power:2"}, 0, sand);
  CHECK(file_of("csv", sand, {"--law", "power:2"}) == file_of("csv", flat.dump(), {"--law", "power:2"}));
  for (const std::string &format : readable) {
    const Outcome made = export_to(format, sand, {"--law", "power:2"});
    const std::string file = made.out;
    // Files of these have no comments.
    const bool is_bare = format == "esys" || format == "lethe" || format == "pfc" || format == "dem-engine" ||
                         format == "musen" || format == "gsd";
    CHECK((is_bare ? made.err : file).find("by --law: x^(2) of a size x") != std::string::npos);
    CHECK(file_of(format, sand).find("--law") == std::string::npos);
    CHECK(quantities(verified(sand, file, format, "m", rounding_of(format), {"--law", "power:2"})) ==
          quantities(flat));
  }
  check_refused(export_to("csv", flat.dump()), "--law");
  check_refused(export_to("csv", answer.dump(), {"--at-least", "10"}), "--at-least: the answer");
  const Outcome limited = export_to("csv", sand, {"--max-steps", "0"});
  CHECK(limited.exit_code == 3);
  CHECK(limited.err.find("stopped at a limit") != std::string::npos);
  CHECK(quantities(verified(sand, limited.out, "csv", "m", "0.0000002")) == "819 90 280 268 25 2 1");
  const Outcome none = export_to("csv", sand, {"--at-most", "1484"});
  CHECK(none.exit_code == 1);
  CHECK(none.out.empty());
  CHECK(none.err.find("1485 particles") != std::string::npos);
}

TEST_CASE("export: the specimen or the box is what the particles stand on", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const auto box = [&sand](const Arguments &options) {
    const std::string file = file_of("lammps", sand, options);
    std::string sides;
    for (const std::string axis : {" xlo", " ylo", " zlo"}) {
      const std::size_t end = file.find(axis), begin = file.rfind("\n0 ", end) + 3;
      sides += file.substr(begin, end - begin) + " ";
    }
    return sides;
  };
  CHECK(box({"--specimen", "box:3x4x5", "--void-ratio", "0.7"}).substr(0, 12) == "0.003 0.004 ");
  CHECK(box({"--box", "3x4"}).substr(0, 12) == "0.003 0.004 ");
  CHECK(box({"--box", "3x4x20"}) == "0.003 0.004 0.02 ");
  CHECK(box({"--box", "3x4x20", "--unit", "mm"}) == "3 4 20 ");
  const double side = std::stod(box({"--specimen", "cylinder:4x4", "--void-ratio", "0.7"}));
  CHECK(side == Approx(0.004 / std::sqrt(2.0)).epsilon(1e-4));
}

TEST_CASE("export: a million particles take little memory", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder / "particles";
  const Outcome outcome =
      mdm({"export", example("athabasca-sand"), "--to", "yade", "--at-least", "1000000", "-o", path});
  CHECK(outcome.exit_code == 0);
  const std::string file = read_file(path);
  CHECK(std::count(file.begin(), file.end(), '\n') == 1000000 + 5);
  CHECK((MDM_IS_SANITIZED || outcome.max_rss_kib < 40000));
}

TEST_CASE("export: what it will cost is on standard error", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  const Outcome loud = export_to("yade", sand, {"--young", "5e6", "--poisson", "0.3"});
  CHECK(loud.err.find("1485 particles") != std::string::npos);
  CHECK(loud.err.find("E = 5e6 Pa, nu = 0.3") != std::string::npos);
  CHECK(loud.err.find("memory of yade") != std::string::npos);
  CHECK(loud.err.find("void ratio") != std::string::npos);
  // pi R sqrt(rho / G) / (0.1631 nu + 0.8766) with R = 37.994 um, rho = 2650, G = 5e6 / 2.6
  const std::size_t at = loud.err.find("Rayleigh time ");
  REQUIRE(at != std::string::npos);
  const double time = std::stod(loud.err.substr(at + 14));
  CHECK(time == Approx(std::acos(-1.0) * 3.79939e-5 * std::sqrt(2650 * 2.6 / 5e6) / (0.1631 * 0.3 + 0.8766))
                    .epsilon(0.01));
  CHECK(export_to("yade", sand, {"--quiet"}).err.empty());
  CHECK(export_to("mercurydpm", sand).err.find("counts are not exact") != std::string::npos);
  CHECK(export_to("dem-engine", sand).err.find("LoadSphereType(mass, radius, material)") !=
        std::string::npos);
}

TEST_CASE("export: a density in g/cm^3 is told, with the option's unit", "[cli]") {
  const std::string plain = "size_mm,mass\n1,1\n2,2\n4,0\n";
  CHECK(contains(export_to("csv", plain, {"--density", "2.65"}).err,
                 "density: 2.65 kg/m^3, which few grains have: --density is in kg/m^3, such as 2650"));
  CHECK_FALSE(contains(export_to("csv", plain).err, "which few grains have"));
  const std::string factors = "size_mm,mass,factor\n1,1,2.65\n2,2,2.7\n4,0,1\n";
  CHECK(contains(export_to("csv", factors, {"--density", "1"}).err, "1000 where they are in g/cm^3"));
}

TEST_CASE("export: what looks like an accident needs an option", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  for (const std::string format : {"liggghts", "lammps", "yade", "vtk", "diameters", "mercurydpm"})
    check_refused(export_to(format, sand, {"--at-least", "10000001"}), "--yes-huge");
  CHECK(export_to("csv", sand, {"--at-least", "10000001"}).exit_code == 0);
  CHECK(export_to("liggghts", sand, {"--at-least", "10000001", "--yes-huge"}).exit_code == 0);
  check_refused(export_to("liggghts", sand, {"--at-least", "2147483648", "--yes-huge"}), "2147483647");
  check_refused(export_to("csv", "size_um,mass\n0.1,1\n0.2,0\n"), "--yes-units");
  CHECK(export_to("csv", "size_um,mass\n0.1,1\n0.2,0\n", {"--yes-units"}).exit_code == 0);
  check_refused(export_to("csv", "size_m,mass\n75,1\n150,0\n"), "more than 100 m");
  check_refused(export_to("lammps", sand, {"--box", "3x100001"}), "more than 100 m");
  CHECK(export_to("lammps", sand, {"--box", "3x100001", "--yes-units"}).exit_code == 0);
}

TEST_CASE("export: nonsense is refused", "[cli]") {
  const std::string sand = read_file(example("athabasca-sand"));
  check_refused(export_to("edem", sand), "use one of");
  check_refused(export_to("csv", sand, {"--unit", "ft"}), "--unit");
  check_refused(export_to("csv", sand, {"--density", "0"}), "--density");
  check_refused(export_to("csv", sand, {"--density", "nan"}), "--density");
  for (const std::string size : {"1.01e30", "1e400", "0.99e-30", "1e-400"}) {
    check_refused(export_to("csv", sand, {"--density", size}), "from 1e-30 to 1e30");
    check_refused(export_to("csv", sand, {"--young", size}), "from 1e-30 to 1e30");
  }
  check_refused(export_to("csv", sand, {"--mass-error", "-1"}), "--mass-error");
  check_refused(export_to("csv", sand, {"--box", "3x4"}), "--box: csv");
  check_refused(export_to("liggghts", sand, {"--seed", "3"}), "--seed: liggghts");
  for (const std::string box : {"3", "3x", "3x4x5x6", "0x3", "ax3", "", "3x4x"})
    check_refused(export_to("yade", sand, {"--box", box}), "--box");
  check_refused(export_to("yade", sand, {"--box", "0.5x5"}), "narrower than the largest");
  check_refused(export_to("yade", sand, {"--box", "2x2x2"}), "wider");
  check_refused(export_to("yade", sand, {"--seed", "x"}), "--seed");
  check_refused(export_to("yade", sand, {"--seed", "18446744073709551616"}), "--seed: at most");
  CHECK(file_of("yade", sand, {"--seed", "18446744073709551615"}) !=
        file_of("yade", sand, {"--seed", "18446744073709551614"}));
  check_refused(export_to("yade", sand, {"--poisson", "0.6"}), "--poisson");
  check_refused(export_to("yade", sand, {"--young", "0"}), "--young");
  check_refused(export_to("yade", "nothing"), "stdin");
  check_refused(export_to("yade", "{\"schema\":\"mdm-batch-1\"}"), "schema");
  check_refused(mdm({"export", example("athabasca-sand")}), "--to");
  const TemporaryFolder folder;
  const std::string path = folder.write("sand.csv", sand);
  check_refused(mdm({"export", path, "--to", "csv", "-o", path}), "sand.csv");
  check_refused(mdm({"export", path, "--to", "yade", "--box", "0.5x0.5", "-o", folder / "new"}));
  CHECK(folder.entries() == 1);
}

TEST_CASE("export: sizes that are said to be radii and diameters are refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string particles = folder.write("particles.csv", "size_mm,quantity\n1,3\n");
  const Outcome radii = mdm({"export", particles, "--to", "csv", "--radius"});
  CHECK(radii.exit_code == 0);
  CHECK(contains(radii.out, "# The mass of each class is that of the exact sizes within "));
  CHECK(contains(radii.out, ": 3 in 1 class, by exactmdm"));
  check_refused(mdm({"export", particles, "--to", "csv", "--radius", "--diameter"}),
                "--radius and --diameter: give one of them");
}

TEST_CASE("export: an answer in another order, or with options of gradations, is refused", "[cli]") {
  Json answer = solve_json({example("athabasca-sand")});
  CHECK(export_to("lammps", answer.dump()).exit_code == 0);
  check_refused(export_to("lammps", answer.dump(), {"--specimen-id", "BH1"}), "--specimen-id: the answer");
  std::reverse(answer["classes"].begin(), answer["classes"].end());
  check_refused(export_to("lammps", answer.dump(), {"--start", "mixed"}), "before it: solve again");
}

TEST_CASE("export: a gradation is one, whatever its id", "[cli]") {
  const std::string text = R"({"id":"schema","sizes":["1","2"],"masses":["3","0"]})";
  CHECK(file_of("csv", text).find("# Particles of schema: 1 in ") == 0);
}

TEST_CASE("export: a band alone gives the particles of its answer", "[cli]") {
  const Arguments band = {"--band", example("c33-fine-aggregate-limits")};
  Arguments solving = {"solve", "--format", "json"}, exporting = {"export", "--to", "csv"};
  solving.insert(solving.end(), band.begin(), band.end());
  exporting.insert(exporting.end(), band.begin(), band.end());
  const Outcome outcome = mdm(exporting);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == file_of("csv", mdm(solving).out));
  check_refused(mdm({"export", "--to", "csv"}), "or --band");
  exporting.insert(exporting.end(), {"--specimen-id", "BH1"});
  check_refused(mdm(exporting), "--specimen-id");
}

TEST_CASE("export: a spread has the sizes that solve gives", "[cli]") {
  const std::string sand = read_file(example("c778-graded-sand"));
  const Json answer = solve_json({"-", "--spread", "--seed", "7"}, 0, sand);
  const std::string file =
      file_of("csv", sand, {"--spread", "--seed", "7", "--unit", "mm", "--mass-error", "1e-14"});
  std::vector<double> solved, written;
  for (const Json &c : answer.at("classes"))
    if (c.contains("sizes"))
      for (const Json &size : c.at("sizes"))
        solved.push_back(std::stod(size.at(0).get<std::string>()));
  for (std::size_t at = file.find("size_mm"); (at = file.find('\n', at) + 1) < file.size();)
    written.push_back(std::stod(file.substr(at)));
  std::sort(solved.begin(), solved.end());
  REQUIRE(written.size() == solved.size());
  for (std::size_t i = 0; i < solved.size(); ++i)
    CHECK(written[i] == Approx(solved[i]).epsilon(1e-13));
  for (const std::string &format : readable) {
    const Json report = verified(sand, file_of(format, sand, {"--spread"}), format, "m", rounding_of(format));
    CHECK(quantities(report) == quantities(answer));
  }
  check_refused(export_to("csv", answer.dump()), "--spread");
  check_refused(export_to("csv", answer.dump(), {"--spread"}), "--spread: the answer");
  check_refused(export_to("csv", sand, {"--spread", "--at-least", "10000001"}), "leave --spread out");
}

TEST_CASE("export says how its file is verified, and that accepts it", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("Hostun's sand.csv", read_file(example("hostun-rf-sand")));
  for (const std::string format : {"liggghts", "lammps", "yade", "vtk", "csv", "diameters", "esys", "lethe",
                                   "kratos", "extxyz", "pfc", "dem-engine", "musen", "gsd"}) {
    const Outcome made =
        mdm({"export", sand, "--size-factor", "2", "--to", format, "-o", folder / ("grains." + format)});
    REQUIRE(made.exit_code == 0);
    const std::string begin = "check it by: mdm ";
    const std::size_t at = made.err.find(begin);
    REQUIRE(at != std::string::npos);
    const std::string command = std::string("'") + MDM_PROGRAM + "' " + made.err.substr(at + begin.size());
    const Outcome judged = Process("/bin/sh", {"-c", command}).end();
    INFO(made.err << judged.out << judged.err);
    CHECK(judged.exit_code == 0);
  }
  CHECK(mdm({"export", example("hostun-rf-sand"), "--to", "mercurydpm", "-o", folder / "grains"})
            .err.find("check it") == std::string::npos);
}

TEST_CASE("export: PhasicFlow has three files, of the same particles", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", read_file(example("athabasca-sand")));
  const Outcome made = mdm({"export", sand, "--to", "phasicflow", "-o", folder / "particlesDict"});
  INFO(made.err);
  REQUIRE(made.exit_code == 0);
  CHECK(made.err.find("what ends in -shapes into caseSetup as shapes") != std::string::npos);
  const Json answer = solve_json({sand});
  CHECK(quantities(verified(read_file(sand), read_file(folder / "particlesDict"), "phasicflow", "m",
                            "0.0000002")) == quantities(answer));
  const std::string positions = read_file(folder / "particlesDict-positions");
  const std::string shapes = read_file(folder / "particlesDict-shapes");
  CHECK(std::to_string(std::count(positions.begin(), positions.end(), '\n')) == answer.at("particles"));
  const auto words = [&shapes](const std::string &of) {
    const std::size_t begin = shapes.find("\n" + of + " (");
    const std::string list = shapes.substr(begin, shapes.find(");", begin) - begin);
    return std::count(list.begin(), list.end(), ' ') - 2;
  };
  CHECK(words("diameters") == 7);
  CHECK(words("names") == 7);
  CHECK(words("materials") == 7);
  check_refused(mdm({"export", sand, "--to", "phasicflow"}), "say where with -o FILE");
  check_refused(mdm({"export", folder.write("dict-positions", read_file(sand)), "--to", "phasicflow", "-o",
                     folder / "dict"}),
                "dict-positions");
}

TEST_CASE("a box that is rounded is told", "[cli]") {
  const TemporaryFolder folder;
  const auto told = [&](const std::string &box) {
    const Outcome outcome = mdm({"export", "-", "--to", "lammps", "--box", box, "-o", folder / "x"},
                                R"({"id":"small","sizes":[1,2,3],"masses":[2,1,0]})");
    CHECK(outcome.exit_code == 0);
    return outcome.err;
  };
  CHECK(contains(told("50.00000123x60"), "note: the box's side of 0.05000000123 m was rounded down to 0.05"));
  CHECK_FALSE(contains(told("50x60"), "rounded"));
}

TEST_CASE("a file says its unit in its heading, and is read back in it", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("athabasca-sand");
  for (const std::string format : {"yade", "diameters", "extxyz"})
    for (const std::string unit : {"m", "um"}) {
      INFO(format << ' ' << unit);
      const std::string file = folder / (format + unit + ".txt");
      REQUIRE(mdm({"export", sand, "--to", format, "--unit", unit, "-o", file, "--quiet"}).exit_code == 0);
      CHECK(mdm({"verify", sand, file, "--tolerance", "1e-6"}).exit_code == 0);
      CHECK(mdm({"verify", sand, file, "--tolerance", "1e-6", "--size-unit", unit}).exit_code == 0);
      CHECK(
          contains(mdm({"verify", sand, file, "--size-unit", "mm"}).err, "and mm was given: leave that out"));
    }
}

} // namespace export_test

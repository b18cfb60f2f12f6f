// mdm export --model: the files that it writes and what it refuses. tests/engines runs them.

#include "answer.hpp"

#include <cmath>
#include <sstream>

namespace export_model_test {

using namespace cli_test;

namespace {

const std::string sand = example("c778-graded-sand");

Outcome export_model(const std::string &to, const std::string &out, const Arguments &more = {}) {
  Arguments arguments{"export", sand, "--to", to, "--model", "settle", "-o", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments);
}

/// Words of the command that a model gives behind `# Then: mdm `.
Arguments verification(const std::string &model, const std::string &dump, const std::string &gradation,
                       const std::string &sample) {
  const std::string begin = "\n# Then: mdm ";
  const std::size_t at = model.find(begin);
  REQUIRE(at != std::string::npos);
  std::istringstream words(model.substr(at + begin.size(), model.find('\n', at + 1) - at - begin.size()));
  Arguments arguments;
  for (std::string word; words >> word;)
    arguments.push_back(word == "GRADATION" ? gradation : word == dump ? sample : word);
  return arguments;
}

} // namespace

TEST_CASE("the command that a model gives accepts its grains, however they were solved", "[cli]") {
  const TemporaryFolder folder;
  const std::string factors = folder.write("f.csv", "size_mm,mass,factor\n0.1,3,1\n0.2,5,1.5\n0.4,0,1\n");
  const std::string on_sieves =
      folder.write("s.csv", "size_mm,mass\n0.038,0.438976\n0.076,1.331\n0.11,3.375\n0.15,0\n");
  const std::string athabasca = example("athabasca-sand");
  const std::string panned = folder.write("p.csv", "size_mm,mass\npan,1\n0.075,3\n0.15,9\n0.3,0\n");
  const std::vector<std::pair<std::string, Arguments>> asked = {
      {sand, {}},
      {factors, {}},
      {panned, {"--pan-size", "0.01", "--spread"}},
      {on_sieves, {"--scale", "upper"}},
      {athabasca, {"--tolerance", "retained:1%"}},
      {athabasca, {"--tolerance", "passing:1%", "--spread", "--mass-error", "1e-6"}},
      {athabasca, {"--tolerance", "total:3%", "--law", "power:2", "--size-factor", "5"}},
      {athabasca, {"--tolerance", "laboratory", "--cut-below", "0.11", "--size-factor", "2"}},
      {athabasca, {"--law", "power:2"}},
      {athabasca, {"--law", "power:5/2", "--at-least", "2000"}},
      {athabasca, {"--cut-below", "0.11", "--size-factor", "5"}}};
  for (const auto &[gradation, options] : asked)
    for (const std::string to : {"lammps", "yade"}) {
      const std::string model = folder / (to == "yade" ? "a.py" : "a.in");
      Arguments arguments{"export", gradation, "--to", to, "--model", "settle", "-o", model};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Outcome exported = mdm(arguments);
      INFO(exported.err);
      REQUIRE(exported.exit_code == 0);
      const Outcome verdict =
          to == "yade" ? mdm(verification(read_file(model), "a-settled.xyzr", gradation, folder / "a.xyzr"))
                       : mdm(verification(read_file(model), "a-settled.dump", gradation, folder / "a.data"));
      INFO(read_file(model).substr(0, 1000) << verdict.out << verdict.err);
      CHECK(verdict.exit_code == 0);
      CHECK((read_file(model).find("# Masses are by --law: x^(") != std::string::npos) ==
            (std::find(options.begin(), options.end(), "--law") != options.end()));
    }
}

TEST_CASE("the command that a model of an answer or a band gives is honest", "[cli]") {
  const TemporaryFolder folder;
  const std::string model = folder / "a.in";
  Json answer = solve_json({example("athabasca-sand"), "--tolerance", "retained:1%"});
  answer["question"] = "within retained:1%";
  const std::string file = folder.write("answer.json", answer.dump());
  REQUIRE(mdm({"export", file, "--to", "lammps", "--model", "settle", "-o", model}).exit_code == 0);
  CHECK(mdm(verification(read_file(model), "a-settled.dump", example("athabasca-sand"), folder / "a.data"))
            .exit_code == 0);
  CHECK(read_file(model).find("as mdm solve had them: within retained:1%.)\n") != std::string::npos);
  REQUIRE(mdm({"export", "--band", example("c33-fine-aggregate-limits"), "--to", "lammps", "--model",
               "settle", "-o", model})
              .exit_code == 0);
  CHECK(read_file(model).find("mdm verify GRADATION") == std::string::npos);
  CHECK(read_file(model).find("\n# mdm verify needs a gradation") != std::string::npos);
}

TEST_CASE("a model lies beside the files that it reads", "[cli]") {
  const TemporaryFolder folder;
  CHECK(export_model("liggghts", folder / "a.in").exit_code == 0);
  CHECK(folder.entries() == 3);
  CHECK(read_file(folder / "a.in").find(" file a-lid.stl ") != std::string::npos);
  CHECK(read_file(folder / "a-lid.stl").find("endsolid") != std::string::npos);
  CHECK(export_model("LAMMPS", folder / "b.in").exit_code == 0);
  CHECK(folder.entries() == 5);
  CHECK(read_file(folder / "b.in").find("\"read_data b.data\"") != std::string::npos);
  CHECK(read_file(folder / "b.data").find("\n141 atoms\n") != std::string::npos);
  CHECK(read_file(folder / "b.data") == read_file(folder / "a.data"));
  CHECK(export_model("yade", folder / "c.py").exit_code == 0);
  CHECK(folder.entries() == 7);
  CHECK(read_file(folder / "c.py").find("with open('c.xyzr') as file:\n") != std::string::npos);
  CHECK(mdm({"verify", sand, folder / "c.xyzr", "--size-unit", "m", "--tolerance", "1e-6"}).exit_code == 0);
}

TEST_CASE("a model's box is the one that was asked for, in the unit of the gradation", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string to : {"liggghts", "lammps"}) {
    REQUIRE(export_model(to, folder / "b.in", {"--box", "3x2.5x20"}).exit_code == 0);
    CHECK(read_file(folder / "b.data").find("\n0 0.003 xlo xhi\n0 0.0025 ylo yhi\n0 0.02 zlo zhi\n") !=
          std::string::npos);
  }
  REQUIRE(export_model("yade", folder / "c.py", {"--box", "3x2.5x20"}).exit_code == 0);
  CHECK(read_file(folder / "c.py").find("\nx, y, z = 0.003, 0.0025, 0.02 ") != std::string::npos);
}

TEST_CASE("a cylinder stays one, and its start is inside", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string start : {"mixed", "deposit"}) {
    const Outcome outcome =
        export_model("lammps", folder / "a.in", {"--specimen", "cylinder:4x4", "--start", start});
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.find("cylinder in a box: 0.004 x 0.004 x ") != std::string::npos);
    CHECK(read_file(folder / "a.in").find("settle in a cylinder of diameter 0.004 m") != std::string::npos);
    const std::string data = read_file(folder / "a.data");
    std::istringstream rows(data.substr(data.find("Atoms # sphere") + 14));
    std::size_t n = 0;
    for (double id, type, d, density, x, y, z; rows >> id >> type >> d >> density >> x >> y >> z; ++n)
      CHECK(std::hypot(x - 0.002, y - 0.002) + d / 2 <= 0.002);
    CHECK(n == 141);
    // The command that the model gives judges the cylinder, up to its highest grain, and not the box around
    // it.
    Arguments verifying = verification(read_file(folder / "a.in"), "a-settled.dump", sand, folder / "a.data");
    verifying.insert(verifying.end(), {"--format", "json"});
    const Json packing = Json::parse(mdm(verifying).out).at("packing");
    CHECK(packing.at("shape") == "cylinder");
    CHECK(packing.at("space").at("high").at(0) == "4");
    CHECK(packing.at("outside") == "0");
  }
  check_refused(export_model("lammps", folder / "a.in", {"--specimen", "cylinder:4x4", "--start", "layers"}),
                "take mixed or deposit");
}

TEST_CASE("the specimen at its void ratio sets the number of particles and the target of the model",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string model = folder / "a.in";
  REQUIRE(export_model("lammps", model, {"--specimen", "cylinder:4x4", "--void-ratio", "0.65"}).exit_code ==
          0);
  CHECK(read_file(model).find("and are compacted by a lid to void ratio 0.65.") != std::string::npos);
  const std::string lid = "# At void ratio 0.65 the lid is ";
  const std::string text = read_file(model);
  CHECK(std::stod(text.substr(text.find(lid) + lid.size())) >= 0.004);
  REQUIRE(export_model("lammps", model, {"--void-ratio", "0.65"}).exit_code == 0);
  CHECK(
      read_file(model).find(": 141 grains settle in a box, and are compacted by a lid to void ratio 0.65.") !=
      std::string::npos);
  CHECK(export_model("lammps", model, {"--specimen", "cylinder:4x4", "--stress", "1e5"})
            .err.find("note: without --void-ratio the gradation sets the number") != std::string::npos);
  REQUIRE(export_model("lammps", model, {"--stress", "1e5"}).exit_code == 0);
  CHECK(read_file(model).find(", and are compacted by a lid at 100000 Pa.") != std::string::npos);
}

TEST_CASE("pressures and Young's moduli are taken with a unit", "[cli]") {
  const TemporaryFolder folder;
  const std::string model = folder / "model.py";
  REQUIRE(export_model("yade", model, {"--stress", "250000", "--young", "7e7"}).exit_code == 0);
  const std::string in_pascals = read_file(model);
  for (const auto &[stress, young] : {std::pair{"250kPa", "0.07GPa"}, std::pair{"0.25 MPa", "70 MPa"}}) {
    REQUIRE(export_model("yade", model, {"--stress", stress, "--young", young}).exit_code == 0);
    CHECK(read_file(model) == in_pascals);
  }
  for (const char *wrong : {"100psi", "kPa", "-1kPa", "1 k Pa", "1e40GPa"})
    check_refused(export_model("yade", model, {"--stress", wrong}), "--stress");
}

TEST_CASE("a periodic box has the ratios of the sides that are asked for", "[cli]") {
  const TemporaryFolder folder;
  REQUIRE(export_model("lammps", folder / "a.in", {"--periodic", "--void-ratio", "0.6", "--box", "1x1x2"})
              .exit_code == 0);
  const std::string data = read_file(folder / "a.data");
  const auto length = [&data](const std::string &axis) {
    return std::stod(data.substr(data.rfind('\n', data.find(" " + axis + "lo")) + 3));
  };
  CHECK(length("z") / length("x") == Approx(2).epsilon(1e-3));
  CHECK(length("y") == length("x"));
  CHECK(read_file(folder / "a.in").find("compacted by its six faces to void ratio 0.6.") !=
        std::string::npos);
}

namespace {

Outcome export_triaxial(const std::string &to, const std::string &out, const Arguments &more) {
  Arguments arguments{"export", sand, "--to", to, "--model", "triaxial", "--at-least", "500", "-o", out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments);
}

} // namespace

TEST_CASE("a triaxial model says what it does, and to what its numbers are bound", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string to : {"lammps", "yade"}) {
    const std::string file = folder / (to == "yade" ? "a.py" : "a.in");
    const Outcome outcome = export_triaxial(to, file, {"--stress", "1e5", "--void-ratio", "0.5"});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.find(" steps of shear;") != std::string::npos);
    const std::string text = read_file(file);
    for (const char *const part :
         {"at 100000 Pa, and sheared as in a drained triaxial test at constant sigma_3 to axial strain 0.2. ",
          "# Void ratio 0.5 at that pressure:", "# Triaxial: each face is brought to 100000 Pa;",
          "have sigma_3 within 2 % of 100000 Pa", "The log is a-triaxial.csv", "Compression is positive",
          "has neither walls nor a membrane", "a-sheared.",
          "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force,constant"})
      CHECK(text.find(part) != std::string::npos);
  }
  REQUIRE(
      export_triaxial("lammps", folder / "b.in", {"--stress", "1e5", "--axial-strain", "0.05"}).exit_code ==
      0);
  CHECK(read_file(folder / "b.in").find("\nvariable axial_strain index 0.05 ") != std::string::npos);
  CHECK(read_file(folder / "b.in").find("asked_void_ratio") == std::string::npos);
}

TEST_CASE("a triaxial model says that p is constant where it is", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string to : {"lammps", "yade"}) {
    const std::string file = folder / (to == "yade" ? "a.py" : "a.in");
    REQUIRE(export_triaxial(to, file, {"--stress", "100kPa", "--constant", "p"}).exit_code == 0);
    const std::string text = read_file(file);
    for (const char *const part :
         {"triaxial test at constant p to axial strain 0.2. ",
          "so that p is constant: each is to have (3 p - sigma_1)/2.", "have p within 2 % of 100000 Pa",
          " have p more than ", "p was not constant: in "})
      CHECK(text.find(part) != std::string::npos);
    for (const char *const part : {"sigma_3 was not", "have sigma_3"})
      CHECK(text.find(part) == std::string::npos);
  }
}

TEST_CASE("a triaxial model for LIGGGHTS has six walls without friction", "[cli]") {
  const TemporaryFolder folder;
  REQUIRE(export_triaxial("liggghts", folder / "a.in", {"--stress", "1e5", "--rolling-friction", "0.1"})
              .exit_code == 0);
  CHECK(read_file(folder / "a-wall.stl").rfind("solid wall\n", 0) == 0);
  CHECK(!std::filesystem::exists(folder / "a-lid.stl"));
  CHECK(read_file(folder / "a.data").find("\n6 atom types\n") != std::string::npos);
  const std::string text = read_file(folder / "a.in");
  for (const char *const part :
       {" grains between six walls, without gravity, and are compacted by them at 100000 Pa, and sheared as "
        "in",
        "The walls have no friction", "\nvariable wall_friction index 0 ",
        "peratomtypepair 6 ${grip} ${grip} ${grip} ${grip} ${grip} ${wall_friction} ${grip}",
        "coefficientRollingFriction peratomtypepair 6 0.1 0.1 0.1 0.1 0.1 0 0.1",
        "meshes west east south north bottom top\n"})
    CHECK(text.find(part) != std::string::npos);
  CHECK(text.find("gravity all") == std::string::npos);
  // The file's box is repeated, and walls cannot be.
  const std::string cell = folder.write(
      "cell.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 3\n0 3\n0 3\n"
                   "ITEM: ATOMS id x y z radius\n1 1 1 1 0.4\n");
  check_refused(mdm({"export", cell, "--to", "liggghts", "--model", "triaxial", "--stress", "1000",
                     "--size-unit", "mm", "-o", folder / "b.in"}),
                "this model's has six walls: give --start mixed");
}

TEST_CASE("a settled cell is where a triaxial model may begin", "[cli]") {
  const TemporaryFolder folder;
  std::ostringstream dump;
  dump << "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n27\nITEM: BOX BOUNDS pp pp pp\n0 3\n0 3\n0 3\n"
          "ITEM: ATOMS id x y z radius\n";
  for (int i = 0; i < 27; ++i)
    dump << i + 1 << " " << i % 3 << ".5 " << i / 3 % 3 << ".5 " << i / 9 << ".5 0.4\n";
  const Outcome kept =
      mdm({"export", folder.write("cell.dump", dump.str()), "--to", "lammps", "--model", "triaxial",
           "--stress", "1000", "--size-unit", "mm", "--axial-strain", "0.05", "-o", folder / "c.in"});
  INFO(kept.err);
  CHECK(kept.exit_code == 0);
  CHECK(kept.err.find("the particles stay where they lie in FILE") != std::string::npos);
}

TEST_CASE("what a triaxial model cannot be is refused", "[cli]") {
  const TemporaryFolder folder;
  const auto refused = [&folder](const Arguments &more, const std::string &remedy,
                                 const std::string &to = "lammps") {
    check_refused(export_triaxial(to, folder / "a.in", more), remedy);
  };
  refused({}, "the pressure before the shear by --stress");
  refused({"--void-ratio", "0.5"}, "the pressure before the shear by --stress");
  refused({"--stress", "0"}, "--stress");
  refused({}, "the pressure before the shear by --stress", "liggghts");
  refused({"--stress", "1e5", "--periodic"}, "no model of such a box: use --to lammps or yade", "liggghts");
  refused({"--stress", "1e5", "--sides", "walls"}, "between six walls: leave --sides out", "liggghts");
  refused({"--stress", "1e5", "--start", "layers"}, "leave --start out", "liggghts");
  refused({"--stress", "1e5", "--types", "one"}, "walls have one of their own: leave it out", "liggghts");
  refused({"--stress", "1e5", "--specimen", "cylinder:4x4"}, "six faces that move, a cylinder has not",
          "liggghts");
  refused({"--stress", "1e5"}, "--to liggghts, lammps or yade", "csv");
  refused({"--stress", "1e5", "--specimen", "cylinder:4x4"}, "six faces that move, a cylinder has not");
  refused({"--stress", "1e5", "--sides", "walls"}, "leave --sides out");
  refused({"--stress", "1e5", "--start", "deposit"}, "leave --start out");
  refused({"--stress", "1e5", "--steps", "100"}, "leave it out");
  refused({"--stress", "1e5", "--axial-strain", "20"}, "'20' is not from 0.001 to 0.5");
  refused({"--stress", "1e5", "--axial-strain", "0"}, "--axial-strain");
  refused({"--stress", "1e5", "--constant", "q"}, "'q' is neither sigma_3 nor p");
  refused({"--stress", "1e5", "--void-ratio", "0"}, "--void-ratio");
  check_refused(export_model("lammps", folder / "a.in", {"--stress", "1e5", "--axial-strain", "0.1"}),
                "give --model triaxial");
  check_refused(export_model("lammps", folder / "a.in", {"--stress", "1e5", "--constant", "p"}),
                "--constant: what is settled is not sheared: give --model triaxial");
  check_refused(mdm({"export", sand, "--to", "lammps", "--axial-strain", "0.1", "-o", folder / "a"}),
                "give --model triaxial");
  CHECK(folder.entries() == 0);
  // A single grain is wider than half of the cell.
  const std::string one = folder.write("one.csv", "size_mm,mass\n1,1\n2,0\n");
  check_refused(
      mdm({"export", one, "--to", "lammps", "--model", "triaxial", "--stress", "1e5", "-o", folder / "a.in"}),
      "and would touch itself");
  CHECK(folder.entries() == 1);
}

TEST_CASE("classes have types of their own on request", "[cli]") {
  const TemporaryFolder folder;
  REQUIRE(export_model("liggghts", folder / "a.in", {"--types", "class"}).exit_code == 0);
  const std::string data = read_file(folder / "a.data");
  CHECK(data.find("\n6 atom types\n") != std::string::npos);
  CHECK(data.find("\n1 5 ") != std::string::npos);
  CHECK(data.find("\n141 1 ") != std::string::npos);
  REQUIRE(mdm({"export", sand, "--to", "lammps", "--types", "class", "-o", folder / "b.data"}).exit_code ==
          0);
  CHECK(read_file(folder / "b.data").find("\n6 atom types\n") != std::string::npos);
  CHECK(mdm({"verify", sand, folder / "b.data", "--tolerance", "1e-6"}).exit_code == 0);
}

TEST_CASE("a model takes the material of each class from a file", "[cli]") {
  const TemporaryFolder folder;
  const std::string material = folder.write("m.csv", "class,friction\n1,0.1\n2,0.2\n3,0.3\n4,0.4\n5,0.5\n");
  const std::string model = folder / "a.in";
  REQUIRE(export_model("lammps", model, {"--material", material}).exit_code == 0);
  CHECK(read_file(folder / "a.data").find("\n6 atom types\n") != std::string::npos);
  // The classes keep their friction, but for what hinders compaction.
  CHECK(read_file(model).find(
            "\nvariable grip equal ${own}*0.3+(1-${own})*((0.3<${mu})*0.3+(0.3>=${mu})*${mu})\n") !=
        std::string::npos);
  REQUIRE(
      export_model("lammps", model, {"--material", material, "--friction-while-filling", "0.1"}).exit_code ==
      0);
  CHECK(read_file(model).find("\nvariable grip equal ${own}*0.3+(1-${own})*${mu}\n") != std::string::npos);
  check_refused(export_model("lammps", model, {"--material", material, "--young", "1e6"}), "--young");
  check_refused(export_model("lammps", model, {"--material", material, "--types", "one"}),
                "--types one: --material gives each class a type of its own");
  check_refused(export_model("lammps", model, {"--material", folder / "none"}), "none");
  check_refused(
      export_model("lammps", model, {"--material", folder.write("n.csv", "class,friction\n1,-1\n")}),
      "n.csv:2: friction: '-1' is not from 0 to 10");
}

TEST_CASE("rolling friction is that of the engine's own model, or is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string model = folder / "a.in";
  const auto written = [&](const char *to, const Arguments &more) {
    REQUIRE(export_model(to, model, more).exit_code == 0);
    return read_file(model);
  };
  const std::string liggghts = written("liggghts", {"--rolling-friction", "0.2"});
  for (const char *part : {"\n#   rolling friction 0.2, by its model epsd2: ", " rolling_friction epsd2\n",
                           "coefficientRollingFriction peratomtypepair 1 0.2\n"})
    CHECK(liggghts.find(part) != std::string::npos);
  const std::string lammps = written("lammps", {"--rolling-friction", "0.2"});
  CHECK(lammps.find("\n#   rolling friction 0.2, by its model sds: ") != std::string::npos);
  CHECK(lammps.find(" rolling sds ") != std::string::npos);
  for (const char *engine : {"liggghts", "lammps"}) {
    const std::string without = written(engine, {});
    CHECK(without.find("\n#   rolling friction none\n") != std::string::npos);
    CHECK(without.find("Rolling") == std::string::npos);
    CHECK(without.find("rolling_") == std::string::npos);
    CHECK(without.find("sds") == std::string::npos);
  }
  const std::string table =
      folder.write("m.csv", "class,rolling_friction\n1,0\n2,0.1\n3,0.2\n4,0.3\n5,0.4\n");
  // Of two classes the lesser; walls have that of the option.
  CHECK(
      written("liggghts", {"--material", table, "--rolling-friction", "0.35"})
          .find("peratomtypepair 6 0 0 0 0 0 0 0 0.1 0.1 0.1 0.1 0.1 0 0.1 0.2 0.2 0.2 0.2 0 0.1 0.2 0.3 0.3 "
                "0.3 0 0.1 0.2 0.3 0.4 0.35 0 0.1 0.2 0.3 0.35 0.35\n") != std::string::npos);
  check_refused(export_model("yade", folder / "a.py", {"--rolling-friction", "0.2"}),
                "--rolling-friction: YADE");
  check_refused(export_model("yade", folder / "a.py", {"--material", table}), "--rolling-friction: YADE");
  check_refused(export_model("lammps", model, {"--rolling-friction", "-1"}), "--rolling-friction");
  check_refused(mdm({"export", sand, "--to", "lammps", "--rolling-friction", "0.2", "-o", folder / "a.data"}),
                "--rolling-friction");
}

TEST_CASE("cohesion is that of the engine's own law, or is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string model = folder / "a.in";
  const auto written = [&](const char *to, const Arguments &more) {
    REQUIRE(export_model(to, model, more).exit_code == 0);
    return read_file(model);
  };
  const auto has = [](const std::string &text, const char *part) {
    return text.find(part) != std::string::npos;
  };
  const std::string liggghts = written("liggghts", {"--cohesion-energy-density", "2e4"});
  CHECK(has(liggghts, "\npair_style gran model hertz tangential history cohesion sjkr\n"));
  CHECK(has(liggghts, "\nfix cohesion all property/global cohesionEnergyDensity peratomtypepair 1 20000\n"));
  CHECK(has(liggghts, "\n#   cohesion         20000 J/m^3, by its model sjkr, of grains alone"));
  CHECK(has(liggghts, "wall/gran model hertz tangential history primitive"));
  const std::string lammps = written("lammps", {"--surface-energy", "0.001", "--rolling-friction", "0.1"});
  CHECK(has(lammps, "\nvariable contact string \"jkr 5e+06 0.5 0.25 0.001 tangential mindlin NULL"));
  CHECK(has(lammps, "\nvariable wall string \"hertz/material 5e+06 0.5 0.25 tangential mindlin NULL"));
  CHECK(!has(written("lammps", {}), "jkr"));
  CHECK(has(written("liggghts", {}), "\n#   cohesion         none\n"));

  check_refused(export_model("lammps", model, {"--cohesion-energy-density", "1"}),
                "--cohesion-energy-density: it is of another law than this engine's: give --surface-energy");
  check_refused(export_model("liggghts", model, {"--surface-energy", "1"}), "give --cohesion-energy-density");
  check_refused(export_model("yade", folder / "a.py", {"--surface-energy", "1"}),
                "--surface-energy: there is no model of cohesion for YADE");
  check_refused(export_model("lammps", model, {"--surface-energy", "10"}),
                "--surface-energy: two of the smallest");
  REQUIRE(export_model("lammps", model, {"--surface-energy", "10", "--young", "7e10"}).exit_code == 0);
  check_refused(export_model("lammps", model, {"--surface-energy", "0"}),
                "--surface-energy: '0' is not positive");
  check_refused(mdm({"export", sand, "--to", "lammps", "--surface-energy", "1", "-o", folder / "a.data"}),
                "--surface-energy");
  check_refused(mdm({"export", sand, "--to", "lammps", "--model", "settle", "--dimension", "2", "--law",
                     "power:2", "--surface-energy", "0.001", "-o", folder / "d.in"}),
                "leave --surface-energy out");
}

TEST_CASE("layers in a cylinder say that they stand on a square", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = mdm({"export", sand, "--to", "lammps", "--specimen", "cylinder:4x4", "--void-ratio",
                               "0.7", "-o", folder / "a.data"});
  CHECK(outcome.err.find("note: layers stand on the square inside the cylinder") != std::string::npos);
}

TEST_CASE("a long run is said in hours, with what makes it shorter", "[cli]") {
  const TemporaryFolder folder;
  const Outcome quick = export_model("yade", folder / "a.py");
  CHECK(quick.err.find(" of a core of 2.1 GHz at 6.4e+05 grains by steps a second") != std::string::npos);
  CHECK(quick.err.find("shorter:") == std::string::npos);
  const Outcome slow = export_model("yade", folder / "a.py", {"--at-least", "1000", "--young", "7e10"});
  CHECK(slow.err.find(" hours of a core of 2.1 GHz") != std::string::npos);
  CHECK(slow.err.find("shorter: yade -n -j 4 FILE; --young 7e9 takes ") != std::string::npos);
  CHECK(export_model("lammps", folder / "a.in", {"--at-least", "10000", "--young", "7e10"})
            .err.find("shorter: mpirun -np 4 lmp -in FILE; ") != std::string::npos);
}

TEST_CASE("targets of a model that make no sense are refused", "[cli]") {
  const TemporaryFolder folder;
  const auto refused = [&folder](const Arguments &more, const std::string &remedy,
                                 const std::string &to = "lammps") {
    check_refused(export_model(to, folder / "a.in", more), remedy);
  };
  refused({"--void-ratio", "0"}, "--void-ratio");
  refused({"--void-ratio", "-1"}, "--void-ratio");
  refused({"--void-ratio", "101"}, "above 100");
  refused({"--stress", "0"}, "--stress");
  refused({"--void-ratio", "0.6", "--stress", "1000"}, "give one of them");
  refused({"--friction", "-0.1"}, "--friction");
  refused({"--friction-while-filling", "11"}, "--friction-while-filling");
  refused({"--target-tolerance", "0.01"}, "--void-ratio or --stress");
  refused({"--void-ratio", "0.6", "--target-tolerance", "1"}, "--target-tolerance");
  refused({"--periodic"}, "--void-ratio or --stress");
  refused({"--periodic", "--void-ratio", "0.6"}, "--to lammps or yade", "liggghts");
  refused({"--periodic", "--void-ratio", "0.6", "--specimen", "cylinder:4x4"},
          "six faces that move, a cylinder has not");
  refused({"--periodic", "--void-ratio", "0.6", "--start", "deposit"}, "leave --start out");
  refused({"--periodic", "--void-ratio", "0.6", "--sides", "walls"}, "leave --sides out");
  refused({"--periodic", "--void-ratio", "0.6", "--box", "2x2"}, "write AxBxC");
  refused({"--types", "size"}, "neither one nor class");
  check_refused(mdm({"export", sand, "--to", "lammps", "--stress", "1000", "-o", folder / "a"}),
                "--model settle");
  check_refused(mdm({"export", sand, "--to", "lammps", "--periodic", "-o", folder / "a"}), "--model settle");
  check_refused(mdm({"export", sand, "--to", "csv", "--types", "class", "-o", folder / "a"}), "has no types");
  CHECK(folder.entries() == 0);
}

TEST_CASE("particles start in layers or mixed, the largest first in the file", "[cli]") {
  const TemporaryFolder folder;
  // Height of the last particle, of the finest class, by that of the box.
  const auto height_of_last = [&folder](const Arguments &more) {
    Arguments arguments{"export", sand, "--to", "lammps", "--quiet", "-o", folder / "a.data"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    REQUIRE(mdm(arguments).exit_code == 0);
    const std::string text = read_file(folder / "a.data");
    const double height = std::stod(text.substr(text.rfind('\n', text.find(" zlo")) + 3));
    return std::stod(text.substr(text.find_last_of(' '))) / height;
  };
  CHECK(height_of_last({}) > 0.9);
  CHECK(height_of_last({}) == height_of_last({"--start", "layers"}));
  double least = 1;
  for (const char *seed : {"1", "2", "3", "4", "5", "6", "7", "8", "9", "10"})
    least = std::min(least, height_of_last({"--start", "mixed", "--seed", seed}));
  CHECK(least < 0.6);
  REQUIRE(export_model("lammps", folder / "b.in").exit_code == 0);
  REQUIRE(export_model("lammps", folder / "c.in", {"--start", "mixed"}).exit_code == 0);
  REQUIRE(export_model("lammps", folder / "d.in", {"--start", "layers"}).exit_code == 0);
  CHECK(read_file(folder / "b.data") == read_file(folder / "c.data"));
  CHECK(read_file(folder / "b.data") != read_file(folder / "d.data"));
}

TEST_CASE("a deposited start is lower than others, and LIGGGHTS reads it too", "[cli]") {
  const TemporaryFolder folder;
  const auto height = [&folder](const std::string &file) {
    const std::string text = read_file(folder / file);
    return std::stod(text.substr(text.rfind('\n', text.find(" zlo")) + 3));
  };
  REQUIRE(export_model("lammps", folder / "a.in").exit_code == 0);
  REQUIRE(export_model("lammps", folder / "b.in", {"--start", "deposit"}).exit_code == 0);
  REQUIRE(export_model("liggghts", folder / "c.in", {"--start", "deposit"}).exit_code == 0);
  REQUIRE(export_model("yade", folder / "d.py", {"--start", "deposit"}).exit_code == 0);
  CHECK(height("b.data") < height("a.data") / 2);
  CHECK(read_file(folder / "b.data") == read_file(folder / "c.data"));
  CHECK(read_file(folder / "d.xyzr").find("no two particles overlap") != std::string::npos);
}

TEST_CASE("a deposit has walls, a cylinder or periodic sides", "[cli]") {
  const TemporaryFolder folder;
  const auto exported = [&folder](const Arguments &more) {
    Arguments arguments{"export", sand, "--to", "lammps", "--start", "deposit", "-o", folder / "a.data"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mdm(arguments);
  };
  const auto data = [&folder] { return read_file(folder / "a.data"); };
  REQUIRE(exported({"--box", "3x2.5"}).exit_code == 0);
  CHECK(data().find("\n# Box: 0.003 x 0.0025 x ") != std::string::npos);
  REQUIRE(exported({"--sides", "cylinder", "--box", "3x3"}).exit_code == 0);
  CHECK(data().find("\n# Cylinder: diameter 0.003, height ") != std::string::npos);
  REQUIRE(exported({"--specimen", "cylinder:4x8", "--void-ratio", "0.7"}).exit_code == 0);
  CHECK(data().find("\n# Cylinder: diameter 0.004, height ") != std::string::npos);
  CHECK(exported({"--specimen", "cylinder:4x8", "--void-ratio", "0.7"})
            .err.find(" --specimen cylinder:0.004m ") != std::string::npos);
  REQUIRE(exported({"--sides", "periodic"}).exit_code == 0);
  CHECK(data().find(", from the origin, repeated in x and y;") != std::string::npos);
  check_refused(exported({"--sides", "cylinder", "--box", "3x2.5"}), "its diameter twice");
  check_refused(exported({"--sides", "round"}), "neither walls nor cylinder nor periodic");
  check_refused(mdm({"export", sand, "--to", "lammps", "--sides", "periodic", "-o", folder / "b"}),
                "--start deposit");
}

TEST_CASE("a model of one step says so", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = export_model("liggghts", folder / "a.in", {"--steps", "1"});
  CHECK(outcome.err.find("model: at most 1 step while settling;") != std::string::npos);
  CHECK(read_file(folder / "a.in").find("\n# 1 step at most while settling: ") != std::string::npos);
  CHECK(
      export_model("liggghts", folder / "a.in", {"--steps", "2"}).err.find("model: at most 2 steps while ") !=
      std::string::npos);
}

TEST_CASE("what is no model is refused with a remedy, and leaves nothing", "[cli]") {
  const TemporaryFolder folder;
  const std::string out = folder / "a.in";
  check_refused(mdm({"export", sand, "--to", "lammps", "--model", "sieve", "-o", out}),
                "there are settle and triaxial");
  check_refused(export_model("csv", out), "--to liggghts, lammps or yade");
  check_refused(export_model("liggghts", "-"), "-o FILE");
  check_refused(export_model("yade", out), "end in .py");
  check_refused(export_model("lammps", folder / "a.data"), "a.data");
  check_refused(export_model("lammps", folder / "a b.in"), "letters, digits");
  check_refused(export_model("liggghts", out, {"--unit", "mm"}), "--unit");
  check_refused(export_model("liggghts", out, {"--steps", "-1"}), "--steps");
  for (const std::string to : {"liggghts", "lammps"}) {
    check_refused(export_model(to, out, {"--steps", "2147483648"}), "fewer --steps");
    check_refused(export_model(to, out, {"--steps", "99999999999999999999"}),
                  "'99999999999999999999' are more than the 2147483647");
    check_refused(export_model(to, out, {"--young", "1e30"}), "softer --young"); // 10^17 steps
    check_refused(export_model(to, out, {"--box", "2x100001"}), "more than 100 m");
    check_refused(export_model(to, out, {"--box", "2x2x100001"}), "more than 100 m");
    check_refused(export_model(to, "/dev/null"), "no regular file");
  }
  CHECK(!std::filesystem::exists("/dev/null.data"));
  check_refused(export_model("lammps", out, {"--start", "shaken"}), "layers nor mixed nor deposit");
  check_refused(export_model("lammps", out, {"--sides", "periodic"}), "--start deposit");
  check_refused(export_model("yade", folder / "a.py", {"--start", "deposit", "--sides", "periodic"}),
                "models of YADE have walls");
  check_refused(export_model("lammps", out, {"--start", "deposit", "--box", "1x1"}), "narrower than 3");
  check_refused(mdm({"export", sand, "--to", "csv", "--start", "mixed", "-o", out}), "--start");
  check_refused(export_model("liggghts", out, {"--box", "0.6x1"}), "--box");
  check_refused(export_model("liggghts", out, {"--box", "3x3x0.5"}), "leave the height of --box out");
  check_refused(mdm({"export", sand, "--to", "liggghts", "--steps", "5", "-o", out}), "--model settle");
  CHECK(folder.entries() == 0);
}

} // namespace export_model_test

// What a command writes every other command reads for which it makes sense; what makes none is refused with
// the command that does.

#include "run.hpp"

#include <algorithm>

namespace outputs_as_inputs_test {

using namespace cli_test;

namespace {

/// Everything that commands write of one sand and of one set, in a folder.
class Outputs {
public:
  Outputs() {
    copy_file(example("athabasca-sand"), path("sand.csv"));
    make({"solve", path("sand.csv"), "-o", path("answer.json")});
    make({"solve", path("sand.csv"), "-o", path("answer.csv")});
    make({"solve", path("sand.csv"), "--spread", "-o", path("spread.json")});
    make({"solve", path("sand.csv"), "--spread", "-o", path("spread.csv")});
    generate("set", {});
    generate("sizes", {"--sizes"});
    generate("match", {"--method", "match", "--spread"});
    generate("discs", {"--sizes", "--dimension", "2"});
    make({"pack", path("discs.csv"), "-o", path("discs.packing"), "--quiet"});
    for (const char *format : {"csv", "lammps", "liggghts", "vtk", "diameters"})
      make({"export", path("sand.csv"), "--to", format, "-o", path(std::string("particles.") + format),
            "--quiet"});
    make({"convert", path("sand.csv"), "-o", path("converted.json")});
    make({"convert", path("sand.csv"), "-o", path("converted.csv")});
    make({"verify", path("sand.csv"), path("answer.json"), "-o", path("verdict.json")});
    make({"describe", path("sand.csv"), "-o", path("description.json")});
  }

  std::string path(const std::string &name) const { return folder_ / name; }

  /// The command on a file; FILE stands for it.
  Outcome run(const std::string &file, Arguments command) const {
    for (std::string &word : command)
      word = word == "FILE" ? path(file) : word.starts_with("out.") || word == "sand.csv" ? path(word) : word;
    return mdm(command);
  }

private:
  static void copy_file(const std::string &from, const std::string &to) {
    std::filesystem::copy_file(from, to);
  }

  static void make(const Arguments &command) {
    const Outcome outcome = mdm(command);
    INFO(command.front() << " " << command.back() << ": " << outcome.err);
    REQUIRE(outcome.exit_code == 0);
  }

  void generate(const std::string &name, const Arguments &more) const {
    for (const char *ending : {".csv", ".json"}) {
      Arguments command = {"generate", "--beta",           "2,3", "--dmin",     "0.1", "--dmax",
                           "1",        "--classes",        "4",   "--at-least", "300", "--quiet",
                           "-o",       path(name + ending)};
      command.insert(command.end(), more.begin(), more.end());
      make(command);
    }
  }

  TemporaryFolder folder_;
};

struct Row {
  const char *file;
  int exit_code;      ///< of the command
  const char *remedy; ///< in the message, where it is 2
};

void check_rows(const Outputs &outputs, const Arguments &command, const std::vector<Row> &rows) {
  for (const Row &row : rows) {
    const Outcome outcome = outputs.run(row.file, command);
    INFO(command.front() << " " << row.file << ": " << outcome.err << outcome.out.substr(0, 300));
    CHECK(outcome.exit_code == row.exit_code);
    CHECK((row.exit_code == 2) == outcome.out.empty());
    if (row.exit_code == 2)
      CHECK(outcome.err.find(row.remedy) != std::string::npos);
  }
}

} // namespace

TEST_CASE("an exported file that was cut between its lines is refused by its title", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("c778-graded-sand");
  for (const std::string format : {"liggghts", "yade", "diameters", "csv", "phasicflow"}) {
    INFO(format);
    const std::string out = folder / ("whole." + format);
    REQUIRE(mdm({"export", sand, "--to", format, "-o", out, "--quiet"}).exit_code == 0);
    const Arguments verify = {"verify", sand, out, "--tolerance", "1e-4"};
    const bool states_unit = format == "csv";
    Arguments whole = verify;
    if (!states_unit)
      whole.insert(whole.end(), {"--size-unit", "m"});
    CHECK(mdm(whole).exit_code == 0);
    std::vector<std::string> lines = lines_of(read_file(out));
    const auto is_class = [](const std::string &line) { return line.rfind("# class ", 0) == 0; };
    const auto last_class = std::find_if(lines.rbegin(), lines.rend(), is_class);
    lines.resize(format == "liggghts"     ? static_cast<std::size_t>(lines.rend() - last_class) - 1
                 : format == "phasicflow" ? lines.size() - 8
                                          : lines.size() - 1);
    std::string cut;
    for (const std::string &line : lines)
      cut += line + "\n";
    folder.write("whole." + format, cut);
    const Outcome refused = mdm(whole);
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, "is the file cut off?"));
  }
}

TEST_CASE("Outputs as inputs: the table of commands and files") {
  const Outputs o;
  const char *const no_sizes = "mdm generate --sizes", *const no_gradation = "mdm convert",
                    *const written = "give the gradation that it was asked about",
                    *const packing = "mdm export", *const discs = "--dimension 2";

  check_rows(o, {"verify", "sand.csv", "FILE", "--tolerance", "1e-6"},
             {{"answer.json", 0, ""},
              {"answer.csv", 0, ""},
              {"spread.json", 0, ""},
              {"spread.csv", 0, ""},
              {"set.json", 2, no_sizes},
              {"set.csv", 2, no_sizes},
              {"sizes.json", 1, ""},
              {"sizes.csv", 1, ""},
              {"match.json", 1, ""},
              {"match.csv", 1, ""},
              {"particles.csv", 0, ""},
              {"particles.lammps", 0, ""},
              {"particles.liggghts", 0, ""},
              {"particles.vtk", 0, ""},
              {"discs.packing", 2, packing},
              {"converted.csv", 2, "is of a gradation, and particles are wanted"},
              {"converted.json", 2, "JSON answer of mdm solve"},
              {"verdict.json", 2, "JSON answer of mdm solve"}});
  // Without a tolerance a range of sizes does not tell.
  check_rows(o, {"verify", "sand.csv", "FILE"},
             {{"answer.json", 0, ""}, {"spread.json", 0, ""}, {"answer.csv", 3, ""}, {"spread.csv", 3, ""}});

  for (const Arguments &command : {Arguments{"describe", "FILE"}, Arguments{"convert", "FILE"}})
    check_rows(o, command,
               {{"sand.csv", 0, ""},
                {"converted.csv", 0, ""},
                {"converted.json", 0, ""},
                {"answer.csv", 0, ""},
                {"spread.csv", 0, ""},
                {"set.json", 0, ""},
                {"set.csv", 0, ""},
                {"sizes.json", 0, ""},
                {"sizes.csv", 0, ""},
                {"match.json", 0, ""},
                {"particles.csv", 0, ""},
                {"particles.lammps", 0, ""},
                {"particles.liggghts", 0, ""},
                {"particles.vtk", 0, ""},
                {"answer.json", 0, ""},
                {"verdict.json", 2, written},
                {"description.json", 2, written},
                {"discs.packing", 2, "packing"}});

  for (const Arguments &command :
       {Arguments{"solve", "FILE"}, Arguments{"tradeoff", "FILE"}, Arguments{"published", "rounded", "FILE"}})
    check_rows(o, command,
               {{"converted.csv", 0, ""},
                {"converted.json", 0, ""},
                {"set.json", 2, no_gradation},
                {"sizes.csv", 2, no_gradation},
                {"spread.csv", 2, no_gradation},
                {"particles.vtk", 2, no_gradation},
                {"answer.json", 2, written},
                {"discs.packing", 2, "packing"}});

  for (const char *format : {"csv", "lammps"})
    check_rows(o, {"export", "FILE", "--to", format, "--yes-units"},
               {{"sand.csv", 0, ""},
                {"answer.json", 0, ""},
                {"answer.csv", 0, ""},
                {"spread.csv", 0, ""},
                {"spread.json", 2, "export the gradation with --spread"},
                {"set.json", 2, no_sizes},
                {"set.csv", 2, no_sizes},
                {"sizes.json", 0, ""},
                {"sizes.csv", 0, ""},
                {"match.json", 0, ""},
                {"particles.vtk", 0, ""},
                {"particles.lammps", 0, ""},
                {"discs.packing", 0, ""},
                {"verdict.json", 2, "JSON answer of mdm solve"}});

  check_rows(o, {"pack", "FILE", "-o", "out.packing"},
             {{"discs.json", 0, ""},
              {"discs.csv", 0, ""},
              {"set.csv", 2, "mdm generate"},
              {"sizes.json", 2, discs},
              {"answer.json", 2, "mdm generate"}});
}

TEST_CASE("Outputs as inputs: what is drawn") {
  const Outputs o;
  const auto draw = [&o](const Arguments &files, int exit_code, const std::string &remedy = "") {
    Arguments command = {"plot"};
    for (const std::string &file : files)
      command.push_back(o.path(file));
    command.insert(command.end(), {"-o", o.path("out.svg"), "--quiet"});
    const Outcome outcome = mdm(command);
    INFO(files.back() << ": " << outcome.err);
    CHECK(outcome.exit_code == exit_code);
    CHECK(outcome.err.find(remedy) != std::string::npos);
  };
  for (const char *file : {"sand.csv", "converted.json", "set.json", "set.csv", "sizes.csv", "match.json",
                           "spread.csv", "particles.vtk", "discs.packing"})
    draw({file}, 0);
  for (const char *file : {"answer.json", "answer.csv", "spread.json", "spread.csv", "sizes.json",
                           "match.csv", "particles.lammps", "particles.csv"})
    draw({"sand.csv", file}, 0);
  draw({"answer.json"}, 0);
  draw({"sand.csv", "set.csv"}, 2, "mdm generate --sizes");
  draw({"sand.csv", "discs.packing"}, 2, "mdm export");
  draw({"sand.csv", "converted.csv"}, 2, "is of a gradation, and particles are wanted");
}

TEST_CASE("Outputs as inputs: the classes of a set as a gradation have its volume fractions") {
  const TemporaryFolder folder;
  const Outcome made = mdm({"generate", "--beta", "1,1", "--dmin", "1", "--dmax", "3", "--classes", "2",
                            "--classing", "regular", "--quiet", "-o", folder / "set.json"});
  REQUIRE(made.exit_code == 0);
  const Outcome converted = mdm({"convert", folder / "set.json"});
  CHECK(converted.exit_code == 0);
  CHECK(converted.out == "size_mm,mass\n1,0.5\n2,0.5\n3,0\n");
}

TEST_CASE("Outputs as inputs: the gradation of a sample has a sieve of each size") {
  const TemporaryFolder folder;
  std::ofstream(folder / "sample.csv") << "diameter_mm,quantity\n2,3\n1,8\n";
  const Outcome converted = mdm({"convert", folder / "sample.csv"});
  CHECK(converted.exit_code == 0);
  CHECK(converted.out == "size_mm,mass\n0,8\n1,24\n2,0\n");
  CHECK(converted.err.find("a sample of 11 spheres") != std::string::npos);
}

TEST_CASE("Outputs as inputs: of a sample no particle is between two sizes", "[cli]") {
  const TemporaryFolder folder;
  const std::string two = folder.write("two.csv", "size_mm,quantity\n2,1000\n9,11\n");
  const Outcome described = mdm({"describe", two});
  INFO(described.out << described.err);
  CHECK(described.exit_code == 0);
  for (const std::string line :
       {"D60     9.000 mm", "fine gravel    4.75 to 19 mm      50.06",
        "coarse sand    2 to 4.75 mm           0", "fines            to 0.075 mm            0"})
    CHECK(described.out.find(line) != std::string::npos);
  CHECK(mdm({"judge", two, "--stability", "kezdi"}).exit_code == 1); // D15 / d85 is 9 / 2
  const std::string sample = folder.write("sample.csv", "size_mm,quantity\n2,1\n3,1\n");
  const auto verdict = [&](const std::string &row) {
    const std::string spec =
        folder.write("spec.csv", "size_mm,passing_min_percent,passing_max_percent\n" + row + "\n");
    return mdm({"judge", sample, "--spec", spec}).exit_code;
  };
  CHECK(verdict("2.4,50,60") == 1); // 8 / 35 pass
  CHECK(verdict("2.4,22.8,22.9") == 0);
  CHECK(verdict("1,0,10") == 0);
}

TEST_CASE("what mdm writes it reads, whatever the id", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string id :
       {"ITEM: TIMESTEP", "size_a,b", "{", "fix x", "variable", "vtk DataFile Version 3.0",
        "radius_m,cumulative_number", "lower_mm,q", "12", "12 atoms", "#", ""}) {
    INFO(id);
    const std::string gradation =
        folder.write("g.json", R"({"id":")" + id + R"(","sizes":[1,2,3],"masses":[2,1,0]})");
    const std::string answer = folder.write("a.json", mdm({"solve", gradation, "--format", "json"}).out);
    CHECK(mdm({"verify", gradation, answer}).exit_code == 0);
    const std::string spread =
        folder.write("s.json", mdm({"solve", gradation, "--spread", "--format", "json"}).out);
    CHECK(mdm({"verify", gradation, spread}).exit_code == 0);
    for (const std::string format : {"csv", "lammps", "vtk", "yade", "diameters", "liggghts", "mercurydpm"}) {
      INFO(format);
      const Outcome file = mdm({"export", gradation, "--to", format, "--yes-units", "--quiet"});
      CHECK(file.exit_code == 0);
      Arguments verify = {"verify", gradation, folder.write("p", file.out), "--tolerance", "1%"};
      if (format == "yade" || format == "diameters")
        verify.insert(verify.end(), {"--size-unit", "m"});
      const Outcome verified = mdm(verify);
      INFO(file.out.substr(0, 300) << verified.err);
      CHECK(verified.exit_code == 0);
    }
  }
}

} // namespace outputs_as_inputs_test

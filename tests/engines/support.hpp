#pragma once
// Models that mdm export writes, run by the engines.

#include "cli/answer.hpp"
#include "tools.hpp"

#include <sstream>

namespace cli_test {

struct Engine {
  std::string name;    // for --to
  std::string package; // of Debian
  std::string program;
  std::string command; // that runs
  std::string model;
  std::string dump;
};

inline const Engine liggghts{"liggghts",      "liggghts", "liggghts",
                             "liggghts -in ", "sand.in",  "sand-settled.dump"};
inline const Engine lammps{"lammps", "lammps", "lmp", "lmp -in ", "sand.in", "sand-settled.dump"};
inline const Engine yade{"yade", "yade", "yade", "yade -n -x ", "sand.py", "sand-settled.xyzr"};

inline bool is_there(const Engine &engine) {
  return mdm_test::has_tool(engine.program, engine.package);
}

/// A folder with a gradation and its model.
class Model {
public:
  Model(Engine engine, const std::string &gradation, const Arguments &more = {"--steps", "300", "--unjammed"},
        const std::string &model = "settle")
      : engine_(std::move(engine)), gradation_(folder_.write("sand.csv", gradation)) {
    Arguments arguments{"export",  gradation_, "--to", engine_.name,
                        "--model", model,      "-o",   folder_ / engine_.model};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
  }

  /// Runs the engine in the folder. \param before, after words around its command
  Outcome run(const std::string &before = "", const std::string &after = "") const {
    return Process("/bin/sh", {"-c", "cd '" + (folder_ / ".") + "' && exec " + before + engine_.command +
                                         engine_.model + " " + after})
        .end();
  }

  std::string path(const std::string &name) const { return folder_ / name; }
  std::string dump() const { return folder_ / engine_.dump; }
  bool has_dump() const { return std::filesystem::exists(dump()); }

  void replace(const std::string &name, const std::string &part, const std::string &by) const {
    std::string text = read_file(folder_ / name);
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    folder_.write(name, text.replace(at, part.size(), by));
  }

  /// Runs the engine and holds what it leaves against the answer of mdm solve, with the very command that the
  /// model says.
  void check_settles(const Arguments &question = {}) const {
    const Outcome outcome = run();
    INFO(outcome.out.substr(0, 20000) << outcome.err.substr(0, 2000));
    REQUIRE(outcome.exit_code == 0);
    check_grains(question);
  }

  void check_grains(const Arguments &question = {}) const {
    const Outcome verdict = mdm(verification());
    INFO(verdict.err);
    CHECK(verdict.exit_code == 0);
    const Json found = Json::parse(verdict.out);
    CHECK(found.at("verdict") == "match");
    CHECK(found.at("outside").at("below") == "0");
    CHECK(found.at("outside").at("above") == "0");
    Arguments asking{gradation_};
    asking.insert(asking.end(), question.begin(), question.end());
    const Json asked = solve_json(asking);
    CHECK(found.at("particles") == asked.at("particles"));
    CHECK(quantities(found) == quantities(asked));
  }

private:
  /// `# Then: mdm verify GRADATION sand-settled.dump --tolerance 2e-7`
  Arguments verification() const {
    const std::string text = read_file(folder_ / engine_.model), begin = "# Then: mdm ";
    const std::size_t at = text.find(begin) + begin.size();
    std::istringstream words(text.substr(at, text.find('\n', at) - at));
    Arguments arguments;
    for (std::string word; words >> word;)
      arguments.push_back(word == "GRADATION" ? gradation_ : word == engine_.dump ? dump() : word);
    arguments.insert(arguments.end(), {"--format", "json"});
    return arguments;
  }

  TemporaryFolder folder_;
  Engine engine_;
  std::string gradation_;
};

/// A start that mdm export writes with places drawn for all particles.
inline void export_start(const std::string &gradation, const std::string &format, const std::string &path) {
  const Outcome outcome = mdm({"export", gradation, "--to", format, "--start", "mixed", "-o", path});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
}

/// Holds a file of places, with options of its reading, against the answer of mdm solve.
inline void check_places(const std::string &gradation, const Arguments &file, const std::string &tolerance) {
  Arguments arguments{"verify", gradation};
  arguments.insert(arguments.end(), file.begin(), file.end());
  arguments.insert(arguments.end(), {"--packing", "--tolerance", tolerance, "--format", "json"});
  const Outcome verdict = mdm(arguments);
  INFO(file.front() << verdict.err);
  REQUIRE(verdict.exit_code == 0);
  const Json found = Json::parse(verdict.out), asked = solve_json({gradation});
  CHECK(found.at("verdict") == "match");
  CHECK(found.at("particles") == asked.at("particles"));
  CHECK(quantities(found) == quantities(asked));
  CHECK(found.at("packing").at("overlaps").at("pairs") == "0");
}

struct Grain {
  double x, y, z, r;
};

/// Rows `id type x y z radius` of a dump.
inline std::vector<Grain> grains(const std::string &dump) {
  std::istringstream text(dump.substr(dump.find("ITEM: ATOMS")));
  std::string line;
  std::getline(text, line);
  std::vector<Grain> all;
  for (double id, type; text >> id >> type;) {
    Grain g{};
    text >> g.x >> g.y >> g.z >> g.r;
    all.push_back(g);
  }
  return all;
}

} // namespace cli_test

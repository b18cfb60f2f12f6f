// What solve --coq writes is a theorem that Coq accepts, and what is changed of it is none.

#include "cli/run.hpp"

#include <sys/stat.h>

#include <regex>

using namespace cli_test;

namespace {

Outcome coqc(const std::string &file) {
  return Process("/bin/sh", {"-c", "'" MDM_COQC "' -q -Q '" MDM_COQ_BUILD "' Mdm '" + file + "'"}).end();
}

/// Writes the theorem of a question and has Coq check it.
class Theorem {
public:
  explicit Theorem(Arguments question) {
    question.insert(question.begin(), "solve");
    question.insert(question.end(), {"--quiet", "--coq", path()});
    exit_code = mdm(question).exit_code;
  }

  std::string text() const { return read_file(path()); }
  Outcome check() const { return coqc(path()); }

  /// With the first `from` in it another text.
  Outcome check_with(const std::string &from, const std::string &to) const {
    std::string changed = text();
    const std::size_t at = changed.find(from);
    REQUIRE(at != std::string::npos);
    changed.replace(at, from.size(), to);
    std::ofstream(folder_ / "changed.v") << changed;
    return coqc(folder_ / "changed.v");
  }

  int exit_code = -1;

private:
  std::string path() const { return folder_ / "theorem.v"; }

  TemporaryFolder folder_;
};

void check_accepted(const Arguments &question, int exit_code = 0) {
  const Theorem theorem(question);
  CHECK(theorem.exit_code == exit_code);
  const Outcome outcome = theorem.check();
  INFO(theorem.text() << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.rfind("Axioms:\nClassicalDedekindReals.", 0) == 0);
}

std::string accepted(const std::string &name) {
  return std::string(MDM_CERTIFICATES_DIR) + "/accepted/" + name;
}

} // namespace

TEST_CASE("Coq accepts the theorem of every kind of question") {
  check_accepted({example("athabasca-sand")});
  check_accepted({example("athabasca-sand"), "--at-least", "2000"});
  check_accepted({example("athabasca-sand"), "--min-per-class", "10", "--law", "power:5/2"});
  check_accepted({example("athabasca-sand"), "--specimen", "cylinder:10x20", "--void-ratio", "0.6"});
  check_accepted({example("athabasca-sand"), "--solids-volume", "1000"});
  check_accepted({accepted("pan_cut_factor.csv"), "--cut-below", "1", "--size-factor", "2.5"});
  check_accepted({accepted("factors.csv")});
}

TEST_CASE("Coq accepts the theorem of a gradation in half-phi") {
  const TemporaryFolder folder;
  std::ofstream(folder / "phi.csv") << "size_phi,mass\n-2,0\n-1.5,1\n-1,0\n-0.5,0\n0,1\n";
  const Theorem theorem({folder / "phi.csv"});
  CHECK(theorem.text().find("least_number sphere asked_question sieves 10") != std::string::npos);
  CHECK(theorem.check().exit_code == 0);
  CHECK(theorem.check_with("sieves 10", "sieves 9").exit_code != 0);
}

TEST_CASE("a theorem whose powers would take Coq minutes is refused, and nothing is written") {
  const TemporaryFolder folder;
  std::ofstream(folder / "phi.csv") << "size_phi,mass\n-2,0\n-1.501,1\n-1,0\n0,1\n";
  for (const Arguments &question :
       std::vector<Arguments>{{folder / "phi.csv"}, {example("athabasca-sand"), "--law", "power:1000/999"}}) {
    Arguments words = {"solve", "--quiet", "--coq", folder / "theorem.v"};
    words.insert(words.end(), question.begin(), question.end());
    const Outcome outcome = mdm(words);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("and Coq takes too long where classes times bits times bits") !=
          std::string::npos);
    CHECK(folder.entries() == 1);
  }
  check_accepted({example("athabasca-sand"), "--law", "power:30"});
}

TEST_CASE("Coq accepts the theorem of every kind of tolerance") {
  check_accepted({example("athabasca-sand"), "--tolerance", "retained:1%"});
  check_accepted({example("athabasca-sand"), "--tolerance", "laboratory", "--tolerance", "total:8%"});
  check_accepted({accepted("tree_retained_file.csv"), "--pan-size", "0.5", "--size-factor", "2.5",
                  "--tolerance", "retained:file", "--tolerance", "passing:20%", "--at-least", "8"});
  check_accepted({"--band", example("c33-fine-aggregate-limits")});
  check_accepted({accepted("tree_none_of_a_band.csv"), "--tolerance", "total:0%", "--law", "power:2"});
}

TEST_CASE("Coq accepts the theorem of a proof by windows of the mass, and none of it changed") {
  const TemporaryFolder folder;
  std::ofstream(folder / "curve.csv") << [] {
    std::string rows = "size_mm,mass\n";
    for (int j = 1; j <= 20; ++j)
      rows += std::to_string(j) + "," + std::to_string(j * (20 - j)) + "\n";
    return rows;
  }();
  const Theorem theorem({folder / "curve.csv", "--tolerance", "retained:1%"});
  const std::string text = theorem.text();
  CHECK(text.find("SplitMass ") != std::string::npos);
  CHECK(text.find("Window [Multiple ") != std::string::npos);
  CHECK(theorem.check().exit_code == 0);
  CHECK(theorem.check_with("Window [Multiple ", "Window [Multiple 1").exit_code != 0);
}

TEST_CASE("Coq accepts the theorem that no sample is within a tolerance") {
  const TemporaryFolder folder;
  std::ofstream(folder / "sand.csv") << "size_mm,mass\n1,1\n2,1\n3,0\n";
  std::ofstream(folder / "limits.csv")
      << "size_mm,passing_min_percent,passing_max_percent\n2,90,95\n3,100,100\n";
  check_accepted({folder / "sand.csv", "--tolerance", "retained:1%", "--band", folder / "limits.csv"}, 1);
}

TEST_CASE("Coq refuses a theorem with another number, another gradation or other evidence") {
  const Theorem exact({example("athabasca-sand")});
  CHECK(exact.check_with("sieves 1485", "sieves 1484").exit_code != 0);
  CHECK(exact.check_with("(Smallest 1485)", "(Smallest 1486)").exit_code != 0);
  CHECK(exact.check_with("(193 # 50)", "(191 # 50)").exit_code != 0);
  CHECK(exact.check_with("Witness 1 819", "Witness 1 818").exit_code != 0);
  CHECK(exact.check_with("Some [7]", "Some [6]").exit_code != 0);
  CHECK(exact.check_with("min_per_class := 0", "min_per_class := 2").exit_code != 0);
  const Theorem tolerant({example("athabasca-sand"), "--tolerance", "retained:1%"});
  CHECK(tolerant.check_with("Some 1%Q", "Some 2%Q").exit_code != 0);
  CHECK(tolerant.check_with("Leaf [Multiple ", "Leaf [Multiple 1").exit_code != 0);
}

TEST_CASE("the example of proofs/README.md runs") {
  const std::string readme = read_file(std::string(MDM_SOURCE_DIR) + "/proofs/README.md");
  const std::size_t begin = readme.find("## A theorem for one answer");
  REQUIRE(begin != std::string::npos);
  const std::string section = readme.substr(begin, readme.find("\n## ", begin) - begin);
  const TemporaryFolder folder;
  std::string script = "set -e\ncd '" + std::string(folder / "") +
                       "'\nln -s '" MDM_SOURCE_DIR "/examples' .\n" +
                       "mdm() { '" MDM_PROGRAM "' \"$@\"; }\ncoqc() { '" MDM_COQC "' \"$@\"; }\n";
  const std::regex command("\n    \\$ ([^\n]*)");
  for (std::sregex_iterator i(section.begin(), section.end(), command), end; i != end; ++i)
    script +=
        std::regex_replace((*i)[1].str(), std::regex("/usr/local/share/exactmdm/coq"), MDM_COQ_BUILD) + "\n";
  const Outcome outcome = Process("/bin/sh", {"-c", script}).end();
  INFO(script << outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("Axioms:") != std::string::npos);
}

// What solve --coq writes is a theorem that Coq accepts, and what is changed of it is none.

#include "cli/run.hpp"

#include <sys/stat.h>

#include <regex>

namespace coq_file_test {

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

/// The line that Coq has printed, each quote once.
std::string printed_line(const std::string &out) {
  const std::size_t begin = out.find("line = \n\""), end = out.find("\"\n     : string\nAxioms:\n");
  REQUIRE(begin == 0);
  REQUIRE(end != std::string::npos);
  return std::regex_replace(out.substr(9, end - 9), std::regex("\"\""), "\"");
}

/// Coq accepts the theorem, and its line is that which mdm-check prints of the same files.
void check_accepted(const Arguments &question, int exit_code = 0) {
  const TemporaryFolder folder;
  Arguments words = question;
  words.insert(words.end(), {"--proof", folder / "proof"});
  const Theorem theorem(words);
  CHECK(theorem.exit_code == exit_code);
  const Outcome outcome = theorem.check();
  INFO(theorem.text() << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("\nAxioms:\nClassicalDedekindReals.") != std::string::npos);
  const std::string source = question[0] == "--band" ? question[1] : question[0];
  const Outcome verdict = Process(MDM_CHECK_PROGRAM, {source, folder / "proof"}).end();
  CHECK(verdict.exit_code == 0);
  CHECK(printed_line(outcome.out) + "\n" == verdict.out);
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
  CHECK(theorem.check().out.find("N = 10 is the smallest") != std::string::npos);
  CHECK(theorem.check_with("particles 10", "particles 9").exit_code != 0);
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
  CHECK(text.find("split M ") != std::string::npos);
  CHECK(text.find("\nwindow ") != std::string::npos);
  CHECK(theorem.check().exit_code == 0);
  CHECK(theorem.check_with("\nwindow ", "\nwindow 1").exit_code != 0);
}

TEST_CASE("Coq accepts the theorem that no sample is within a tolerance") {
  const TemporaryFolder folder;
  std::ofstream(folder / "sand.csv") << "size_mm,mass\n1,1\n2,1\n3,0\n";
  std::ofstream(folder / "limits.csv")
      << "size_mm,passing_min_percent,passing_max_percent\n2,90,95\n3,100,100\n";
  check_accepted({folder / "sand.csv", "--tolerance", "retained:1%", "--band", folder / "limits.csv"}, 1);
}

TEST_CASE("Coq accepts the theorem of bounds, where a limit ended the search") {
  const TemporaryFolder folder;
  std::ofstream(folder / "sand.csv")
      << "size_mm,mass\n0.05,1.1\n0.07,18.3\n0.084,16.8\n0.109,16.6\n0.142,17.1\n0.169,25.6\n0.219,10.0\n"
         "0.261,14.1\n0.311,19.3\n0.404,1.9\n0.569,22.4\n0.74,20.2\n1.044,1.4\n1.357,3.3\n1.913,10.2\n"
         "2.697,11.0\n3.21,13.5\n4.173,18.6\n5.883,19.1\n8.295,13.8\n10.784,0\n";
  const Theorem theorem({folder / "sand.csv", "--tolerance", "retained:0.4%", "--node-limit", "1"});
  CHECK(theorem.exit_code == 3);
  const Outcome outcome = theorem.check();
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  const std::string line = printed_line(outcome.out);
  CHECK((line.find(" is between ") != std::string::npos ||
         line.rfind("accepted: no number of particles below ", 0) == 0));
}

TEST_CASE("the bytes are those of the file: with a mark, CR LF, tabs, quotes and other letters") {
  const TemporaryFolder folder;
  const std::string sand = folder / "s\xc3\xa4nd \"2\".csv";
  std::ofstream(sand)
      << "\xef\xbb\xbf\"size_mm\",mass\r\n# gr\xc3\xb6\xc3\x9f\x65n\r\n1, 2\r\n\"2\",\t1\r\n3,0\r\n";
  check_accepted({sand});
  CHECK(Theorem({sand}).text().find(R"(""size_mm"",mass)") != std::string::npos);
}

TEST_CASE("a gradation that the checkers do not read is in the theorem as canonical CSV") {
  const TemporaryFolder folder;
  std::ofstream(folder / "sand.csv") << "Sieb;Masse\n1 mm;2\n2 mm;1\n3 mm;0\n";
  const Theorem theorem({folder / "sand.csv"});
  const Outcome outcome = theorem.check();
  INFO(outcome.out << outcome.err);
  CHECK(printed_line(outcome.out).find("sand.csv as canonical CSV\" exactly") != std::string::npos);
  CHECK(theorem.text().find("\"size_mm,mass\n1,2\n2,1\n3,0\n\"") != std::string::npos);
}

TEST_CASE("Coq refuses a theorem with another number, another gradation, other evidence or another line") {
  const Theorem exact({example("athabasca-sand")});
  CHECK(exact.check_with("particles 1485", "particles 1484").exit_code != 0);
  CHECK(exact.check_with("particles 1485", "particles 1486").exit_code != 0);
  CHECK(exact.check_with("0.15,15.27", "0.15,15.26").exit_code != 0);
  CHECK(exact.check_with("class 1 819", "class 1 818").exit_code != 0);
  CHECK(exact.check_with("chain 7", "chain 6").exit_code != 0);
  CHECK(exact.check_with("particles", "min-per-class 2\nparticles").exit_code != 0);
  CHECK(exact
            .check_with(":= Eval vm_compute in verdict_line (judge gradation certificate)",
                        ":= \"accepted: N = 1 is the smallest number of particles that matches "
                        "\"\"athabasca-sand.csv\"\" "
                        "exactly (mass law x^3; sizes in mm)\"")
            .exit_code != 0);
  const Theorem tolerant({example("athabasca-sand"), "--tolerance", "retained:1%"});
  CHECK(tolerant.check_with("retained 1\n", "retained 2\n").exit_code != 0);
  CHECK(tolerant.check_with("\nleaf ", "\nleaf 1").exit_code != 0);
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

} // namespace coq_file_test

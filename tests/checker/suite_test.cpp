// mdm-check --suite: all certificates of a folder, a summary, and the worst exit code. Those of streams are
// in proof_stream_test.cpp.

#include "catch.hpp"
#include "program.hpp"

using namespace mdm_check_test;

namespace {

std::string certificate(const std::string &file) {
  return read_file(std::filesystem::path(MDM_CERTIFICATES_DIR) / file);
}

const std::string line = R"({"id": "a", "sizes": [1, 2, 3], "masses": [2, 1, 0]})";
const std::string other_line = R"({"id": "b", "sizes": [1, 2, 3], "masses": [2, 9, 0]})";

/// A suite and its folder.
struct Suite {
  TemporaryFolder folder;
  std::string file = (folder.path() / "suite.jsonl").string();
  std::string proofs = (folder.path() / "proofs").string();

  explicit Suite(const std::string &lines) {
    std::filesystem::create_directory(proofs);
    write_file(file, lines);
  }
  std::string add(const std::string &name, const std::string &text) const {
    return write_file(std::filesystem::path(proofs) / name, text).string();
  }
  std::string summary(const std::string &counts) const { return file + ": " + counts + "\n"; }
};

} // namespace

TEST_CASE("certificates are checked against the lines that their names begin with", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s(line + "\r\n \n" + line + "\n");
  s.add("000001-a.proof", proof);
  s.add("3.proof", proof);
  s.add("notes.txt", "of no concern");
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == s.summary("2 accepted, 0 refused, 0 malformed, 0 missing"));
  CHECK(outcome.err.empty());
  const Outcome verbose = run({"--suite", s.file, s.proofs, "--verbose"});
  CHECK(verbose.out.find(s.file + ":1\" exactly (") != std::string::npos);
  CHECK(verbose.out.find(s.file + ":3\" exactly (") != std::string::npos);
  CHECK(run({"--suite", "-", s.proofs}, s.file).exit_code == 0);
}

TEST_CASE("the exit code of a suite is that of the worst certificate", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s(line + "\n" + other_line + "\n" + line + "\n");
  s.add("1.proof", proof);
  const std::string wrong = s.add("2-b.proof", proof);
  const Outcome refused = run({"--suite", s.file, s.proofs});
  CHECK(refused.exit_code == 1);
  CHECK(refused.out.find("refused: " + wrong + ": ") == 0);
  CHECK(refused.out.find("missing: " + s.file + ":3: ") != std::string::npos);
  CHECK(refused.out.find(s.summary("1 accepted, 1 refused, 0 malformed, 1 missing")) != std::string::npos);
  const std::string none = s.add("3-c.proof", "none");
  const Outcome malformed = run({"--suite", s.file, s.proofs});
  CHECK(malformed.exit_code == 2);
  CHECK(malformed.out.find("malformed: " + none + ":1: ") != std::string::npos);
}

TEST_CASE("a certificate without a line, and a line that is no gradation, are malformed", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  for (const char *name : {"0.proof", "2-a.proof", "a.proof", "1a.proof", "99999999999999999999.proof"}) {
    const Suite s(line + "\n");
    s.add("1.proof", proof);
    const std::string path = s.add(name, proof);
    const Outcome outcome = run({"--suite", s.file, s.proofs});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "malformed: " + path + ": begins with the number of no line of '" + s.file + "'\n" +
                             s.summary("1 accepted, 0 refused, 1 malformed, 0 missing"));
  }
  const Suite s("{\n");
  s.add("1.proof", proof);
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("malformed: " + s.file + ":1: '") == 0);
}

TEST_CASE("every certificate of one line is checked", "[checker]") {
  const Suite s(line + "\n");
  s.add("1-a.proof", certificate("accepted/sphere_two_classes.proof"));
  s.add("1-b.proof", "older");
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("1 accepted, 0 refused, 1 malformed") != std::string::npos);
}

TEST_CASE("threads change nothing of the verdicts and their order", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  std::string lines;
  for (int i = 0; i < 500; ++i)
    lines += (i % 7 == 3 ? other_line : line) + "\n";
  const Suite s(lines);
  for (int i = 1; i <= 500; ++i)
    if (i % 11 != 0)
      s.add(std::to_string(i) + ".proof", i % 5 == 0 ? proof + "x" : proof);
  const Outcome one = run({"--suite", s.file, s.proofs, "--verbose"});
  CHECK(one.exit_code == 2);
  for (const std::vector<std::string> &threads :
       std::vector<std::vector<std::string>>{{"-j", "2"}, {"-j7"}, {"-j", "1024"}}) {
    std::vector<std::string> arguments = {"--suite", s.file, s.proofs, "--verbose"};
    arguments.insert(arguments.end(), threads.begin(), threads.end());
    const Outcome more = run(arguments);
    CHECK(more.exit_code == one.exit_code);
    CHECK(more.out == one.out);
  }
  for (const char *threads : {"0", "1025", "x", "-1", "", "99999999999999999999"})
    CHECK(run({"--suite", s.file, s.proofs, "-j", threads}).err.find("mdm-check: -j: ") == 0);
  CHECK(run({"--suite", s.file, s.proofs, "-j"}).exit_code == 2);
}

TEST_CASE("without a suite, certificates are checked against the gradations beside them", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s("");
  s.add("1-a.proof", proof);
  s.add("1-a.gradation", "size_mm,mass\n1,2\n2,1\n3,0\n");
  CHECK(run({"--suite", s.proofs}).exit_code == 0);
  const std::string alone = s.add("2-b.gradation", line), other = s.add("3-c.proof", proof);
  const Outcome outcome = run({"--suite", s.proofs});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find("missing: " + alone + ": ") != std::string::npos);
  CHECK(outcome.out.find("missing: " + other + ": ") != std::string::npos);
  CHECK(outcome.out.find("1 accepted, 0 refused, 0 malformed, 2 missing") != std::string::npos);
}

TEST_CASE("a suite or a folder that cannot be read, or has nothing, is refused", "[checker]") {
  const Suite s("\n");
  const std::string missing = s.folder.path() / "missing";
  for (const std::vector<std::string> &arguments :
       std::vector<std::vector<std::string>>{{"--suite"},
                                             {"--suite", "-"},
                                             {"--suite", s.file, s.proofs, s.proofs},
                                             {"--suite", s.file, missing},
                                             {"--suite", missing, s.proofs},
                                             {"--suite", s.file, s.file},
                                             {"--suite", s.proofs, s.proofs},
                                             {"--suite", s.file, s.proofs},
                                             {"--suite", s.proofs},
                                             {"--suite", s.file, s.proofs, "--print"}}) {
    const Outcome outcome = run(arguments);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

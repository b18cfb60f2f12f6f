// mdm crosscheck --proofs NAME.proofs: the certificates of answers as one stream with an index.

#include "run.hpp"

namespace answer_stream_test {

using namespace cli_test;

namespace {

std::string gradation(const std::string &id) {
  return R"({"id":")" + id + R"(","sizes":[1,2,3],"masses":[2,1,0]})" + "\n";
}

const std::string suite_text =
    gradation("a") + "\n" + gradation("b") + gradation("open") + gradation("garbage") + gradation("c");
const std::string answers_text = R"({"id":"c","quantities":[3,1]})"
                                 "\n"
                                 R"({"id":"a","quantities":[3,1]})"
                                 "\n"
                                 R"({"id":"open","quantities":[1,1]})"
                                 "\n"
                                 R"({"id":"garbage","quantities":"x"})"
                                 "\n"
                                 R"({"id":"a","quantities":[1,1],"sizes":[1.5,2.5]})"
                                 "\n"
                                 R"({"id":"b","quantities":[5,2]})"
                                 "\n";

struct Files {
  TemporaryFolder folder;
  std::string suite = folder.write("suite.jsonl", suite_text),
              answers = folder.write("answers.jsonl", answers_text), stream = folder / "all.proofs";

  Outcome crosscheck(const Arguments &more = {}) const {
    Arguments words = {"crosscheck", suite, answers, "--proofs", stream};
    words.insert(words.end(), more.begin(), more.end());
    return mdm(words);
  }
  Outcome check(const Arguments &more = {}) const {
    Arguments words = {"--suite", suite, stream};
    words.insert(words.end(), more.begin(), more.end());
    return mdm_check(words);
  }
};

} // namespace

TEST_CASE("a stream of answers' certificates has those of the folder, and an index by line", "[cli]") {
  const Files f;
  const std::string proofs = f.folder / "folder";
  CHECK(mdm({"crosscheck", f.suite, f.answers, "--proofs", proofs}).exit_code == 1);
  std::string text, entries = "mdm-proofs sample 1\n";
  for (const auto &[name, place] :
       {std::pair("1", "1 1 "), std::pair("1-2", "1 2 "), std::pair("3", "3 1 "), std::pair("6", "6 1 ")}) {
    const std::string sample = read_file(proofs + "/" + name + ".sample.csv"),
                      proof = read_file(proofs + "/" + name + ".proof");
    entries += place + std::to_string(text.size()) + " " + std::to_string(sample.size()) + " " +
               std::to_string(proof.size()) + "\n";
    text += sample + proof;
  }
  for (const char *threads : {"1", "3"}) {
    const Outcome outcome = f.crosscheck({"-j", threads});
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.out, "4 certificates are in "));
    CHECK(contains(outcome.out, "check them with: mdm-check --suite " + f.suite + " " + f.stream));
    CHECK(contains(outcome.out, "; of 1 answers there is none"));
    CHECK(read_file(f.stream) == text);
    CHECK(read_file(f.stream + ".index") == entries);
  }
}

TEST_CASE("mdm-check judges a stream of answers' certificates; an answer without one is missing", "[cli]") {
  const Files f;
  f.crosscheck();
  const Outcome checked = f.check({"--verbose"});
  CHECK(checked.exit_code == 1);
  const std::vector<std::string> lines = lines_of(checked.out);
  REQUIRE(lines.size() == 7);
  CHECK(lines[0] == "accepted: the 4 particles of \"" + f.stream + " (sample of line 1)\" match \"" +
                        f.suite +
                        ":1\" exactly; conditions 1 yes, 2 yes, 3 yes, 4 yes (mass law x^3; sizes in mm)");
  CHECK(contains(lines[1], " (sample of line 1, answer 2)\" do not match \"" + f.suite + ":1\" exactly: "));
  CHECK(contains(lines[2], "the 7 particles of "));
  CHECK(lines[3] == "missing: " + f.suite + ":4: no certificate in the stream");
  CHECK(lines[4] == "missing: " + f.suite + ":5: no certificate in the stream");
  CHECK(lines[6].rfind(f.suite + ": 4 accepted, 0 refused, 0 malformed, 2 missing; 4 accepted as ", 0) == 0);
}

TEST_CASE("a stream of answers of which each is certified is accepted, also compressed", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", gradation("a") + gradation("b")),
                    answers = folder.write("answers.csv", "id,quantities\na,3 1\nb,5 2\n");
  for (const char *name : {"a.proofs", "a.proofs.zst"}) {
    const std::string stream = folder / name;
    CHECK(mdm({"crosscheck", suite, answers, "--proofs", stream}).exit_code == 0);
    const Outcome checked = mdm_check({"--suite", suite, stream});
    CHECK(checked.exit_code == 0);
    CHECK(contains(checked.out, ": 2 accepted, 0 refused, 0 malformed, 0 missing; 2 accepted as "));
  }
}

TEST_CASE("a solver's answers are certified in a stream, and a crash has no certificate", "[cli]") {
  const Files f;
  const Outcome outcome =
      mdm({"crosscheck", f.suite, "--solver", R"(grep -q '"c"' && exit 3; echo '{"quantities": [3, 1]}')",
           "--proofs", f.stream});
  CHECK(outcome.exit_code == 1);
  const Outcome checked = f.check();
  CHECK(checked.exit_code == 1);
  CHECK(contains(checked.out, "missing: " + f.suite + ":6: "));
  CHECK(contains(checked.out, ": 4 accepted, 0 refused, 0 malformed, 1 missing"));
}

TEST_CASE("certificates of a stream are refused with another suite", "[cli]") {
  const Files f;
  f.crosscheck();
  std::string other = suite_text;
  other.replace(other.find("[2,1,0]"), 7, "[2,9,0]");
  f.folder.write("suite.jsonl", other);
  const Outcome checked = f.check();
  CHECK(checked.exit_code == 1);
  CHECK(contains(checked.out, "refused: " + f.stream + " (of line 1): "));
  CHECK(contains(checked.out, "refused: " + f.stream + " (of line 1, answer 2): "));
  CHECK(contains(checked.out, ": 2 accepted, 2 refused, 0 malformed, 2 missing"));
  f.folder.write("suite.jsonl", gradation("a"));
  CHECK(contains(f.check().out, "malformed: " + f.stream + ".index:4: no line 3 in "));
}

TEST_CASE("a stream of answers is of a suite, and over no other file", "[cli]") {
  const Files f;
  check_refused(mdm({"crosscheck", example("athabasca-sand"), "--solution", f.answers, "--proofs", f.stream}),
                "name a folder");
  const std::string proofs = f.folder.write("kept.proofs", suite_text);
  const auto crosscheck = [&](const std::string &suite, const Arguments &more) {
    Arguments words = {"crosscheck", suite, f.answers};
    words.insert(words.end(), more.begin(), more.end());
    return mdm(words);
  };
  check_refused(crosscheck(proofs, {"--proofs", proofs}), "different names");
  check_refused(crosscheck(f.suite, {"--proofs", proofs, "-o", proofs, "--format", "csv"}),
                "different names");
  check_refused(crosscheck(f.suite, {"--proofs", proofs, "-o", proofs + ".index", "--format", "csv"}),
                "different names");
  check_refused(crosscheck(f.suite, {"--proofs", f.folder / "missing/a.proofs"}), "missing/a.proofs");
  std::filesystem::create_directory(f.folder / "b.proofs");
  check_refused(crosscheck(f.suite, {"--proofs", f.folder / "b.proofs"}), "b.proofs");
  CHECK(read_file(proofs) == suite_text);
}

TEST_CASE("a crosscheck that fails or is interrupted leaves no part of a stream", "[cli]") {
  const Files f;
  f.folder.write("suite.jsonl", suite_text + "nonsense\n");
  CHECK(f.crosscheck().exit_code == 2);
  f.folder.write("suite.jsonl", suite_text);
  const auto entries = f.folder.entries();
  Process run(MDM_PROGRAM, {"crosscheck", f.suite, "--solver",
                            "echo >>'" + f.folder / "begun" + "'; exec sleep 1000", "--proofs", f.stream});
  while (!std::filesystem::exists(f.folder / "begun"))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  run.signal(SIGTERM);
  CHECK(run.end().signal == SIGTERM);
  CHECK(f.folder.entries() == entries + 1);
  CHECK_FALSE(std::filesystem::exists(f.stream));
}

} // namespace answer_stream_test

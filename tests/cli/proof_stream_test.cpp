// mdm batch --proofs NAME.proofs: the certificates as one stream with an index.

#include "run.hpp"

namespace proof_stream_test {

using namespace cli_test;

namespace {

const std::string good = R"({"id":"good","sizes":["1","2","3"],"masses":["2","1","0"]})";
const std::string slow =
    R"({"id":"slow","sizes":["1","1.000001","1.000002","1.000003"],"masses":["7","11","13","0"]})";

Outcome check(const std::string &suite, const std::string &proofs) {
  return Process(MDM_CHECK_PROGRAM, {"--suite", suite, proofs}).end();
}

} // namespace

TEST_CASE("a stream of proofs has the certificates of the folder, and an index by line", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", good + "\n\nnonsense\n" + slow + "\n" + good + "\n");
  const auto batch = [&](const std::string &proofs) {
    return mdm({"batch", suite, "--max-steps", "1", "--proofs", proofs, "-j", "2"});
  };
  CHECK(batch(folder / "folder").exit_code == 2);
  const Outcome outcome = batch(folder / "all.proofs");
  CHECK(outcome.exit_code == 2);
  const std::string first = read_file(folder / "folder/000001-good.proof"),
                    bounds = read_file(folder / "folder/000004-slow.proof"),
                    second = read_file(folder / "folder/000005-good.proof");
  CHECK(read_file(folder / "all.proofs") == first + bounds + second);
  const auto entry = [](int line, std::size_t offset, const std::string &proof) {
    return std::to_string(line) + " " + std::to_string(offset) + " " + std::to_string(proof.size()) + "\n";
  };
  CHECK(read_file(folder / "all.proofs.index") == "mdm-proofs 1\n" + entry(1, 0, first) +
                                                      entry(4, first.size(), bounds) +
                                                      entry(5, first.size() + bounds.size(), second));
  CHECK(outcome.out.find("\"proof\"") == std::string::npos);
  const Outcome checked = check(suite, folder / "all.proofs");
  CHECK(checked.exit_code == 1);
  CHECK(checked.out.find("3 accepted, 0 refused, 0 malformed, 1 missing") != std::string::npos);
}

TEST_CASE("answers beside a stream of proofs are those without proofs", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = MDM_SUITE;
  const Outcome alone = mdm({"batch", suite});
  CHECK(mdm({"batch", suite, "--proofs", folder / "all.proofs", "-j", "2"}).out == alone.out);
  CHECK(check(suite, folder / "all.proofs").out ==
        suite + ": 2750 accepted, 0 refused, 0 malformed, 0 missing; 2750 accepted as the smallest number of "
                "particles that matches exactly (mass law x^3)\n");
  CHECK(folder.entries() == 2);
}

TEST_CASE("answers of every kind say what their proofs do", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write(
      "suite.jsonl",
      R"({"unit": "um", "sizes": [0, 1, 2, 4, 8], "masses": [1, 3, 2, 5, 0], "tolerances_percent": [2, 3, 4, 5, 6], )"
      R"("factors": [1, 2, 1, 3, 1]})"
      "\n\n"
      R"({"id": "b; at least 2 particles", "unit": "um", "sizes": [0, 1, 2, 3, 8], )"
      R"("masses": [2, 3, 0.125, 5, 0], "tolerances_percent": [2, 3, 4, 5, 6]})"
      "\n");
  const std::vector<Arguments> questions = {
      {},
      {"--at-least", "300", "--law", "power:5/2", "--min-per-class", "2"},
      {"--pan-size", "0.5", "--cut-below", "1", "--size-factor", "2.5"},
      {"--specimen", "cylinder:20x30", "--void-ratio", "0.6"},
      {"--specimen", "box:20x30x10", "--void-ratio", "0.6", "--tolerance", "retained:2%"},
      {"--solids-volume", "1000", "--max-steps", "1"},
      {"--tolerance", "retained:file", "--tolerance", "total:9%", "--min-per-class", "1"},
      {"--tolerance", "passing:file", "--at-least", "20", "--law", "power:1"},
      {"--tolerance", "passing:1%", "--node-limit", "1"},
      {"--tolerance", "retained:0.5%", "--at-most", "3"}};
  const std::string answers = folder / "answers.jsonl", proofs = folder / "proofs",
                    table = folder / "answers.csv";
  for (Arguments options : questions) {
    std::filesystem::remove_all(proofs);
    Arguments batch = {"batch", suite, "--quiet"};
    batch.insert(batch.end(), options.begin(), options.end());
    Arguments in_csv = batch;
    batch.insert(batch.end(), {"-o", answers, "--proofs", proofs});
    in_csv.insert(in_csv.end(), {"--format", "csv", "-o", table});
    const Outcome solved = mdm(batch);
    INFO(solved.err << (options.empty() ? "" : options[0]) << read_file(answers));
    const Outcome checked =
        Process(MDM_CHECK_PROGRAM, {"--suite", suite, proofs, "--answers", answers}).end();
    INFO(checked.out << checked.err);
    CHECK(checked.exit_code == 0);
    CHECK(checked.out.find(" 0 missing, 0 different; ") != std::string::npos);
    mdm(in_csv);
    CHECK(Process(MDM_CHECK_PROGRAM, {"--suite", suite, proofs, "--answers", table}).end().exit_code == 0);
  }
}

TEST_CASE("a stream of proofs is of one suite", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", good + "\n" + good + "\n");
  const std::string proofs = folder / "all.proofs";
  check_refused(mdm({"batch", suite, suite, "--proofs", proofs}), "--proofs: ");
  check_refused(mdm({"batch", example("athabasca-sand"), "--proofs", proofs}), "no suite in JSON Lines");
  CHECK(folder.entries() == 1);
  CHECK(mdm({"batch", "--proofs", proofs}, good).exit_code == 0);
  CHECK(mdm({"batch", "-", "--proofs", proofs}, good + "\n" + good).exit_code == 0);
  CHECK(check(suite, proofs).exit_code == 0);
}

TEST_CASE("a stream of proofs is written whole or not at all, and over nothing else", "[cli]") {
  const TemporaryFolder folder;
  const std::string proofs = folder.write("a.proofs", good + "\n");
  check_refused(mdm({"batch", proofs, "--proofs", proofs}), "different names");
  check_refused(mdm({"batch", "--proofs", proofs, "-o", proofs}, good), "different names");
  check_refused(mdm({"batch", "--proofs", proofs, "-o", proofs + ".index"}, good), "different names");
  check_refused(mdm({"batch", "--proofs", folder / "missing/a.proofs"}, good), "missing/a.proofs");
  std::filesystem::create_directory(folder / "b.proofs");
  check_refused(mdm({"batch", "--proofs", folder / "b.proofs"}, good), "b.proofs");
  CHECK(mdm({"batch", folder / "missing.jsonl", "--proofs", proofs}).exit_code == 2);
  CHECK(read_file(proofs) == good + "\n");
  CHECK(folder.entries() == 2);
}

} // namespace proof_stream_test

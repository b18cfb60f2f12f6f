// mdm crosscheck --minimum: least matches that proofs give, so that nothing is solved twice.

#include "answer.hpp"

namespace known_minima_test {

using namespace cli_test;

namespace {

/// Two gradations, with a blank line between them.
const std::string problems = R"({"id":"a","sizes":["1","2","3","5"],"masses":["2","1","4","0"]})"
                             "\n\n"
                             R"({"id":"b","sizes":["1","2","4"],"masses":["3","1","0"]})"
                             "\n";

struct Suite {
  TemporaryFolder folder;
  std::string suite = folder.write("suite.jsonl", problems), answers = folder / "answers.jsonl",
              proofs = folder / "suite.proofs";

  explicit Suite(const Arguments &question) : question_(question) {
    CHECK(mdm(asked({"batch", suite, "--proofs", proofs, "-o", answers})).exit_code == 0);
  }
  Outcome crosscheck(Arguments options = {}) const {
    options.insert(options.begin(), {"crosscheck", suite, answers, "--minimum", proofs, "--format", "json"});
    return mdm(options);
  }
  Arguments asked(Arguments arguments) const {
    arguments.insert(arguments.end(), question_.begin(), question_.end());
    return arguments;
  }

private:
  Arguments question_;
};

} // namespace

TEST_CASE("least matches are taken from proofs, which are checked", "[cli]") {
  for (const Arguments &question :
       std::vector<Arguments>{{"--tolerance", "retained:2%"},
                              {"--tolerance", "passing:1%", "--min-per-class", "2"},
                              {"--at-least", "30"},
                              {"--law", "power:2", "--tolerance", "total:3%"},
                              {"--specimen", "box:9x9x9", "--void-ratio", "0.6"}}) {
    const Suite of(question);
    const Outcome judged = of.crosscheck(question);
    INFO(judged.out << judged.err);
    CHECK(judged.exit_code == 0);
    REQUIRE(Json::accept(judged.out));
    const Json rows = Json::parse(judged.out).at("rows");
    REQUIRE(rows.size() == 2);
    for (const Json &row : rows)
      CHECK(row.at("verdict") == "minimal");
    // The same as without them.
    Arguments without{"crosscheck", of.suite, of.answers, "--format", "json"};
    without.insert(without.end(), question.begin(), question.end());
    CHECK(mdm(without).out == judged.out);
  }
}

TEST_CASE("proofs of another question or another suite are refused", "[cli]") {
  const Suite of({"--tolerance", "retained:2%"});
  check_refused(of.crosscheck({"--tolerance", "retained:1%"}), "line 1 is of another question");
  check_refused(of.crosscheck({"--tolerance", "retained:2%", "--min-per-class", "2"}), "of another question");
  of.folder.write("suite.jsonl", R"({"id":"a","sizes":["1","2","3","5"],"masses":["9","1","4","0"]})");
  check_refused(of.crosscheck({"--tolerance", "retained:2%"}), "make the proofs anew for this suite");
}

TEST_CASE("a line without a proof is solved, and a smaller answer than is proved is none", "[cli]") {
  const Suite of({"--tolerance", "retained:2%"});
  of.folder.write("suite.jsonl", problems + R"({"id":"c","sizes":["1","2","4"],"masses":["3","1","0"]})");
  const std::string more =
      of.folder.write("more.jsonl", read_file(of.answers) + R"({"id":"c","quantities":[2,1]})");
  const Json judged = Json::parse(mdm({"crosscheck", of.suite, more, "--minimum", of.proofs, "--tolerance",
                                       "retained:2%", "--format", "json"})
                                      .out);
  CHECK(judged.at("rows").at(0).at("verdict") == "minimal");
  CHECK(judged.at("rows").at(2).at("verdict") == "not-a-match");
}

TEST_CASE("what is no stream of proofs, and a question that is answered at once, are refused", "[cli]") {
  const Suite of({"--tolerance", "retained:2%"});
  check_refused(mdm({"crosscheck", of.suite, of.answers, "--minimum", of.proofs}), "is found at once");
  of.folder.write("suite.proofs.index", "mdm-proofs 1\n1 0 99999999\n");
  check_refused(of.crosscheck({"--tolerance", "retained:2%"}), "is none of a certificate");
  of.folder.write("suite.proofs.index", "nothing\n");
  check_refused(of.crosscheck({"--tolerance", "retained:2%"}), "no index of proofs");
}

} // namespace known_minima_test

// mdm blend --problems, and mdm crosscheck of problems of blends.

#include "answer.hpp"
#include "replaced.hpp"

namespace blend_problems_test {

using namespace cli_test;
using mdm_test::replaced;

namespace {

/// 40 + 60 a percent pass 4 mm: at least 60 for a >= 1/3; the cost 4 + 6 a grows with a.
const std::string cheap =
    R"({"id":"a","stockpiles":[{"name":"A","passing":["60","100"],"cost":"10"},)"
    R"({"name":"B","passing":["0",40],"cost":"4"}],"sieves":[{"size":"1","least":"10","most":"30"},)"
    R"({"size":4,"least":60,"most":"140/2"}],"aim":"cost"})";
/// 60 a >= 50 and 40 + 60 a <= 70 contradict each other.
const std::string none =
    R"({"id":"b","stockpiles":[{"name":"A","passing":[60,100]},{"name":"B","passing":[0,40]}],)"
    R"("sieves":[{"size":1,"least":50},{"size":4,"most":"70"}]})";

std::vector<Json> solved(const std::string &lines, int exit_code, Arguments options = {}) {
  options.insert(options.begin(), {"blend", "--problems", "-"});
  const Outcome outcome = mdm(options, lines);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  std::vector<Json> answers;
  for (const std::string &line : lines_of(outcome.out))
    answers.push_back(Json::parse(line));
  return answers;
}

Outcome judged(const std::string &problems, const std::string &answers, Arguments options = {}) {
  const TemporaryFolder folder;
  options.insert(options.begin(), {"crosscheck", folder.write("problems.jsonl", problems),
                                   folder.write("answers.jsonl", answers)});
  return mdm(options);
}

} // namespace

TEST_CASE("problems of blends: an answer a line, in order, and the exit code of the worst", "[blend]") {
  const std::vector<Json> answers = solved(cheap + "\n\n" + none + "\n", 1, {"-j", "2"});
  REQUIRE(answers.size() == 2);
  CHECK(answers[0].at("schema") == "mdm-blend-1");
  CHECK(answers[0].at("id") == "a");
  CHECK(answers[0].at("blends").at(0).at("shares") == Json::array({"17/50", "33/50"}));
  CHECK(answers[0].at("blends").at(0).at("value") == "151/25");
  CHECK(answers[1].at("id") == "b");
  CHECK(answers[1].at("status") == "none");
  const std::vector<Json> bad = solved(cheap + "\n{}\n" + none, 2);
  REQUIRE(bad.size() == 3);
  CHECK(bad[1] == Json{{"id", "2"}, {"status", "error"}, {"error", "stdin:2: sieves is missing"}});
  CHECK(solved(cheap + "\n{\"id\":\"y\"}", 2).at(1).at("id") == "y");
  CHECK(solved(cheap, 3, {"--node-limit", "0"}).at(0).at("status") == "unknown");
}

TEST_CASE("answers to problems go to a file of JSON Lines", "[blend]") {
  const TemporaryFolder folder;
  const std::string problems = folder.write("p.jsonl", cheap + "\n"), answers = folder / "answers.jsonl";
  CHECK(mdm({"blend", "--problems", problems, "-o", answers}).exit_code == 0);
  CHECK(std::filesystem::exists(answers));
  check_refused(mdm({"blend", example("athabasca-sand"), "--spec", "x.csv", "-o", answers}),
                ".jsonl is for --problems");
  check_refused(mdm({"blend", "--problems", problems, "-o", folder / "answers.csv"}), "JSON Lines");
}

TEST_CASE("problems of which fewer blends were found than asked for say so", "[blend]") {
  const std::string many = replaced(cheap, R"("aim")", R"("steps":"1000000000","aim")");
  const Json cut = solved(many, 3, {"--all", "1000000", "--time-limit", "0.1"}).at(0);
  CHECK(contains(cut.at("notes").dump(), "best of the 1000000 blends that were asked for"));
  CHECK(solved(cheap, 0, {"--all", "5"}).at(0).at("notes") == Json::array());
}

TEST_CASE("Ctrl-C ends problems of blends with the answers so far", "[blend]") {
  const TemporaryFolder folder;
  const std::string steps = R"("steps":"1000000000","aim")",
                    problems = folder.write("p.jsonl", none + "\n" + replaced(cheap, R"("aim")", steps) +
                                                           "\n" + none + "\n");
  Process run(MDM_PROGRAM,
              {"blend", "--problems", problems, "--all", "1000000", "--node-limit", "1000000000"});
  std::this_thread::sleep_for(std::chrono::seconds(1)); // it is searching by now
  run.signal(SIGINT);
  const Outcome outcome = run.end();
  CHECK(outcome.exit_code == 3);
  const std::vector<std::string> answers = lines_of(outcome.out);
  REQUIRE(answers.size() == 2);
  CHECK(contains(answers[1], "the search was interrupted"));
  CHECK(outcome.err == "note: the run was interrupted after 2 problems: the others are left out\n");
}

TEST_CASE("a cost that is missing is none, where the least cost is asked for", "[blend]") {
  const std::string problem =
      R"({"stockpiles":[{"name":"A","passing":["50","100"],"cost":"1"},{"name":"B","passing":["10","100"]}],)"
      R"("sieves":[{"size":"1","least":"20","most":"40"},{"size":"2","least":"100","most":"100"}],"steps":"100",)"
      R"("aim":"cost"})";
  CHECK(contains(solved(problem, 2).at(0).at("error").get<std::string>(), "stockpiles[1].cost is missing"));
}

TEST_CASE("an answer is its own problem", "[blend]") {
  const Outcome first = mdm({"blend", "--problems", "-"}, cheap + "\n" + none + "\n");
  CHECK(mdm({"blend", "--problems", "-"}, first.out).out == first.out);
}

TEST_CASE("problems and files have the same best blends", "[blend]") {
  const TemporaryFolder folder;
  const Arguments files = {
      "blend",
      folder.write("fine.csv", "size_mm,passing_percent\n8,100\n4,100\n1,60\n0.5,0\n"),
      folder.write("coarse.csv", "size_mm,passing_percent\n8,100\n4,40\n2,0\n"),
      "--spec",
      folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n4,60,70\n1,10,30\n"),
      "--format",
      "json"};
  Arguments more = files;
  more.insert(more.end(), {"--limit", "FM-EN=..5.5", "--cost", "fine=10,coarse=4", "--share", "coarse=..60%",
                           "--at-most-stockpiles", "2"});
  for (const Arguments &command : {files, more}) {
    const Json of_files = Json::parse(mdm(command).out);
    const Json of_line = solved(of_files.dump() + "\n", 0).at(0);
    for (const char *key :
         {"stockpiles", "sieves", "moduli", "steps", "at_most", "aim", "blends", "real", "prices"})
      CHECK(of_files.at(key) == of_line.at(key));
  }
}

TEST_CASE("problems of blends that are none", "[blend]") {
  const auto error = [](const std::string &line) {
    return solved(line + "\n", 2).at(0).at("error").get<std::string>();
  };
  CHECK(contains(error("[]"), "is no object"));
  CHECK(contains(error(replaced(cheap, "\"aim\"", "\"aims\"")), "'aims' is unknown"));
  CHECK(contains(error(replaced(cheap, "\"aim\":\"cost\"", "\"aim\":\"least\"")), "aim is 'least'"));
  CHECK(contains(error(replaced(cheap, "\"aim\"", "\"at_most\":\"-1\",\"aim\"")),
                 "at_most: '-1' is no whole number from 0 on"));
  CHECK(contains(error(replaced(cheap, "[\"60\",\"100\"]", "[\"60\"]")),
                 "stockpiles[0].passing has 1 numbers"));
  CHECK(contains(error(replaced(cheap, "[\"60\",\"100\"]", "[\"60\",\"50\"]")),
                 "less than one of a finer sieve"));
  CHECK(contains(error(replaced(cheap, "\"size\":4", "\"size\":1")), "the size 1 is there twice"));
  CHECK(contains(error(replaced(cheap, "\"size\":4", "\"size\":0")), "is not above 0"));
  CHECK(contains(error(replaced(cheap, "\"140/2\"", "\"140/0\"")), "is divided by 0"));
  CHECK(contains(error(replaced(cheap, "\"140/2\"", "\"141\"")), "above 100"));
  CHECK(contains(error(replaced(cheap, "\"name\":\"B\"", "\"name\":\"A\"")), "'A' is there twice"));
  CHECK(contains(error(replaced(cheap, "\"aim\":\"cost\"", "\"aim\":\"deviation\"")),
                 "a target at each sieve"));
  CHECK(contains(error(replaced(cheap, "\"aim\"", "\"steps\":0,\"aim\"")), "a whole of 0 steps is none"));
  CHECK(contains(error(replaced(cheap, "\"aim\"", "\"unit\":\"um\",\"aim\"")), "unit is 'um': write mm"));
  CHECK(contains(error(replaced(cheap, "\"aim\"", "\"schema\":\"mdm-answer-1\",\"aim\"")),
                 "write mdm-blend-1"));
  CHECK(contains(error(cheap.substr(0, 40)), "stdin:1"));
  check_refused(mdm({"blend", "--problems", "-"}, "\n"), "there are no problems");
  check_refused(mdm({"blend", "--problems", "-", "--step", "1%"}, cheap), "its lines say all that is asked");
  check_refused(mdm({"blend", "--problems", "-", "--format", "csv"}, cheap), "JSON Lines");
  check_refused(mdm({"blend", "--spec", "x"}), "--problems");
  check_refused(mdm({"blend", "a.csv", "--spec", "x", "-j", "2"}), "--problems");
}

TEST_CASE("blends of another solver: best, worse, none of the problem, and what it says rightly", "[blend]") {
  const std::string problems = cheap + "\n" + none + "\n";
  const std::string answers = "{\"id\":\"a\",\"percents\":[34,66]}\n"
                              "{\"id\":\"a\",\"percents\":[33,67]}\n"
                              "{\"id\":\"a\",\"shares\":[\"2/5\",0.6]}\n"
                              "{\"id\":\"a\",\"shares\":[\"0.3405\",\"0.6595\"]}\n"
                              "{\"id\":\"a\",\"shares\":[\"0.34\",\"0.65\"]}\n"
                              "{\"id\":\"a\",\"percents\":[34]}\n"
                              "{\"id\":\"a\",\"percents\":[101,-1]}\n"
                              "{\"id\":\"a\",\"status\":\"infeasible\"}\n"
                              "{\"id\":\"a\",\"status\":\"gave up\"}\n"
                              "{\"id\":\"a\"}\n"
                              "{\"id\":\"b\",\"status\":\"none\"}\n"
                              "{\"percents\":[34,66]}\n"
                              "{\"id\":\"c\",\"percents\":[34,66]}\n";
  const Outcome csv = judged(problems, answers, {"--format", "csv"});
  CHECK(csv.exit_code == 1);
  const std::vector<std::string> rows = lines_of(csv.out);
  REQUIRE(rows.size() == 13);
  CHECK(rows[0] == "id,verdict,value,best,reason");
  CHECK(rows[1] == "a,best,6.04,6.04,");
  CHECK(rows[2] == "a,not-a-blend,5.98,6.04,it does not keep: at least 60 % passing 4 mm");
  CHECK(rows[3] == "a,worse,6.4,6.04,");
  CHECK(rows[4] == "a,not-a-blend,,6.04,\"the share of A is 34.05 %, no whole number of steps of 1 %\"");
  CHECK(rows[5] == "a,not-a-blend,,6.04,the shares sum to 99 %");
  CHECK(rows[6] == "a,not-a-blend,,6.04,\"it has 1 shares, and there are 2 stockpiles\"");
  CHECK(rows[7] == "a,not-a-blend,,6.04,the share of B is negative");
  CHECK(rows[8] == "a,infeasible,,6.04,");
  CHECK(rows[9] == "a,gave-up,,6.04,");
  CHECK(rows[10].starts_with("a,garbage,,6.04,"));
  CHECK(rows[11] == "b,best,,,\"there is no blend, as it says\"");
  CHECK(rows[12] == ",garbage,,,the answer has no id");
  CHECK(contains(csv.err, "There is no problem 'c'"));
  const Json json = Json::parse(judged(problems, answers, {"--format", "json"}).out);
  CHECK(json.at("schema") == "mdm-crosscheck-blends-1");
  CHECK(json.at("rows").size() == 12);
  CHECK(json.at("verdicts").at("best") == "2");
  const std::string near = "{\"id\":\"a\",\"shares\":[0.3400000000000001,0.6599999999999999]}\n";
  CHECK(contains(judged(cheap, near, {"--format", "csv"}).out,
                 "the share of A is 34.00000000000001 %, no whole number of steps of 1 %"));
  const auto verdict_on = [](const std::string &answer) {
    return judged(cheap, answer + "\n", {"--format", "csv"}).out;
  };
  CHECK(contains(verdict_on("{\"id\":\"a\",\"shares\":[\"0.34\",\"0.66\"],\"status\":\"infeasible\"}"),
                 "a,garbage,,6.04,\"it has shares, and its status says that there is no blend\""));
  CHECK(contains(verdict_on("{\"id\":\"a\",\"stockpiles\":[\"A\",\"B\"],\"percents\":[34,66]}"), "a,best,"));
  CHECK(contains(verdict_on("{\"id\":\"a\",\"stockpiles\":[\"B\",\"A\"],\"percents\":[66,34]}"),
                 "its stockpile 1 is 'B', and that of the problem is 'A'"));
  const std::string worse = "{\"id\":\"a\",\"percents\":[40,60]}\n";
  const Outcome text = judged(cheap, worse);
  CHECK(text.exit_code == 0);
  CHECK(contains(text.out, "a: worse, 6.4 for 6.04"));
  CHECK(judged(cheap, worse, {"--require-minimal"}).exit_code == 1);
  CHECK(contains(judged(problems, worse).out, "b: no-answer: there is none with this id"));
}

TEST_CASE("blends of a program that is asked", "[blend]") {
  const TemporaryFolder folder;
  const std::string problems = folder.write("problems.jsonl", cheap + "\n");
  const auto asked = [&](const std::string &command) {
    return mdm({"crosscheck", problems, "--solver", command, "--time-limit", "20"}).out;
  };
  CHECK(contains(asked(std::string("'") + MDM_PROGRAM + "' blend --problems -"), "best: 1"));
  CHECK(contains(asked("echo '{\"percents\":[20,80]}'"), "a: not-a-blend: it does not keep: "));
  CHECK(contains(asked("exit 3"), "crashed: 1"));
  CHECK(contains(asked("echo '{\"id\":\"z\",\"percents\":[34,66]}'"), "the answer is for 'z'"));
  check_refused(mdm({"crosscheck", problems, problems, "--tolerance", "1%"}),
                "leave out the options of gradations");
  check_refused(mdm({"crosscheck", problems, problems, "--by", "x"}), "leave out the options of gradations");
  check_refused(mdm({"crosscheck", "-", problems}, cheap + "\n{\"stockpiles\":1}\n"),
                "stdin:2: sieves is missing");
}

} // namespace blend_problems_test

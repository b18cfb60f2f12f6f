// mdm batch: an answer a line, in order, whatever the lines hold.

#include "answer.hpp"

#include <sstream>

namespace batch_test {

using namespace cli_test;

namespace {

const std::string good = R"({"id":"good","sizes":["1","2","3"],"masses":["2","1","0"]})";

std::vector<Json> answers(const std::string &out) {
  std::vector<Json> all;
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);)
    all.push_back(Json::parse(line));
  return all;
}

/// The first lines of the suite of tests/data.
std::string suite(std::size_t lines) {
  std::ifstream file(MDM_SUITE);
  std::string text;
  for (std::string line; lines > 0 && std::getline(file, line); --lines)
    text += line + "\n";
  REQUIRE(lines == 0);
  return text;
}

} // namespace

TEST_CASE("answers come in the order of the lines, with their ids", "[cli]") {
  const std::string input = suite(50);
  const Outcome outcome = mdm({"batch"}, input);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const std::vector<Json> all = answers(outcome.out);
  const std::vector<Json> lines = answers(input);
  REQUIRE(all.size() == 50);
  for (std::size_t i = 0; i < 50; ++i) {
    CHECK(all[i].at("id") == lines[i].at("id"));
    CHECK(all[i].at("status") == "optimal");
    check_match(all[i]);
  }
}

TEST_CASE("solve and batch give the same answer", "[cli]") {
  std::istringstream lines(suite(5));
  for (std::string line; std::getline(lines, line);)
    CHECK(mdm({"batch"}, line).out == mdm({"solve", "-", "--format", "json"}, line).out);
}

TEST_CASE("ids need not be unique and a missing one is the line number", "[cli]") {
  const std::string nameless = R"({"sizes":[1,2],"masses":[1,0]})";
  const Outcome outcome = mdm(
      {"batch"}, good + "\n" + nameless + "\n" + good + "\n" + R"({"id":17,"sizes":[1,2],"masses":[1,0]})" +
                     "\n" + R"({"id":"\u00e9\u0000\"","sizes":[1,2],"masses":[1,0]})" + "\n");
  CHECK(outcome.exit_code == 0);
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 5);
  CHECK(all[0].at("id") == "good");
  CHECK(all[1].at("id") == "2");
  CHECK(all[2].at("id") == "good");
  CHECK(all[3].at("id") == "17");
  CHECK(all[4].at("id") == std::string("\xC3\xA9\0\"", 4));
}

TEST_CASE("a bad line has its error in its place and the run goes on", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "lines.jsonl", good + "\n" + R"({"id":"bad","sizes":[1,2],"masses":["x",0]})" + "\nnonsense\n" +
                         R"({"sizes":[1,2],"masses":[1,0)" + "\n" + good + "\n");
  const Outcome outcome = mdm({"batch", file});
  CHECK(outcome.exit_code == 2);
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 5);
  CHECK(all[0].at("status") == "optimal");
  CHECK(all[4].at("status") == "optimal");
  for (const std::size_t i : {1u, 2u, 3u}) {
    CHECK(all[i].size() == 3);
    CHECK(all[i].at("status") == "error");
    CHECK(all[i].at("error").get<std::string>().find(file + ":" + std::to_string(i + 1) + ": ") == 0);
  }
  CHECK(all[1].at("id") == "bad");
  CHECK(all[2].at("id") == "3");
  CHECK(outcome.out.find(R"({"id":"bad","status":"error","error":")") != std::string::npos);
}

TEST_CASE("every kind of bad line stays in its place", "[cli]") {
  std::string input;
  const std::vector<std::string> bad = {"{",
                                        "[]",
                                        "1",
                                        "\"x\"",
                                        "null",
                                        "{}",
                                        R"({"sizes":[1,2],"masses":[1e400,0]})",
                                        R"({"sizes":[1,2],"masses":[1,0],"id":null})",
                                        R"({"sizes":[1,2],"masses":[1,0],"id":"a","id":"b"})",
                                        "\xFF",
                                        std::string("\0", 1),
                                        "\x7F"
                                        "ELF",
                                        "{\"x\":" + std::string(100'000, '['),
                                        R"({"sizes":[1,2],"masses":[)" + std::string(100'000, '9') + ",0]}"};
  for (const std::string &line : bad)
    input += line + "\n" + good + "\n";
  const Outcome outcome = mdm({"batch"}, input);
  CHECK(outcome.exit_code == 2);
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 2 * bad.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    CHECK(all[i].at("status") == (i % 2 == 0 ? "error" : "optimal"));
}

TEST_CASE("the exit code is that of the worst line: 2 before 3 before 1", "[cli]") {
  std::string slow =
      R"({"id":"slow","sizes":["1","1.000001","1.000002","1.000003"],"masses":["7","11","13","0"]})";
  const std::string bad = "nonsense\n";
  slow += "\n";
  const std::string easy = R"({"sizes":[1,2],"masses":[1,0]})"
                           "\n";
  const auto exit_code = [](const std::string &input, Arguments options) {
    options.insert(options.begin(), "batch");
    return mdm(options, input).exit_code;
  };
  CHECK(exit_code(easy, {"--at-most", "3"}) == 0);
  CHECK(exit_code(easy + good + "\n" + easy, {"--at-most", "3"}) == 1);
  CHECK(exit_code(good + "\n" + slow + easy, {"--at-most", "3", "--max-steps", "1"}) == 1);
  CHECK(exit_code(easy + slow + easy, {"--max-steps", "1"}) == 3);
  CHECK(exit_code(good + "\n" + slow + easy, {"--at-most", "2000000", "--max-steps", "1"}) == 3);
  CHECK(exit_code(good + "\n" + bad + slow + easy, {"--max-steps", "1"}) == 2);
  CHECK(exit_code(bad + good + "\n", {"--at-most", "3"}) == 2);
}

TEST_CASE("empty input has an empty answer", "[cli]") {
  for (const char *input : {"", "\n", "  \n\t\r\n\n"}) {
    const Outcome outcome = mdm({"batch"}, input);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
  }
}

TEST_CASE("an empty file is a suite of none only where its name is not that of a table", "[cli]") {
  const TemporaryFolder folder;
  for (const char *name : {"a.jsonl", "a.ndjson", "a"})
    for (const char *text : {"", " \n\n"}) {
      const Outcome outcome = mdm({"batch", folder.write(name, text)});
      INFO(name << outcome.err);
      CHECK(outcome.exit_code == 0);
      CHECK(outcome.out.empty());
    }
  for (const char *name : {"a.csv", "a.json", "a.txt", "a.ags"}) {
    const Outcome outcome = mdm({"batch", folder.write(name, "\n"), folder.write("b.jsonl", good)});
    CHECK(outcome.exit_code == 2);
    CHECK(Json::parse(outcome.out.substr(0, outcome.out.find('\n'))).at("status") == "error");
    CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 2);
  }
}

TEST_CASE("line ends: none at the end, CRLF, blank lines", "[cli]") {
  const std::string answer = mdm({"batch"}, good + "\n").out;
  CHECK(mdm({"batch"}, good).out == answer);
  CHECK(mdm({"batch"}, good + "\r\n").out == answer);
  CHECK(mdm({"batch"}, "\n\n" + good + "\n\n \n" + good + "\n").out == answer + answer);
  const std::vector<Json> numbered = answers(mdm({"batch"}, "\n\n"
                                                            R"({"sizes":[1,2],"masses":[1,0]})")
                                                 .out);
  REQUIRE(numbered.size() == 1);
  CHECK(numbered[0].at("id") == "3");
}

TEST_CASE("a line of more than 64 MiB is one error and the next line is read", "[cli]") {
  const Outcome outcome = mdm({"batch"}, std::string((64u << 20) + 100'000, 'x') + "\n" + good + "\n");
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 2);
  CHECK(all[0].at("status") == "error");
  CHECK(all[1].at("status") == "optimal");
}

TEST_CASE("threads change nothing", "[cli]") {
  const std::string input = suite(1500) + "nonsense\n" + good + "\n";
  const Outcome one = mdm({"batch", "-j", "1"}, input);
  CHECK(one.exit_code == 2);
  CHECK(mdm({"batch", "-j", "2"}, input).out == one.out);
  CHECK(mdm({"batch", "-j", "7"}, input).out == one.out);
}

TEST_CASE("a pipe has its answer before the next line is sent", "[cli]") {
  for (const char *threads : {"1", "2"}) {
    Process batch(MDM_PROGRAM, {"batch", "-j", threads});
    for (int line = 1; line <= 3; ++line) {
      batch.send(good + "\n");
      CHECK(batch.wait_for_lines(line));
    }
    CHECK(batch.end().exit_code == 0);
  }
}

TEST_CASE("option --proofs has a certificate for each line, accepted with the line as gradation file",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string input = suite(40);
  const Outcome outcome = mdm({"batch", "--proofs", folder / "proofs"}, input);
  CHECK(outcome.exit_code == 0);
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 40);
  std::istringstream lines(input);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string name = (number < 10 ? "00000" : "0000") + std::to_string(number) + "-" +
                             Json::parse(line).at("id").get<std::string>() + ".proof";
    CHECK(all[number - 1].at("proof") == name);
    const Outcome verdict = mdm_check(folder.write("line.json", line), folder / ("proofs/" + name));
    INFO(verdict.out << verdict.err);
    CHECK(verdict.exit_code == 0);
  }
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "proofs"),
                      std::filesystem::directory_iterator()) == 40);
}

TEST_CASE("ids are made safe for the names of proofs", "[cli]") {
  const TemporaryFolder folder;
  const std::string tail = R"(","sizes":[1,2],"masses":[1,0]})"
                           "\n";
  std::string input;
  for (const char *id : {"../x", "/etc/x", "a b", "", ".", "..", "\\u0000", "\xC3\xA9"})
    input += std::string(R"({"id":")") + id + tail;
  input += R"({"id":")" + std::string(5000, 'a') + tail;
  CHECK(mdm({"batch", "--proofs", folder / "proofs"}, input).exit_code == 0);
  CHECK(folder.entries() == 1);
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "proofs"),
                      std::filesystem::directory_iterator()) == 9);
  for (const std::string name : {"000001-.._x", "000003-a_b", "000004", "000006-..", "000008-__"})
    CHECK(std::filesystem::exists(folder / ("proofs/" + name + ".proof")));
}

TEST_CASE("gradation files have the answers that they have alone", "[cli]") {
  const std::vector<std::string> names = {"athabasca-sand", "hostun-rf-sand"};
  const Outcome outcome = mdm({"batch", example(names[0]), example(names[1])});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out == mdm({"solve", example(names[0]), "--format", "json"}).out +
                           mdm({"solve", example(names[1]), "--format", "json"}).out);
}

TEST_CASE("a file is a suite or a gradation by its content", "[cli]") {
  const TemporaryFolder folder;
  const std::string open = "{\n  \"id\": \"open\",\n  \"sizes\": [1, 2],\n  \"masses\": [1, 0]\n}\n";
  const auto ids = [&](const std::string &content) {
    std::string all;
    for (const Json &answer : answers(mdm({"batch", folder.write("file", content)}).out))
      all += (all.empty() ? "" : " ") + answer.at("id").get<std::string>() + ":" +
             answer.at("status").get<std::string>();
    return all;
  };
  CHECK(ids(open) == "open:optimal");
  CHECK(ids("\xEF\xBB\xBF" + open) == "open:optimal");
  CHECK(ids(good) == "good:optimal");
  CHECK(ids(good + "\n" + good) == "good:optimal good:optimal");
  CHECK(ids("\n{\n" + good) == "2:error good:optimal");
  CHECK(ids("nonsense\n" + good) == "1:error good:optimal");
  CHECK(ids("size_mm,mass\n1,2\n2,0\n") == "file:optimal");
  CHECK(ids("nonsense\nnonsense\n") == "file:error");
  CHECK(ids("\xFF\xFE") == "file:error");
  CHECK(ids(" \n") == "");
}

namespace {

/// Specimens BH1, BH2 and BH3 of AGS4, of which the second passes more than 100 %.
const std::string three_specimens =
    "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"GRAT_SIZE\",\"GRAT_PERP\"\n\"UNIT\",\"\",\"mm\",\"%\"\n"
    "\"DATA\",\"BH1\",\"2\",\"100\"\n\"DATA\",\"BH1\",\"1\",\"40\"\n\"DATA\",\"BH1\",\"0.5\",\"0\"\n"
    "\"DATA\",\"BH2\",\"2\",\"101\"\n\"DATA\",\"BH2\",\"1\",\"40\"\n"
    "\"DATA\",\"BH3\",\"4\",\"100\"\n\"DATA\",\"BH3\",\"2\",\"0\"\n";

} // namespace

TEST_CASE("a dash is standard input, by its content too", "[cli]") {
  const std::string sand = read_file(example("hostun-rf-sand"));
  const std::vector<Json> all = answers(mdm({"batch", "-", example("athabasca-sand")}, sand).out);
  REQUIRE(all.size() == 2);
  CHECK(all[0].at("id") == "stdin");
  CHECK(all[0].at("particles") == "31");
  CHECK(all[1].at("particles") == "1485");
  CHECK(answers(mdm({"batch", "-"}, suite(3)).out).size() == 3);
  CHECK(answers(mdm({"batch"}, sand).out).at(0).at("status") == "error");
}

TEST_CASE("an AGS4 file gives all its specimens, and a bad one has its error in its place", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("site.ags", three_specimens);
  const Outcome outcome = mdm({"batch", file, "--proofs", folder / "proofs", "-j", "2"});
  CHECK(outcome.exit_code == 2);
  const std::vector<Json> all = answers(outcome.out);
  REQUIRE(all.size() == 3);
  CHECK(all[0].at("id") == "BH1");
  CHECK(all[0].at("proof") == "000001-BH1.proof");
  CHECK(all[1].at("id") == "BH2");
  CHECK(all[1].at("error").get<std::string>().find(file + ":7: ") == 0);
  CHECK(all[2].at("id") == "BH3");
  const Outcome checked = Process(MDM_CHECK_PROGRAM, {"--suite", folder / "proofs"}).end();
  CHECK(checked.exit_code == 0);
  CHECK(checked.out.find(": 2 accepted, 0 refused, 0 malformed, 0 missing; 2 accepted as the smallest") !=
        std::string::npos);
}

TEST_CASE("proofs of gradation files and suites together are checked by their folder", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite_file = folder.write("suite.jsonl", suite(5) + "\n" + good);
  const std::string half_phi = folder.write("half_phi.csv", "size_phi,mass\n0.5,1\n0,2\n-0.5,0\n");
  CHECK(mdm({"batch", half_phi, suite_file, example("athabasca-sand"), "--size-factor", "2", "--proofs",
             folder / "proofs"})
            .exit_code == 0);
  const Outcome checked = Process(MDM_CHECK_PROGRAM, {"--suite", folder / "proofs", "--verbose"}).end();
  INFO(checked.out << checked.err);
  CHECK(checked.exit_code == 0);
  CHECK(lines_of(checked.out).size() == 9);
  CHECK(read_file(folder / "proofs/000001-half_phi.gradation") == read_file(half_phi));
  CHECK(std::filesystem::exists(folder / "proofs/000009-athabasca-sand.gradation"));
}

TEST_CASE("as CSV the answers have a row a class", "[cli]") {
  const TemporaryFolder folder;
  const std::string input = R"({"id":"a, \"b\"","sizes":["1","2","3"],"masses":["2","1","0"]})"
                            "\n" +
                            good + "\n";
  const Outcome outcome = mdm({"batch", "--format", "csv"}, input);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(lines.size() == 5);
  CHECK(lines[0] == "id,class,lower_mm,upper_mm,share_percent,quantity,size_lo_mm,size_hi_mm");
  CHECK(lines[1].find(R"("a, ""b""",1,1,2,66.6666666666666,)") == 0);
  CHECK(lines[4].find("good,2,2,3,33.3333333333333,") == 0);
  CHECK(mdm({"batch", "-o", folder / "answers.csv"}, input).exit_code == 0);
  CHECK(read_file(folder / "answers.csv") == outcome.out);
}

TEST_CASE("the share of CSV is that of the match", "[cli]") {
  const std::string line = R"({"sizes":["0.1","0.2","3"],"masses":["1","99","0"]})";
  const std::vector<std::string> lines =
      lines_of(mdm({"batch", "--format", "csv", "--tolerance", "retained:1%"}, line).out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[1] == "1,1,0.1,0.2,0,0,,");
  CHECK(lines[2].find("1,2,0.2,3,100,1,") == 0);
}

TEST_CASE("what CSV has no place for is on standard error", "[cli]") {
  const Outcome bad = mdm({"batch", "--format", "csv"}, "nonsense\n" + good + "\n");
  CHECK(bad.exit_code == 2);
  CHECK(bad.err.find("stdin:1: ") == 0);
  CHECK(lines_of(bad.out).size() == 3);
  const Outcome none = mdm({"batch", "--format", "csv", "--at-most", "1"}, good);
  CHECK(none.exit_code == 1);
  CHECK(none.err.find("good: ") == 0);
  CHECK(none.out.find("good,1,1,2,66.6666666666666,,,\n") != std::string::npos);
  const std::string um = R"({"id":"fine","unit":"um","sizes":[1,2],"masses":[1,0]})";
  const Outcome mixed = mdm({"batch", "--format", "csv"}, good + "\n" + um + "\n");
  CHECK(mixed.exit_code == 2);
  CHECK(mixed.err.find("fine: lengths in um, where the table has mm") == 0);
  CHECK(lines_of(mixed.out).size() == 3);
}

TEST_CASE("one file of many that cannot be read is refused before any work", "[cli]") {
  const TemporaryFolder folder;
  check_refused(mdm({"batch", example("athabasca-sand"), folder / "missing.csv"}), "missing.csv");
  check_refused(mdm({"batch", example("athabasca-sand"), folder / "."}), "cannot be read");
  const std::string file = folder.write("sand.csv", "size_mm,mass\n1,2\n2,0\n");
  check_refused(mdm({"batch", example("athabasca-sand"), file, "-o", file}), "different names");
}

TEST_CASE("a folder of proofs that cannot be made is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  check_refused(mdm({"batch", "--proofs", file}, good), "file");
  check_refused(mdm({"batch", "--proofs", folder / "missing/proofs"}, good), "missing");
  CHECK(read_file(file) == "old");
}

TEST_CASE("a folder that has proofs of another run is told", "[cli]") {
  const TemporaryFolder folder;
  const std::string proofs = folder / "proofs";
  CHECK(mdm({"batch", "--proofs", proofs}, good).err.empty());
  const Outcome again = mdm({"batch", "--proofs", proofs}, good);
  CHECK(again.exit_code == 0);
  CHECK(again.err.find("proofs has proofs of another run; those that this one does not write again stay.") !=
        std::string::npos);
  CHECK(mdm({"batch", "--proofs", proofs, "--quiet"}, good).err.empty());
}

TEST_CASE("batch -o is written whole or not at all", "[cli]") {
  const TemporaryFolder folder;
  CHECK(mdm({"batch", "-o", folder / "answers"}, good).exit_code == 0);
  CHECK(read_file(folder / "answers") == mdm({"batch"}, good).out);
  CHECK(mdm({"batch", "-o", folder / "answers"}, "nonsense").exit_code == 2);
  CHECK(read_file(folder / "answers").find(R"("status":"error")") != std::string::npos);
  CHECK(folder.entries() == 1);
}

TEST_CASE("batch takes the options of solving", "[cli]") {
  const std::vector<Json> all =
      answers(mdm({"batch", "--min-per-class", "5", "--at-least", "40", "--scale", "upper"}, good).out);
  REQUIRE(all.size() == 1);
  check_match(all[0]);
  CHECK(all[0].at("particles") == "40");
  CHECK(all[0].at("scale").at("chosen") == all[0].at("scale").at("up_to"));
  check_refused(mdm({"batch", "--at-least", "x"}, good), "--at-least");
  const std::vector<Json> wrong = answers(mdm({"batch", "--cut-below", "1.5"}, good).out);
  REQUIRE(wrong.size() == 1);
  CHECK(wrong[0].at("id") == "good");
  CHECK(wrong[0].at("status") == "error");
}

#if !MDM_IS_SANITIZED
TEST_CASE("memory does not grow with the number of lines", "[cli]") {
  const auto most_kib = [chunk = suite(2750)](int chunks, const char *threads) {
    Process batch(MDM_PROGRAM, {"batch", "-j", threads}, "/dev/null");
    for (int i = 0; i < chunks; ++i)
      batch.send(chunk);
    const Outcome outcome = batch.end();
    CHECK(outcome.exit_code == 0);
    return outcome.max_rss_kib;
  };
  for (const char *threads : {"1", "3"})
    CHECK(most_kib(40, threads) < most_kib(2, threads) + 8 * 1024);
}
#endif

TEST_CASE("batch reads gradation files as the options of reading say, and refuses them for JSON Lines") {
  const TemporaryFolder folder;
  const std::string table = folder.write("table.csv", "a,b\n1,0.501\n2,0.499\n4,0\n");
  const std::string suite =
      folder.write("suite.jsonl", "{\"sizes\": [\"1\", \"2\"], \"masses\": [\"1\", \"0\"]}\n");
  const Arguments reading = {"--columns", "1,2", "--kind", "retained", "--unit", "mm"};
  const auto batch = [&reading](const std::string &file, const Arguments &more) {
    Arguments command = {"batch", file};
    command.insert(command.end(), reading.begin(), reading.end());
    command.insert(command.end(), more.begin(), more.end());
    return mdm(command);
  };
  const Outcome whole = batch(table, {}), rounded = batch(table, {"--round", "1"});
  CHECK(whole.exit_code == 0);
  CHECK(whole.out.find("\"mass\":\"0.501\"") != std::string::npos);
  CHECK(rounded.exit_code == 0);
  CHECK(rounded.out.find("\"mass\":\"0.5\"") != std::string::npos);
  check_refused(batch(suite, {}), "is of gradation files, and this is JSON Lines");
  check_refused(mdm({"batch", "--round", "2"}), "stdin");
}

} // namespace batch_test

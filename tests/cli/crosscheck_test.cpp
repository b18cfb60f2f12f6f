// mdm crosscheck: files of answers, and solvers that are right, wrong, slow or broken.

#include "answer.hpp"

#include <sstream>

namespace crosscheck_test {

using namespace cli_test;

namespace {

const std::string suite = MDM_SUITE;
const std::string float_answers = MDM_DATA_DIR "/suite-2750-float-answers.csv";

/// (1, 2] with 2 and (2, 3] with 1: the least match is 3, 1.
const std::string small = R"({"id":"small","sizes":[1,2,3],"masses":[2,1,0]})";
const std::string right = R"(echo '{"quantities":[3,1]}')";

/// The rows as CSV, without the header.
std::vector<std::string> rows(const Arguments &arguments, int exit_code, const std::string &input = "") {
  Arguments all = {"crosscheck"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--format", "csv"});
  const Outcome outcome = mdm(all, input);
  INFO(outcome.out.substr(0, 2000) << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  std::vector<std::string> lines = lines_of(outcome.out);
  REQUIRE(!lines.empty());
  CHECK(lines[0].rfind("id,verdict,particles,minimum,ratio,max_error", 0) == 0);
  lines.erase(lines.begin());
  return lines;
}

/// The only row for the small gradation and a solver, with its reason.
std::string solver_row(const std::string &solver, int exit_code, const Arguments &more = {}) {
  Arguments arguments = {"-", "--solver", solver, "--reasons"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const std::vector<std::string> all = rows(arguments, exit_code, small + "\n");
  REQUIRE(all.size() == 1);
  return all[0];
}

Outcome crosscheck(const Arguments &arguments, const std::string &input = "") {
  Arguments all = {"crosscheck"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return mdm(all, input);
}

bool runs(const std::string &pid) {
  std::ifstream stat("/proc/" + pid + "/stat");
  std::string number, name, state;
  return stat >> number >> name >> state && state != "Z";
}

/// Waits until the file has the text's number of lines; false after a minute.
bool wait_for_lines(const std::string &file, std::size_t n) {
  for (int i = 0; i < 6000; ++i) {
    if (std::filesystem::exists(file) && lines_of(read_file(file)).size() >= n)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

bool wait_until_gone(const std::string &pid) {
  for (int i = 0; i < 1000 && runs(pid); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !runs(pid);
}

} // namespace

TEST_CASE("the answers of batch are judged, as JSON Lines and as CSV", "[cli]") {
  const TemporaryFolder folder;
  const std::string problems =
      folder.write("problems.jsonl", R"({"id":"a,b","sizes":["1","2","3"],"masses":["2","1","0"]})"
                                     "\n"
                                     R"({"sizes":["1","2"],"masses":["1","0"]})"
                                     "\n");
  for (const std::string name : {"answers.jsonl", "answers.csv"}) {
    const std::string answers = folder / name;
    REQUIRE(mdm({"batch", problems, "-o", answers}).exit_code == 0);
    const Outcome judged = mdm({"crosscheck", problems, answers, "--require-minimal"});
    INFO(judged.out << judged.err);
    CHECK(judged.exit_code == 0);
  }
  check_refused(
      mdm({"crosscheck", problems,
           folder.write("cut.csv", "id,class,lower_mm,upper_mm,share_percent,quantity,size_lo_mm,size_hi_mm\n"
                                   "a,2,1,2,50,1,1.5,1.5\n")}),
      "cut.csv:2: the classes of an answer are not in order from 1 on");
}

TEST_CASE("ids with blanks at their ends, or of nothing, come back from CSV as they were", "[cli]") {
  const TemporaryFolder folder;
  std::string lines;
  for (const char *id : {"a", " a", "a ", "", "#1"})
    lines += std::string(R"({"id":")") + id + R"(","sizes":["1","2","3"],"masses":["2",")" +
             std::to_string(lines.size() + 1) + "\",\"0\"]}\n";
  const std::string problems = folder.write("problems.jsonl", lines);
  for (const std::string name : {"answers.jsonl", "answers.csv"}) {
    const std::string answers = folder / name;
    REQUIRE(mdm({"batch", problems, "-o", answers}).exit_code == 0);
    const Outcome judged = mdm({"crosscheck", problems, answers, "--require-minimal"});
    INFO(read_file(answers) << judged.out << judged.err);
    CHECK(judged.exit_code == 0);
  }
}

TEST_CASE("the published code's answers to the paper's suite", "[cli]") {
  const Outcome outcome = crosscheck({suite, float_answers, "--by", "x_n_factor", "--format", "json"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err.empty());
  const Json report = Json::parse(outcome.out);
  CHECK(report.at("schema") == "mdm-crosscheck-1");
  CHECK(report.at("rows").size() == 5500);
  CHECK(report.at("versions").contains("mdm"));
  const Json &half = report.at("summary").at(0), &low = report.at("summary").at(1);
  CHECK(half.at("setting") == "0.5");
  CHECK(half.at("verdicts").at("minimal") == "23");
  CHECK(half.at("verdicts").at("larger") == "2727");
  CHECK(half.at("ratio").at("quarter") == "1.55");
  CHECK(half.at("ratio").at("median") == "1.88");
  CHECK(half.at("ratio").at("three_quarters") == "3.29885");
  CHECK(low.at("setting") == "0.001");
  CHECK(low.at("verdicts").at("minimal") == "782");
  CHECK(low.at("verdicts").at("larger") == "1964");
  CHECK(low.at("verdicts").at("not-a-match") == "4");
  CHECK(low.at("ratio").at("median") == "1.00099");
  CHECK(low.at("ratio").at("three_quarters") == "1.00289");
  std::vector<std::string> no_match;
  for (const Json &row : report.at("rows"))
    if (row.at("verdict") == "not-a-match") {
      no_match.push_back(row.at("id"));
      CHECK(row.at("reason").get<std::string>().find("can hold its mass at scales up to") !=
            std::string::npos);
      CHECK(Integer(row.at("particles").get<std::string>()) < Integer(row.at("minimum").get<std::string>()));
    }
  CHECK(no_match == std::vector<std::string>{"g0363", "g0915", "g0946", "g1650"});
}

TEST_CASE("the text is the summary, and -o has the rows", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = crosscheck({suite, float_answers, "--by", "x_n_factor", "-o", folder / "rows.csv"});
  CHECK(outcome.exit_code == 1);
  CHECK(lines_of(outcome.out).size() == 11);
  const std::vector<std::string> all = lines_of(read_file(folder / "rows.csv"));
  REQUIRE(all.size() == 5501);
  CHECK(all[0] == "id,verdict,particles,minimum,ratio,max_error,x_n_factor");
  CHECK(all[1].rfind("g0000,larger,26,10,2.6,", 0) == 0);
  CHECK(all[2].rfind("g0000,minimal,10,10,1,", 0) == 0);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a file whose name ends in .json has rows and summary as JSON", "[cli]") {
  const TemporaryFolder folder;
  const std::string line = lines_of(read_file(suite))[0] + "\n", file = folder.write("suite.jsonl", line),
                    answers = folder / "answers.jsonl", out = folder / "rows.json";
  REQUIRE(mdm({"batch", file, "-o", answers}).exit_code == 0);
  CHECK(crosscheck({file, answers, "-o", out}).out.empty());
  CHECK(read_file(out) == crosscheck({file, answers, "--format", "json"}).out);
}

TEST_CASE("batch's own answers are minimal, and no longer when changed", "[cli]") {
  const TemporaryFolder folder;
  std::string lines;
  for (std::size_t i = 0; i < 100; ++i)
    lines += lines_of(read_file(suite))[27 * i] + "\n";
  const std::string problems = folder.write("suite.jsonl", lines);
  const std::string answers = mdm({"batch", problems}).out;
  const Outcome outcome = crosscheck({problems, folder.write("a.jsonl", answers)});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  std::string fewer, sizes_only;
  for (const std::string &line : lines_of(answers)) {
    Json answer = Json::parse(line);
    for (Json &c : answer["classes"]) // a size larger by 1e-6, beyond the tolerance
      if (c["quantity"] != "0") {
        const Rational x = rational(c["size"][0]) * Rational(1000001, 1000000);
        const Integer digits(numerator(x) * boost::multiprecision::pow(Integer(10), 30) / denominator(x));
        c["size"] = {"0", "0"};
        c["size"][0] = c["size"][1] = digits.str() + "e-30";
        break;
      }
    sizes_only += answer.dump() + "\n";
    answer = Json::parse(line);
    for (Json &c : answer["classes"])
      if (c["quantity"] != "0") {
        c["quantity"] = Integer(Integer(c["quantity"].get<std::string>()) - 1).str();
        break;
      }
    fewer += answer.dump() + "\n";
  }
  for (const std::string &row : rows({problems, folder.write("b.jsonl", fewer)}, 1))
    CHECK(row.find(",not-a-match,") != std::string::npos);
  for (const std::string &row : rows({problems, folder.write("c.jsonl", sizes_only)}, 1))
    CHECK(row.find(",not-a-match,") != std::string::npos);
  CHECK(crosscheck({problems, folder / "c.jsonl", "--size-tolerance", "1e-5"}).exit_code == 0);
}

TEST_CASE("missing answers, strangers, several answers and bad lines are told", "[cli]") {
  const TemporaryFolder folder;
  const std::string problems = small + "\n\n" + R"({"id":"b","sizes":[1,2],"masses":[1,0]})" + "\n" +
                               R"({"id":"c","sizes":[1,2],"masses":[1,0]})" + "\n";
  const std::string answers = folder.write(
      "a.csv", "id,quantities,knob\nc,1,x\nsmall,6 2,x\nsmall,3 1,y\nz,1,x\nc,one,x\nsmall,3 1,x\n\"b,1,x\n");
  CHECK(
      rows({"-", answers, "--reasons"}, 1, problems) ==
      std::vector<std::string>{
          "small,larger,8,4,2,,", "small,minimal,4,4,1,,", "small,minimal,4,4,1,,",
          "b,no-answer,,1,,,there is none with this id", "c,minimal,1,1,1,,",
          "c,garbage,,1,,," + answers + ":6: quantity 'one' is not a whole number from 0 on",
          ",garbage,,,,," + answers + ":8: a quoted field does not end with a quote before the next comma"});
  CHECK(rows({"-", answers, "--by", "knob"}, 1, problems) ==
        std::vector<std::string>{"small,larger,8,4,2,,x", "small,minimal,4,4,1,,x", "small,minimal,4,4,1,,y",
                                 "b,no-answer,,1,,,x", "b,no-answer,,1,,,y", "c,minimal,1,1,1,,x",
                                 "c,garbage,,1,,,x", "c,no-answer,,1,,,y", ",garbage,,,,,"});
  const Outcome text = crosscheck({"-", answers}, problems);
  INFO(text.out);
  CHECK(text.out.find("stdin: 3 gradations\n") == 0);
  CHECK(text.out.find("note: the suite has no gradation for 1 of the ids that have answers, such as 'z'") !=
        std::string::npos);
  CHECK(text.out.find(
            "note: 2 ids have several answers; each is a row: tell them apart with --by, by 'knob'") !=
        std::string::npos);
}

TEST_CASE("every gradation of an id is held against its answer", "[cli]") {
  const TemporaryFolder folder;
  const std::string answers = folder.write("a.csv", "id,quantities\nsmall,3 1\n2,1\n");
  const std::string nameless = R"({"sizes":[1,2],"masses":[1,0]})";
  CHECK(rows({"-", answers}, 0, small + "\n" + nameless + "\n" + small + "\n") ==
        std::vector<std::string>{"small,minimal,4,4,1,", "2,minimal,1,1,1,", "small,minimal,4,4,1,"});
}

TEST_CASE("exit codes: no match 1, undecided 3", "[cli]") {
  const TemporaryFolder folder;
  const std::string larger = folder.write("larger.csv", "id,quantities\nsmall,6 2\n");
  const std::string no_match = folder.write("no.csv", "id,quantities\nsmall,2 1\n");
  CHECK(crosscheck({"-", larger}, small).exit_code == 0);
  CHECK(crosscheck({"-", larger, "--require-minimal"}, small).exit_code == 1);
  CHECK(crosscheck({"-", no_match}, small).exit_code == 1);
  CHECK(crosscheck({"-", larger, "--max-steps", "0"}, small).exit_code == 3);
}

TEST_CASE("a bad line of the suite, or none, is refused before anything runs", "[cli]") {
  const TemporaryFolder folder;
  const std::string bad = small + "\n\n" + R"({"id":"x","sizes":[1],"masses":[0]})" + "\n";
  const std::string answers = folder.write("a.csv", "id,quantities\nsmall,3 1\n");
  for (const char *format : {"text", "csv", "json"}) {
    check_refused(crosscheck({"-", answers, "--format", format}, bad), "stdin:3: ");
    check_refused(crosscheck({"-", answers, "--format", format}, "\n \n"),
                  "stdin:2: there are no gradations");
    check_refused(crosscheck({"-", answers, "--format", format}), "stdin:1: there are no gradations");
  }
  check_refused(crosscheck({"-", "--solver", "touch " + (folder / "ran"), "--journal", folder / "j"}, bad),
                "stdin:3: ");
  check_refused(crosscheck({"-", answers, "-o", folder / "rows.csv"}, bad), "stdin:3: ");
  CHECK(folder.entries() == 1);
}

TEST_CASE("wrong use of crosscheck is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string answers = folder.write("a.csv", "id,quantities,knob\nsmall,3 1,x\n");
  const std::string problems = folder.write("s.jsonl", small + "\n");
  check_refused(crosscheck({problems}), "give a file of ANSWERS, a program with --solver, or");
  check_refused(crosscheck({problems, answers, "--solver", "x"}), "give a file of ANSWERS");
  check_refused(crosscheck({problems, answers, "--journal", folder / "j"}), "--journal");
  check_refused(crosscheck({problems, answers, "--time-limit", "1"}), "--time-limit");
  check_refused(crosscheck({problems, "--solver", right, "--by", "x"}), "--by");
  check_refused(crosscheck({problems, "--solver", right, "--time-limit", "0"}), "'0' is not positive");
  check_refused(crosscheck({problems, "--solver", right, "--time-limit", "x"}), "--time-limit: 'x'");
  check_refused(crosscheck({problems, answers, "--by", "kno"}), "no answer has 'kno'; they have 'knob'");
  check_refused(crosscheck({problems, answers, "--size-tolerance", "1"}), "'1' is not below 1");
  check_refused(crosscheck({problems, answers, "--size-tolerance", "-1"}), "'-1' is negative");
  check_refused(crosscheck({problems, answers, "--size-tolerance", "x"}), "--size-tolerance: 'x'");
  check_refused(crosscheck({problems, answers, "-o", answers}), "would be overwritten");
  check_refused(crosscheck({problems, answers, "-o", "-"}), "--format csv");
  check_refused(crosscheck({"-", "-"}), "standard input");
  check_refused(crosscheck({problems, "--solver", right, "--journal", "-"}), "--journal needs a file");
  check_refused(crosscheck({problems, folder / "missing"}), "cannot be read");
  check_refused(crosscheck({folder / "missing", answers}), "cannot be read");
  check_refused(crosscheck({folder / "", answers, "--format", "csv"}), "cannot be read");
  check_refused(crosscheck({folder / "", answers, "--format", "json"}), "cannot be read");
  check_refused(crosscheck({problems, answers, "--max-steps", "x"}), "--max-steps: 'x'");
  check_refused(crosscheck({problems, folder.write("bad.csv", "a,b\n")}), "no column id");
  check_refused(crosscheck({folder / "bad.csv", folder / "bad.csv"}), "bad.csv:1: ");
  CHECK(folder.entries() == 3);
}

TEST_CASE("a solver gets its gradation as JSON and is judged", "[cli]") {
  const TemporaryFolder folder;
  CHECK(solver_row("cat > '" + (folder / "seen") + "'; " + right, 0) == "small,minimal,4,4,1,,");
  CHECK(read_file(folder / "seen") ==
        R"({"id": "small", "unit": "mm", "sizes": ["1", "2", "3"], "masses": ["2", "1", "0"]})"
        "\n");
  CHECK(solver_row(std::string("'") + MDM_PROGRAM + "' solve - --format json", 0)
            .rfind("small,minimal,4,4,1,", 0) == 0);
  CHECK(solver_row(R"(echo '{"id":"small","quantities":[3,1],"sizes":[1.9,2.2]}')", 1)
            .rfind("small,not-a-match,4,4,,", 0) == 0);
  CHECK(solver_row(R"(echo '{"quantities":[6,2]}')", 0) == "small,larger,8,4,2,,");
}

TEST_CASE("a solver that ignores its input and leaves children behind is judged all the same", "[cli]") {
  const TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  CHECK(solver_row("exec <&-; " + right, 0) == "small,minimal,4,4,1,,");
  CHECK(solver_row("sleep 1000 & echo $! > '" + (folder / "pid") + "'; " + right, 0) ==
        "small,minimal,4,4,1,,");
  CHECK(wait_until_gone(lines_of(read_file(folder / "pid"))[0]));
  CHECK(solver_row(right + "; exec >&- 2>&-; sleep 0.1", 0) == "small,minimal,4,4,1,,");
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
}

TEST_CASE("crashes, exit codes, silence and garbage are verdicts", "[cli]") {
  CHECK(solver_row("kill -SEGV $$", 1) == "small,crashed,,4,,,signal 11");
  CHECK(solver_row(right + "; echo one >&2; echo 'two, too' >&2; exit 3", 1) ==
        "small,crashed,,4,,,\"exit code 3: 'two, too'\"");
  CHECK(solver_row("mdm-no-such-program 2> /dev/null", 1) ==
        "small,crashed,,4,,,exit code 127: /bin/sh did not find it");
  CHECK(solver_row("true", 1) == "small,no-answer,,4,,,no output");
  CHECK(solver_row(R"(echo '{"status":"error","error":"too hard"}')", 1) == "small,no-answer,,4,,,too hard");
  CHECK(solver_row("echo nonsense", 1).rfind("small,garbage,,4,,,", 0) == 0);
  CHECK(solver_row("head -c 100000 /dev/zero", 1).rfind("small,garbage,,4,,,", 0) == 0);
  CHECK(solver_row(right + "; " + right, 1).rfind("small,garbage,,4,,,", 0) == 0);
  CHECK(solver_row(R"(echo '{"id":"other","quantities":[3,1]}')", 1) ==
        "small,garbage,,4,,,the answer is for 'other'");
  CHECK(solver_row("while :; do head -c 1000000 /dev/zero; done", 1) ==
        "small,garbage,,4,,,more than 64 MiB of output");
  CHECK(solver_row("head -c 10000000 /dev/zero >&2; " + right, 0) == "small,minimal,4,4,1,,");
}

TEST_CASE("a solver that hangs is killed with its children", "[cli]") {
  const TemporaryFolder folder;
  CHECK(solver_row("sleep 1000 & echo $! > '" + (folder / "pid") + "'; wait", 1, {"--time-limit", "0.3"}) ==
        "small,timeout,,4,,,no end within 0.3 s");
  CHECK(wait_until_gone(lines_of(read_file(folder / "pid"))[0]));
  CHECK(solver_row("trap '' TERM INT; while :; do :; done", 1, {"--time-limit", "0.2"}) ==
        "small,timeout,,4,,,no end within 0.2 s");
}

TEST_CASE("several solvers at once keep the order of the suite", "[cli]") {
  std::string problems;
  for (int i = 0; i < 12; ++i)
    problems += R"({"id":")" + std::to_string(i) + R"(","sizes":[1,2,3],"masses":[2,1,0]})" + "\n";
  const std::string solver =
      R"(case $(cat) in *'"id": "0"'*) sleep 0.3;; *'"id": "5"'*) kill -9 $$;; *'"id": "7"'*) sleep 1000;; esac; )" +
      right;
  const std::vector<std::string> all =
      rows({"-", "--solver", solver, "-j", "4", "--time-limit", "2"}, 1, problems);
  REQUIRE(all.size() == 12);
  for (std::size_t i = 0; i < 12; ++i)
    CHECK(all[i] == std::to_string(i) + (i == 5   ? ",crashed,,4,,"
                                         : i == 7 ? ",timeout,,4,,"
                                                  : ",minimal,4,4,1,"));
}

TEST_CASE("a run that was killed goes on where it was", "[cli]") {
  const TemporaryFolder folder;
  std::string problems;
  for (int i = 0; i < 5; ++i)
    problems += R"({"id":"p","sizes":[1,2,3],"masses":[2,1,0]})"
                "\n";
  const std::string file = folder.write("suite.jsonl", problems);
  const std::string journal = folder / "journal.jsonl", log = folder / "log", out = folder / "rows.csv";
  // Hangs at the third problem until there is the file `go`.
  const std::string solver = "cd '" + (folder / "") + "'; echo $$ >> log; [ $(wc -l < log) = 3 ] && " +
                             "[ ! -e go ] && exec sleep 1000; " + right;
  const Arguments arguments = {"crosscheck", file, "--solver", solver, "--journal", journal, "-o", out};
  {
    Process process(MDM_PROGRAM, arguments);
    REQUIRE(wait_for_lines(log, 3));
    process.signal(SIGKILL);
    CHECK(process.end().signal == SIGKILL);
  }
  CHECK(!std::filesystem::exists(out));
  CHECK(lines_of(read_file(journal)).size() == 2);
  {
    std::ofstream half(journal, std::ios::app);
    half << R"({"solver":"x","line":"3","id":"p","quant)";
  }
  folder.write("go", "");
  folder.write("log", "");
  CHECK(mdm(arguments).exit_code == 0);
  CHECK(lines_of(read_file(log)).size() == 3);
  CHECK(lines_of(read_file(journal)).size() == 5);
  CHECK(lines_of(read_file(out)).size() == 6);
  // All is there: nothing is asked again.
  CHECK(mdm(arguments).exit_code == 0);
  CHECK(lines_of(read_file(log)).size() == 3);
  // The journal is a file of answers as well.
  CHECK(rows({file, journal}, 0).size() == 25);
  // Another solver's answers are not this one's.
  CHECK(crosscheck({file, "--solver", "true", "--journal", journal}).exit_code == 1);
  CHECK(lines_of(read_file(journal)).size() == 10);
}

TEST_CASE("a journal keeps failures and sizes, and belongs to its suite", "[cli]") {
  const TemporaryFolder folder;
  const std::string journal = folder / "j";
  const std::string crash = "touch '" + (folder / "asked") + "'; exit 9";
  const Arguments more = {"--journal", journal};
  const std::string first = solver_row(crash, 1, more);
  std::filesystem::remove(folder / "asked");
  CHECK(solver_row(crash, 1, more) == first);
  CHECK(!std::filesystem::exists(folder / "asked"));
  const std::string sized = R"(echo '{"quantities":[3,1],"sizes":[1.8820720577620569,2.1544346900318843]}')";
  const std::string with_sizes = solver_row(sized, 0, more);
  CHECK(solver_row(sized, 0, more) == with_sizes);
  const Outcome other = crosscheck({"-", "--solver", crash, "--journal", journal},
                                   R"({"id":"x","sizes":[1,2],"masses":[1,0]})");
  check_refused(other, "the suite is another one");
  const std::string text = folder.write("text", "not a journal\n");
  check_refused(crosscheck({"-", "--solver", right, "--journal", text}, small), "no line of a journal");
  CHECK(read_file(text) == "not a journal\n");
  const std::string half = folder.write("half", "not a journal");
  check_refused(crosscheck({"-", "--solver", right, "--journal", half}, small), "no journal");
  CHECK(read_file(half) == "not a journal");
  check_refused(crosscheck({"-", "--solver", right, "--journal", suite}, small), "no line of a journal");
  check_refused(crosscheck({"-", "--solver", right, "--journal", "/dev/null"}, small), "regular file");
}

TEST_CASE("a run that is interrupted takes its solvers with it, which is no answer of theirs", "[cli]") {
  const TemporaryFolder folder;
  std::size_t files = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    const std::string pids = folder / std::to_string(signal), journal = pids + ".jsonl";
    Process process(MDM_PROGRAM,
                    {"crosscheck", suite, "-j", "2", "--journal", journal, "-o", folder / "rows.csv",
                     "--solver", "echo $$ >> '" + pids + "'; exec sleep 1000"});
    REQUIRE(wait_for_lines(pids, 2));
    process.signal(signal);
    CHECK(process.end().signal == signal);
    for (const std::string &pid : lines_of(read_file(pids)))
      CHECK(wait_until_gone(pid));
    CHECK(read_file(journal).empty());
    files += 2;
    if (signal != SIGKILL)
      CHECK(folder.entries() == files);
  }
}

TEST_CASE("a run of blends that is interrupted takes its solver with it", "[cli]") {
  const TemporaryFolder folder;
  const std::string pids = folder / "pids",
                    problem =
                        folder.write("p.jsonl", R"({"id":"b","stockpiles":[{"name":"A","passing":[60]},)"
                                                R"({"name":"B","passing":[0]}],)"
                                                R"("sieves":[{"size":1,"least":10,"most":30}]})"
                                                "\n");
  Process process(MDM_PROGRAM,
                  {"crosscheck", problem, "--solver", "echo $$ >> '" + pids + "'; exec sleep 1000"});
  REQUIRE(wait_for_lines(pids, 1));
  process.signal(SIGTERM);
  CHECK(process.end().signal == SIGTERM);
  CHECK(wait_until_gone(lines_of(read_file(pids)).at(0)));
}

TEST_CASE("a CSV answer leaves the size of no particles out", "[cli]") {
  const TemporaryFolder folder;
  const std::string gapped = R"({"id":"gap","sizes":[1,2,3,4],"masses":[2,0,1,0]})";
  const Json best = Json::parse(mdm({"solve", "-", "--format", "json"}, gapped).out);
  std::string sizes, counts;
  for (const Json &c : best.at("classes")) {
    counts += c.at("quantity").get<std::string>() + " ";
    sizes += c.at("size").is_null() ? "- " : c.at("size").at(1).get<std::string>() + " ";
  }
  const auto judge = [&](const std::string &of) {
    const std::string answers =
        folder.write("a.csv", "id,sizes_mm,quantities\ngap," + of + "," + counts + "\n");
    return mdm({"crosscheck", "-", answers, "--require-minimal", "--format", "csv", "--reasons"}, gapped);
  };
  CHECK(judge(sizes).exit_code == 0);
  CHECK(contains(judge(sizes.substr(0, sizes.find('-'))).out, "write - for the size of a 0"));
}

TEST_CASE("a journal knows what was asked, not the id alone", "[cli]") {
  const TemporaryFolder folder;
  const std::string journal = folder / "j", log = folder / "log";
  const std::string solver = "echo x >> '" + log + R"('; echo '{"quantities":[3,1]}')";
  const auto crosscheck = [&](const std::string &lines) {
    return mdm({"crosscheck", "-", "--solver", solver, "--journal", journal, "--format", "csv"}, lines);
  };
  CHECK(crosscheck(small).exit_code == 0);
  CHECK(crosscheck(small).exit_code == 0);
  CHECK(lines_of(read_file(log)).size() == 1);
  // The suite is corrected under the same id: the solver is asked anew.
  const std::string corrected = R"({"id":"small","sizes":[1,2,3],"masses":[9,1,0]})";
  CHECK(crosscheck(corrected).exit_code == 1);
  CHECK(lines_of(read_file(log)).size() == 2);
  CHECK(crosscheck(corrected).exit_code == 1);
  CHECK(lines_of(read_file(log)).size() == 2);
  // As ANSWERS each of its answers is judged against what was asked alone.
  const auto judged = [&](const std::string &lines) {
    return mdm({"crosscheck", "-", journal, "--format", "csv", "--reasons"}, lines);
  };
  const Outcome now = judged(corrected);
  CHECK(now.exit_code == 1);
  CHECK(lines_of(now.out).size() == 2);
  CHECK(contains(now.out, "small,not-a-match,4,"));
  CHECK(contains(now.err, "note: 1 answers of the journal are to other gradations"));
  CHECK(judged(small).exit_code == 0);
  const Outcome third = judged(R"({"id":"small","sizes":[1,2,3],"masses":[8,1,0]})");
  CHECK(third.exit_code == 1);
  CHECK(lines_of(third.out).size() == 2);
  CHECK(contains(third.out, "small,no-answer,,"));
  CHECK(contains(third.out, "the journal's answer is to another gradation with this id: ask again"));
  CHECK(contains(third.err, "note: 2 answers of the journal"));
  // A journal that does not say what was asked is no basis.
  folder.write("j", R"({"solver":"x","line":"1","id":"small","quantities":["3","1"],"sizes":[],"unit":"mm"})"
                    "\n");
  check_refused(crosscheck(small), "does not say which gradation was asked");
}

} // namespace crosscheck_test

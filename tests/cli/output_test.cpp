// Where answers go: whole files or none, and an error for what cannot be written.

#include "answer.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

namespace output_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");

/// Three hundred classes of uneven masses, which no search ends on within seconds.
std::string uneven_csv() {
  constexpr int classes = 300;
  std::string csv = "size_um,mass\n";
  for (int j = 0; j <= classes; ++j)
    csv += std::to_string(std::pow(10, 3.0 * j / classes)) + ',' +
           std::to_string(j < classes ? 100 + j * 7919 % 1901 : 0) + '\n';
  return csv;
}

} // namespace

TEST_CASE("option -o writes what standard output would have", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = mdm({"solve", athabasca, "-o", folder / "answer.txt"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  CHECK(read_file(folder / "answer.txt") == mdm({"solve", athabasca}).out);
  CHECK(folder.entries() == 1);
  CHECK(mdm({"solve", athabasca, "-o", "/dev/stdout"}).out == read_file(folder / "answer.txt"));
  CHECK(mdm({"solve", athabasca, "-o", "-"}).out == read_file(folder / "answer.txt"));
}

TEST_CASE("the ending of -o tells the format where --format does not", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string format : {"json", "csv"}) {
    const std::string path = folder / ("answer." + format);
    CHECK(mdm({"solve", athabasca, "-o", path}).exit_code == 0);
    CHECK(read_file(path) == mdm({"solve", athabasca, "--format", format}).out);
    CHECK(mdm({"solve", athabasca, "--format", "text", "-o", path}).exit_code == 0);
    CHECK(read_file(path) == mdm({"solve", athabasca}).out);
  }
}

TEST_CASE("an ending of -o that is another format's is refused with those that there are", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", R"({"sizes":["1","2"],"masses":["1","0"]})");
  const std::string answers = folder.write("answers.csv", "id,quantities\n1,1\n");
  const Arguments commands[] = {
      {"solve", athabasca},
      {"describe", athabasca},
      {"tradeoff", athabasca},
      {"verify", athabasca, athabasca},
      {"published", "rounded", athabasca},
      {"generate", "--curve", athabasca, "--at-most", "2000"},
      {"convert", athabasca},
      {"batch", suite},
      {"crosscheck", suite, answers},
      {"suite", suite},
      {"merge", suite},
      {"export", athabasca, "--to", "csv"},
      {"pack", athabasca, "--spread"},
      {"plot", athabasca},
  };
  for (const Arguments &command : commands)
    for (const std::string ending : {"html", "HTML", "docx", "xlsx", "gz", "md"}) {
      Arguments words = command;
      words.insert(words.end(), {"-o", folder / ("answer." + ending)});
      INFO(command.front() << " " << ending);
      const Outcome outcome = mdm(words);
      check_refused(outcome, "OUT end in .");
      CHECK(outcome.err.find("answer." + ending) != std::string::npos);
    }
  CHECK(folder.entries() == 2);
  check_refused(
      mdm({"describe", athabasca, "-o", "a.html"}),
      "a.html: mdm describe writes no .html: let OUT end in .txt, .json or .csv, or say with --format");
  check_refused(mdm({"describe", athabasca, "-o", "a.svg"}), "writes no .svg");
  check_refused(mdm({"describe", athabasca, "-o", "a.jsonl"}), "writes no .jsonl");
  check_refused(mdm({"describe", athabasca, "-o", "a.html.zst"}), "writes no .html");
  check_refused(mdm({"crosscheck", suite, answers, "-o", "a.html"}), "writes no .html");
}

TEST_CASE("an ending that stands for no format is taken, and --format decides for any", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string name : {"answer", "answer.out", "answer.v1.2", "answer.TXT", ".answer"}) {
    CHECK(mdm({"solve", athabasca, "-o", folder / name}).exit_code == 0);
    CHECK(read_file(folder / name) == mdm({"solve", athabasca}).out);
  }
  CHECK(mdm({"solve", athabasca, "-o", folder / "answer.JSON"}).exit_code == 0);
  CHECK(read_file(folder / "answer.JSON") == mdm({"solve", athabasca, "--format", "json"}).out);
  CHECK(mdm({"solve", athabasca, "--format", "text", "-o", folder / "answer.html"}).exit_code == 0);
  CHECK(read_file(folder / "answer.html") == mdm({"solve", athabasca}).out);
}

TEST_CASE("option -o replaces a file and keeps its mode", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("answer.txt", "old");
  REQUIRE(chmod(path.c_str(), 0640) == 0);
  CHECK(mdm({"solve", athabasca, "-o", path}).exit_code == 0);
  CHECK(read_file(path).find("1485") != std::string::npos);
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  CHECK((status.st_mode & 07777) == 0640);
  CHECK(folder.entries() == 1);
}

TEST_CASE("a run that a signal ends leaves nothing beside -o", "[cli]") {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const TemporaryFolder folder;
    Process batch(MDM_PROGRAM, {"batch", "-o", folder / "answers.jsonl"});
    const auto deadline = std::chrono::steady_clock::now() + Process::time_limit;
    while (folder.entries() == 0 && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    REQUIRE(folder.entries() == 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // it has just been made
    batch.signal(number);
    CHECK(batch.end().signal == number);
    CHECK(folder.entries() == 0);
  }
}

TEST_CASE("option -o makes what a symbolic link leads to", "[cli]") {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("answer.txt", folder / "second");
  std::filesystem::create_symlink(folder / "second", folder / "first");
  CHECK(mdm({"solve", athabasca, "-o", folder / "first"}).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder / "first"));
  CHECK(std::filesystem::is_symlink(folder / "second"));
  CHECK(read_file(folder / "answer.txt").find("1485") != std::string::npos);
  std::filesystem::create_symlink("loop", folder / "loop");
  check_refused(mdm({"solve", athabasca, "-o", folder / "loop"}), "cannot be written");
  std::filesystem::create_symlink("none/answer.txt", folder / "lost");
  check_refused(mdm({"solve", athabasca, "-o", folder / "lost"}), "cannot be written");
  check_refused(mdm({"solve", athabasca, "-o", ""}), "'': cannot be written");
}

TEST_CASE("option -o /dev/stdout writes on where standard output stands", "[cli]") {
  const TemporaryFolder folder;
  const std::string answer = mdm({"solve", athabasca}).out;
  for (const char *path : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const std::string log = folder.write("log", "");
    const std::string command = std::string("(echo header; '") + MDM_PROGRAM + "' solve '" + athabasca +
                                "' -o " + path + "; echo footer) > '" + log + "'";
    CHECK(std::system(command.c_str()) == 0);
    CHECK(read_file(log) == "header\n" + answer + "footer\n");
  }
  check_refused(mdm({"solve", athabasca, "-o", "/dev/fd/99"}), "cannot be written");
}

TEST_CASE("option -o follows a symbolic link", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("answer.txt", "old");
  std::filesystem::create_symlink(path, folder / "link");
  CHECK(mdm({"solve", athabasca, "-o", folder / "link"}).exit_code == 0);
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(read_file(path).find("1485") != std::string::npos);
}

TEST_CASE("after an error an existing file is as before, and nothing else is there", "[cli]") {
  const TemporaryFolder folder;
  const std::string answer = folder.write("answer.txt", "old");
  const std::string proof = folder.write("proof", "old");
  const std::string bad = folder.write("bad.csv", "size_mm,mass\n1,x\n2,0\n");
  check_refused(mdm({"solve", bad, "-o", answer, "--proof", proof, "--vipr", folder / "new"}));
  check_refused(mdm({"convert", bad, "-o", answer}));
  check_refused(mdm({"solve", athabasca, "-o", answer, "--proof", proof, "--vipr", folder / "missing/new"}));
  CHECK(read_file(answer) == "old");
  CHECK(read_file(proof) == "old");
  CHECK(folder.entries() == 3);
}

TEST_CASE("a full disk is an error, and no other result is left", "[cli]") {
  const TemporaryFolder folder;
  check_refused(mdm({"solve", athabasca, "--proof", folder / "proof"}, "", "/dev/full"), "No space left");
  check_refused(mdm({"solve", athabasca, "--proof", folder / "proof", "-o", "/dev/full"}), "/dev/full");
  check_refused(mdm({"solve", athabasca, "--proof", "/dev/full", "-o", folder / "answer"}), "/dev/full");
  check_refused(mdm({"convert", athabasca}, "", "/dev/full"), "No space left");
  check_refused(mdm({"convert", athabasca, "-o", "/dev/full"}), "/dev/full");
  check_refused(mdm({"batch"}, R"({"sizes":[1,2],"masses":[1,0]})", "/dev/full"), "No space left");
  check_refused(mdm({"--help"}, "", "/dev/full"), "No space left");
  check_refused(mdm({"--version"}, "", "/dev/full"), "No space left");
  check_refused(mdm({"solve", "--help"}, "", "/dev/full"), "No space left");
  CHECK(folder.entries() == 0);
}

TEST_CASE("a limit of the file size is exit 2 without a signal, and leaves no file", "[cli]") {
  const TemporaryFolder folder;
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  rlimit limit = before;
  limit.rlim_cur = 256; // bytes: room for the message, not for the answer
  REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
  const Outcome outcome = mdm({"solve", athabasca, "-o", folder / "answer.txt"});
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  check_refused(outcome, "File too large");
  CHECK(folder.entries() == 0);
}

TEST_CASE("a closed pipe ends the program silently with exit 2", "[cli]") {
  const TemporaryFolder folder;
  for (const Arguments &arguments :
       {Arguments{"solve", athabasca, "--proof", folder / "proof"}, Arguments{"convert", athabasca},
        Arguments{"batch"}, Arguments{"--help"}}) {
    const Outcome outcome = mdm(arguments, R"({"sizes":[1,2],"masses":[1,0]})", "closed pipe");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.empty());
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("Ctrl-C ends a search with what is certain", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("many.csv", uneven_csv());
  for (const std::string format : {"text", "json"}) {
    Process search(MDM_PROGRAM, {"solve", file, "--tolerance", "total:0.2%", "--format", format, "--proof",
                                 folder / "proof"});
    std::this_thread::sleep_for(std::chrono::seconds(3)); // it is searching by now
    search.signal(SIGINT);
    const Outcome outcome = search.end();
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.find("the search was interrupted") != std::string::npos);
    CHECK(outcome.out.find(format == "text" ? "stopped at a limit" : "\"lower_bound\"") != std::string::npos);
    CHECK(mdm_check(file, folder / "proof").out.find(" is between ") != std::string::npos);
  }
}

TEST_CASE("Ctrl-C ends a batch with the answers so far and what is certain of the gradation that it searches",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string easy = folder.write("easy.csv", "size_mm,mass\n2,0\n1,7\n0.5,3\n"),
                    hard = folder.write("many.csv", uneven_csv());
  for (const std::string &out : {std::string("-"), folder / "answers.jsonl"}) {
    Process run(MDM_PROGRAM, {"batch", easy, hard, easy, "--tolerance", "total:0.2%", "-o", out});
    std::this_thread::sleep_for(std::chrono::seconds(3)); // it is searching by now
    run.signal(SIGINT);
    const Outcome outcome = run.end();
    CHECK(outcome.exit_code == 3);
    const std::vector<std::string> answers = lines_of(out == "-" ? outcome.out : read_file(out));
    REQUIRE(answers.size() == 2);
    CHECK(answers[0].find("\"status\":\"optimal\"") != std::string::npos);
    CHECK(answers[1].find("the search was interrupted") != std::string::npos);
    CHECK(answers[1].find("\"lower_bound\"") != std::string::npos);
    CHECK(outcome.err.find("the run was interrupted after 2 gradations: the others are left out") !=
          std::string::npos);
  }
}

TEST_CASE("Ctrl-C ends the judgement of answers with the rows so far", "[cli]") {
  const TemporaryFolder folder;
  const std::string hard = folder.write("many.csv", uneven_csv()), json = folder / "many.json";
  REQUIRE(mdm({"convert", hard, "-o", json}).exit_code == 0);
  const std::string easy = R"({"id":"easy","unit":"mm","sizes":["0.5","1","2"],"masses":["3","7","0"]})";
  const std::string suite = folder.write("suite.jsonl", easy + "\n" + read_file(json) + easy + "\n"),
                    answers = folder.write("answers.csv", "id,quantities\neasy,1 1\nmany,1\nother,1\n");
  Process run(MDM_PROGRAM, {"crosscheck", suite, answers, "--tolerance", "total:0.2%", "--format", "csv"});
  std::this_thread::sleep_for(std::chrono::seconds(3)); // it is searching by now
  run.signal(SIGINT);
  const Outcome outcome = run.end();
  CHECK(outcome.exit_code == 3);
  CHECK(lines_of(outcome.out).size() == 3); // with the header
  CHECK(outcome.err == "note: the run was interrupted after 2 gradations: the others are left out\n");
}

TEST_CASE("an output without a name, and the gradation beside a proof that is no file", "[cli]") {
  check_refused(mdm({"solve", athabasca, "-o", ""}), "'': cannot be written: it is no name");
  const TemporaryFolder folder;
  const std::string sheet = folder.write("sheet.csv", "Sieve (mm),Retained (g)\n4,0\n2,30\nPan,7\n");
  const Outcome outcome = mdm({"solve", sheet, "--proof", "/dev/null"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("mdm convert makes a file that it reads") != std::string::npos);
  CHECK(!std::filesystem::exists("/dev/null.gradation.csv"));
}

TEST_CASE("Ctrl-C ends the search of an export", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("many.csv", uneven_csv());
  Process search(MDM_PROGRAM,
                 {"export", file, "--to", "csv", "--tolerance", "total:0.2%", "-o", folder / "p.csv"});
  std::this_thread::sleep_for(std::chrono::seconds(3)); // it is searching by now
  search.signal(SIGINT);
  const Outcome outcome = search.end();
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("the search was interrupted") != std::string::npos);
}

TEST_CASE("Ctrl-C ends a trade-off with the rows so far and brackets around the others", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("many.csv", uneven_csv());
  Process search(MDM_PROGRAM, {"tradeoff", file, "--kind", "total", "--tolerances", "0,0.2"});
  std::this_thread::sleep_for(std::chrono::seconds(3)); // it is searching by now
  search.signal(SIGINT);
  const Outcome outcome = search.end();
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.find('[') != std::string::npos);
}

TEST_CASE("a folder, and a path in a folder that is not there, cannot be written", "[cli]") {
  const TemporaryFolder folder;
  const std::string missing = folder / "missing/answer.txt";
  for (const std::string &path : {folder / ".", missing}) {
    check_refused(mdm({"solve", athabasca, "-o", path}), path);
    check_refused(mdm({"solve", athabasca, "--proof", path}), path);
    check_refused(mdm({"convert", athabasca, "-o", path}), path);
    check_refused(mdm({"batch", "-o", path}), path);
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("a folder without write permission cannot be written", "[cli]") {
  if (geteuid() == 0)
    return; // permissions do not bind root
  const TemporaryFolder folder;
  REQUIRE(chmod((folder / ".").c_str(), 0555) == 0);
  check_refused(mdm({"solve", athabasca, "-o", folder / "answer.txt"}), "Permission denied");
  check_refused(mdm({"batch", "--shard", "1/1", "-o", folder / "answers"}), "Permission denied");
  REQUIRE(chmod((folder / ".").c_str(), 0755) == 0);
  CHECK(folder.entries() == 0);
}

TEST_CASE("two results cannot have one file", "[cli]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  const std::string p = folder / "p";
  for (const std::string &same : {p, folder / "./p", folder / "sub/../p"}) {
    check_refused(mdm({"solve", athabasca, "--proof", p, "-o", same}), "overwritten");
    check_refused(mdm({"solve", athabasca, "--proof", p, "--vipr", same}), "overwritten");
    check_refused(mdm({"solve", athabasca, "--vipr", p, "-o", same}), "overwritten");
  }
  folder.write("p", "old");
  std::filesystem::create_symlink(p, folder / "link");
  check_refused(mdm({"solve", athabasca, "--proof", p, "-o", folder / "link"}), "overwritten");
  CHECK(read_file(p) == "old");
  check_refused(mdm({"solve", athabasca, "--proof", "-"}), "--proof");
}

TEST_CASE("files beside those that were named do not replace a suite", "[cli]") {
  const TemporaryFolder folder;
  const std::string line = R"({"id":"a","sizes":["1","2","3"],"masses":["2","1","0"]})";
  const std::string totals = folder.write("o.totals", line), table = folder.write("table1.csv", line);
  check_refused(mdm({"batch", totals, "--shard", "1/1", "-o", folder / "o"}), "would be overwritten");
  check_refused(mdm({"study", "figures", table, "--out", folder / "."}), "would be overwritten");
  CHECK(read_file(totals) == line);
  CHECK(read_file(table) == line);
}

TEST_CASE("a proof does not replace the gradation that it proves", "[cli]") {
  const TemporaryFolder folder;
  const std::string text = read_file(athabasca);
  const std::string sand = folder.write("sand.csv", text);
  check_refused(mdm({"solve", sand, "--proof", sand}), "sand.csv");
  check_refused(mdm({"solve", sand, "--vipr", folder / "./sand.csv"}), "sand.csv");
  check_refused(mdm({"solve", sand, "-o", sand}), "sand.csv");
  CHECK(read_file(sand) == text);
}

TEST_CASE("option --vipr writes the proof, exact or within a tolerance, and --node-limit leaves none",
          "[cli]") {
  const TemporaryFolder folder;
  for (const Arguments &how : {Arguments{}, Arguments{"--tolerance", "retained:1%"}}) {
    Arguments arguments = {"solve", athabasca, "--vipr", folder / "vipr"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.find("no proof was written") == std::string::npos);
    CHECK(read_file(folder / "vipr").find("\nVER 1.0\n") != std::string::npos);
  }
  const Outcome limited = mdm({"solve", example("ottawa-f65-sand"), "--tolerance", "retained:1%",
                               "--node-limit", "2", "--vipr", folder / "none"});
  CHECK(limited.exit_code == 3);
  CHECK(limited.out.find("no proof was written") != std::string::npos);
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is no regular file is written in place", "[cli]") {
  CHECK(mdm({"solve", athabasca, "-o", "/dev/null"}).exit_code == 0);
  struct stat status {};
  REQUIRE(stat("/dev/null", &status) == 0);
  CHECK(S_ISCHR(status.st_mode));
}

TEST_CASE("without a standard output no other file takes its place", "[cli]") {
  const TemporaryFolder folder;
  check_refused(mdm({"solve", athabasca}, "", "nowhere"));
  check_refused(mdm({"convert", athabasca}, "", "nowhere"));
  check_refused(mdm({"solve", athabasca, "--proof", folder / "proof"}, "", "nowhere"));
  check_refused(mdm({"batch"}, R"({"sizes":[1,2],"masses":[1,0]})", "nowhere"));
  CHECK(folder.entries() == 0);
  CHECK(mdm({"solve", athabasca, "-o", folder / "answer", "--proof", folder / "proof"}, "", "nowhere",
            "nowhere")
            .exit_code == 0);
  CHECK(read_file(folder / "answer") == mdm({"solve", athabasca}).out);
  CHECK(mdm_check(athabasca, folder / "proof").exit_code == 0);
}

TEST_CASE("a message that cannot be written changes no exit code", "[cli]") {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.csv", "size_mm,mass\n1,x\n2,0\n");
  const std::string noted = folder.write("noted.csv", "size_mm,passing_percent\n1,10\n2,100\n");
  for (const char *errors : {"nowhere", "/dev/full", "closed pipe"}) {
    INFO(errors);
    for (const Arguments &arguments :
         {Arguments{"solve", bad}, Arguments{"frobnicate"}, Arguments{"solve", bad, "--frob"}, Arguments{}}) {
      const Outcome outcome = mdm(arguments, "", "", errors);
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.out.empty());
    }
    const Outcome converted = mdm({"convert", noted}, "", "", errors);
    CHECK(converted.exit_code == 0);
    CHECK(converted.out == mdm({"convert", noted}).out);
    CHECK(mdm({"solve", noted, "--format", "csv", "-o", folder / "answer", "--proof", folder / "proof"}, "",
              "", errors)
              .exit_code == 0);
    CHECK(mdm_check(noted, folder / "proof").exit_code == 0);
    CHECK(folder.entries() == 4);
  }
}

} // namespace output_test

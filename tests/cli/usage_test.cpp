// Help, versions, and command lines that are wrong.

#include "run.hpp"

namespace usage_test {

using namespace cli_test;

namespace {

constexpr const char *commands[] = {"solve",      "batch",      "merge",     "convert",  "describe",
                                    "verify",     "crosscheck", "published", "generate", "blend",
                                    "pack",       "study",      "tradeoff",  "plot",     "export",
                                    "completion", "suite",      "report",    "judge"};

/// The length of the longest line.
std::size_t columns(const std::string &text) {
  std::size_t most = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    most = std::max(most, line.size());
  return most;
}

} // namespace

TEST_CASE("help has an example and exits with 0", "[cli]") {
  std::vector<Arguments> all = {{"--help"}, {"-h"}};
  for (const char *command : commands)
    all.push_back({command, "--help"});
  for (const Arguments &arguments : all) {
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.out.find("\n  mdm ") != std::string::npos);
    CHECK(columns(outcome.out) <= 100);
    CHECK(outcome.out.back() == '\n');
    CHECK(outcome.out.front() != '\n');
  }
  for (const char *option : {"--min-per-class", "--at-least", "--at-most", "--specimen", "--void-ratio",
                             "--solids-volume", "--law", "--size-factor", "--cut-below", "--pan-size",
                             "--digits", "--scale", "--max-steps", "--time-limit"})
    for (const char *command : {"solve", "batch"})
      CHECK(mdm({command, "--help"}).out.find(option) != std::string::npos);
}

TEST_CASE("the help of a command is also that of the command help", "[cli]") {
  CHECK(mdm({"help"}).out == mdm({"--help"}).out);
  CHECK(mdm({"help", "solve"}).out == mdm({"solve", "--help"}).out);
  check_refused(mdm({"help", "sovle"}), "did you mean solve?");
}

TEST_CASE("the version names the program and its libraries", "[cli]") {
  std::vector<Arguments> all = {{"--version"}, {"-V"}, {"solve", "-V"}};
  for (const char *command : commands)
    all.push_back({command, "--version"});
  for (const Arguments &arguments : all) {
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.find("mdm ") == 0);
    for (const char *library : {"gmp", "boost", "arb"})
      CHECK(outcome.out.find(library) != std::string::npos);
  }
}

TEST_CASE("an unknown command names the commands that there are", "[cli]") {
  for (const Arguments &arguments :
       {Arguments{}, Arguments{"sovle"}, Arguments{""}, Arguments{"Solve", "x"}}) {
    const Outcome outcome = mdm(arguments);
    check_refused(outcome);
    for (const char *command : commands)
      CHECK(outcome.err.find(command) != std::string::npos);
  }
  check_refused(mdm({"\x1B[31m\xFF\n" + std::string(1000, 'x')}));
}

TEST_CASE("a mistyped command or option names the nearest one", "[cli]") {
  check_refused(mdm({"slove", "a"}), "'slove' is no command (did you mean solve?)");
  check_refused(mdm({"VERIFY"}), "did you mean verify?");
  check_refused(mdm({"solve", "a", "--tolerence", "1%"}), "did you mean --tolerance?");
  check_refused(mdm({"solve", "a", "--tolerence=1%"}), "did you mean --tolerance?");
  check_refused(mdm({"--versoin"}), "did you mean --version?");
  for (const Arguments &arguments : {Arguments{"xyzzy"}, Arguments{"solve", "a", "--xyzzy"}})
    CHECK(mdm(arguments).err.find("did you mean") == std::string::npos);
}

TEST_CASE("command lines that are wrong point to the help", "[cli]") {
  for (const Arguments &arguments :
       {Arguments{"--frobnicate"}, Arguments{"solve"}, Arguments{"solve", "a", "b"},
        Arguments{"solve", "a", "--frob"}, Arguments{"solve", "a", "-o"},
        Arguments{"solve", "a", "--at-least"}, Arguments{"solve", "a", "--digits", "1", "--digits", "2"},
        Arguments{"batch", "a", "--format", "text"}, Arguments{"batch", "-j", "0"},
        Arguments{"batch", "-j", "x"}, Arguments{"batch", "-j", "-1"}, Arguments{"batch", "-j"},
        Arguments{"convert"}, Arguments{"convert", "a", "--format", "ags"}, Arguments{"verify", "a"},
        Arguments{"verify", "a", "b", "--radius", "--diameter"},
        Arguments{"verify", "a", "b", "--format", "x"}})
    check_refused(mdm(arguments), "--help");
}

TEST_CASE("an unknown option is named also where arguments are missing", "[cli]") {
  check_refused(mdm({"verify", "--nosuch"}), "--nosuch");
  check_refused(mdm({"verify", "a", "--nosuch", "b"}), "--nosuch");
  check_refused(mdm({"verify", "a"}), "SAMPLE is required");
  check_refused(mdm({"describe", "a", "--digits", "3", "--digits", "4"}),
                "--digits: given 2 times: give it once");
}

TEST_CASE("a dash is standard input", "[cli]") {
  const std::string text = read_file(example("hostun-rf-sand"));
  const Outcome outcome = mdm({"solve", "-"}, text);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find(": 31 particles") != std::string::npos);
  CHECK(mdm({"convert", "-"}, text).exit_code == 0);
  CHECK(mdm({"batch", "-"}, R"({"sizes":[1,2],"masses":[1,0]})").out ==
        mdm({"batch"}, R"({"sizes":[1,2],"masses":[1,0]})").out);
}

TEST_CASE("nothing is on standard error when it is no terminal", "[cli]") {
  CHECK(mdm({"solve", example("athabasca-sand")}).err.empty());
  CHECK(mdm({"solve", example("athabasca-sand"), "--quiet"}).out ==
        mdm({"solve", example("athabasca-sand")}).out);
}

TEST_CASE("words of the user are quoted, escaped and cut", "[cli]") {
  const std::string word = "a\x1B\xFF\n" + std::string(300, 'x');
  const std::string shown = "'a\\x1b\\xff\\x0a" + std::string(64, 'x') + "...'";
  for (const Arguments &arguments :
       {Arguments{"solve", "a", "--format", word}, Arguments{"published", word, "a"},
        Arguments{"plot", "a", "--what", word}, Arguments{"tradeoff", "a", "--kind", word},
        Arguments{"batch", "-j", word}, Arguments{"describe", "a", "--digits", word},
        Arguments{"solve", "a", word}, Arguments{"solve", "a", "--quiet=" + word}})
    check_refused(mdm(arguments), shown);
  check_refused(mdm({"solve", "a", "--format", "json not in {text}"}),
                "'json not in {text}' is not in {text,");
  check_refused(mdm({"--quiet", "solve", "a"}), "'--quiet' stands before the command: write it behind that");
  check_refused(mdm({"solve", "a", "b", "-z", "--c=d"}), "'b', '-z', '--c=d' were not expected");
  check_refused(mdm({"solve", "a", "b.csv"}),
                "'b.csv' was not expected: mdm solve takes one file at a time (mdm batch solves many); see");
  check_refused(mdm({"verify", "a", "b", "c"}),
                "'c' was not expected: mdm verify takes one file of each kind");
  check_refused(mdm({"--nosuch", "solve", "a"}), "'--nosuch'");
  check_refused(mdm({"batch", "-j", "1.5"}), "-j: '1.5' is not a whole number from 1 to 1024");
}

} // namespace usage_test

// mdm study: the folder it writes, and what it refuses.

#include "run.hpp"

#include <sstream>

namespace study_test {

using namespace cli_test;
using mdm_test::line_count;

namespace {

const std::string specimens = std::string(MDM_SOURCE_DIR) + "/examples/specimens/zeraati-2025.csv";

/// The first gradations of the suite.
std::string some_of_the_suite(int n) {
  std::istringstream lines(read_file(MDM_SUITE));
  std::string text, line;
  for (int i = 0; i < n && std::getline(lines, line); ++i)
    text += line + "\n";
  return text;
}

} // namespace

TEST_CASE("study figures writes the table and the figures' numbers", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome =
      mdm({"study", "figures", "-", "--out", folder / "study"}, some_of_the_suite(21) + "\n");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  const std::filesystem::directory_iterator files(folder / "study");
  CHECK(std::distance(begin(files), end(files)) == 7);
  CHECK(line_count(folder / "study/statements.csv") == 1 + 44);
  CHECK(read_file(folder / "study/statements.csv").rfind("statement,where,found,holds,command\n", 0) == 0);
  CHECK(line_count(folder / "study/table1.csv") == 13);
  for (const char *name : {"study/figure3.csv", "study/figure4.csv", "study/figure5.csv"})
    CHECK(line_count(folder / name) == 22);
}

TEST_CASE("study specimens shows a table or writes it", "[cli]") {
  const TemporaryFolder folder;
  const Outcome shown = mdm({"study", "specimens", example("athabasca-sand"), specimens});
  CHECK(shown.exit_code == 0);
  CHECK(std::count(shown.out.begin(), shown.out.end(), '\n') == 15);
  CHECK(shown.out.find(" 69221 ") != std::string::npos);
  const Outcome written =
      mdm({"study", "specimens", example("athabasca-sand"), specimens, "--out", folder / "s"});
  CHECK(written.exit_code == 0);
  CHECK(line_count(folder / "s/specimens.csv") == 15);
}

TEST_CASE("study refuses what is broken and leaves no folder behind", "[cli]") {
  const TemporaryFolder folder;
  const auto refused = [&](const Arguments &words, const std::string &input, const std::string &part) {
    Arguments arguments{"study"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    arguments.insert(arguments.end(), {"--out", folder / "study"});
    check_refused(mdm(arguments, input), part);
    CHECK(folder.entries() == 0);
  };
  refused({"figures", "-"}, some_of_the_suite(3) + "{\"id\": 1\n", "stdin:4");
  refused({"figures", "-"}, "\n", "there is no gradation");
  refused({"figures", "-", "-"}, "", "one file");
  refused({"figures", "-", "--plots", "gif"}, "", "--plots");
  refused({"specimens", example("athabasca-sand")}, "", "two files");
  refused({"specimens", example("athabasca-sand"), "-"}, "a,b\n", "stdin:1");
  refused({"specimens", example("athabasca-sand"), specimens, "--plots", "svg"}, "", "not an option");
  check_refused(mdm({"study", "figures", "-"}, some_of_the_suite(1)), "--out is missing");
  check_refused(mdm({"study", "--out", folder / "study"}), "WHAT is missing");
  check_refused(mdm({"study", "--paper", "voivret"}), "--out is missing");
  refused({"figures", "-", "--paper", "voivret"}, "", "without WHAT and FILE");
  for (const char *what : {"figures", "specimens"})
    refused({what, "--paper", "voivret"}, "", "without WHAT and FILE");
  refused({"--paper", "newton"}, "", "--paper");
  refused({"figures", "-", "--seeds", "2"}, "", "--paper voivret");
  refused({"--paper", "voivret", "--seeds", "0"}, "", "--seeds");
  refused({"--paper", "voivret", "--spans", "0.5,1"}, "", "--spans");
  refused({"--paper", "voivret", "--spans", "x"}, "", "--spans");
  refused({"--paper", "voivret", "--at-least", "none"}, "", "--at-least");
  refused({"--paper", "voivret", "--at-most", "1e9"}, "", "--at-most");
  refused({"--paper", "voivret", "--at-most", "100000000"}, "", "10^7");
  refused({"--paper", "voivret", "--only", "9"}, "", "--only");
  const std::string file = folder.write("file", "");
  check_refused(mdm({"study", "figures", "-", "--out", file}, some_of_the_suite(1)), "no folder can be made");
  CHECK(folder.entries() == 1);
}

TEST_CASE("the examples of study's help write into folders of their own", "[cli]") {
  const std::string help = mdm({"study", "--help"}).out;
  CHECK(help.find("mdm study figures suite.jsonl --out study ") != std::string::npos);
  CHECK(help.find("mdm study --paper voivret --out models ") != std::string::npos);
}

TEST_CASE("study draws its figures", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome =
      mdm({"study", "figures", "-", "--out", folder / "study", "--plots", "svg"}, some_of_the_suite(21));
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  for (const char *name : {"study/figure1.svg", "study/figure2.svg", "study/figure3.svg", "study/figure4.svg",
                           "study/figure5.svg"})
    CHECK(read_file(folder / name).find("</svg>") != std::string::npos);
}

namespace {

/// Few deposits, of 200 discs and more.
Outcome packings(const std::string &out, const Arguments &more = {}) {
  Arguments arguments = {"study",   "--paper", "voivret", "--only", "packings",
                         "--spans", "0.1,0.2", "--seeds", "2",      "--at-most",
                         "400",     "-j",      "2",       "--out",  out};
  if (more.empty())
    arguments.insert(arguments.end(), {"--at-least", "200"});
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments);
}

} // namespace

TEST_CASE("a study of packings writes its tables and keeps its deposits", "[cli]") {
  const TemporaryFolder folder;
  const std::string out = folder / "study", journal = out + "/figure9.journal.jsonl";
  const Outcome outcome = packings(out);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  CHECK(line_count(out + "/figure9.csv") == 1 + 2 * 6 * 2);
  CHECK(line_count(out + "/statements.csv") == 1 + 13);
  CHECK(line_count(out + "/figure2.csv") == 1 + 1864);
  CHECK(line_count(out + "/figure10.csv") > 4990);
  const std::string points = read_file(out + "/figure9.csv"), kept = read_file(journal);
  CHECK(points.find("\n2,4,regular,0.2,") != std::string::npos);
  CHECK(points.find(",left out: more than 400 discs\n") != std::string::npos);
  // Terms, the deposits of Figure 9, and those that are dropped.
  CHECK(line_count(journal) == 1 + (line_count(out + "/figure9-deposits.csv") - 1) + 2 * 2);

  // A run that was killed while it wrote its last line goes on; what it has kept is not made again.
  const std::size_t last = kept.rfind('\n', kept.size() - 2) + 1;
  std::string some = kept.substr(0, last + 40);
  const std::size_t fraction = some.find("\"packing_fraction\":[\"0.") + 23;
  some.replace(fraction, 1, "1");
  folder.write("study/figure9.journal.jsonl", some);
  CHECK(packings(out).exit_code == 0);
  CHECK(line_count(journal) == std::count(kept.begin(), kept.end(), '\n'));
  const bool is_used = read_file(out + "/figure9.csv") != points;
  CHECK(is_used);
}

TEST_CASE("a journal of another study, or none at all, is refused with what to do", "[cli]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "study");
  const auto refused = [&](const std::string &journal, const std::string &part) {
    folder.write("study/figure9.journal.jsonl", journal);
    check_refused(packings(folder / "study"), "figure9.journal.jsonl");
    check_refused(packings(folder / "study"), part);
    CHECK(read_file(folder / "study/figure9.journal.jsonl") == journal);
  };
  refused("{\"terms\":\"mdm 0.0.1, N_c = 10, N_pc = 10, N_min = 200\"}\n", "name another --out");
  refused("{\"deposit\":\"a\"}\n", "figure9.journal.jsonl:1: is no line of a journal");
  refused("a,b\n1,2\n", "is no line of a journal");
  refused("a,b", "is no line of a journal");
}

} // namespace study_test

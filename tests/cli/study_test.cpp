// mdm study: the folder it writes, and what it refuses.

#include "run.hpp"

#include <sstream>

using namespace cli_test;

namespace {

const std::string specimens = std::string(MDM_SOURCE_DIR) + "/examples/specimens/zeraati-2025.csv";

/// The first gradations of the suite.
std::string some_of_the_suite(int n) {
  std::istringstream lines(read_file(std::string(MDM_DATA_DIR) + "/suite-2750.jsonl"));
  std::string text, line;
  for (int i = 0; i < n && std::getline(lines, line); ++i)
    text += line + "\n";
  return text;
}

std::ptrdiff_t lines_of(const std::string &path) {
  const std::string text = read_file(path);
  return std::count(text.begin(), text.end(), '\n');
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
  CHECK(std::distance(begin(files), end(files)) == 6);
  CHECK(lines_of(folder / "study/table1.csv") == 13);
  for (const char *name : {"study/figure3.csv", "study/figure4.csv", "study/figure5.csv"})
    CHECK(lines_of(folder / name) == 22);
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
  CHECK(lines_of(folder / "s/specimens.csv") == 15);
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
  const std::string file = folder.write("file", "");
  check_refused(mdm({"study", "figures", "-", "--out", file}, some_of_the_suite(1)), "no folder can be made");
  CHECK(folder.entries() == 1);
}

TEST_CASE("the examples of study's help write into folders of their own", "[cli]") {
  const std::string help = mdm({"study", "--help"}).out;
  CHECK(help.find("mdm study figures suite.jsonl --out study ") != std::string::npos);
  CHECK(help.find("mdm study --paper voivret --out models ") != std::string::npos);
}

TEST_CASE("study draws its figures, or says that gnuplot is missing", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome =
      mdm({"study", "figures", "-", "--out", folder / "study", "--plots", "svg"}, some_of_the_suite(21));
  if (outcome.exit_code != 0) {
    check_refused(outcome, "gnuplot-nox");
    CHECK(folder.entries() == 0);
    return;
  }
  for (const char *name : {"study/figure1.svg", "study/figure2.svg", "study/figure3.svg", "study/figure4.svg",
                           "study/figure5.svg"})
    CHECK(read_file(folder / name).find("</svg>") != std::string::npos);
}

TEST_CASE("study --paper voivret writes the numbers of its figures", "[cli]") {
  if (MDM_KEEPS_FREED_MEMORY) // all of them: a minute there
    return;
  const TemporaryFolder folder;
  const Outcome outcome = mdm({"study", "--paper", "voivret", "--out", folder / "study"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  const std::pair<const char *, std::ptrdiff_t> rows[] = {
      {"1", 100}, {"3", 707}, {"4", 294}, {"5", 180}, {"6", 48}, {"7", 66}, {"8", 2304}, {"8-spans", 2000}};
  for (const auto &[number, n] : rows)
    CHECK(lines_of(folder / ("study/figure" + std::string(number) + ".csv")) == n + 1);
  const std::string sets = read_file(folder / "study/figure7.csv");
  CHECK(sets.find("\n1,3,geometric,10,10,2000,33927,33927,0.01") != std::string::npos);
  CHECK(sets.find("\n1,3,regular,10,10,2000,7258942,7258942,\n") != std::string::npos);
}

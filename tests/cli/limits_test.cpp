// Limits on steps, time and memory: what is asked ends, and what is certain is said.

#include "answer.hpp"

#include <fmt/core.h>

#include <filesystem>

namespace limits_test {

using namespace cli_test;

namespace {

/// Sieves so close that a sweep would take 10^12 steps.
std::string endless(const std::string &id = "endless") {
  return R"({"id":")" + id +
         R"(","sizes":["7","7.000000000002","7.000000000004","7.000000000006"],"masses":[1,3,2,0]})";
}

const std::string small = R"({"id":"small","sizes":[1,2,3],"masses":[2,1,0]})";

constexpr long megabyte = 1024; // KiB

} // namespace

TEST_CASE("a sweep ends at a stated size, with its bounds", "[cli]") {
  const Outcome outcome = mdm({"solve", "-", "--format", "json"}, endless());
  CHECK(outcome.exit_code == 3);
  const Json answer = Json::parse(outcome.out);
  CHECK(answer.at("status") == "feasible");
  CHECK(contains(answer.at("notes").dump(), "ended after 67108864 steps"));
  CHECK(outcome.max_rss_kib < 100 * megabyte); // no chain is kept without a proof
}

TEST_CASE("a chain that is kept stays bounded", "[cli]") {
  const TemporaryFolder folder;
  // With sanitizers the sweeps to the stated size take minutes.
  const std::string steps = MDM_IS_SANITIZED ? "1000000" : "1000000000000";
  const Outcome outcome = mdm({"solve", "-", "--proof", folder / "p", "--max-steps", steps}, endless());
  CHECK(outcome.exit_code == 3);
  CHECK((MDM_IS_SANITIZED || outcome.max_rss_kib < 800 * megabyte));
  CHECK(contains(outcome.out, "the proof is of the bounds: N is at least "));
  CHECK(folder.entries() == 1);
  CHECK(std::filesystem::file_size(folder / "p") < (std::uintmax_t{250} << 20));
}

TEST_CASE("the lines beside an endless one are written in batch, crosscheck and tradeoff", "[cli]") {
  const std::string suite = small + "\n" + endless() + "\n" + small + "\n";
  const Outcome batch = mdm({"batch"}, suite);
  CHECK(batch.exit_code == 3);
  REQUIRE(lines_of(batch.out).size() == 3);
  CHECK(contains(lines_of(batch.out)[1], "\"feasible\""));
  CHECK(contains(lines_of(batch.out)[2], "\"optimal\""));
  CHECK(batch.max_rss_kib < 100 * megabyte);

  const TemporaryFolder folder;
  const std::string answers = folder.write("a.csv", "id,quantities\nsmall,3 1\nendless,1 1 1\n");
  const Outcome judged = mdm({"crosscheck", "-", answers, "--format", "csv"}, suite);
  CHECK(lines_of(judged.out).size() == 4);
  CHECK(judged.max_rss_kib < 100 * megabyte);

  Arguments tradeoff{"tradeoff", "-", "--tolerances", "1", "--format", "csv"};
  if (MDM_IS_SANITIZED) // with sanitizers the sweeps to the stated size take minutes
    tradeoff.insert(tradeoff.end(), {"--max-steps", "1000000"});
  const Outcome rows = mdm(tradeoff, endless());
  CHECK(rows.exit_code == 3);
  CHECK((MDM_IS_SANITIZED || rows.max_rss_kib < 100 * megabyte));
}

TEST_CASE("within a tolerance the exact match takes a small share of the limits", "[cli]") {
  const Outcome outcome = mdm({"solve", "-", "--tolerance", "retained:1%", "--format", "json"}, endless());
  CHECK(outcome.exit_code == 0);
  CHECK(Json::parse(outcome.out).at("status") == "optimal");
  CHECK(outcome.max_rss_kib < 100 * megabyte);
}

TEST_CASE("a line that takes too much memory leaves the other lines of a batch alone", "[cli]") {
  if (MDM_IS_SANITIZED)
    return;
  const TemporaryFolder folder;
  const std::string suite = folder.write("s.jsonl", small + "\n" + endless() + "\n" + small + "\n");
  const std::string command =
      "ulimit -v 250000; exec '" MDM_PROGRAM "' batch '" + suite + "' --proofs '" + (folder / "p") + "'";
  const Outcome outcome = Process("/bin/sh", {"-c", command}).end();
  INFO(outcome.err);
  CHECK(outcome.exit_code == 2);
  REQUIRE(lines_of(outcome.out).size() == 3);
  CHECK(contains(lines_of(outcome.out)[0], "\"optimal\""));
  CHECK(contains(lines_of(outcome.out)[1], "out of memory"));
  CHECK(contains(lines_of(outcome.out)[2], "\"optimal\""));
}

TEST_CASE("where the system has no more threads, the first does it all", "[cli]") {
  if (MDM_IS_SANITIZED)
    return;
  const TemporaryFolder folder;
  const std::string suite = folder.write("s.jsonl", small + "\n" + small + "\n" + small + "\n");
  const auto limited = [](const std::string &command) {
    return Process("/bin/sh", {"-c", "ulimit -s 2000000; ulimit -v 1500000; exec " + command}).end();
  };
  const Outcome solved =
      limited("'" MDM_PROGRAM "' batch -j 4 '" + suite + "' --proofs '" + (folder / "p") + "'");
  CHECK(solved.exit_code == 0);
  CHECK(lines_of(solved.out).size() == 3);
  const Outcome checked =
      limited("'" MDM_CHECK_PROGRAM "' --suite '" + suite + "' '" + (folder / "p") + "' -j 4");
  CHECK(checked.exit_code == 0);
  CHECK(contains(checked.out, "3 accepted"));
}

TEST_CASE("where memory ends no file is left", "[cli]") {
  if (MDM_IS_SANITIZED)
    return;
  const TemporaryFolder folder;
  std::string sand = "size_mm,mass\n";
  for (int i = 1; i <= 8000; ++i)
    sand +=
        fmt::format("{}.{},{}\n", i, std::string(900, '7'), i < 8000 ? "1." + std::string(900, '3') : "0");
  const std::string file = folder.write("sand.csv", sand);
  const std::string command =
      "ulimit -v 90000; exec '" MDM_PROGRAM "' solve '" + file + "' -o '" + (folder / "answer.txt") + "'";
  const Outcome outcome = Process("/bin/sh", {"-c", command}).end();
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "mdm: out of memory: give it more"));
  const std::filesystem::directory_iterator files(folder.path());
  CHECK(std::distance(begin(files), end(files)) == 1);
}

} // namespace limits_test

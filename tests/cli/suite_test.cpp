// mdm suite: lines that any part of which can be made alone, and what batch makes of them.

#include "answer.hpp"

namespace suite_test {

using namespace cli_test;

namespace {

const std::string mixed = R"({"schema": "mdm-suite-1", "id": "mixed", "classes": [3, 9],
  "sieves": {"series": "ISO R20", "from": 0.063, "to": 4},
  "masses": [{"kind": "random"}, {"kind": "gap-graded"}, {"kind": "beta", "a": [0.5, 4], "b": [0.5, 4]},
    {"kind": "lognormal", "median": [0, 1], "deviation": [0.5, 2]}, {"kind": "ties"}]})";

/// The suite of the description on standard input.
std::string made(const Arguments &options) {
  Arguments arguments{"suite", "-"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = mdm(arguments, mixed);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

} // namespace

TEST_CASE("ranges and shards of a suite are its lines, whatever the threads", "[suite]") {
  const std::string whole = made({"--count", "1500", "--seed", "5"});
  const std::vector<std::string> lines = lines_of(whole);
  REQUIRE(lines.size() == 1500);
  CHECK(lines[41].find(R"({"id": "mixed-42", "unit": "mm")") == 0);
  CHECK(made({"--count", "1500", "--seed", "5", "-j", "3"}) == whole);
  CHECK(made({"--lines", "42-42", "--seed", "5"}) == lines[41] + "\n");
  const auto shard = [](const std::string &which) {
    std::vector<std::string> all = lines_of(made({"--count", "1500", "--seed", "5", "--shard", which}));
    CHECK(Json::parse(all.at(0)).at("schema") == "mdm-shard-1");
    CHECK(Json::parse(all.at(0)).at("lines") == std::to_string(all.size() - 1));
    all.erase(all.begin());
    return all;
  };
  const std::vector<std::vector<std::string>> shards = {shard("1/4"), shard("2/4"), shard("3/4"),
                                                        shard("4/4")};
  for (std::size_t i = 0; i < lines.size(); ++i)
    CHECK(shards[i % 4].at(i / 4) == lines[i]);
  CHECK(shards[0].size() + shards[1].size() + shards[2].size() + shards[3].size() == 1500);
  const auto behind_first = [](const std::string &text) { return text.substr(text.find('\n') + 1); };
  CHECK(behind_first(made({"--lines", "11-13", "--shard", "2/3"})) == made({"--lines", "12-12"}));
  CHECK(behind_first(made({"--lines", "12-16", "--shard", "2/3"})) ==
        made({"--lines", "13-13"}) + made({"--lines", "16-16"}));
  CHECK(behind_first(made({"--count", "2", "--shard", "3/3"})).empty());
  CHECK(behind_first(made({"--count", "0", "--shard", "1/3"})).empty());
  CHECK(made({"--count", "1500", "--seed", "6"}) != whole);
  CHECK(lines_of(made({})).size() == 1000);
}

TEST_CASE("lines near the end of all numbers are made as the others", "[suite]") {
  const std::string last = made({"--lines", "18446744073709551614-18446744073709551615"});
  CHECK(lines_of(last).size() == 2);
  CHECK(last.find("mixed-18446744073709551615") != std::string::npos);
  CHECK(lines_of(made({"--lines", "18446744072709551616-18446744073709551615", "--shard", "7/1000000000"}))
            .size() == 2);
}

TEST_CASE("batch reads and solves every line of a suite", "[suite]") {
  const Outcome outcome = mdm({"batch"}, made({"--count", "300"}));
  CHECK(outcome.exit_code == 0);
  for (const std::string &line : lines_of(outcome.out))
    check_match(Json::parse(line));
}

TEST_CASE("shards that are made, solved and joined are the suite made and solved at once", "[suite]") {
  const TemporaryFolder folder;
  const auto solved = [&folder](const Arguments &options, const std::string &name, Arguments batch) {
    batch.insert(batch.begin(), {"batch", "-"});
    batch.insert(batch.end(), {"-o", folder / name});
    const Outcome outcome = mdm(batch, made(options));
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
  };
  for (const char *i : {"1", "2", "3"}) {
    const std::string shard = std::string(i) + "/3";
    solved({"--count", "100", "--shard", shard}, std::string(i) + ".jsonl", {"--shard", shard, "--alone"});
  }
  solved({"--count", "100"}, "whole.jsonl", {});
  const Outcome merged = mdm(
      {"merge", folder / "1.jsonl", folder / "2.jsonl", folder / "3.jsonl", "-o", folder / "merged.jsonl"});
  INFO(merged.err);
  CHECK(merged.exit_code == 0);
  CHECK(read_file(folder / "merged.jsonl") == read_file(folder / "whole.jsonl"));
}

TEST_CASE("a long suite takes the memory of a short one", "[suite]") {
  if (MDM_IS_SANITIZED)
    return;
  const Outcome outcome =
      mdm({"suite", "-", "--count", "500000", "-o", "/dev/null"},
          R"({"schema": "mdm-suite-1", "sieves": {"series": "phi"}, "masses": {"kind": "random"}})");
  CHECK(outcome.exit_code == 0);
  constexpr long kib_of_50_mib = 50 * 1024; // the lines have some 190 MB
  CHECK(outcome.max_rss_kib < kib_of_50_mib);
}

TEST_CASE("a suite is written to its file", "[suite]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("mixed.json", mixed), out = folder / "suite.jsonl";
  CHECK(mdm({"suite", file, "--count", "3", "-o", out}).exit_code == 0);
  CHECK(read_file(out) == made({"--count", "3"}));
  check_refused(mdm({"suite", file, "-o", file}), "mixed.json");
  CHECK(read_file(file) == mixed);
}

TEST_CASE("suites that make no sense are refused", "[suite]") {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.json", "{\n\"schema\": x}");
  check_refused(mdm({"suite"}), "DESCRIPTION");
  check_refused(mdm({"suite", folder / "none.json"}), "none.json");
  check_refused(mdm({"suite", bad}), "bad.json:2: this is not JSON");
  check_refused(mdm({"suite", "-"}, "{}"), "stdin: schema: is missing");
  const auto refused = [](Arguments options, const std::string &part) {
    options.insert(options.begin(), {"suite", "-"});
    check_refused(mdm(options, mixed), part);
  };
  refused({"--count", "-1"}, "--count");
  refused({"--count", "18446744073709551616"}, "--count");
  refused({"--count", "5", "--lines", "1-5"}, "give one of them");
  refused({"--lines", "5"}, "--lines: '5' is not A-B");
  refused({"--lines", "0-5"}, "--lines: '0-5'");
  refused({"--lines", "5-4"}, "--lines: '5-4'");
  refused({"--shard", "0/4"}, "--shard: '0/4' is not I/N");
  refused({"--shard", "5/4"}, "--shard");
  refused({"--shard", "5"}, "--shard: '5' is not I/N");
  refused({"--seed", "x"}, "--seed");
  refused({"-j", "0"}, "-j");
  refused({"-o", "/no/such/folder/suite.jsonl"}, "/no/such/folder");
}

TEST_CASE("a full disk and a closed pipe end a suite", "[suite]") {
  const Outcome full = mdm({"suite", "-", "--count", "100"}, mixed, "/dev/full");
  CHECK(full.exit_code == 2);
  CHECK(full.err.find("No space left") != std::string::npos);
  const Outcome closed = mdm({"suite", "-", "--count", "100000000000"}, mixed, "closed pipe");
  CHECK(closed.exit_code == 2);
}

} // namespace suite_test

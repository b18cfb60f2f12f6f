// mdm batch --shard: each part of a suite alone, complete or not there.

#include "shards.hpp"

#include <nlohmann/json.hpp>

#include <random>

namespace shard_test {

using namespace cli_test;
using Json = nlohmann::json;

namespace {

const std::string good = R"({"sizes":["1","2","3"],"masses":["2","1","0"]})";
const std::string slow = R"({"sizes":["1","1.000001","1.000002","1.000003"],"masses":["7","11","13","0"]})";

std::string ids(const std::string &answers) {
  std::string all;
  for (const std::string &line : lines_of(answers))
    all += (all.empty() ? "" : " ") + Json::parse(line).at("id").get<std::string>();
  return all;
}

std::string replaced(std::string text, const std::string &from, const std::string &to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

/// Runs `program` with `arguments` under a limit of the file size, in blocks of 512 bytes or 1 KiB.
Outcome with_small_disk(const Arguments &arguments) {
  std::string command = "ulimit -f 8; exec '" MDM_PROGRAM "'";
  for (const std::string &argument : arguments)
    command += " '" + argument + "'";
  return Process("/bin/sh", {"-c", command}).end();
}

} // namespace

TEST_CASE("a shard has every N-th line that is not blank, with the numbers of the whole suite", "[cli]") {
  const ShardFolder s(good + "\n\n" + good + "\nnonsense\n \n" + good + "\n" + good);
  CHECK(s.solve(1, 2).exit_code == 2);
  CHECK(s.solve(2, 2).exit_code == 0);
  CHECK(ids(read_file(s.answers("1"))) == "1 4 7");
  CHECK(ids(read_file(s.answers("2"))) == "3 6");
  CHECK(read_file(s.answers("1")).find("suite.jsonl:4: ") != std::string::npos);
  CHECK(s.solve(3, 9).exit_code == 2);
  CHECK(s.solve(6, 9).exit_code == 0);
  CHECK(read_file(s.answers("6")).empty());
  CHECK(read_file(s.proofs("6") + ".index") == "mdm-proofs 1\n");
}

TEST_CASE("totals name the files beside them with their bytes and SHA-256", "[cli]") {
  const ShardFolder s(good + "\nnonsense\n" + good + "\n" + slow + "\n");
  CHECK(s.solve(1, 3, {"--max-steps", "1"}).exit_code == 3);
  CHECK(s.solve(2, 3, {"--max-steps", "1"}).exit_code == 2);
  const Json first = Json::parse(read_file(s.totals("1"))), second = Json::parse(read_file(s.totals("2")));
  CHECK(first.at("schema") == "mdm-totals-1");
  CHECK(first.at("shard") == Json{{"number", "1"}, {"of", "3"}});
  CHECK(first.at("question") == "--max-steps 1");
  CHECK(first.at("lines") == "2");
  CHECK(first.at("errors") == "0");
  CHECK(first.at("exit") == "3");
  CHECK(second.at("lines") == "1");
  CHECK(second.at("errors") == "1");
  CHECK(second.at("exit") == "2");
  CHECK(second.at("suite") == first.at("suite"));
  const auto sha256sum = [](const std::string &path) {
    return Process("/usr/bin/sha256sum", {path}).end().out.substr(0, 64);
  };
  CHECK(first.at("suite").at("sha256") == sha256sum(s.suite));
  for (const char *key : {"answers", "proofs", "index"}) {
    const std::string path = s.folder / first.at(key).at("file").get<std::string>();
    CHECK(first.at(key).at("sha256") == sha256sum(path));
    CHECK(first.at(key).at("bytes") == std::to_string(std::filesystem::file_size(path)));
  }
}

TEST_CASE("a shard that is complete is not solved again", "[cli]") {
  const ShardFolder s(good + "\nnonsense\n" + good + "\n");
  CHECK(s.solve(2, 2).exit_code == 2);
  const auto before = s.contents();
  std::filesystem::last_write_time(s.answers("2"), {});
  const Outcome again = s.solve(2, 2, {"-j", "2"});
  CHECK(again.exit_code == 2); // as it was
  CHECK(again.err.find("shard 2/2 is complete already: nothing was done\n") != std::string::npos);
  CHECK(s.contents() == before);
  CHECK(std::filesystem::last_write_time(s.answers("2")) == std::filesystem::file_time_type{});
}

TEST_CASE("a shard is solved again where anything is another", "[cli]") {
  const std::string lines = good + "\n" + good + "\n" + good + "\n";
  const auto is_solved_again = [&](const std::function<void(const ShardFolder &)> &change,
                                   const Arguments &more = {}, int shard = 1) {
    const ShardFolder s(lines);
    CHECK(s.solve(1, 2).exit_code == 0);
    change(s);
    Arguments words = s.words(shard, 2, more);
    words[5] = s.answers("1");
    words[7] = s.proofs("1");
    const Outcome outcome = mdm(words);
    CHECK(outcome.exit_code == 0);
    CHECK(read_file(s.totals("1")).find(read_file(s.suite) == lines ? "" : "nothing") == 0);
    return outcome.err.find("complete already") == std::string::npos;
  };
  const auto nothing = [](const ShardFolder &) {};
  const auto replaced = [](const std::string &from, const std::string &to) {
    return [=](const ShardFolder &s) {
      std::string totals = read_file(s.totals("1"));
      REQUIRE(totals.find(from) != std::string::npos);
      totals.replace(totals.find(from), from.size(), to);
      s.folder.write("1.jsonl.totals", totals);
    };
  };
  CHECK_FALSE(is_solved_again(nothing));
  CHECK(is_solved_again(nothing, {"--at-least", "5"}));
  CHECK(is_solved_again(nothing, {}, 2));
  CHECK(is_solved_again([](const ShardFolder &s) { std::filesystem::remove(s.totals("1")); }));
  CHECK(is_solved_again([](const ShardFolder &s) { std::filesystem::remove(s.proofs("1")); }));
  CHECK(is_solved_again([](const ShardFolder &s) { std::filesystem::remove(s.proofs("1") + ".index"); }));
  CHECK(is_solved_again([](const ShardFolder &s) { s.folder.write("1.jsonl", "cut short"); }));
  CHECK(is_solved_again([](const ShardFolder &s) {
    std::string damaged = read_file(s.answers("1"));
    damaged[damaged.size() / 2] ^= 1; // of the same length
    s.folder.write("1.jsonl", damaged);
  }));
  CHECK(is_solved_again([](const ShardFolder &s) { s.folder.write("1.jsonl.totals", "{\"schema\":"); }));
  CHECK(is_solved_again(replaced("\"mdm\":\"", "\"mdm\":\"9.")));
  CHECK(is_solved_again(replaced("\"of\":\"2\"", "\"of\":\"3\"")));
  CHECK(is_solved_again(replaced("mdm-totals-1", "mdm-totals-2")));
}

TEST_CASE("a shard is solved again where the suite has another length", "[cli]") {
  const ShardFolder s(good + "\n");
  CHECK(s.solve(1, 1).exit_code == 0);
  s.folder.write("suite.jsonl", good + "\n" + good + "\n");
  CHECK(s.solve(1, 1).err.empty());
  CHECK(lines_of(read_file(s.answers("1"))).size() == 2);
}

TEST_CASE("a shard is solved again where the suite has other lines of the same length", "[cli]") {
  const ShardFolder s(good + "\n" + slow + "\n");
  CHECK(s.solve(1, 1).exit_code == 0);
  s.folder.write("suite.jsonl", slow + "\n" + good + "\n");
  CHECK(s.solve(1, 1).err.empty());
  CHECK(lines_of(read_file(s.answers("1")))[0].find("1.000001") != std::string::npos);
}

TEST_CASE("a shard that is alone is complete for the same lines alone", "[cli]") {
  const ShardFolder s(good + "\n");
  CHECK(s.solve(2, 2, {"--alone"}).exit_code == 0);
  CHECK(s.solve(2, 2, {"--alone"}).err.find("complete already") != std::string::npos);
  CHECK(s.solve(2, 2).err.empty()); // of a suite of which they are no lines
  CHECK(s.solve(2, 2, {"--alone"}).err.empty());
  s.folder.write("suite.jsonl", replaced(good, "[\"2\"", "[\"3\"") + "\n");
  CHECK(s.solve(2, 2, {"--alone"}).err.empty());
  CHECK(read_file(s.answers("2")).find(R"("mass":"3")") != std::string::npos);
  Arguments piped = s.words(2, 2, {"--alone"});
  piped[1] = "-";
  CHECK(mdm(piped, good + "\n").err.empty());
  CHECK(mdm(piped, good + "\n").err.empty()); // nothing is known of a pipe before it is read
}

TEST_CASE("shards of standard input and with threads are the same", "[cli]") {
  const ShardFolder s(suite_lines(300, 3));
  CHECK(s.solve(2, 3).exit_code == 0);
  const std::string answers = read_file(s.answers("2")), proofs = read_file(s.proofs("2"));
  CHECK(lines_of(answers).size() == 300);
  CHECK(
      mdm({"batch", "-j", "3", "--shard", "2/3", "-o", s.answers("2"), "--proofs", s.proofs("2"), "--quiet"},
          read_file(s.suite))
          .exit_code == 0);
  CHECK(read_file(s.answers("2")) == answers);
  CHECK(read_file(s.proofs("2")) == proofs);
}

TEST_CASE("what is no shard is refused before any work", "[cli]") {
  const ShardFolder s(good + "\n");
  for (const char *shard :
       {"0/2", "3/2", "1", "1/", "/2", "1/0", "-1/2", "1/2/3", "a/b", "", "1.5/2", "1/99999999999999999999"})
    check_refused(mdm({"batch", s.suite, "--shard", shard, "-o", s.answers("1")}), "--shard: ");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2"}), "name the answers with -o");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", "-"}), "name a file with -o");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", "/dev/full"}), "name a file with -o");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", s.answers("1"), "--proofs", "/dev/null"}),
                "name a file with --proofs");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", s.folder / "a.csv"}), "JSON Lines");
  check_refused(mdm({"batch", s.suite, s.suite, "--shard", "1/2", "-o", s.answers("1")}), "one suite");
  check_refused(mdm({"batch", example("athabasca-sand"), "--shard", "1/2", "-o", s.answers("1")}),
                "no suite in JSON Lines");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", s.folder / "missing/a"}), "missing/a");
  check_refused(
      mdm({"batch", s.suite, "--shard", "1/2", "-o", s.answers("1"), "--proofs", s.folder / "no/p"}), "no/p");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", s.answers("1"), "--proofs", s.answers("1")}),
                "different names");
  check_refused(mdm({"batch", s.suite, "--shard", "1/2", "-o", s.suite}), "different names");
  CHECK(s.folder.entries() == 1);
}

TEST_CASE("a full disk ends a shard with a message, and what was complete stays", "[cli]") {
  const ShardFolder s(suite_lines(500));
  const Outcome outcome = with_small_disk(s.words(1, 1));
  check_refused(outcome, "cannot be written");
  CHECK(s.folder.entries() == 1);
  CHECK(s.solve(1, 1).exit_code == 0);
  const auto before = s.contents();
  check_refused(with_small_disk(s.words(1, 1, {"--at-least", "3"})), "cannot be written");
  CHECK(s.contents() == before);
}

TEST_CASE("two runs do not write one shard at once", "[cli]") {
  const ShardFolder s(good + "\n");
  const Arguments words = {"batch", "--shard", "1/1", "-o", s.answers("1")};
  Process first(MDM_PROGRAM, words);
  while (!std::filesystem::exists(s.answers("1") + ".lock"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  // The lock is taken a moment after its file is there: whoever is second is refused.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  check_refused(s.solve(1, 1), "another run writes these files");
  first.send(good + "\n");
  CHECK(first.end().exit_code == 0);
  CHECK(ids(read_file(s.answers("1"))) == "1");
  CHECK(s.folder.entries() == 3);
}

TEST_CASE("shards that are killed at random leave nothing that looks complete, and lose nothing", "[cli]") {
  const ShardFolder s(suite_lines(2750, 2));
  s.solve_whole();
  std::mt19937 random(19);
  constexpr int shards = 3;
  for (int kill = 0; kill < 10; ++kill) {
    const int shard = kill % shards + 1;
    const std::string name = std::to_string(shard);
    Process run(MDM_PROGRAM, s.words(shard, shards));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 150));
    run.signal(SIGKILL);
    run.end();
    if (std::filesystem::exists(s.totals(name)))
      CHECK(s.solve(shard, shards).err.find("complete already") != std::string::npos);
    else
      check_refused(s.merge({1, 2, 3}));
  }
  s.solve_all(shards);
  CHECK(s.merge({1, 2, 3}).exit_code == 0);
  s.check_merged();
  CHECK(s.folder.entries() ==
        1 + 3 + 4 * 3 + 4); // suite, whole, shards, merged: nothing is left of the killed
}

} // namespace shard_test

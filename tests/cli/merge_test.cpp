// mdm merge: shards become what batch without --shard writes, or are refused.

#include "shards.hpp"

#include <nlohmann/json.hpp>

namespace merge_test {

using namespace cli_test;
using Json = nlohmann::json;

namespace {

const std::string good = R"({"id":"good","sizes":["1","2","3"],"masses":["2","1","0"]})";
const std::string slow = R"({"sizes":["1","1.000001","1.000002","1.000003"],"masses":["7","11","13","0"]})";

/// Good lines, bad ones, blank ones, and one that stops at the limit.
std::string mixed_lines() {
  return suite_lines(40) + "\nnonsense\n" + good + "\n  \n\n" + slow + "\n" + suite_lines(40) + "{}\n" + slow;
}

const Arguments limit = {"--max-steps", "1000"};

/// The lines of a shard, without blank ones among them all.
std::string part_of(const std::string &lines, int shard, int of) {
  std::string own;
  int number = 0;
  for (const std::string &line : lines_of(lines))
    if (number++ % of == shard - 1)
      own += line + "\n";
  return own;
}

/// Solves a shard of lines that come alone, by a pipe.
Outcome solve_alone(const ShardFolder &s, int shard, int of, const std::string &lines) {
  Arguments words = s.words(shard, of, {"--alone"});
  words[1] = "-";
  return mdm(words, lines);
}

void change_byte(const std::string &path, std::size_t at) {
  std::string text = read_file(path);
  text.at(at) ^= 1;
  std::ofstream(path, std::ios::binary) << text;
}

} // namespace

TEST_CASE("merged shards are byte for byte what batch writes without them", "[cli]") {
  for (const char *ending : {"", ".zst"}) {
    const ShardFolder s(mixed_lines(), ending);
    s.solve_whole(limit);
    for (const int of : {1, 2, 7}) {
      s.solve_all(of, limit);
      std::vector<int> shards;
      for (int shard = of; shard >= 1; --shard)
        shards.push_back(shard);
      const Outcome outcome = s.merge(shards);
      INFO(outcome.err);
      CHECK(outcome.exit_code == 0);
      CHECK(outcome.out.empty());
      CHECK(outcome.err.empty());
      s.check_merged();
    }
  }
}

TEST_CASE("more shards than lines are merged, too", "[cli]") {
  const ShardFolder s(good + "\n\n" + good);
  s.solve_whole();
  s.solve_all(5);
  CHECK(s.merge({5, 4, 3, 2, 1}).exit_code == 0);
  s.check_merged();
}

TEST_CASE("shards whose lines come alone are those of the whole suite", "[cli]") {
  const std::string lines =
      suite_lines(30) + "nonsense\n" + R"({"sizes":[1,2],"masses":[1,0]})" + "\n" + slow + "\n";
  const ShardFolder s(lines);
  CHECK(mdm({"batch", "-o", s.answers("whole"), "--proofs", s.proofs("whole")}, lines).exit_code == 2);
  for (int shard = 1; shard <= 4; ++shard)
    CHECK(solve_alone(s, shard, 4, part_of(lines, shard, 4)).signal == 0);
  check_refused(s.merge({1, 2, 3, 4}),
                "do not say which suite they are of: name the whole suite with --suite");
  CHECK(s.merge({1, 2, 3, 4}, {"--suite", s.suite}).exit_code == 0);
  s.check_merged();
  CHECK(Json::parse(read_file(s.totals("merged"))).at("suite").at("bytes") == std::to_string(lines.size()));
  CHECK_FALSE(Json::parse(read_file(s.totals("merged"))).contains("alone"));
  check_refused(s.merge({1, 2, 3, 4}, {"--suite", s.folder.write("other.jsonl", lines + good)}),
                "the suite of --suite does not have there");
  check_refused(s.merge({1, 2, 3, 4}, {"--suite", s.folder / "missing.jsonl"}), "missing.jsonl");
  check_refused(mdm({"batch", "--alone", s.suite}), "--alone: ");
}

TEST_CASE("a shard that was alone stands beside others of its suite, and of no other", "[cli]") {
  const std::string lines = suite_lines(31);
  const ShardFolder s(lines);
  s.solve_whole();
  CHECK(s.solve(1, 3).exit_code == 0);
  CHECK(s.solve(3, 3).exit_code == 0);
  CHECK(solve_alone(s, 2, 3, part_of(lines, 2, 3)).exit_code == 0);
  CHECK(s.merge({1, 2, 3}).exit_code == 0);
  s.check_merged();
  CHECK(Json::parse(read_file(s.totals("merged"))).at("suite") ==
        Json::parse(read_file(s.totals("1"))).at("suite"));
  for (const std::string &other : {part_of(lines, 3, 3), part_of(suite_lines(62), 2, 6)}) {
    CHECK(solve_alone(s, 2, 3, other).exit_code == 0);
    check_refused(s.merge({1, 2, 3}), "of the shards that were solved alone ('" + s.answers("2") + "')");
  }
  CHECK(solve_alone(s, 2, 3, good + "\n").exit_code == 0);
  check_refused(s.merge({1, 2, 3}), "shard 2/3 has 1 lines, and 1/3 11: of one suite that cannot be: solve "
                                    "shard 2/3 again, with all of its lines");
}

TEST_CASE("a suite that is made shard by shard has the answers of the whole", "[cli]") {
  const ShardFolder s("");
  const std::string description = s.folder.write(
      "some.json", R"({"schema":"mdm-suite-1","sieves":{"series":"ISO R20/3","from":0.063,"to":31.5},)"
                   R"("classes":[4,9],"masses":{"kind":"random"}})");
  const auto made = [&](const Arguments &more) {
    Arguments words = {"suite", description, "--count", "50"};
    words.insert(words.end(), more.begin(), more.end());
    return mdm(words).out;
  };
  s.folder.write("suite.jsonl", made({}));
  s.solve_whole();
  for (int shard = 1; shard <= 3; ++shard) {
    const std::string which = std::to_string(shard) + "/3";
    CHECK(solve_alone(s, shard, 3, made({"--shard", which})).exit_code == 0);
    CHECK(solve_alone(s, shard, 3, made({"--shard", which})).err.find("complete already") !=
          std::string::npos);
  }
  CHECK(s.merge({1, 2, 3}).exit_code == 0);
  s.check_merged();
  CHECK(lines_of(read_file(s.answers("merged"))).size() == 50);
  CHECK(Process(MDM_CHECK_PROGRAM, {"--suite", s.suite, s.proofs("merged")}).end().exit_code == 0);
}

TEST_CASE("shards of suites that were made of other things are not joined", "[cli]") {
  const ShardFolder s("");
  const std::string kind =
      R"({"schema":"mdm-suite-1","classes":4,"sieves":{"from":1,"ratio":2},"masses":{"kind":)";
  const auto made = [&](const std::string &masses, const Arguments &more) {
    Arguments words = {"suite", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return mdm(words, kind + masses).out;
  };
  const std::string random = R"("random"}})";
  const Arguments second = {"--count", "10", "--shard", "2/2"};
  CHECK(solve_alone(s, 1, 2, made(random, {"--count", "10", "--shard", "1/2"})).exit_code == 0);
  CHECK(solve_alone(s, 2, 2, made(random, second)).exit_code == 0);
  CHECK(s.merge({1, 2}).exit_code == 0);
  CHECK(Json::parse(read_file(s.totals("merged"))).at("made").at("to") == "10");
  for (const std::string &other :
       {made(random, {"--count", "10", "--shard", "2/2", "--seed", "2"}), made(R"("ties"}})", second),
        made(random, {"--count", "11", "--shard", "2/2"})}) {
    CHECK(solve_alone(s, 2, 2, other).exit_code == 0);
    check_refused(s.merge({1, 2}), "(description, seed and lines)");
  }
  const std::string lines = made(random, second);
  const auto refused = [&](const std::string &text, const std::string &why) {
    const auto before = s.contents();
    check_refused(solve_alone(s, 2, 2, text), why);
    CHECK(s.contents() == before);
  };
  refused(lines.substr(0, lines.rfind('{')), "there are 4 lines, and its first line says 5");
  refused(lines + good + "\n", "there are 6 lines, and its first line says 5");
  refused(made(random, {"--count", "10", "--shard", "1/2"}), "those of shard 1/2, and --shard is 2/2");
  refused(R"({"schema":"mdm-shard-9"})", "is not mdm-shard-1");
  check_refused(mdm({"batch", "-", "-o", s.answers("2")}, lines), "give --shard 2/2 --alone");
}

TEST_CASE("the totals of a merged set are those of one shard of all", "[cli]") {
  const ShardFolder s(mixed_lines());
  s.solve_all(3, limit);
  CHECK(s.merge({1, 2, 3}).exit_code == 0);
  const std::string merged = read_file(s.totals("merged"));
  CHECK(mdm({"batch", s.suite, "--shard", "1/1", "-o", s.answers("merged"), "--proofs", s.proofs("merged"),
             "--max-steps", "1000"})
            .err.find("complete already") != std::string::npos);
  std::filesystem::remove(s.totals("merged"));
  CHECK(mdm({"batch", s.suite, "--shard", "1/1", "-o", s.answers("merged"), "--proofs", s.proofs("merged"),
             "--max-steps", "1000"})
            .exit_code == 2);
  CHECK(read_file(s.totals("merged")) == merged);
  const Json totals = Json::parse(merged);
  CHECK(totals.at("lines") == "85");
  CHECK(totals.at("errors") == "2");
}

TEST_CASE("answers alone are merged where proofs are not asked for", "[cli]") {
  const ShardFolder s(mixed_lines());
  s.solve_all(2, limit);
  s.solve_whole(limit);
  CHECK(mdm({"merge", s.answers("2"), s.answers("1"), "-o", s.answers("merged")}).exit_code == 0);
  CHECK(read_file(s.answers("merged")) == read_file(s.answers("whole")));
  CHECK_FALSE(Json::parse(read_file(s.totals("merged"))).contains("proofs"));
}

TEST_CASE("gaps, overlaps and strangers are refused", "[cli]") {
  const ShardFolder s(mixed_lines());
  s.solve_all(3, limit);
  const auto before = s.contents();
  check_refused(s.merge({1, 3}), "shard 2/3 is missing");
  check_refused(s.merge({2, 3}), "shard 1/3 is missing");
  check_refused(s.merge({1, 2}), "shard 3/3 is missing");
  check_refused(s.merge({1, 2, 3, 2}), "shard 2/3 is there already");
  check_refused(mdm({"merge", s.suite, "-o", s.answers("merged")}), "suite.jsonl.totals: cannot be read");
  check_refused(mdm({"merge", s.answers("9"), "-o", s.answers("merged")}), "9.jsonl: cannot be read");
  check_refused(mdm({"merge", s.answers("1")}), "-o");
  check_refused(mdm({"merge", "-o", s.answers("merged")}), "FILE");
  check_refused(mdm({"merge", s.answers("1"), s.answers("2"), s.answers("3"), "-o", "-"}),
                "name a file with -o");
  check_refused(mdm({"merge", s.answers("1"), s.answers("2"), s.answers("3"), "-o", s.answers("2")}),
                "different names");
  check_refused(mdm({"merge", s.answers("1"), s.answers("2"), s.answers("3"), "-o", s.answers("merged"),
                     "--proofs", s.proofs("1")}),
                "different names");
  CHECK(s.contents() == before);
}

TEST_CASE("mixtures of questions, versions, suites and numbers of shards are refused", "[cli]") {
  const ShardFolder s(mixed_lines());
  const auto refused = [&s](const std::string &message) {
    check_refused(s.merge({1, 2}), message);
    CHECK_FALSE(std::filesystem::exists(s.answers("merged")));
  };
  s.solve_all(2, limit);
  CHECK(s.merge({1, 2}).exit_code == 0);
  std::filesystem::remove(s.answers("merged"));
  s.solve(2, 2, {"--max-steps", "1001"});
  refused("the question is '--max-steps 1001'");
  s.solve(2, 3, limit);
  refused("shard 2/3, where 1/2 is of");
  s.folder.write("suite.jsonl", mixed_lines() + "\n");
  s.solve(2, 2, limit);
  refused("the suite is not that of");
  s.folder.write("suite.jsonl", mixed_lines());
  s.solve(2, 2, limit);
  std::string totals = read_file(s.totals("2"));
  const std::string gmp = "\"gmp\":\"";
  totals.replace(totals.find(gmp), gmp.size(), gmp + "9.");
  s.folder.write("2.jsonl.totals", totals);
  refused("the versions of the program and its libraries are not those of");
  CHECK(mdm({"batch", s.suite, "--shard", "2/2", "-o", s.answers("2"), "--max-steps", "1000"}).exit_code ==
        2);
  refused("there are no proofs, and there are of");
}

TEST_CASE("a band counts by what it holds", "[cli]") {
  const ShardFolder s(good + "\n" + good + "\n");
  const std::string band =
      s.folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n2,60,70\n");
  CHECK(s.solve(1, 2, {"--band", band}).exit_code == 0);
  s.folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n2,60,71\n");
  CHECK(s.solve(2, 2, {"--band", band}).exit_code == 0);
  check_refused(s.merge({1, 2}), "the question is '--band sha256:");
}

TEST_CASE("a file that is not what its totals say is refused", "[cli]") {
  const ShardFolder s(mixed_lines());
  s.solve_all(2, limit);
  const auto spoiled = [&s](const std::string &path, const std::function<void()> &spoil,
                            const std::string &message) {
    const std::string before = read_file(path);
    spoil();
    check_refused(s.merge({1, 2}), message);
    std::ofstream(path, std::ios::binary) << before;
    CHECK_FALSE(std::filesystem::exists(s.answers("merged")));
    CHECK_FALSE(std::filesystem::exists(s.proofs("merged")));
  };
  for (const std::string &path : {s.answers("2"), s.proofs("2"), s.proofs("2") + ".index"}) {
    for (const std::size_t at : {std::size_t{0}, std::size_t{30}, std::size_t{100}})
      spoiled(
          path, [&] { change_byte(path, at); }, "it is not the file that its totals were written of");
    spoiled(
        path, [&] { std::filesystem::resize_file(path, 50); }, "50 bytes, where its totals have ");
    spoiled(
        path, [&] { std::ofstream(path, std::ios::app) << "more\n"; }, " bytes, where its totals have ");
    spoiled(
        path, [&] { std::filesystem::remove(path); }, "cannot be read");
  }
  const std::string totals = s.totals("2");
  spoiled(
      totals, [&] { s.folder.write("2.jsonl.totals", "{}"); }, "schema is missing");
  spoiled(
      totals, [&] { s.folder.write("2.jsonl.totals", ""); }, "2.jsonl.totals: ");
  spoiled(
      totals, [&] { s.folder.write("2.jsonl.totals", "{\"schema\":\"mdm-answer-1\"}"); },
      "is not mdm-totals-1");
  for (const char *lines : {"0", "41", "43", "18446744073709551615"}) {
    std::string changed = read_file(totals);
    const std::string key = "\"lines\":\"";
    const std::size_t at = changed.find(key) + key.size();
    changed.replace(at, changed.find('"', at) - at, lines);
    spoiled(
        totals, [&] { s.folder.write("2.jsonl.totals", changed); }, "");
  }
  CHECK(s.merge({1, 2}).exit_code == 0);
}

TEST_CASE("more shards than files may be open are refused before any work", "[cli]") {
  const ShardFolder s(good + "\n");
  std::string files;
  for (int shard = 1; shard <= 10; ++shard) {
    CHECK(s.solve(shard, 10).exit_code == 0);
    files += " '" + s.answers(std::to_string(shard)) + "'";
  }
  const auto merge_with = [&](const std::string &setting) {
    return Process("/bin/sh", {"-c", setting + "; exec '" MDM_PROGRAM "' merge -o '" + s.answers("merged") +
                                         "'" + files})
        .end();
  };
  check_refused(merge_with("ulimit -n 39"), "10 shards are up to 40 open files, and the system allows 39");
  CHECK_FALSE(std::filesystem::exists(s.answers("merged")));
  CHECK(merge_with("ulimit -S -n 20").exit_code == 0); // what the system allows is used
}

TEST_CASE("merged proofs are accepted with the suite", "[cli]") {
  const ShardFolder s(suite_lines(100), ".zst");
  s.solve_all(3);
  CHECK(s.merge({1, 2, 3}).exit_code == 0);
  const Outcome checked =
      Process(MDM_CHECK_PROGRAM, {"--suite", s.suite, s.proofs("merged"), "-j", "2"}).end();
  CHECK(checked.exit_code == 0);
  CHECK(checked.out.find(": 100 accepted, 0 refused, 0 malformed, 0 missing; 100 accepted as the smallest") !=
        std::string::npos);
}

#if !MDM_IS_SANITIZED
TEST_CASE("memory of a shard and of a merge does not grow with the number of lines", "[cli]") {
  const auto most_kib = [](int times) {
    const ShardFolder s(suite_lines(2750, times));
    s.solve_all(2, {"--quiet"});
    const Outcome shard = s.solve(1, 2, {"--digits", "16"}), merged = [&s] {
      s.solve(1, 2);
      return s.merge({1, 2});
    }();
    CHECK(merged.exit_code == 0);
    return std::pair(shard.max_rss_kib, merged.max_rss_kib);
  };
  const auto [few_shard, few_merged] = most_kib(1);
  const auto [many_shard, many_merged] = most_kib(12);
  CHECK(many_shard < few_shard + 8 * 1024);
  CHECK(many_merged < few_merged + 4 * 1024);
}
#endif

} // namespace merge_test

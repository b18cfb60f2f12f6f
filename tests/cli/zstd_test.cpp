// Files whose names end in .zst: what mdm writes zstd unpacks, what zstd writes mdm reads, in bounded memory.

#include "run.hpp"
#include "tools.hpp"

namespace zstd_test {

using namespace cli_test;

namespace {

const std::string good = R"({"id":"good","sizes":["1","2","3"],"masses":["2","1","0"]})";

bool has_zstd() {
  return mdm_test::has_tool("zstd", "zstd");
}

/// Runs a command of sh and checks that it succeeds.
std::string shell(const std::string &command) {
  const Outcome outcome = Process("/bin/sh", {"-c", command}).end();
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  return outcome.out;
}

} // namespace

TEST_CASE("answers and proofs that end in .zst are those without, compressed", "[cli]") {
  if (!has_zstd())
    return;
  const TemporaryFolder folder;
  const std::string suite = MDM_SUITE;
  for (const std::string ending : {"", ".zst"})
    CHECK(mdm({"batch", suite, "-o", folder / "a.jsonl" + ending, "--proofs", folder / "a.proofs" + ending})
              .exit_code == 0);
  for (const std::string file : {"a.jsonl", "a.proofs"}) {
    CHECK(shell("zstd -dc " + folder / file + ".zst") == read_file(folder / file));
    CHECK(3 * std::filesystem::file_size(folder / file + ".zst") < std::filesystem::file_size(folder / file));
  }
  CHECK(read_file(folder / "a.proofs.index") == read_file(folder / "a.proofs.zst.index"));
  CHECK(mdm({"crosscheck", suite, folder / "a.jsonl.zst"}).out.size() ==
        mdm({"crosscheck", suite, folder / "a.jsonl"}).out.size());
  CHECK(mdm({"batch", "-o", folder / "a.csv.zst"}, good).exit_code == 0);
  CHECK(shell("zstd -dc " + folder / "a.csv.zst").starts_with("id,class,lower_mm"));
}

TEST_CASE("a suite that zstd wrote is read, in several frames too", "[cli]") {
  if (!has_zstd())
    return;
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", good + "\n" + good + "\n");
  shell("zstd -q -19 " + suite + " && cat " + suite + ".zst " + suite + ".zst > " + folder / "two.jsonl.zst");
  CHECK(mdm({"batch", suite + ".zst"}).out == mdm({"batch", suite}).out);
  CHECK(mdm({"batch", folder / "two.jsonl.zst"}).out == mdm({"batch", suite, suite}).out);
  CHECK(mdm({"batch", suite + ".zst", "--proofs", folder / "a.proofs"}).exit_code == 0);
  CHECK(Process(MDM_CHECK_PROGRAM, {"--suite", suite + ".zst", folder / "a.proofs"}).end().exit_code == 0);
}

TEST_CASE("a journal is not compressed", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", good + "\n");
  check_refused(mdm({"crosscheck", suite, "--solver", "true", "--journal", folder / "a.zst"}),
                "without .zst");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is not compressed, or cut short, is refused with its name", "[cli]") {
  if (!has_zstd())
    return;
  const TemporaryFolder folder;
  check_refused(mdm({"batch", folder.write("none.jsonl.zst", good)}), "none.jsonl.zst: cannot be unpacked: ");
  check_refused(mdm({"batch", folder.write("empty.jsonl.zst", "")}), "empty.jsonl.zst: cannot be unpacked: ");
  const std::string suite = MDM_SUITE, packed = folder / "suite.jsonl.zst";
  shell("zstd -q -c '" + suite + "' > " + packed);
  const std::string whole = read_file(packed);
  for (const std::size_t bytes : {std::size_t{3}, whole.size() / 2, whole.size() - 1}) {
    folder.write("suite.jsonl.zst", whole.substr(0, bytes));
    check_refused(mdm({"batch", packed, "-o", folder / "answers"}), "suite.jsonl.zst: cannot be unpacked: ");
    CHECK_FALSE(std::filesystem::exists(folder / "answers"));
  }
  std::string changed = whole;
  changed[whole.size() / 2] ^= 1;
  folder.write("suite.jsonl.zst", changed);
  check_refused(mdm({"batch", packed, "-o", folder / "answers"}), "suite.jsonl.zst: cannot be unpacked: ");
}

TEST_CASE("a compressed stream of proofs with a changed byte, or cut short, is not accepted", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = MDM_SUITE, proofs = folder / "a.proofs.zst";
  CHECK(mdm({"batch", suite, "-o", folder / "answers", "--proofs", proofs}).exit_code == 0);
  const std::string whole = read_file(proofs);
  const auto check = [&](const std::string &text) {
    folder.write("a.proofs.zst", text);
    return Process(MDM_CHECK_PROGRAM, {"--suite", suite, proofs, "-j", "2"}).end();
  };
  CHECK(check(whole).exit_code == 0);
  for (std::size_t at = 1000; at < whole.size(); at += whole.size() / 10) {
    std::string changed = whole;
    changed[at] ^= 1;
    CHECK(check(changed).exit_code != 0);
  }
  const Outcome cut = check(whole.substr(0, whole.size() / 2));
  CHECK(cut.exit_code == 2);
  CHECK(cut.out.find("malformed: " + proofs + ": cannot be unpacked: it ends too early") !=
        std::string::npos);
  CHECK(cut.out.find(" 1 malformed,") != std::string::npos);
  CHECK(check(whole + "x").exit_code == 2);
}

#if !MDM_IS_SANITIZED
TEST_CASE("a file that unpacks to gigabytes takes no gigabytes", "[cli]") {
  if (!has_zstd())
    return;
  const TemporaryFolder folder;
  const std::string bomb = folder / "bomb.jsonl.zst", one = folder.write("one.jsonl", good + "\n");
  shell("(cat " + one + " " + one + "; head -c 2000000000 /dev/zero) | zstd -q -c > " + bomb);
  REQUIRE(std::filesystem::file_size(bomb) < 1'000'000);
  const long most_kib = 200 * 1024;
  const Outcome batch = mdm({"batch", bomb});
  CHECK(batch.exit_code == 2);
  CHECK(lines_of(batch.out).size() == 3);
  CHECK(batch.out.find("the line has more than 64 MiB") != std::string::npos);
  CHECK(batch.max_rss_kib < most_kib);
  const Outcome solve = mdm({"solve", bomb});
  check_refused(solve, "more than 64 MiB");
  CHECK(solve.max_rss_kib < most_kib);
  CHECK(mdm({"batch", one, "--proofs", folder / "a.proofs"}).exit_code == 0);
  const Outcome suite = Process(MDM_CHECK_PROGRAM, {"--suite", bomb, folder / "a.proofs"}).end();
  CHECK(suite.exit_code == 2);
  CHECK(suite.max_rss_kib < most_kib);
  shell("cp " + bomb + " " + folder / "b.proofs.zst && cp " + folder / "a.proofs.index " +
        folder / "b.proofs.zst.index");
  const Outcome proofs = Process(MDM_CHECK_PROGRAM, {"--suite", one, folder / "b.proofs.zst"}).end();
  CHECK(proofs.exit_code == 2);
  CHECK(proofs.max_rss_kib < most_kib);
}
#endif

} // namespace zstd_test

#pragma once
/// \file
/// Shards of a suite, solved by mdm batch --shard.

#include "run.hpp"

#include <map>

namespace cli_test {

/// The first lines of the suite of tests/data, so often one after the other.
inline std::string suite_lines(std::size_t lines, int times = 1) {
  std::ifstream file(MDM_SUITE);
  std::string once, all;
  for (std::string line; lines > 0 && std::getline(file, line); --lines)
    once += line + "\n";
  for (int i = 0; i < times; ++i)
    all += once;
  return all;
}

/// A folder with a suite and what is made of it.
struct ShardFolder {
  TemporaryFolder folder;
  std::string suite;
  std::string ending; ///< of all other files: nothing or .zst

  explicit ShardFolder(const std::string &lines, std::string names_end = "")
      : suite(folder.write("suite.jsonl", lines)), ending(std::move(names_end)) {}

  std::string answers(const std::string &name) const { return folder / (name + ".jsonl" + ending); }
  std::string proofs(const std::string &name) const { return folder / (name + ".proofs" + ending); }
  std::string totals(const std::string &name) const { return answers(name) + ".totals"; }

  Arguments words(int shard, int of, const Arguments &more = {}) const {
    const std::string name = std::to_string(shard);
    Arguments all = {"batch", suite,         "--shard",  name + "/" + std::to_string(of),
                     "-o",    answers(name), "--proofs", proofs(name)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome solve(int shard, int of, const Arguments &more = {}) const { return mdm(words(shard, of, more)); }
  void solve_all(int of, const Arguments &more = {}) const {
    for (int shard = of; shard >= 1; --shard) // in any order
      CHECK(solve(shard, of, more).signal == 0);
  }
  Outcome merge(const std::vector<int> &shards, const Arguments &more = {}) const {
    Arguments all = {"merge", "-o", answers("merged"), "--proofs", proofs("merged")};
    for (const int shard : shards)
      all.push_back(answers(std::to_string(shard)));
    all.insert(all.end(), more.begin(), more.end());
    return mdm(all);
  }
  /// What batch without --shard writes: `whole`.
  void solve_whole(const Arguments &more = {}) const {
    Arguments all = {"batch", suite, "-o", answers("whole"), "--proofs", proofs("whole")};
    all.insert(all.end(), more.begin(), more.end());
    CHECK(mdm(all).signal == 0);
  }
  /// The merged files are those of `whole`.
  void check_merged() const {
    CHECK(read_file(answers("merged")) == read_file(answers("whole")));
    CHECK(read_file(proofs("merged")) == read_file(proofs("whole")));
    CHECK(read_file(proofs("merged") + ".index") == read_file(proofs("whole") + ".index"));
  }
  /// All files by name.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const auto &entry : std::filesystem::directory_iterator(folder.path()))
      all[entry.path().filename().string()] = read_file(entry.path());
    return all;
  }
};

} // namespace cli_test

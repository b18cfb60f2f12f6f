#include "ask/shards.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "files/counted_files.hpp"
#include "files/file_totals.hpp"
#include "files/joined_parts.hpp"
#include "files/open_files.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct MergeCommand {
  std::vector<std::string> files;
  std::optional<std::string> proofs, suite;
  OutputFlags output;
};

std::string proofs_of(const AnsweredShard &shard) {
  return path_beside(shard.answers, *shard.totals.proofs);
}

std::string index_of(const AnsweredShard &shard) {
  return path_beside(shard.answers, *shard.totals.index);
}

/// The shards in order.
std::vector<AnsweredShard> read_shards(const MergeCommand &c) {
  std::vector<AnsweredShard> shards;
  for (const std::string &file : c.files) {
    check_readable(file);
    shards.push_back({file, read_totals_of(file)});
    check_same(shards.front(), shards.back());
  }
  std::stable_sort(shards.begin(), shards.end(), [](const AnsweredShard &a, const AnsweredShard &b) {
    return a.totals.shard < b.totals.shard;
  });
  check_set(shards);
  for (const AnsweredShard &shard : shards) {
    check_bytes({shard.answers, shard.totals.answers});
    if (!c.proofs)
      continue;
    if (!shard.totals.proofs)
      throw file_error(shard.answers, "there are no proofs of this shard: leave out " + option("proofs"));
    check_bytes({proofs_of(shard), *shard.totals.proofs});
    check_bytes({index_of(shard), *shard.totals.index});
  }
  return shards;
}

std::vector<PartFile> answers_of(const std::vector<AnsweredShard> &shards) {
  std::vector<PartFile> files;
  for (const AnsweredShard &shard : shards)
    files.push_back({shard.answers, shard.totals.answers});
  return files;
}

std::vector<ProofFiles> proofs_of(const std::vector<AnsweredShard> &shards) {
  std::vector<ProofFiles> files;
  for (const AnsweredShard &shard : shards)
    files.push_back({{proofs_of(shard), *shard.totals.proofs}, {index_of(shard), *shard.totals.index}});
  return files;
}

void check_names(const MergeCommand &c, const std::vector<AnsweredShard> &shards) {
  std::vector<std::string> names = {c.output.path(), totals_path(c.output.path())};
  if (c.suite)
    names.push_back(*c.suite);
  if (c.proofs)
    names.insert(names.end(), {*c.proofs, proof_index_path(*c.proofs)});
  for (const AnsweredShard &shard : shards) {
    names.push_back(shard.answers);
    names.push_back(totals_path(shard.answers));
    if (shard.totals.proofs)
      names.insert(names.end(), {proofs_of(shard), index_of(shard)});
  }
  check_distinct(names);
}

int run(const MergeCommand &c) {
  const std::vector<AnsweredShard> shards = read_shards(c);
  check_names(c, shards);
  const std::optional<SuiteTotals> suite =
      suite_of(shards, c.suite ? std::optional(suite_totals(*c.suite)) : std::nullopt);
  allow_open_files(shards.size());
  CountedFiles files(c.output.path(), c.proofs);
  files.open();
  std::atomic<std::uint64_t> count = 0;
  ProgressLine progress([&count] { return fmt::format("{} answers", count.load()); }, c.output.quiet);
  Totals totals = sum(shards, suite);
  const Sink answers = [&files](std::string_view text) { files.answers().write(text); };
  join_lines(answers_of(shards), totals.lines, answers, [&count] { ++count; });
  if (c.proofs)
    join_proofs(proofs_of(shards), *files.proofs());
  for (const AnsweredShard &shard : shards)
    totals.exit = worse_exit(totals.exit, shard.totals.exit);
  files.commit(totals);
  return Exit::done;
}

} // namespace

Run add_merge(CLI::App &app) {
  const auto c = std::make_shared<MergeCommand>();
  CLI::App &command = *app.add_subcommand("merge", "Joins the shards of mdm batch --shard");
  command
      .add_option("FILE", c->files, "the answers of all shards, in any order; their totals stand beside them")
      ->required();
  c->output.out_has_report = false;
  c->output.check_ending_of_out(command, {"jsonl", "ndjson", "json", "txt"});
  command.add_option("-o", c->output.out, "write to OUT, and its totals to OUT.totals")
      ->type_name("OUT")
      ->required();
  command
      .add_option("--proofs", c->proofs, "join the proofs, too, to the stream NAME with the index NAME.index")
      ->type_name("NAME");
  command
      .add_option("--suite", c->suite,
                  "the whole suite, - for standard input: lines that came alone are compared with it")
      ->type_name("SUITE");
  c->output.add_quiet(command, "no progress on standard error");
  command.footer(footer(
      paragraph(
          "OUT is, byte for byte, what mdm batch without --shard writes, and so is the stream of proofs; "
          "OUT.totals are those of the set. Gaps, overlaps, mixtures of suites, questions and versions, "
          "and files that are not what their totals say are refused; so are shards of --alone that neither "
          "say which suite they are of nor stand beside others, without --suite. What ends in .zst is read "
          "and "
          "written compressed."),
      {"mdm merge shards/*.jsonl -o answers.jsonl --proofs all.proofs"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

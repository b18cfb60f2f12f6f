#include "ask/shards.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "files/counted_files.hpp"
#include "files/counted_part.hpp"
#include "files/line_hash.hpp"
#include "files/paths.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <queue>

namespace mdm::cli {
namespace {

constexpr const char *again_remedy = ": solve the shard again";

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

/// The suite in a file, as a shard that is not alone tells it.
SuiteTotals suite_in(const std::string &path) {
  FileLines lines(path);
  lines.bytes().keep_digest();
  LineHash hash;
  LineSum sum;
  std::uint64_t number = 0;
  for (std::vector<FileLines::Line> some = lines.next(512); !some.empty(); some = lines.next(512))
    for (const FileLines::Line &line : some)
      if (!FileLines::is_blank(line))
        sum.add(hash.of(++number, line));
  return {{lines.bytes().digest().bytes(), lines.bytes().digest().sha256()}, sum};
}

/// Refuses a file that is not as long as its totals say, before any work is done.
void check_bytes(const std::string &path, const NamedFileTotals &file) {
  check_readable(path);
  if (const std::optional<std::uint64_t> bytes = file_bytes(path); bytes != file.bytes)
    throw file_error(path, fmt::format("{} bytes, where its totals have {}", bytes.value_or(0), file.bytes) +
                               again_remedy);
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
    check_bytes(shard.answers, shard.totals.answers);
    if (!c.proofs)
      continue;
    if (!shard.totals.proofs)
      throw file_error(shard.answers, "there are no proofs of this shard: leave out --proofs");
    check_bytes(proofs_of(shard), *shard.totals.proofs);
    check_bytes(index_of(shard), *shard.totals.index);
  }
  return shards;
}

/// The answers of shards take turns.
void merge_answers(const std::vector<AnsweredShard> &shards, Output &out, std::atomic<std::uint64_t> &count) {
  std::vector<std::unique_ptr<CountedPart>> parts;
  std::uint64_t lines = 0;
  for (const AnsweredShard &shard : shards) {
    parts.push_back(std::make_unique<CountedPart>(shard.answers, shard.totals.answers));
    lines += shard.totals.lines;
  }
  const Sink sink = [&out](std::string_view text) { out.write(text); };
  for (std::uint64_t i = 0; i < lines; ++i, ++count)
    parts[i % parts.size()]->line(sink);
  for (const std::unique_ptr<CountedPart> &part : parts)
    part->check_end();
}

/// Certificates come in the order of the lines that they are of.
void merge_proofs(const std::vector<AnsweredShard> &shards, ProofStream &out) {
  std::vector<std::unique_ptr<CountedProofs>> parts;
  using Next = std::pair<std::uint64_t, std::size_t>; // line and part
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  const auto add = [&](std::size_t part) {
    if (parts[part]->number() > 0)
      queue.emplace(parts[part]->number(), part);
  };
  for (const AnsweredShard &shard : shards) {
    parts.push_back(std::make_unique<CountedProofs>(proofs_of(shard), *shard.totals.proofs, index_of(shard),
                                                    *shard.totals.index));
    add(parts.size() - 1);
  }
  while (!queue.empty()) {
    const auto [number, part] = queue.top();
    queue.pop();
    out.add(number, parts[part]->take([&out](std::string_view text) { out.stream().write(text); }));
    add(part);
  }
  for (const std::unique_ptr<CountedProofs> &part : parts)
    part->check_end();
}

/// Of all shards two files are open at once. \throws InputError if the system lets no process have so many
void allow_open_files(std::size_t shards) {
  const rlim_t needed = 2 * shards + 20; // and those of the program itself
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= needed)
    return;
  if (limit.rlim_max < needed)
    throw InputError(
        fmt::format("mdm: {} shards are up to {} open files, and the system allows {}: raise it, as "
                    "with ulimit -n, or solve the suite in fewer shards",
                    shards, needed, limit.rlim_max));
  limit.rlim_cur = needed;
  setrlimit(RLIMIT_NOFILE, &limit);
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
      suite_of(shards, c.suite ? std::optional(suite_in(*c.suite)) : std::nullopt);
  allow_open_files(shards.size());
  CountedFiles files(c.output.path(), c.proofs);
  files.open();
  std::atomic<std::uint64_t> count = 0;
  Progress progress([&count] { return fmt::format("{} answers", count.load()); }, c.output.quiet);
  merge_answers(shards, files.answers(), count);
  if (c.proofs)
    merge_proofs(shards, *files.proofs());
  Totals totals = sum(shards, suite);
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

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "files/counted_files.hpp"
#include "files/counted_part.hpp"
#include "files/line_hash.hpp"
#include "files/paths.hpp"
#include "text/short_list.hpp"

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

/// A shard's answers, and what its totals say.
struct ShardFile {
  std::string answers;
  Totals totals;

  std::string name() const { return fmt::format("{}/{}", totals.shard, totals.shards); }
  std::string proofs() const { return path_beside(answers, *totals.proofs); }
  std::string index() const { return path_beside(answers, *totals.index); }
};

/// Refuses a shard that was not asked the same as the first.
void check_same(const ShardFile &first, const ShardFile &other) {
  const auto refuse = [&](const std::string &what) {
    throw file_error(other.answers, what + " " + printable(first.answers) + again_remedy);
  };
  if (other.totals.shards != first.totals.shards)
    refuse(fmt::format("shard {}, where {} is of", other.name(), first.name()));
  if (other.totals.question != first.totals.question)
    refuse(fmt::format("the question is {}, and {} that of", in_quotes(other.totals.question),
                       in_quotes(first.totals.question)));
  if (other.totals.versions != first.totals.versions)
    refuse("the versions of the program and its libraries are not those of");
  if (other.totals.proofs.has_value() != first.totals.proofs.has_value())
    refuse(other.totals.proofs ? "there are proofs, and none of" : "there are no proofs, and there are of");
}

/// Refuses a set that is not all shards, each once. \param shards by their numbers
void check_complete(const std::vector<ShardFile> &shards) {
  const std::uint64_t count = shards[0].totals.shards;
  std::uint64_t done = 0;
  const auto refuse_gap = [&] {
    throw InputError(
        fmt::format("mdm: shard {}/{} is missing: give the files of all, or solve it", done + 1, count));
  };
  for (const ShardFile &shard : shards) {
    if (shard.totals.shard == done)
      throw file_error(shard.answers, fmt::format("shard {} is there already, as {}: give each once",
                                                  shard.name(), printable(shards[done - 1].answers)));
    if (shard.totals.shard != done + 1)
      refuse_gap();
    ++done;
  }
  if (done < count)
    refuse_gap();
}

/// Refuses shards with too few lines: a shard has as many as the one before it, or one less than all before.
void check_line_counts(const std::vector<ShardFile> &shards) {
  const auto refuse = [](const ShardFile &few, const ShardFile &many) {
    throw file_error(
        few.answers,
        fmt::format("shard {} has {} lines, and {} {}: of one suite that cannot be: solve shard {} "
                    "again, with all of its lines",
                    few.name(), few.totals.lines, many.name(), many.totals.lines, few.name()));
  };
  for (std::size_t i = 1; i < shards.size(); ++i) {
    const std::uint64_t first = shards[0].totals.lines, before = shards[i - 1].totals.lines,
                        lines = shards[i].totals.lines;
    if (lines > before)
      refuse(shards[i - 1], shards[i]);
    if (lines < before && before < first)
      refuse(shards[i], shards[0]);
    if (lines < before && before - lines > 1)
      refuse(shards[i], shards[i - 1]);
  }
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

/// The names of the shards that came alone.
std::string alone_names(const std::vector<ShardFile> &shards) {
  ShortList names;
  for (const ShardFile &shard : shards)
    if (!shard.totals.suite)
      names.add(shard.answers);
  return names.text();
}

/// The suite that all shards are of; nothing where it is known by its making alone.
/// \param named that of --suite, or nothing
/// \throws InputError if they are of several, or it is not known that they are of one
std::optional<SuiteTotals> suite_of(const std::vector<ShardFile> &shards,
                                    const std::optional<SuiteTotals> &named) {
  const ShardFile *whole = nullptr;
  LineSum sum;
  for (const ShardFile &shard : shards) {
    sum.add(shard.totals.sum);
    if (!shard.totals.suite)
      continue;
    whole = whole ? whole : &shard;
    if (shard.totals.suite != whole->totals.suite)
      throw file_error(shard.answers, "the suite is not that of " + printable(whole->answers) + again_remedy);
    if (named && shard.totals.suite != named)
      throw file_error(shard.answers, std::string("the suite is not that of --suite") + again_remedy);
  }
  if (whole || named) {
    const SuiteTotals &suite = whole ? *whole->totals.suite : *named;
    if (sum != suite.sum)
      throw InputError("mdm: of the shards that were solved alone (" + alone_names(shards) +
                       ") one at least has lines that the suite of " +
                       (whole ? printable(whole->answers) : "--suite") +
                       " does not have there: solve them again, with the lines of that suite");
    return suite;
  }
  for (const ShardFile &shard : shards) {
    if (!shard.totals.made)
      throw file_error(shard.answers, "its lines came alone and do not say which suite they are of: name the "
                                      "whole suite with --suite");
    if (shard.totals.made != shards[0].totals.made)
      throw file_error(shard.answers, "the suite is not that of " + printable(shards[0].answers) +
                                          " (description, seed and lines)" + again_remedy);
  }
  return std::nullopt;
}

/// Refuses a file that is not as long as its totals say, before any work is done.
void check_bytes(const std::string &path, const NamedFileTotals &file) {
  check_readable(path);
  if (const std::optional<std::uint64_t> bytes = file_bytes(path); bytes != file.bytes)
    throw file_error(path, fmt::format("{} bytes, where its totals have {}", bytes.value_or(0), file.bytes) +
                               again_remedy);
}

/// The shards in order.
std::vector<ShardFile> read_shards(const MergeCommand &c) {
  std::vector<ShardFile> shards;
  for (const std::string &file : c.files) {
    check_readable(file);
    shards.push_back({file, read_totals_of(file)});
    check_same(shards.front(), shards.back());
  }
  std::stable_sort(shards.begin(), shards.end(),
                   [](const ShardFile &a, const ShardFile &b) { return a.totals.shard < b.totals.shard; });
  check_complete(shards);
  check_line_counts(shards);
  for (const ShardFile &shard : shards) {
    check_bytes(shard.answers, shard.totals.answers);
    if (!c.proofs)
      continue;
    if (!shard.totals.proofs)
      throw file_error(shard.answers, "there are no proofs of this shard: leave out --proofs");
    check_bytes(shard.proofs(), *shard.totals.proofs);
    check_bytes(shard.index(), *shard.totals.index);
  }
  return shards;
}

/// The answers of shards take turns.
void merge_answers(const std::vector<ShardFile> &shards, Output &out, std::atomic<std::uint64_t> &count) {
  std::vector<std::unique_ptr<CountedPart>> parts;
  std::uint64_t lines = 0;
  for (const ShardFile &shard : shards) {
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
void merge_proofs(const std::vector<ShardFile> &shards, ProofStream &out) {
  std::vector<std::unique_ptr<CountedProofs>> parts;
  using Next = std::pair<std::uint64_t, std::size_t>; // line and part
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
  const auto add = [&](std::size_t part) {
    if (parts[part]->number() > 0)
      queue.emplace(parts[part]->number(), part);
  };
  for (const ShardFile &shard : shards) {
    parts.push_back(std::make_unique<CountedProofs>(shard.proofs(), *shard.totals.proofs, shard.index(),
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

/// The totals of the set, without its files. \param suite where it was read
Totals sum(const std::vector<ShardFile> &shards, const std::optional<SuiteTotals> &suite) {
  Totals totals = shards[0].totals;
  totals.suite = suite;
  totals.alone.reset();
  if (suite)
    totals.made.reset();
  totals.shard = totals.shards = 1;
  totals.proofs.reset();
  totals.index.reset();
  for (std::size_t i = 1; i < shards.size(); ++i) {
    totals.sum.add(shards[i].totals.sum);
    totals.lines += shards[i].totals.lines;
    totals.errors += shards[i].totals.errors;
    totals.exit = worse_exit(totals.exit, shards[i].totals.exit);
  }
  return totals;
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

void check_names(const MergeCommand &c, const std::vector<ShardFile> &shards) {
  std::vector<std::string> names = {c.output.path(), totals_path(c.output.path())};
  if (c.suite)
    names.push_back(*c.suite);
  if (c.proofs)
    names.insert(names.end(), {*c.proofs, proof_index_path(*c.proofs)});
  for (const ShardFile &shard : shards) {
    names.push_back(shard.answers);
    names.push_back(totals_path(shard.answers));
    if (shard.totals.proofs)
      names.insert(names.end(), {shard.proofs(), shard.index()});
  }
  check_distinct(names);
}

int run(const MergeCommand &c) {
  const std::vector<ShardFile> shards = read_shards(c);
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
  files.commit(sum(shards, suite));
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

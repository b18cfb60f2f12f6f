#include "answer/batch_csv.hpp"
#include "answer/shard.hpp"
#include "ask/option_values.hpp"
#include "cli/batch_solver.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/interrupted.hpp"
#include "cli/whole_number.hpp"
#include "files/byte_source.hpp"
#include "files/counted_files.hpp"
#include "files/file_totals.hpp"
#include "files/in_parallel.hpp"
#include "files/interrupt.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/standard_streams.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

/// The answers to some gradations, by several threads, in order: those up to the first that was not begun
/// when Ctrl-C was pressed.
std::vector<BatchAnswer> answers(const BatchSolver &solver, const std::vector<BatchItem> &items,
                                 unsigned threads) {
  std::vector<BatchAnswer> found;
  in_order<BatchAnswer>(
      items.size(), threads, [&](std::size_t i) { return solver.answer(items[i]); },
      [&found](BatchAnswer &answer) { found.push_back(std::move(answer)); }, Interrupt::was_pressed);
  return found;
}

/// What is written of one answer after the other.
class BatchReport {
public:
  explicit BatchReport(const OutputFlags &flags) : flags_(flags) {}

  /// The text that the answer adds to the output; what standard error has is told.
  std::string add(const BatchAnswer &answer) {
    const bool fits = answer.unit.empty() || unit_.empty() || answer.unit == unit_;
    const int exit = fits ? answer.exit : Exit::bad_input;
    worst_ = worse_exit(worst_, exit);
    ++lines_;
    errors_ += exit == Exit::bad_input ? 1 : 0;
    if (!fits) {
      tell(fmt::format("{}: lengths in {}, where the table has {}: give it in a batch of its own, or write "
                       "--format json\n",
                       answer.id, answer.unit, unit_));
      return "";
    }
    if (exit != Exit::done || !flags_.quiet)
      tell(answer.told);
    const bool is_first = !answer.unit.empty() && unit_.empty();
    if (is_first)
      unit_ = answer.unit;
    return is_first ? batch_csv_header(unit_) + answer.text : answer.text;
  }

  int worst() const { return worst_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t errors() const { return errors_; }

private:
  const OutputFlags &flags_;
  std::string unit_; ///< of the table; empty before its first row
  int worst_ = Exit::done;
  std::uint64_t lines_ = 0, errors_ = 0;
};

bool reads_stdin(const BatchCommand &c) {
  return c.files.empty() || std::count(c.files.begin(), c.files.end(), "-") > 0;
}

void check_files(const BatchCommand &c) {
  check_paths(c.files, {c.output.path()});
  std::for_each(c.files.begin(), c.files.end(), check_readable);
  if (c.alone && !c.shard)
    throw InputError(option("alone") + ": it is of a shard: say with " + option("shard") + " which");
  if (reads_stdin(c) && c.flags.band == "-")
    throw InputError(option("band") + ": standard input has the gradations: give the band by name");
  if (c.has_proof_stream() && c.files.size() > 1)
    throw InputError(option("proofs") +
                     ": a stream of proofs is that of one suite: give one, or a folder for the proofs");
  if (c.has_proof_stream())
    check_distinct({c.files.empty() ? "-" : c.files[0], c.output.path(), *c.proofs,
                    proof_index_path(*c.proofs), totals_path(c.output.path())});
}

void check_shard(const BatchCommand &c) {
  if (!c.output.out)
    throw InputError(option("shard") + ": answers and totals are files: name the answers with -o");
  if (c.output.is_csv())
    throw InputError(option("shard") + ": the answers of shards are JSON Lines: leave out " +
                     option("format") + " csv and names in .csv");
  if (c.files.size() > 1)
    throw InputError(option("shard") + ": it is of one suite: give one");
  if (!c.files.empty())
    check_distinct({c.files[0], c.output.path(), totals_path(c.output.path())});
}

/// Solves what the sources have.
/// \param proofs null for none
/// \return false where Ctrl-C ended it before the last gradation
bool solve_all(const BatchCommand &c, const BatchSolver &solver, BatchSources &sources, Output &out,
               ProofStream *proofs, BatchReport &report) {
  std::atomic<std::uint64_t> count = 0;
  ProgressLine progress([&count] { return fmt::format("{} gradations", count.load()); }, c.output.quiet);
  constexpr std::size_t at_once = 512;
  for (std::vector<BatchItem> items = sources.next(at_once); !items.empty(); items = sources.next(at_once)) {
    std::string text;
    std::optional<Interrupt> interrupt;
    if (reads_stdin(c) && !c.shard) // where it waits for lines, Ctrl-C ends it at once
      interrupt.emplace();
    const std::vector<BatchAnswer> answered = answers(solver, items, c.threads);
    for (std::size_t i = 0; i < answered.size(); ++i) {
      text += report.add(answered[i]);
      if (proofs && !answered[i].certificate.empty())
        proofs->add(items[i].number, answered[i].certificate);
    }
    count += answered.size();
    out.write(text);
    if (answered.size() < items.size() || (interrupt && Interrupt::was_pressed()))
      return false;
  }
  return true;
}

/// The totals of a shard before it is solved.
Totals asked_totals(const BatchCommand &c, const Shard &shard) {
  Totals totals;
  totals.shard = shard.number;
  totals.shards = shard.count;
  totals.question = c.flags.words();
  totals.versions = {versions().begin(), versions().end()};
  return totals;
}

/// True if what an earlier run read is certainly what this one would: a file is known by its digest, lines
/// that mdm suite made by what they were made of. Of other pipes nothing is known before they are read.
bool is_same_input(const Totals &earlier, const BatchCommand &c, BatchSources &sources) {
  if (c.alone && sources.made())
    return earlier.made == sources.made();
  const std::optional<FileTotals> read = c.alone ? earlier.alone : std::optional<FileTotals>(earlier.suite);
  return read && !c.files.empty() && file_bytes(c.files[0]) == read->bytes && file_totals(c.files[0]) == read;
}

/// True if a run with these totals asked the same of the same lines.
bool is_same_run(const Totals &earlier, const Totals &asked, const BatchCommand &c, BatchSources &sources) {
  return earlier.shard == asked.shard && earlier.shards == asked.shards &&
         earlier.question == asked.question && earlier.versions == asked.versions &&
         is_same_input(earlier, c, sources);
}

int run_shard(const BatchCommand &c) {
  check_shard(c);
  const Shard shard = named("shard", *c.shard, parse_shard);
  const BatchSolver solver(c);
  Totals totals = asked_totals(c, shard);
  CountedFiles files(c.output.path(), c.proofs);
  BatchSources sources(c.files, c.reading.reading(), c.reading.given(), shard, c.alone);
  if (const std::optional<Totals> earlier = files.complete();
      earlier && is_same_run(*earlier, totals, c, sources)) {
    if (!c.output.quiet)
      tell(printable(c.output.path()) + ": shard " + *c.shard + " is complete already: nothing was done\n");
    return earlier->exit;
  }
  files.open();
  BatchReport report(c.output);
  solve_all(c, solver, sources, files.answers(), files.proofs(), report);
  sources.tell_lines(totals);
  totals.lines = report.lines();
  totals.errors = report.errors();
  totals.exit = report.worst();
  files.commit(totals);
  return report.worst();
}

int run(const BatchCommand &c) {
  check_files(c);
  if (c.shard)
    return run_shard(c);
  if (c.has_proof_folder()) {
    make_folder(*c.proofs);
    if (has_file(*c.proofs, ".proof"))
      c.output.tell_notes(
          {fmt::format("{} has proofs of another run; those that this one does not write again "
                       "stay.",
                       shown_name(*c.proofs))});
  }
  const BatchSolver solver(c);
  BatchSources sources(c.files, c.reading.reading(), c.reading.given(), c.has_proof_stream());
  Output out(c.output.path());
  std::optional<ProofStream> proofs;
  if (c.has_proof_stream())
    proofs.emplace(*c.proofs);
  BatchReport report(c.output);
  std::optional<Interrupt> interrupt;
  if (!reads_stdin(c))
    interrupt.emplace();
  const bool is_whole = solve_all(c, solver, sources, out, proofs ? &*proofs : nullptr, report);
  if (proofs)
    proofs->commit();
  out.commit();
  if (is_whole)
    return report.worst();
  c.output.tell_notes({interrupted_after(report.lines(), "gradation")});
  return worse_exit(report.worst(), Exit::limited);
}

} // namespace

Run add_batch(CLI::App &app) {
  const auto c = std::make_shared<BatchCommand>();
  CLI::App &command =
      *app.add_subcommand("batch", "Solves many gradations, an answer each in the same order");
  command.add_option("FILE", c->files,
                     "JSON Lines, or gradation files, of AGS4 all specimens, of a workbook all sheets; - for "
                     "standard input; without "
                     "any, JSON Lines from there");
  c->flags.add_to(command);
  command.add_option("-j", c->threads, "threads")->type_name("THREADS")->transform(whole_number(1, 1024));
  command
      .add_option("--proofs", c->proofs,
                  "write certificates for mdm-check --suite: into the folder NAME, named by the gradation's "
                  "number and id, of a gradation file also what mdm-check reads, and of a budget "
                  "NAME.proof.finer, that the next finer step needs more particles; or, where NAME ends in "
                  ".proofs or .proofs.zst or is that of a shard, as one stream with the index NAME.index")
      ->type_name("NAME");
  command
      .add_option(
          "--shard", c->shard,
          "solve the shard I of N of one suite: of its lines that are not blank, each N-th from the "
          "I-th on; OUT.totals is written last, and a shard that has it is complete and not solved again")
      ->type_name("I/N");
  command.add_flag(
      "--alone", c->alone,
      "with --shard: FILE has the lines of the shard alone, none of them blank; those of mdm suite "
      "--shard say which suite they are of");
  command
      .add_option("--format", c->output.asked_format,
                  "json (a line a gradation) or csv (a row a class); csv if OUT ends so, else json")
      ->check(CLI::IsMember({"json", "csv"}));
  c->output.add_out(command, "write", {"jsonl", "ndjson", "json", "csv", "txt"});
  c->output.add_verbose(command, "on standard error also each answer as text, with its scale");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "What ends in .zst is read and written compressed. mdm merge joins shards. Ctrl-C ends a run with "
          "the answers so far (exit 3); of a shard it leaves none."),
      {"mdm batch suite.jsonl -j 4 -o answers.jsonl --proofs proofs",
       "mdm batch suite.jsonl -o answers.jsonl --proofs suite.proofs",
       "mdm batch suite.jsonl.zst --shard 7/100 -o 7.jsonl.zst --proofs 7.proofs.zst",
       "mdm batch site/*.csv report.ags -o answers.csv",
       "mdm batch --tolerance retained:1% < suite.jsonl > answers.jsonl"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

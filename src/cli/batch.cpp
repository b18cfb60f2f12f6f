#include "answer/batch_csv.hpp"
#include "cli/batch_sources.hpp"
#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/in_parallel.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"
#include "text/json_writer.hpp"

#include <mdm/answer/answer.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>

namespace mdm::cli {
namespace {

struct BatchCommand {
  std::vector<std::string> files;
  SolveFlags flags;
  ReadingFlags reading;
  std::optional<std::string> proofs;
  unsigned threads = 1;
  OutputFlags output;
};

/// The answer to one gradation, with the exit code that it would have alone.
struct Answer {
  std::string text; ///< empty for a blank line
  int exit = Exit::done;
  std::string told = {}; ///< what standard error has beside CSV
  std::string id = {};   ///< of a table's rows
  std::string unit = {}; ///< the same; empty: no rows
};

/// The exit code of a whole run is that of its worst line.
int severity(int exit) {
  switch (exit) {
  case Exit::bad_input:
    return 3;
  case Exit::limited:
    return 2;
  case Exit::negative:
    return 1;
  default:
    return 0;
  }
}

/// Name of a proof without its ending: the number makes it unique and sorts it, the id makes it findable,
/// with
/// `_` for what does not serve in a file name.
std::string proof_name(std::uint64_t number, const std::string &id) {
  constexpr std::size_t longest_id = 64;
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  };
  std::string name = id.substr(0, longest_id);
  std::replace_if(
      name.begin(), name.end(), [&](char c) { return !is_plain(c); }, '_');
  return name.empty() || id == std::to_string(number) ? fmt::format("{:06}", number)
                                                      : fmt::format("{:06}-{}", number, name);
}

class Batch {
public:
  explicit Batch(const BatchCommand &command)
      : command_(command), asked_(command.flags.question()), options_(solve_options()) {}

  Answer answer(const BatchItem &item) const {
    if (!item.read)
      return {};
    try {
      return solved(item.read(), item);
    } catch (const InputError &e) {
      return error(item.id(), e.what());
    } catch (const std::bad_alloc &) { // the others are none the worse for it
      return error(item.id(), printable(item.where) + ": out of memory: give it more, or a --max-steps");
    }
  }

private:
  /// The proof of each gradation is kept where it is to be written.
  SolveOptions solve_options() const { return command_.flags.options(command_.proofs.has_value()); }

  Answer error(const std::string &id, const std::string &message) const {
    if (command_.output.is_csv())
      return {"", Exit::bad_input, message + "\n"};
    JsonWriter json;
    json.begin_object().key("id").string(id).key("status").plain("error").key("error").string(message);
    json.end_object();
    return {json.take() + "\n", Exit::bad_input};
  }

  Answer solved(Gradation g, const BatchItem &item) const {
    SolveOptions options = options_;
    if (command_.flags.time_limit)
      options.limits = solve_options().limits; // a deadline of its own for each gradation
    const std::string checked = command_.proofs && item.checked_as ? item.checked_as(g) : "";
    const Question question = asked_.in(g.unit());
    Match m = in_file(item.where, [&] { return solve(std::move(g), question, options); });
    std::string proof;
    if (command_.proofs && has_certificate(m))
      proof = write_proof(m, item, checked);
    else if (command_.proofs)
      m.notes.push_back("no proof was written: the limit came before the end");
    return command_.output.is_csv()
               ? rows(m, options.limits)
               : Answer{answer_json(m, nullptr, proof) + "\n", exit_code(m, options.limits)};
  }

  /// \param checked the gradation file beside it, if there is to be one
  /// \return the name of its file
  std::string write_proof(const Match &m, const BatchItem &item, const std::string &checked) const {
    const std::string name = proof_name(item.number, m.gradation.id());
    write_file(*command_.proofs + "/" + name + ".proof", in_file(item.where, [&] { return certificate(m); }));
    if (!checked.empty())
      write_file(*command_.proofs + "/" + name + ".gradation", checked);
    return name + ".proof";
  }

  static void write_file(const std::string &path, const std::string &text) {
    Output file(path);
    file.write(text);
    file.commit();
  }

  /// CSV has no place for a verdict and for notes.
  static Answer rows(const Match &m, const Limits &limits) {
    const std::string id = printable(m.gradation.id());
    std::string told = m.status == Status::optimal ? "" : id + ": " + headline(m) + "\n";
    for (const std::string &note : m.notes)
      told += id + ": note: " + note + "\n";
    return {batch_csv(m), exit_code(m, limits), told, id, std::string(name(m.gradation.unit()))};
  }

  const BatchCommand &command_;
  AskedQuestion asked_;
  SolveOptions options_;
};

/// The answers to some gradations, by several threads, in order.
std::vector<Answer> answers(const Batch &batch, const std::vector<BatchItem> &items, unsigned threads) {
  std::vector<Answer> result(items.size());
  in_parallel(items.size(), threads, [&](std::size_t i) { result[i] = batch.answer(items[i]); });
  return result;
}

/// What is written of one answer after the other.
class BatchReport {
public:
  explicit BatchReport(const OutputFlags &flags) : flags_(flags) {}

  /// The text that the answer adds to the output; what standard error has is told.
  std::string add(const Answer &answer) {
    const bool fits = answer.unit.empty() || unit_.empty() || answer.unit == unit_;
    const int exit = fits ? answer.exit : Exit::bad_input;
    if (severity(exit) > severity(worst_))
      worst_ = exit;
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

private:
  const OutputFlags &flags_;
  std::string unit_; ///< of the table; empty before its first row
  int worst_ = Exit::done;
};

void check_files(const BatchCommand &c) {
  for (const std::string &file : c.files) {
    check_distinct({file, c.output.path()});
    check_readable(file);
  }
  const bool reads_stdin = c.files.empty() || std::count(c.files.begin(), c.files.end(), "-") > 0;
  if (reads_stdin && c.flags.band == "-")
    throw InputError("--band: standard input has the gradations: give the band by name");
  if (c.flags.band)
    check_distinct({*c.flags.band, c.output.path()});
}

int run(const BatchCommand &c) {
  check_files(c);
  if (c.proofs)
    make_folder(*c.proofs);
  const Batch batch(c);
  BatchSources sources(c.files, c.reading);
  Output out(c.output.path());
  BatchReport report(c.output);
  std::atomic<std::uint64_t> count = 0;
  Progress progress([&count] { return fmt::format("{} gradations", count.load()); }, c.output.quiet);
  constexpr std::size_t at_once = 512;
  for (std::vector<BatchItem> items = sources.next(at_once); !items.empty(); items = sources.next(at_once)) {
    std::string text;
    for (const Answer &answer : answers(batch, items, c.threads))
      text += report.add(answer);
    count += items.size();
    out.write(text);
  }
  out.commit();
  return report.worst();
}

} // namespace

Run add_batch(CLI::App &app) {
  const auto c = std::make_shared<BatchCommand>();
  CLI::App &command =
      *app.add_subcommand("batch", "Solves many gradations, an answer each in the same order");
  command.add_option("FILE", c->files,
                     "JSON Lines, or gradation files, of AGS4 all specimens; - for standard input; without "
                     "any, JSON Lines from there");
  c->flags.add_to(command);
  command.add_option("-j", c->threads, "threads")->type_name("THREADS")->check(CLI::Range(1, 1024));
  command
      .add_option("--proofs", c->proofs,
                  "write certificates into the folder DIR, named by the gradation's number and id, for "
                  "mdm-check --suite; of a gradation file also what mdm-check reads")
      ->type_name("DIR");
  command
      .add_option("--format", c->output.asked_format,
                  "json (a line a gradation) or csv (a row a class); csv if OUT ends so, else json")
      ->check(CLI::IsMember({"json", "csv"}));
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer("", {"mdm batch suite.jsonl -j 4 -o answers.jsonl --proofs proofs",
                             "mdm batch site/*.csv report.ags -o answers.csv",
                             "mdm batch --tolerance retained:1% < suite.jsonl > answers.jsonl"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

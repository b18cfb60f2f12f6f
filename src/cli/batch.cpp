#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/in_parallel.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "cli/solve_flags.hpp"
#include "text/json_writer.hpp"

#include <mdm/answer/answer.hpp>
#include <mdm/gradation/read_gradation.hpp>
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
  std::string file = "-";
  SolveFlags flags;
  std::optional<std::string> proofs;
  unsigned threads = 1;
  OutputFlags output;
};

/// The answer to one line, with the exit code that it would have alone.
struct Answer {
  std::string text; // empty for a blank line
  int exit = Exit::done;
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

/// Name of a line's proof: the line number makes it unique, the id, where it can stand in a file name,
/// findable.
std::string proof_name(std::uint64_t number, const std::string &id) {
  const auto plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  };
  const bool usable = !id.empty() && id.size() <= 64 && std::all_of(id.begin(), id.end(), plain);
  return usable && id != std::to_string(number) ? fmt::format("{}-{}.proof", number, id)
                                                : fmt::format("{}.proof", number);
}

class Batch {
public:
  explicit Batch(const BatchCommand &command)
      : command_(command), question_(command.flags.question()), options_(solve_options()) {}

  Answer answer(const FileLines::Line &line, std::uint64_t number) const {
    const std::string fallback = std::to_string(number);
    if (!line)
      return error(fallback,
                   where(number) + ": " + FileLines::too_long("the line") + ": write one gradation a line");
    if (line->find_first_not_of(" \t\r") == std::string::npos)
      return {};
    try {
      return solved(read_json_gradation(*line, where(number), fallback), number);
    } catch (const InputError &e) {
      return error(json_gradation_id(*line).value_or(fallback), e.what());
    } catch (const std::bad_alloc &) { // the other lines are none the worse for it
      return error(fallback, where(number) + ": out of memory: give it more, or a --max-steps");
    }
  }

private:
  /// The proof of each line is kept where it is to be written.
  SolveOptions solve_options() const { return command_.flags.options(command_.proofs.has_value()); }

  std::string where(std::uint64_t number) const { return line_name(command_.file, number); }

  static Answer error(const std::string &id, const std::string &message) {
    JsonWriter json;
    json.begin_object().key("id").string(id).key("status").plain("error").key("error").string(message);
    json.end_object();
    return {json.take() + "\n", Exit::bad_input};
  }

  Answer solved(Gradation g, std::uint64_t number) const {
    const std::string id = g.id();
    SolveOptions options = options_;
    if (command_.flags.time_limit)
      options.limits = solve_options().limits; // a deadline of its own for each line
    Match m = in_file(where(number), [&] { return solve(std::move(g), question_, options); });
    if (command_.proofs && has_certificate(m)) {
      Output proof(*command_.proofs + "/" + proof_name(number, id));
      proof.write(in_file(where(number), [&] { return certificate(m); }));
      proof.commit();
    } else if (command_.proofs) {
      m.notes.push_back("no proof was written: the limit came before the end");
    }
    return {answer_json(m) + "\n", exit_code(m.status)};
  }

  const BatchCommand &command_;
  Question question_;
  SolveOptions options_;
};

/// Answers to lines first, first + 1, ..., by several threads, in order.
std::vector<Answer> answers(const Batch &batch, const std::vector<FileLines::Line> &lines,
                            std::uint64_t first, unsigned threads) {
  std::vector<Answer> result(lines.size());
  in_parallel(lines.size(), threads, [&](std::size_t i) { result[i] = batch.answer(lines[i], first + i); });
  return result;
}

int run(const BatchCommand &c) {
  check_distinct({c.file, c.output.path()});
  if (c.flags.band)
    check_distinct({*c.flags.band, c.output.path()});
  if (c.file == "-" && c.flags.band == "-")
    throw InputError("--band: standard input has the gradations: give the band by name");
  if (c.proofs)
    make_folder(*c.proofs);
  const Batch batch(c);
  FileLines lines(c.file);
  Output out(c.output.path());
  std::atomic<std::uint64_t> count = 0;
  Progress progress([&count] { return fmt::format("{} gradations", count.load()); }, c.output.quiet);
  int worst = Exit::done;
  constexpr std::size_t at_once = 512;
  for (std::vector<FileLines::Line> chunk = lines.next(at_once); !chunk.empty();
       chunk = lines.next(at_once)) {
    std::string text;
    for (const Answer &answer : answers(batch, chunk, count + 1, c.threads)) {
      text += answer.text;
      if (severity(answer.exit) > severity(worst))
        worst = answer.exit;
    }
    count += chunk.size();
    out.write(text);
  }
  out.commit();
  return worst;
}

} // namespace

Run add_batch(CLI::App &app) {
  const auto c = std::make_shared<BatchCommand>();
  CLI::App &command =
      *app.add_subcommand("batch", "Solves JSON Lines of gradations, an answer a line in the same order");
  command.add_option("FILE", c->file, "JSON Lines; standard input if left out");
  c->flags.add_to(command);
  command.add_option("-j", c->threads, "threads")->type_name("THREADS")->check(CLI::Range(1, 1024));
  command.add_option("--proofs", c->proofs, "write a certificate for each line into the folder DIR")
      ->type_name("DIR");
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress on standard error");
  command.footer(footer("", {"mdm batch suite.jsonl -j 4 -o answers.jsonl",
                             "mdm batch suite.jsonl -o answers.jsonl --proofs proofs",
                             "mdm batch --tolerance retained:1% < suite.jsonl > answers.jsonl"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "sets/suite.hpp"

#include "answer/made_suite.hpp"
#include "ask/suite_lines.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/whole_number.hpp"
#include "files/byte_source.hpp"
#include "files/digest.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

constexpr std::size_t most_description_bytes = std::size_t{1} << 20;

struct SuiteCommand {
  std::string description;
  SuiteTexts asked;
  unsigned threads = 1;
  OutputFlags output;
};

std::string sha256_of(const std::string &text) {
  Digest digest;
  digest.add(text);
  return digest.sha256();
}

int run(const SuiteCommand &c) {
  const std::uint64_t seed = c.asked.asked_seed();
  const LineRange all = c.asked.all_lines();
  const Shard shard = c.asked.asked_shard();
  const LineRange range = lines_of(all, shard);
  check_distinct({c.description, c.output.path()});
  const std::string name = shown_name(c.description);
  const std::string text = read_file(c.description, most_description_bytes);
  const Suite suite(text, name);
  const std::string first_line = c.asked.shard ? shard_line(sha256_of(text), seed, all, shard) : "";
  Output out(c.output.path());
  out.write(first_line);
  std::atomic<std::uint64_t> written = 0;
  ProgressLine progress([&written] { return fmt::format("{} gradations", written.load()); }, c.output.quiet);
  constexpr std::uint64_t at_once = 512;
  while (written < range.count()) {
    std::vector<std::string> lines(std::min(at_once, range.count() - written));
    const std::uint64_t first = range.first + written * range.step;
    in_parallel(lines.size(), c.threads,
                [&](std::size_t i) { lines[i] = gradation_json(suite.line(first + i * range.step, seed)); });
    for (const std::string &line : lines)
      out.write(line);
    written += lines.size();
  }
  out.commit();
  return Exit::done;
}

constexpr const char *example_description = R"(  {"schema": "mdm-suite-1", "classes": [4, 9],
   "sieves": {"series": "ISO R20/3", "from": 0.063, "to": 31.5},
   "masses": {"kind": "beta", "a": [0.5, 10], "b": [0.5, 10]}}

)";

std::string about_suites() {
  return paragraph("Line n depends on the description, the seed and n alone, and is the same on every "
                   "machine. A description is, for example:") +
         example_description +
         paragraph("A range [from, to] stands for a random number in it, for each line. There are id, "
                   "which begins the ids (g), unit (mm), classes and digits, to which shares are "
                   "rounded (6 of the whole). Sieves are some of a series (ISO R20/3, ISO R20, ASTM "
                   "E11, Tyler, phi, half-phi, quarter-phi; from, to) or a list, any or neighbours "
                   "(true), or geometric (from and to, or from and ratio; digits).") +
         paragraph(
             "Masses are of a kind: random; gap-graded (empty: classes without mass); beta (a, "
             "b); lognormal (median, its place on the log scale from the smallest sieve, 0, to "
             "the largest, 1; deviation); normal (over the classes: centre, its place among them, 0 to 1; "
             "deviation, in classes; noise, over its height); ties (at upper, lower or either sieves, "
             "quantities, "
             "law). Of a list of kinds each line has one. The schema mdm-suite-1 has the rest.");
}

} // namespace

Run add_suite(CLI::App &app) {
  const auto c = std::make_shared<SuiteCommand>();
  CLI::App &command =
      *app.add_subcommand("suite", "Gradations made of a description and a seed, a line each");
  command.add_option("DESCRIPTION", c->description, "what they are to be, in JSON; - for standard input")
      ->required();
  add_options(command, SuiteTexts::options, c->asked);
  command.add_option("-j", c->threads, "threads")->type_name("THREADS")->transform(whole_number(1, 1024));
  c->output.out_has_report = false;
  c->output.add_out(command, "write", {"jsonl", "ndjson", "json", "txt"});
  c->output.add_quiet(command, "no progress on standard error");
  command.footer(footer(about_suites(), {"mdm suite beta.json --count 1000000 --seed 7 -o suite.jsonl",
                                         "mdm suite beta.json --count 1e9 --shard 7/1000 | "
                                         "mdm batch - --shard 7/1000 --alone -o 7.jsonl"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

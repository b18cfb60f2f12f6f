#include "cli/accessible.hpp"

#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/whole_number.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "papers/accessible_report.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {
namespace {

constexpr std::size_t most_numbers = 1000;
constexpr std::size_t most_shapes = 100000;

std::vector<std::string> parts(const std::string &text, char separator) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    all.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return all;
}

std::vector<Rational> steps(const std::string &name, const std::vector<std::string> &words) {
  const Rational from = positive(name, words[0]), to = positive(name, words[1]),
                 step = positive(name, words[2]);
  if (to < from)
    throw InputError(option(name) + ": " + in_quotes(words[0] + ":" + words[1]) +
                     " has its end before its start");
  if ((to - from) / step >= Rational(most_numbers))
    throw InputError(option(name) + ": more than 1000 numbers: take a larger step");
  std::vector<Rational> numbers;
  for (Rational at = from; at <= to; at += step)
    numbers.push_back(at);
  return numbers;
}

} // namespace

void AccessibleFlags::add_to(CLI::App &command) {
  command.add_flag("--accessible", on,
                   "instead of one set: which shapes a, b take at most --at-most (10000) particles, by Eq. "
                   "6-9 and by the smallest match, at the --span (one or several, as the shapes)");
  command.add_option("--a", a, "shapes of --accessible: numbers 1,2,5 or FROM:TO:STEP (0.5:10:0.5)")
      ->type_name("LIST");
  command.add_option("--b", b, "the same for b (0.5:10:0.5)")->type_name("LIST");
  command.add_option("--plot", plot, "the map of --accessible into OUT.svg, .png or .pdf")->type_name("OUT");
  command.add_option("-j", threads, "threads of --accessible")
      ->type_name("THREADS")
      ->transform(whole_number(1, 1024));
}

std::vector<Rational> number_list(const std::string &name, const std::string &text) {
  const std::vector<std::string> words = parts(text, ':');
  if (words.size() == 3)
    return steps(name, words);
  if (words.size() != 1)
    throw InputError(option(name) + ": " + in_quotes(text) + " is not a list: write 1,2,5 or FROM:TO:STEP");
  std::vector<Rational> numbers;
  for (const std::string &word : parts(text, ','))
    numbers.push_back(positive(name, word));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags) {
  if (flags.plot == "-")
    throw InputError("--plot needs a file: standard output has the answer");
  const std::optional<Picture> picture = flags.plot ? picture_at(*flags.plot) : std::nullopt;
  if (flags.plot && !picture)
    throw InputError("--plot: " + printable(*flags.plot) + ": let OUT end in .svg, .png or .pdf");
  check_distinct({output.path(), flags.plot.value_or("-")});
  std::vector<AccessibleRow> rows = grid(question);
  if (rows.size() > most_shapes)
    throw InputError("--accessible: more than 100000 shapes: take larger steps or fewer spans");
  Output out(output.path());
  std::atomic<std::size_t> done = 0;
  {
    const Progress progress([&] { return fmt::format("{} of {} shapes", done.load(), rows.size()); },
                            output.quiet);
    in_parallel(rows.size(), flags.threads, [&](std::size_t i) {
      fill(rows[i], question);
      ++done;
    });
  }
  std::unique_ptr<Output> plot;
  if (picture) {
    plot = std::make_unique<Output>(*flags.plot);
    plot->write(picture_of(accessible_map(question, rows), *picture));
  }
  out.write(output.report([&] { return accessible_text(question, rows); },
                          [&] { return accessible_json(question, rows); },
                          [&] { return accessible_csv(rows); }));
  if (plot)
    plot->commit();
  out.commit();
  const std::vector<std::string> open = undecided(rows);
  // CSV has no place for them.
  if (output.is_csv())
    for (const std::string &line : open)
      tell(line + "\n");
  return open.empty() ? Exit::done : Exit::limited;
}

} // namespace mdm::cli

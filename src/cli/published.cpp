#include "report/published.hpp"

#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/progress.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "match/fixed_size.hpp"
#include "match/spanned_integer.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>

namespace mdm::cli {
namespace {

/// The most iterations: more are of no use, and each is reported.
constexpr std::uint64_t most_iterations = 100'000;
constexpr std::uint64_t most_increments = 1'000'000'000;

struct PublishedCommand {
  using Text = std::optional<std::string>;
  std::string algorithm;
  std::string file;
  GradationTexts flags;
  Text sizes, size_at, rounding, tolerance, max_iterations, start, increments, digits;
  ReadingFlags reading;
  OutputFlags output;
};

/// Refuses the option where the algorithm does not know it.
void check_knows(const PublishedCommand &c, const char *option, const PublishedCommand::Text &value,
                 const char *algorithms) {
  if (value && std::string(algorithms).find(c.algorithm) == std::string::npos)
    throw InputError(fmt::format("{}: not an option of {}: leave it out (it is one of {})", option,
                                 c.algorithm, algorithms));
}

void check_options(const PublishedCommand &c) {
  check_knows(c, "--sizes", c.sizes, "rounded, fixed-size");
  check_knows(c, "--size-at", c.size_at, "rounded, fixed-size");
  check_knows(c, "--rounding", c.rounding, "rounded, fixed-size");
  check_knows(c, "--tolerance", c.tolerance, "fixed-size");
  check_knows(c, "--max-iterations", c.max_iterations, "fixed-size, spanned-integer");
  check_knows(c, "--start", c.start, "spanned-integer");
  check_knows(c, "--increments", c.increments, "spanned-integer");
  if (c.sizes && c.size_at)
    throw InputError("--sizes and --size-at: give one of them");
}

/// A position in a class: above its lower sieve, 0, and up to its upper one, 1.
Rational position(const char *name, const std::string &text) {
  const Rational t = positive(name, text);
  if (t > 1)
    throw InputError(fmt::format("{}: {} is above 1, the upper sieve", option(name), in_quotes(text)));
  return t;
}

std::uint64_t bounded(const char *name, const std::string &text, std::uint64_t most) {
  const Integer n = natural(name, text, 1);
  if (n > most)
    throw InputError(fmt::format("{}: at most {}", option(name), most));
  return static_cast<std::uint64_t>(n);
}

/// `1%` as a fraction.
Rational share(const char *name, const std::string &text) {
  if (text.empty() || text.back() != '%')
    throw InputError(
        fmt::format("{}: {} has no percent sign: write 1%, for example", option(name), in_quotes(text)));
  return not_negative(name, text.substr(0, text.size() - 1)) / 100;
}

SizeChoice size_choice(const PublishedCommand &c) {
  if (c.size_at)
    return {position("size-at", *c.size_at)};
  if (c.sizes == "volume")
    return {};
  return {c.sizes == "lower" ? ratio(1, 1000) : c.sizes == "upper" ? Rational(1) : ratio(1, 2)};
}

std::string in_words(const SizeChoice &sizes) {
  return sizes.position ? "sizes at " + to_decimal(*sizes.position) + " of their classes"
                        : std::string("sizes of the mean volume of their classes' bounds");
}

struct NamedRounding {
  const char *name;
  Rounding rounding;
  const char *words;
};

constexpr NamedRounding roundings[] = {{"nearest", Rounding::nearest, "to nearest, a half up"},
                                       {"even", Rounding::even, "to nearest, a half to even"},
                                       {"up", Rounding::up, "up"},
                                       {"down", Rounding::down, "down"}};

const NamedRounding &rounding_named(const std::string &name) {
  return *std::find_if(std::begin(roundings), std::end(roundings) - 1,
                       [&name](const NamedRounding &r) { return r.name == name; });
}

/// The algorithm that the user chose.
struct Algorithm {
  PublishedAlgorithm kind;
  std::string settings; ///< in words
  std::function<Published(const Gradation &, const MassLaw &)> run;
};

Algorithm fixed_size_of(const PublishedCommand &c) {
  FixedSizeOptions o;
  o.sizes = size_choice(c);
  const NamedRounding &rounding = rounding_named(c.rounding.value_or("nearest"));
  o.rounding = rounding.rounding;
  std::string settings = fmt::format("{}, rounded {}", in_words(o.sizes), rounding.words);
  PublishedAlgorithm kind = PublishedAlgorithm::fixed_size;
  if (c.algorithm == "rounded") {
    kind = PublishedAlgorithm::rounded;
    o.max_iterations = 1;
  } else {
    o.tolerance = share("tolerance", c.tolerance.value_or("1%"));
    if (c.max_iterations)
      o.max_iterations = bounded("max-iterations", *c.max_iterations, most_iterations);
    settings += fmt::format(", total error up to {} %, at most {} iterations",
                            to_decimal(Rational(100 * o.tolerance)), o.max_iterations);
  }
  return {kind, settings, [o](const Gradation &g, const MassLaw &law) { return fixed_size(g, law, o); }};
}

Algorithm spanned_integer_of(const PublishedCommand &c) {
  SpannedIntegerOptions o;
  if (c.start)
    o.start = position("start", *c.start);
  if (c.increments)
    o.increments = bounded("increments", *c.increments, most_increments);
  if (c.max_iterations)
    o.max_iterations = bounded("max-iterations", *c.max_iterations, most_iterations);
  return {PublishedAlgorithm::spanned_integer,
          fmt::format("x_nS from {} of its class, {} size{}, at most {} iterations", to_decimal(o.start),
                      o.increments, o.increments == 1 ? "" : "s", o.max_iterations),
          [o](const Gradation &g, const MassLaw &law) { return spanned_integer(g, law, o); }};
}

int run(const PublishedCommand &c) {
  check_options(c);
  check_distinct({c.file, c.output.path()});
  const Algorithm algorithm = c.algorithm == "spanned-integer" ? spanned_integer_of(c) : fixed_size_of(c);
  const AskedQuestion asked = c.flags.question();
  const unsigned digits = c.digits ? digits_of("digits", *c.digits) : 15;
  refuse_sample(c.file);
  const Gradation read =
      read_gradation(read_file(c.file, max_gradation_bytes), shown_name(c.file), c.reading.reading());
  const Question question = asked.in(read.unit());
  Progress progress([] { return std::string("running the algorithm"); }, c.output.quiet);
  const PublishedReport report = in_file(c.file, [&] {
    const Gradation g = asked_gradation(read, question);
    return PublishedReport{algorithm.kind,
                           algorithm.settings,
                           g,
                           question.law,
                           algorithm.run(g, question.law),
                           smallest_match(g, question.law),
                           digits,
                           g.notes()};
  });
  Output out(c.output.path());
  out.write(c.output.report([&] { return published_text(report); }, [&] { return published_json(report); },
                            [&] { return published_csv(report); }));
  out.commit();
  c.output.tell_notes_beside_csv(report.notes);
  // CSV has no place for the least match.
  if (!c.output.is_csv() && !report.least.is_point())
    return Exit::limited;
  return succeeded(report) ? Exit::done : Exit::negative;
}

} // namespace

Run add_published(CLI::App &app) {
  const auto c = std::make_shared<PublishedCommand>();
  CLI::App &command = *app.add_subcommand(
      "published", "The algorithms of Arnold's paper as published, beside the smallest match");
  command.add_option("ALGORITHM", c->algorithm, "rounded (Eq. 18), fixed-size (FS) or spanned-integer (SI)")
      ->required()
      ->check(CLI::IsMember({"rounded", "fixed-size", "spanned-integer"}));
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard input")
      ->required();
  add_gradation_options(command, c->flags);
  command
      .add_option(
          "--sizes", c->sizes,
          "rounded, fixed-size: the size of each class: middle (default), upper (the "
          "sieve), volume (with the mean of the bounds' volumes) or lower (0.001 of the class above its "
          "open end)")
      ->check(CLI::IsMember({"lower", "middle", "upper", "volume"}));
  command
      .add_option("--size-at", c->size_at,
                  "rounded, fixed-size: the size as a part T of the class, 0 < T <= 1: lower + T (upper - "
                  "lower)")
      ->type_name("T");
  command
      .add_option("--rounding", c->rounding,
                  "rounded, fixed-size: nearest (default, a half up), even (a half to even), up or down")
      ->check(CLI::IsMember({"nearest", "even", "up", "down"}));
  command.add_option("--tolerance", c->tolerance, "fixed-size: the total error that is enough (1%)")
      ->type_name("P%");
  command
      .add_option("--start", c->start,
                  "spanned-integer: the first x_nS as a part T of its class, 0 < T <= 1 (0.001)")
      ->type_name("T");
  command
      .add_option("--increments", c->increments,
                  "spanned-integer: so many x_nS, evenly from the first to the upper sieve (100); 1: the "
                  "first alone")
      ->type_name("N");
  command
      .add_option("--max-iterations", c->max_iterations,
                  "fixed-size, spanned-integer: give up after so many (999), exit 1")
      ->type_name("N");
  command.add_option("--digits", c->digits, "significant digits of sizes (15)")->type_name("D");
  c->output.add_format(command, "text, json, or csv (the iterations)");
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Exit code 3: the smallest match was not found within some seconds; the report has bounds."),
      {"mdm published rounded sand.csv", "mdm published fixed-size sand.csv --format csv",
       "mdm published spanned-integer sand.csv --start 0.5 --increments 1"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli

#include "ask/published.hpp"

#include "ask/option_values.hpp"
#include "match/fixed_size.hpp"
#include "match/spanned_integer.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace mdm {
namespace {

/// The most iterations: more are of no use, and each is reported.
constexpr std::uint64_t most_iterations = 100'000;
constexpr std::uint64_t most_increments = 1'000'000'000;

/// Refuses the option where the algorithm does not know it.
void check_knows(const PublishedTexts &c, const char *name, const OptionText &value, const char *algorithms) {
  if (value && std::string(algorithms).find(c.algorithm) == std::string::npos)
    throw InputError(fmt::format("{}: not an option of {}: leave it out (it is one of {})", option(name),
                                 c.algorithm, algorithms));
}

/// A position in a class: above its lower sieve, 0, and up to its upper one, 1; a decimal or a fraction as
/// 1/127.
Rational class_position(const char *name, const std::string &text) {
  const std::size_t slash = text.find('/');
  const Rational t =
      slash == std::string::npos
          ? positive(name, text)
          : Rational(positive(name, text.substr(0, slash)) / positive(name, text.substr(slash + 1)));
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

SizeChoice size_choice(const PublishedTexts &c) {
  if (c.size_at)
    return {class_position("size-at", *c.size_at)};
  if (c.sizes == "volume")
    return {};
  return {c.sizes == "lower" ? ratio(1, 1000) : c.sizes == "upper" ? Rational(1) : ratio(1, 2)};
}

/// A decimal, or the fraction that it is.
std::string position_text(const Rational &t) {
  return exact_decimal(t).value_or(to_string(t));
}

std::string size_choice_words(const SizeChoice &sizes) {
  return sizes.position ? "sizes at " + position_text(*sizes.position) + " of their classes"
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
struct ChosenAlgorithm {
  PublishedAlgorithm kind;
  std::string settings; ///< in words
  std::function<Published(const Gradation &, const MassLaw &)> run;
  std::optional<Rational> total_error; ///< that is enough
};

/// The tolerance of the fixed size algorithm, which stops at a total error: `total:1%`, or `1%`.
Rational total_error(const std::string &text) {
  const bool is_bare = text.find_first_not_of("0123456789.eE%_+- ") == std::string::npos;
  const AskedTolerance asked = parse_tolerance(is_bare ? "total:" + text : text);
  if (asked.kind != AskedTolerance::Kind::total)
    throw InputError("the fixed size algorithm stops at a total error: write total:1%, or 1%");
  return asked.percent / 100;
}

ChosenAlgorithm fixed_size_of(const PublishedTexts &c) {
  FixedSizeOptions o;
  o.sizes = size_choice(c);
  const NamedRounding &rounding = rounding_named(c.rounding.value_or("nearest"));
  o.rounding = rounding.rounding;
  std::string settings = fmt::format("{}, rounded {}", size_choice_words(o.sizes), rounding.words);
  PublishedAlgorithm kind = PublishedAlgorithm::fixed_size;
  if (c.algorithm == "rounded") {
    kind = PublishedAlgorithm::rounded;
    o.max_iterations = 1;
  } else {
    o.tolerance = named("tolerance", c.tolerance.value_or("1%"), total_error);
    if (c.max_iterations)
      o.max_iterations = bounded("max-iterations", *c.max_iterations, most_iterations);
    settings += fmt::format(", total error up to {} %, at most {} iterations",
                            to_decimal(Rational(100 * o.tolerance)), o.max_iterations);
  }
  return {kind, settings, [o](const Gradation &g, const MassLaw &law) { return fixed_size(g, law, o); },
          kind == PublishedAlgorithm::fixed_size ? std::optional(o.tolerance) : std::nullopt};
}

ChosenAlgorithm spanned_integer_of(const PublishedTexts &c) {
  SpannedIntegerOptions o;
  if (c.start)
    o.start = class_position("start", *c.start);
  if (c.increments)
    o.increments = bounded("increments", *c.increments, most_increments);
  if (c.max_iterations)
    o.max_iterations = bounded("max-iterations", *c.max_iterations, most_iterations);
  return {PublishedAlgorithm::spanned_integer,
          fmt::format("x_nS from {} of its class, {} size{}, at most {} iterations", position_text(o.start),
                      o.increments, o.increments == 1 ? "" : "s", o.max_iterations),
          [o](const Gradation &g, const MassLaw &law) { return spanned_integer(g, law, o); }, std::nullopt};
}

/// Refuses options that do not go together.
void check_published(const PublishedTexts &c) {
  check_knows(c, "sizes", c.sizes, "rounded, fixed-size");
  check_knows(c, "size-at", c.size_at, "rounded, fixed-size");
  check_knows(c, "rounding", c.rounding, "rounded, fixed-size");
  check_knows(c, "tolerance", c.tolerance, "fixed-size");
  check_knows(c, "max-iterations", c.max_iterations, "fixed-size, spanned-integer");
  check_knows(c, "start", c.start, "spanned-integer");
  check_knows(c, "increments", c.increments, "spanned-integer");
  if (c.sizes && c.size_at)
    throw InputError(option("sizes") + " and " + option("size-at") + ": give one of them");
}

ChosenAlgorithm algorithm_of(const PublishedTexts &c) {
  check_published(c);
  return c.algorithm == "spanned-integer" ? spanned_integer_of(c) : fixed_size_of(c);
}

} // namespace

const std::vector<OptionRow<PublishedTexts>> PublishedTexts::options = {
    {"sizes",
     "TEXT",
     OptionKind::text,
     "rounded, fixed-size: the size of each class: middle (default), upper (the "
     "sieve), volume (with the mean of the bounds' volumes) or lower (0.001 of the class above its "
     "open end)",
     &PublishedTexts::sizes,
     {"lower", "middle", "upper", "volume"}},
    {"size-at", "T", OptionKind::number,
     "rounded, fixed-size: the size as a part T of the class, 0 < T <= 1: lower + T (upper - "
     "lower)",
     &PublishedTexts::size_at},
    {"rounding",
     "TEXT",
     OptionKind::text,
     "rounded, fixed-size: nearest (default, a half up), even (a half to even), up or down",
     &PublishedTexts::rounding,
     {"nearest", "even", "up", "down"}},
    {"tolerance", "WHICH", OptionKind::number,
     "fixed-size: the total error that is enough, total:1% or 1% (1%)", &PublishedTexts::tolerance},
    {"start", "T", OptionKind::number,
     "spanned-integer: the first x_nS as a part T of its class, 0 < T <= 1, as 0.5 or 1/127 (0.001)",
     &PublishedTexts::start},
    {"increments", "N", OptionKind::number,
     "spanned-integer: so many x_nS, evenly from the first to the upper sieve (100); 1: the "
     "first alone",
     &PublishedTexts::increments},
    {"max-iterations", "N", OptionKind::number,
     "fixed-size, spanned-integer: give up after so many (999), exit 1", &PublishedTexts::max_iterations},
    {"digits", "D", OptionKind::number, "significant digits of sizes (15)", &PublishedTexts::digits}};

PublishedRun::PublishedRun(const PublishedTexts &asked) {
  ChosenAlgorithm algorithm = algorithm_of(asked);
  kind_ = algorithm.kind;
  settings_ = std::move(algorithm.settings);
  run_ = std::move(algorithm.run);
  total_error_ = std::move(algorithm.total_error);
  question_ = asked.gradation.question();
  digits_ = asked.digits ? digits_of("digits", *asked.digits) : 15;
}

PublishedReport PublishedRun::report(const Gradation &read) const {
  const Question question = question_.of(read);
  const Gradation g = asked_gradation(read, question);
  return {kind_,   settings_, g, question.law, run_(g, question.law), smallest_match(g, question.law),
          digits_, g.notes()};
}

std::optional<CertifiedSample> PublishedRun::certified(const PublishedReport &report,
                                                       const SampleCertifier::Begin &begin) const {
  Question question = question_.of(report.gradation);
  if (total_error_)
    question.tolerances.push_back({AskedTolerance::Kind::total, Rational(100 * *total_error_)});
  SampleCertifier certifier(report.gradation, question, begin);
  const unsigned a = report.law.a;
  bool has_particles = false;
  for (std::size_t j = 0; j < report.run.powers.size(); ++j) {
    const Integer &quantity = report.run.result().q[j];
    if (quantity == 0)
      continue;
    const Rational &power = report.run.powers[j]; // x^a; a square where that is no power
    certifier.add(a > 1 ? RootSize{power, a} : RootSize{mdm::power(power, 2), 2}, quantity);
    has_particles = true;
  }
  return has_particles ? certifier.certified() : std::nullopt;
}

Outcome outcome_of(const PublishedReport &report) {
  return succeeded(report) ? Outcome::done : Outcome::negative;
}

} // namespace mdm

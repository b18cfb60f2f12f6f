#include "proof/sample_certificate.hpp"

#include "match/problem.hpp"
#include "proof/certificate_parts.hpp"
#include "proof/question_text.hpp"

#include <mdm/match/tolerance.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

/// Digits of a percent, and the most places that it may need to differ from what is asked.
constexpr unsigned percent_digits = 6, most_places = 5000;

/// Places after the point with which a number shows so many digits.
unsigned places_of(const Rational &value) {
  if (value == 0)
    return 0;
  unsigned places = 0;
  for (Rational scaled = value; scaled < power_of_ten(percent_digits - 1) && places < most_places; ++places)
    scaled *= 10;
  return places;
}

/// The greatest decimal of so many places up to a number, and the least one from it up.
Rational cut(const Rational &value, unsigned places) {
  return ratio(floor(Rational(value * power_of_ten(places))), power_of_ten(places));
}
Rational raise(const Rational &value, unsigned places) {
  return ratio(ceil(Rational(value * power_of_ten(places))), power_of_ten(places));
}

/// `p r`, decimal percents around a share.
std::string percents(const Interval &share, unsigned places) {
  return to_decimal(cut(Rational(100 * share.lo), places)) + " " +
         to_decimal(raise(Rational(100 * share.hi), places));
}
std::string percents(const Interval &share) {
  return percents(share, places_of(Rational(100 * share.hi)));
}

std::string class_line(std::size_t j, const Integer &count, const Interval &share) {
  return fmt::format("class {} {} {}\n", j + 1, to_string(count),
                     share.is_point() ? to_string(Rational(100 * share.lo)) : percents(share));
}

/// The largest error, and the class of which it is.
std::string largest_error(const char *name, const std::vector<Interval> &errors) {
  const auto largest = std::max_element(errors.begin(), errors.end(),
                                        [](const Interval &x, const Interval &y) { return x.hi < y.hi; });
  return fmt::format("{} {} {}\n", name, largest - errors.begin() + 1, percents(*largest));
}

std::string count_line(const char *name, const Integer &count) {
  return count > 0 ? fmt::format("{} {}\n", name, to_string(count)) : "";
}

/// A value that is not what is asked for, by how much, and the words of the verdict.
struct Miss {
  Rational gap = 0;
  std::string words;
};

/// `p r least v` with r < v, or `p r most v` with v < p: with as many digits as that takes.
std::string miss_text(const Interval &found, const ShareBounds &asked) {
  const bool is_least = found.hi < asked.lo;
  const Rational bound = 100 * (is_least ? asked.lo : asked.hi);
  for (unsigned places = places_of(Rational(100 * found.hi));; ++places) {
    const Rational v = is_least ? cut(bound, places) : raise(bound, places);
    const bool is_told =
        is_least ? raise(Rational(100 * found.hi), places) < v : v < cut(Rational(100 * found.lo), places);
    if (is_told)
      return fmt::format("{} {} {}", percents(found, places), is_least ? "least" : "most", to_decimal(v));
    if (places > most_places)
      refuse_long_numbers();
  }
}

/// Keeps the greater of two misses.
void keep_miss(Miss &worst, const std::string &of, const Interval &found, const ShareBounds &asked) {
  const Rational gap = std::max(Rational(asked.lo - found.hi), Rational(found.lo - asked.hi));
  if (gap > worst.gap)
    worst = {gap, of + " " + miss_text(found, asked)};
}

bool is_within(const Interval &found, const ShareBounds &asked) {
  return asked.lo <= found.lo && found.hi <= asked.hi;
}

/// What is asked of shares: those of the gradation where there is no tolerance.
Tolerance asked_bounds(const Gradation &g, const Question &question) {
  std::vector<AskedTolerance> asked = question.tolerances;
  if (!question.is_tolerant())
    asked.push_back({AskedTolerance::Kind::retained, 0});
  return tolerance_of(g, asked, question.band, question.size_factor);
}

/// The words of the verdict; nothing where it is open.
std::optional<std::string> verdict(const SampleFindings &f, const Tolerance &asked) {
  if (f.below > 0 || f.above > 0)
    return "outside";
  bool matches = f.unplaced == 0;
  Miss of_class, of_passing, of_total;
  for (std::size_t j = 0; j < asked.retained.size(); ++j) {
    keep_miss(of_class, fmt::format("class {}", j + 1), f.shares[j], asked.retained[j]);
    matches = matches && is_within(f.shares[j], asked.retained[j]);
  }
  for (std::size_t j = 0; j < asked.passing.size(); ++j) {
    if (j + 1 < f.passing.size())
      keep_miss(of_passing, fmt::format("passing {}", j + 1), f.passing[j], asked.passing[j]);
    matches = matches && is_within(f.passing[j], asked.passing[j]);
  }
  if (asked.total) {
    const ShareBounds most{0, *asked.total};
    keep_miss(of_total, "total", f.total, most);
    matches = matches && is_within(f.total, most);
  }
  if (matches)
    return "match";
  for (const Miss &miss : {of_class, of_passing, of_total})
    if (miss.gap > 0)
      return miss.words;
  return std::nullopt;
}

/// The limits of the question alone (1 and 2 of section 2).
void check_question(const Gradation &g, const Question &question, const ToleranceLines &tolerance) {
  const std::uint64_t e = highest_power(question.law, g.root());
  const std::uint64_t in_gradation = std::max({longest_opening(g), longest_part(g.masses()),
                                               longest_part(g.factors()), longest_part(g.tolerances())});
  if (e * std::max<std::uint64_t>(in_gradation, tolerance.longest) > max_power_bits ||
      64 * (g.powers().size() + tolerance.bands) * e * (in_gradation + tolerance.longest) > max_work)
    refuse_long_numbers();
}

} // namespace

std::optional<CertifiedSample> certified_sample(const Gradation &g, const Question &question,
                                                const SampleTally &tally) {
  const ToleranceLines tolerance = tolerance_lines(question, g);
  check_question(g, question, tolerance);
  const SampleFindings f = tally.findings();
  const std::optional<std::string> said = verdict(f, asked_bounds(g, question));
  if (!said)
    return std::nullopt;
  std::string text = "mdm-certificate sample 1\n" + law_and_openings_lines(question) + tolerance.text;
  if (tally.places())
    text += fmt::format("places {}\n", *tally.places());
  text += fmt::format("particles {}\n", to_string(f.particles)) + count_line("below", f.below) +
          count_line("above", f.above) + count_line("unplaced", f.unplaced);
  for (std::size_t j = 0; j < f.counts.size(); ++j)
    text += class_line(j, f.counts[j], f.shares[j]);
  text += largest_error("retained-error", f.share_errors);
  if (!f.passing_errors.empty())
    text += largest_error("passing-error", f.passing_errors);
  text += "total-error " + percents(f.total) + "\nconditions";
  for (const std::string_view condition : f.conditions)
    text += " " + std::string(condition);
  text += "\nverdict " + *said + "\nend\n";
  check_short_numbers(text);
  return CertifiedSample{std::move(text), *said == "match"};
}

} // namespace mdm

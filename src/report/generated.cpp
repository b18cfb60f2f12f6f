#include "generated_sizes.hpp"
#include "text_buffer.hpp"

#include <mdm/error.hpp>
#include <mdm/grading/size_distribution.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/text_table.hpp>
#include <mdm/report/versions.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned read_digits = 6; // in text

std::string pair(const Real &y, unsigned digits) {
  return json_enclosure(enclose(y, digits));
}

/// What is not negative, rounded outwards: never below 0, nor any wider than it is.
Enclosure outwards(const Interval &y, unsigned digits) {
  if (y.exact())
    return enclose(Real(y.lo), digits);
  const Integer d = denominator(y.lo) * denominator(y.hi);
  const Integer lo = numerator(y.lo) * denominator(y.hi), hi = numerator(y.hi) * denominator(y.lo);
  Enclosure e = enclose_interval(lo > 0 ? lo : hi, hi, d, digits);
  if (lo == 0)
    e.lo = 0;
  return e;
}

std::string pair(const Interval &y, unsigned digits) {
  return json_enclosure(outwards(y, digits));
}

std::string columns(const Real &y, unsigned digits) {
  const Enclosure e = enclose(y, digits);
  return e.lower_text() + "," + e.upper_text();
}

/// Bounds and volume fraction of class j, as generated or, for a match, as rounded.
struct Shown {
  Real lower, upper, volume_fraction;
};

Shown shown(const GeneratedSet &set, std::size_t j) {
  if (!set.match)
    return {set.classes[j].lower.real, set.classes[j].upper.real, set.classes[j].volume_fraction};
  const Gradation &g = set.match->gradation;
  return {g.lower(j), g.upper(j), g.mass(j)};
}

/// P_i (Eq. 10); nothing if not decided.
std::optional<Rational> number_fraction(const GeneratedSet &set, std::size_t j) {
  const std::optional<Integer> q = set.quantity(j), n = set.particles();
  return q && n ? std::optional(ratio(*q, *n)) : std::nullopt;
}

/// Size i of the table: equal steps from d_min to d_max.
Rational table_size(const GeneratedSet &set, unsigned i) {
  const Rational low = set.curve->d_min();
  return low + (set.curve->d_max() - low) * ratio(i, set.table - 1);
}

SizeDistribution distribution(const GeneratedSet &set) {
  std::vector<Real> bounds{set.classes.front().lower.real}, shares;
  for (const SizeClass &c : set.classes) {
    bounds.push_back(c.upper.real);
    shares.push_back(c.volume_fraction);
  }
  return SizeDistribution::by_volume(std::move(bounds), std::move(shares), set.wanted.dimension);
}

/// One line of the table.
struct TableLine {
  Rational size;
  Real passing, volume_density, partition, number_density; ///< h, V, F and f of the set
  Real curve;                                              ///< h of the curve that it is to have
};

std::vector<TableLine> table_lines(const GeneratedSet &set) {
  const SizeDistribution all = distribution(set);
  std::vector<TableLine> lines;
  for (unsigned i = 0; i < set.table; ++i) {
    const Rational d = table_size(set, i);
    lines.push_back({d, all.grading(d), all.volume_density(d), all.partition(d), all.number_density(d),
                     set.curve->passing(Surd(d))});
  }
  return lines;
}

/// A number of particles, with an exponent if it is long.
std::string short_count(const Integer &n) {
  constexpr std::size_t longest = 20;
  const std::string text = to_string(n);
  return text.size() <= longest ? text : rounded(Real(Rational(n)), read_digits);
}

std::string estimate_text(const IntegerBounds &n) {
  return n.known() ? short_count(n.lo) : short_count(n.lo) + " or " + short_count(n.hi);
}

std::string percent(const Real &share) {
  return rounded(share * 100, read_digits);
}

/// Its certain digits, or a bound where there are none.
std::string shown(const Interval &y) {
  const std::string text = rounded(real_in(y), read_digits);
  if (text != "0" || y.hi == 0)
    return text;
  const Integer n = numerator(y.hi);
  return "<= " + rounded(Real(enclose_interval(n, n, denominator(y.hi), 1).upper()), 1);
}

std::string percent(const Interval &share) {
  return shown(share * Interval(100));
}

std::string class_table(const GeneratedSet &set) {
  std::vector<std::vector<std::string>> lines = {
      {"class", "from", "to", "volume [%]", "N'", "N", "number [%]"}};
  if (set.drawn_quality)
    lines.front().insert(lines.front().end(), {"drawn volume [%]", "its largest [%]"});
  const bool decided = set.counts.decided();
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    const SizeClass &c = set.classes[j];
    lines.push_back({std::to_string(j + 1), rounded(c.lower.real, read_digits),
                     rounded(c.upper.real, read_digits), percent(c.volume_fraction),
                     estimate_text(set.counts.estimate[j]),
                     decided ? short_count(set.counts.numbers[j]) : "?",
                     decided ? percent(Real(ratio(set.counts.numbers[j], set.counts.particles()))) : "?"});
    if (set.drawn_quality)
      lines.back().insert(lines.back().end(),
                          {percent(set.drawn_quality->shares[j]), percent(set.drawn_quality->largest[j])});
  }
  return text_table(lines, ">");
}

std::string match_table(const GeneratedSet &set) {
  const Match &m = *set.match;
  std::vector<std::vector<std::string>> lines = {
      {"class", "from", "to", "volume", "quantity", "size of a particle"}};
  for (std::size_t j = 0; j < m.gradation.classes(); ++j) {
    const std::optional<std::size_t> at = place_in_match(m, j);
    lines.push_back({std::to_string(j + 1), to_decimal(m.gradation.lower(j)),
                     to_decimal(m.gradation.upper(j)), to_decimal(m.gradation.mass(j)),
                     at ? to_string(m.q[*at]) : "0", at ? m.sizes[*at].text() : "-"});
  }
  return text_table(lines, ">");
}

std::string sized(const Rational &size, const std::string &unit) {
  return rounded(Real(size), read_digits) + (unit.empty() ? "" : " " + unit);
}

/// What Eq. 8-9 give, in a line.
std::string count_line(const GeneratedSet &set) {
  const ClassCounts &c = set.counts;
  if (!c.decided())
    return "4096 bits do not decide every N': N is not known";
  std::string text =
      "N = " + short_count(c.particles()) + " (sum N' = " + short_count(c.estimated().lo) + ")";
  if (c.particles() < set.wanted.at_least)
    text += ", " + to_string(Integer(set.wanted.at_least - c.particles())) +
            " fewer than N_min: the floors of Eq. 9 lose them";
  return text;
}

/// What is known of the match, in a line.
std::string match_line(const Match &m) {
  return m.complete ? "N = " + to_string(m.particles())
                    : "stopped at a limit: N is at least " + to_string(m.lower_bound);
}

/// Whether N_max is kept, if there is one.
std::optional<std::string> verdict_line(const GeneratedSet &set) {
  if (!set.at_most)
    return std::nullopt;
  const std::optional<bool> accessible = set.accessible();
  const std::string verdict = "accessible with N_max = " + to_string(*set.at_most);
  return accessible ? (*accessible ? "" : "not ") + verdict : "it is open whether a set is " + verdict;
}

std::vector<std::string> quality_line(const std::string &name, const Integer &n, const SetQuality &q) {
  return {name, short_count(n), percent(q.worst_error), shown(q.c_r), shown(q.c_u), shown(q.c_c)};
}

/// Beside the curve, what of it the sets have.
std::string quality_table(const GeneratedSet &set) {
  std::vector<std::vector<std::string>> lines = {{"", "N", "worst class error [%]", "C_r", "C_u", "C_c"},
                                                 {"the curve", "", "", "",
                                                  rounded(uniformity(*set.curve), read_digits),
                                                  rounded(curvature(*set.curve), read_digits)}};
  if (set.counts.decided())
    lines.push_back({"Eq. 6-10, all of median size", short_count(set.counts.particles()),
                     percent(rounding_cost(set.classes, set.counts, set.wanted.dimension)), "", "", ""});
  if (set.drawn_quality)
    lines.push_back(quality_line(set.seed ? fmt::format("Eq. 6-10, drawn with seed {}", *set.seed)
                                          : "Eq. 6-10, quantiles",
                                 set.counts.particles(), *set.drawn_quality));
  if (set.match_quality)
    lines.push_back(quality_line(set.spread ? "the match, spread" : "the match", set.match->particles(),
                                 *set.match_quality));
  return text_table(lines, "<>");
}

std::string quality_json(const SetQuality &q, unsigned digits) {
  std::string classes;
  for (std::size_t j = 0; j < q.shares.size(); ++j)
    classes += fmt::format(R"({}{{"share":{},"largest":{}}})", j == 0 ? "" : ",", pair(q.shares[j], digits),
                           pair(q.largest[j], digits));
  return fmt::format(R"({{"Cr":{},"worst_error":{},"Cu":{},"Cc":{},"classes":[{}]}})", pair(q.c_r, digits),
                     pair(q.worst_error, digits), pair(q.c_u, digits), pair(q.c_c, digits), classes);
}

} // namespace

std::optional<Integer> GeneratedSet::quantity(std::size_t j) const {
  if (!match)
    return counts.decided() ? std::optional(counts.numbers[j]) : std::nullopt;
  if (!match->complete)
    return std::nullopt;
  const std::optional<std::size_t> at = place_in_match(*match, j);
  return at ? match->q[*at] : Integer(0);
}

std::optional<Integer> GeneratedSet::particles() const {
  if (match)
    return match->complete ? std::optional(match->particles()) : std::nullopt;
  return counts.decided() ? std::optional(counts.particles()) : std::nullopt;
}

ParticlesOf GeneratedSet::match_particles() const {
  return spread ? spread_particles(*match, *spread) : matched_particles(*match);
}

std::optional<bool> GeneratedSet::accessible() const {
  if (!at_most)
    return true;
  if (!match)
    return is_accessible(counts, wanted, *at_most);
  if (match->complete)
    return match->particles() <= *at_most;
  return match->lower_bound > *at_most ? std::optional(false) : std::nullopt;
}

void generated_json(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink) {
  const unsigned digits = set.digits;
  const std::optional<std::uint64_t> seed = set.match ? set.spread : set.seed;
  std::string text = fmt::format(
      R"({{"schema":"mdm-generate-1","id":{},"unit":{},"method":"{}","dimension":"{}","seed":{},)"
      R"("classes":[)",
      json_string(set.id), set.unit.empty() ? "null" : json_string(set.unit), set.match ? "match" : "paper",
      set.wanted.dimension, seed ? fmt::format("\"{}\"", *seed) : "null");
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    const Shown c = shown(set, j);
    const std::optional<Integer> q = set.quantity(j);
    const std::optional<Rational> p = number_fraction(set, j);
    text += fmt::format(
        R"({}{{"lower":{},"upper":{},"volume_fraction":{},"estimate":["{}","{}"],"quantity":{},)"
        R"("number_fraction":{}}})",
        j == 0 ? "" : ",", pair(c.lower, digits), pair(c.upper, digits), pair(c.volume_fraction, digits),
        to_string(set.counts.estimate[j].lo), to_string(set.counts.estimate[j].hi),
        q ? "\"" + to_string(*q) + "\"" : "null", p ? pair(Real(*p), digits) : "null");
  }
  const std::optional<Integer> n = set.particles();
  const std::optional<bool> accessible = set.at_most ? set.accessible() : std::nullopt;
  text += fmt::format(R"(],"particles":{},"accessible":{},"Cu":{},"Cc":{})",
                      n ? "\"" + to_string(*n) + "\"" : "null",
                      accessible ? (*accessible ? "true" : "false") : "null",
                      pair(uniformity(*set.curve), digits), pair(curvature(*set.curve), digits));
  if (set.drawn_quality || set.match_quality)
    text += fmt::format(R"(,"quality":{{"points":"{}","drawn":{},"match":{}}})", set.points,
                        set.drawn_quality ? quality_json(*set.drawn_quality, digits) : "null",
                        set.match_quality ? quality_json(*set.match_quality, digits) : "null");
  if (set.table > 0) {
    std::string lines;
    for (const TableLine &line : table_lines(set))
      lines +=
          fmt::format(R"({}{{"size":{},"passing":{},"volume_density":{},"partition":{},"number_density":{},)"
                      R"("curve_passing":{}}})",
                      lines.empty() ? "" : ",", pair(Real(line.size), digits), pair(line.passing, digits),
                      pair(line.volume_density, digits), pair(line.partition, digits),
                      pair(line.number_density, digits), pair(line.curve, digits));
    text += R"(,"curve":[)" + lines + "]";
  }
  text += R"(,"notes":[)";
  for (std::size_t i = 0; i < set.notes.size(); ++i)
    text += (i == 0 ? "" : ",") + json_string(set.notes[i]);
  text += R"(],"versions":)" + versions_json();
  if (draws) {
    sink(text + R"(,"sizes":[)");
    write_sizes_json(set, *draws, sink);
    text = "]";
  }
  sink(text + "}");
}

void generated_csv(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink) {
  if (draws) {
    write_sizes_csv(set, *draws, sink);
    return;
  }
  const unsigned digits = set.digits;
  std::string text;
  if (set.table > 0) {
    text = "size_lo,size_hi,passing_lo,passing_hi,volume_density_lo,volume_density_hi,partition_lo,"
           "partition_hi,number_density_lo,number_density_hi,curve_passing_lo,curve_passing_hi\n";
    for (const TableLine &line : table_lines(set))
      text +=
          fmt::format("{},{},{},{},{},{}\n", columns(Real(line.size), digits), columns(line.passing, digits),
                      columns(line.volume_density, digits), columns(line.partition, digits),
                      columns(line.number_density, digits), columns(line.curve, digits));
  } else {
    text = "class,lower_lo,lower_hi,upper_lo,upper_hi,volume_fraction_lo,volume_fraction_hi,quantity,"
           "number_fraction_lo,number_fraction_hi\n";
    for (std::size_t j = 0; j < set.classes.size(); ++j) {
      const Shown c = shown(set, j);
      const std::optional<Integer> q = set.quantity(j);
      const std::optional<Rational> p = number_fraction(set, j);
      text += fmt::format("{},{},{},{},{},{}\n", j + 1, columns(c.lower, digits), columns(c.upper, digits),
                          columns(c.volume_fraction, digits), q ? to_string(*q) : "",
                          p ? columns(Real(*p), digits) : ",");
    }
  }
  sink(text);
}

std::string headline(const GeneratedSet &set) {
  const std::optional<std::string> verdict = verdict_line(set);
  return (verdict ? *verdict + ": " : "") + (set.match ? match_line(*set.match) : count_line(set));
}

std::string generated_text(const GeneratedSet &set) {
  std::string text =
      fmt::format("{}, from {} to {}\n  {}\n", printable(set.id), sized(set.curve->d_min(), set.unit),
                  sized(set.curve->d_max(), set.unit), set.terms);
  text += "\n  by the paper (Eq. 6-10): " + count_line(set) + "\n" + class_table(set);
  if (set.match) {
    const Match &m = *set.match;
    text += fmt::format("\n  exact, bounds and volumes rounded to {} digits: ", set.match_digits);
    text += match_line(m);
    text += m.complete ? ", every class's volume exactly as below\n" + match_table(set) : "\n";
  }
  text += "\n" + quality_table(set);
  if (const std::optional<std::string> verdict = verdict_line(set))
    text += "\n  " + *verdict + "\n";
  if (set.table > 0) {
    std::vector<std::vector<std::string>> lines = {{"d", "h(d)", "V(d)", "F(d)", "f(d)", "h of the curve"}};
    for (const TableLine &line : table_lines(set))
      lines.push_back({rounded(Real(line.size), read_digits), rounded(line.passing, read_digits),
                       rounded(line.volume_density, read_digits), rounded(line.partition, read_digits),
                       rounded(line.number_density, read_digits), rounded(line.curve, read_digits)});
    text += "\n" + text_table(lines, ">");
  }
  for (const std::string &note : set.notes)
    text += "  note: " + note + "\n";
  return text;
}

} // namespace mdm

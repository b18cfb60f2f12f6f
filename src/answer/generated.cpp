#include "answer/generated_sizes.hpp"
#include "answer/json_values.hpp"
#include "gradation/shown.hpp"
#include "sets/size_distribution.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned read_digits = 6; // in text

/// An enclosure of a number that is not negative, rounded outwards but never below 0.
Enclosure outwards(const Interval &y, unsigned digits) {
  if (y.is_point())
    return enclose(Real(y.lo), digits);
  const Integer d = denominator(y.lo) * denominator(y.hi);
  const Integer lo = numerator(y.lo) * denominator(y.hi), hi = numerator(y.hi) * denominator(y.lo);
  Enclosure e = enclose_interval(lo > 0 ? lo : hi, hi, d, digits);
  if (lo == 0)
    e.lo = 0;
  return e;
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
  return n.is_point() ? short_count(n.lo) : short_count(n.lo) + " or " + short_count(n.hi);
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
  for (const MatchClass &c : m.classes())
    lines.push_back({std::to_string(lines.size()), c.lower.text(), c.upper.text(), to_decimal(c.mass),
                     to_string(c.quantity), c.size ? c.size->text() : "-"});
  return text_table(lines, ">");
}

std::string sized(const Rational &size, const std::string &unit) {
  return rounded(Real(size), read_digits) + (unit.empty() ? "" : " " + unit);
}

/// The counts by Eq. 8-9, in a line.
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

/// The match, or its bounds, in a line.
std::string match_line(const Match &m) {
  return m.complete ? "N = " + to_string(*m.particles())
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
    lines.push_back(quality_line(set.spread ? "the match, spread" : "the match", *set.match->particles(),
                                 *set.match_quality));
  return text_table(lines, "<>");
}

void write_quality(JsonWriter &json, const std::optional<SetQuality> &q, unsigned digits) {
  if (!q) {
    json.null();
    return;
  }
  write(json.begin_object().key("Cr"), outwards(q->c_r, digits));
  write(json.key("worst_error"), outwards(q->worst_error, digits));
  write(json.key("Cu"), outwards(q->c_u, digits));
  write(json.key("Cc"), outwards(q->c_c, digits));
  json.key("classes").begin_array();
  for (std::size_t j = 0; j < q->shares.size(); ++j) {
    write(json.begin_object().key("share"), outwards(q->shares[j], digits));
    write(json.key("largest"), outwards(q->largest[j], digits)).end_object();
  }
  json.end_array().end_object();
}

void write_class(JsonWriter &json, const GeneratedSet &set, std::size_t j) {
  const Shown c = shown(set, j);
  const std::optional<Rational> p = number_fraction(set, j);
  write(json.begin_object().key("lower"), enclose(c.lower, set.digits));
  write(json.key("upper"), enclose(c.upper, set.digits));
  write(json.key("volume_fraction"), enclose(c.volume_fraction, set.digits));
  json.key("estimate").bounds(to_string(set.counts.estimate[j].lo), to_string(set.counts.estimate[j].hi));
  write(json.key("quantity"), set.quantity(j));
  write(json.key("number_fraction"), p ? std::optional(enclose(Real(*p), set.digits)) : std::nullopt);
  json.end_object();
}

void write_table_line(JsonWriter &json, const TableLine &line, unsigned digits) {
  write(json.begin_object().key("size"), enclose(Real(line.size), digits));
  write(json.key("passing"), enclose(line.passing, digits));
  write(json.key("volume_density"), enclose(line.volume_density, digits));
  write(json.key("partition"), enclose(line.partition, digits));
  write(json.key("number_density"), enclose(line.number_density, digits));
  write(json.key("curve_passing"), enclose(line.curve, digits)).end_object();
}

} // namespace

std::optional<Integer> GeneratedSet::quantity(std::size_t j) const {
  if (!match)
    return counts.decided() ? std::optional(counts.numbers[j]) : std::nullopt;
  if (!match->complete)
    return std::nullopt;
  return match->sample->quantities[j];
}

std::optional<Integer> GeneratedSet::particles() const {
  if (match)
    return match->complete ? match->particles() : std::nullopt;
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
  JsonWriter json(sink);
  json.begin_object().key("schema").plain("mdm-generate-1").key("id").string(set.id);
  write_text(json.key("unit"), set.unit).key("method").plain(set.match ? "match" : "paper");
  json.key("dimension").number(set.wanted.dimension).key("seed");
  if (seed)
    json.number(*seed);
  else
    json.null();
  json.key("classes").begin_array();
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    write_class(json, set, j);
  json.end_array();
  write(json.key("particles"), set.particles());
  write_truth(json.key("accessible"), set.at_most ? set.accessible() : std::nullopt);
  write(json.key("Cu"), enclose(uniformity(*set.curve), digits));
  write(json.key("Cc"), enclose(curvature(*set.curve), digits));
  if (set.drawn_quality || set.match_quality) {
    write_quality(json.key("quality").begin_object().key("points").number(set.points).key("drawn"),
                  set.drawn_quality, digits);
    write_quality(json.key("match"), set.match_quality, digits);
    json.end_object();
  }
  if (set.table > 0) {
    json.key("curve").begin_array();
    for (const TableLine &line : table_lines(set))
      write_table_line(json, line, digits);
    json.end_array();
  }
  json.key("notes").strings(set.notes).key("versions").raw(versions_json());
  if (draws)
    write_sizes_json(set, *draws, json.key("sizes"));
  json.end_object();
  json.hand_on();
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

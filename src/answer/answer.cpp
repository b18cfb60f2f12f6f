#include "text/json_text.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/answer/answer.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace mdm {
namespace {

/// One class of the gradation as all three forms show it.
struct Row {
  std::string lower, upper, mass;
  std::string quantity;            // empty: no answer
  const Enclosure *size = nullptr; // nothing for an empty class
};

std::vector<Row> rows(const Match &m) {
  const Gradation &g = m.gradation;
  std::vector<Row> rows(g.classes());
  for (std::size_t j = 0; j < rows.size(); ++j)
    rows[j] = {j == 0 ? g.opening_text(0) : rows[j - 1].upper, g.opening_text(j + 1), to_decimal(g.mass(j)),
               "", nullptr};
  for (std::size_t j = 0; m.has_answer() && j < rows.size(); ++j) {
    rows[j].quantity = to_string(m.sample->quantities[j]);
    if (const std::optional<Enclosure> &size = m.sample->sizes[j])
      rows[j].size = &*size;
  }
  return rows;
}

const char *status_name(Status status) {
  static constexpr std::array<const char *, 4> names = {"optimal", "feasible", "none", "unknown"};
  return names.at(static_cast<std::size_t>(status));
}

/// add() with a format that FMT_COMPILE made: in a batch, reading formats at run time costs as much as the
/// rest of a report.
template <class Format, class... Args>
void add_compiled(Buffer &out, const Format &format, Args &&...args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

/// A row without its closing brace.
void add_json_row(Buffer &out, const Match &m, std::size_t j, const Row &row) {
  add_compiled(out, FMT_COMPILE(R"({{"lower":"{}","upper":"{}","mass":"{}",)"), row.lower, row.upper,
               row.mass);
  if (m.gradation.root() > 1)
    add(out, R"("lower_power":"{}","upper_power":"{}",)", to_string(m.gradation.powers()[j]),
        to_string(m.gradation.powers()[j + 1]));
  if (row.quantity.empty())
    add_compiled(out, FMT_COMPILE(R"("quantity":null,"size":null)"));
  else if (!row.size)
    add_compiled(out, FMT_COMPILE(R"("quantity":"{}","size":null)"), row.quantity);
  else
    add_compiled(out, FMT_COMPILE(R"("quantity":"{}","size":["{}","{}"])"), row.quantity,
                 row.size->lower_text(), row.size->upper_text());
}

/// The margin, which has three digits; with an exponent if it is tiny.
std::string margin_text(const MatchScale &scale) {
  static const Rational tiny = ratio(1, 1000000);
  return scale.margin < tiny ? approximate(scale.margin, 3) : to_decimal(scale.margin);
}

void add_json_scale(Buffer &out, const MatchScale &scale) {
  add_compiled(out, FMT_COMPILE(R"(,"scale":{{"above":"{}","up_to":"{}","chosen":"{}","margin":"{}")"),
               to_string(scale.window.above), to_string(scale.window.up_to), to_string(scale.chosen),
               margin_text(scale));
  if (const std::optional<Interval> &start = scale.window.start)
    add(out, R"(,"start":["{}","{}"])", to_string(start->lo), to_string(start->hi));
}

std::string json_bounds(const std::vector<ShareBounds> &bounds) {
  std::string text;
  for (const ShareBounds &b : bounds)
    text += fmt::format(R"({}["{}","{}"])", text.empty() ? "" : ",", to_string(b.lo), to_string(b.hi));
  return "[" + text + "]";
}

/// The tolerance as it was asked for and as bounds on shares, and the shares that the match has.
void add_json_tolerance(Buffer &out, const Match &m) {
  const Tolerance &t = *m.tolerance;
  std::string asked, achieved;
  for (const AskedTolerance &a : m.question.tolerances)
    asked += (asked.empty() ? "\"" : ",\"") + to_string(a) + "\"";
  if (m.sample)
    for (const Rational &share : *m.sample->shares)
      achieved += (achieved.empty() ? "\"" : ",\"") + to_string(share) + "\"";
  add(out, R"(,"tolerance":{{"asked":[{}],"band":{},"retained":{},"passing":{},"total":{}}},"achieved":{})",
      asked, m.question.band ? json_string(m.question.band->id) : "null", json_bounds(t.retained),
      json_bounds(t.passing), t.total ? "\"" + to_string(*t.total) + "\"" : "null",
      m.has_answer() ? "[" + achieved + "]" : "null");
}

/// The scale at which the achieved shares are the masses: with it and the quantities a reader has the sizes
/// exactly, as f^-1(chosen * share / (quantity * factor)).
void add_json_tolerant_scale(Buffer &out, const MatchSample &sample) {
  add(out, R"(,"scale":{{"above":null,"up_to":null,"chosen":"{}","margin":null)", to_string(sample.mass));
}

void add_json_spectrum(Buffer &out, const Spectrum &s) {
  add(out, R"(,"spectrum":{{"intervals":[)");
  for (std::size_t i = 0; i < s.intervals.size(); ++i)
    add(out, R"({}["{}","{}"])", i == 0 ? "" : ",", to_string(s.intervals[i].first),
        to_string(s.intervals[i].second));
  add(out, R"(],"{}":"{}"}})", s.complete ? "all_from" : "unknown_from", to_string(s.all_from));
}

std::string counted(const Integer &n) {
  return to_string(n) + (n == 1 ? " particle" : " particles");
}

/// The text form's table.
void add_table(Buffer &out, const Match &m) {
  const std::string unit(name(m.gradation.unit()));
  TextTable table;
  table.add_column("class", '>');
  table.add_column("sizes, " + unit + " (above, up to]", '<');
  table.add_column("mass", '>');
  table.add_column("quantity", '>');
  table.add_column("size of a particle (" + unit + ")", '<');
  const std::vector<Row> all = rows(m);
  for (std::size_t j = 0; j < all.size(); ++j) {
    const Row &r = all[j];
    table.add_line();
    for (const std::string &entry : {std::to_string(j + 1), "(" + r.lower + ", " + r.upper + "]", r.mass,
                                     r.quantity, r.size ? r.size->text() : "-"})
      table.add(entry);
  }
  add(out, "{}", table.text());
}

/// A share in percent: exact if that is short, else its first digits.
std::string percent_text(const Rational &share) {
  constexpr std::size_t longest = 9;
  constexpr unsigned digits = 7;
  const std::optional<std::string> exact = exact_decimal(Rational(share * 100));
  return exact && exact->size() <= longest ? *exact : approximate(Rational(share * 100), digits);
}

std::string limits_text(const ShareBounds &bounds) {
  if (bounds.lo == 0 && bounds.hi == 1)
    return "-";
  return percent_text(bounds.lo) + " .. " + percent_text(bounds.hi);
}

/// Shares that a tolerance speaks of, one a class: those of the gradation, their limits and those of the
/// match.
struct ShownShares {
  std::string what;
  std::vector<Rational> target;
  std::vector<ShareBounds> limits; ///< may be empty
  std::vector<Rational> achieved;
};

/// The shares that pass the upper sieves or are retained on the lower ones, as the question asks.
std::vector<ShownShares> shown_shares(const Match &m) {
  const Tolerance &t = *m.tolerance;
  const std::vector<Rational> target = shares(m.gradation);
  const std::vector<Rational> &achieved = *m.sample->shares;
  std::vector<ShownShares> shown;
  if (!t.passing.empty())
    shown.push_back({"passes upper (%)", accumulated(target), t.passing, accumulated(achieved)});
  if (!t.retained.empty() || t.total)
    shown.push_back({"retained (%)", target, t.retained, achieved});
  return shown;
}

/// A column of percentage points that were worked out for each sieve: those at the upper one of each class.
struct ShownTolerance {
  std::string what;
  std::vector<Rational> percent;
};

std::vector<ShownTolerance> shown_tolerances(const Match &m) {
  std::vector<ShownTolerance> shown;
  for (const AskedTolerance &a : m.question.tolerances)
    if (a.kind == AskedTolerance::Kind::laboratory || a.kind == AskedTolerance::Kind::rounding)
      shown.push_back({to_string(a) + " +-", passing_tolerances(m.gradation, a.kind)});
  return shown;
}

Rational total_deviation(const Match &m) {
  const std::vector<Rational> target = shares(m.gradation);
  Rational all = 0;
  for (std::size_t j = 0; j < target.size(); ++j)
    all += abs(Rational((*m.sample->shares)[j] - target[j]));
  return all;
}

/// The volume of solids, of spheres.
void add_text_volume(Buffer &out, const Match &m) {
  if (const std::optional<Enclosure> volume = m.solids_volume())
    add(out, "  volume of the particles: {} {}^3\n", volume->text(), name(m.gradation.unit()));
}

/// The same for a tolerance, with the shares that it speaks of.
void add_tolerant_table(Buffer &out, const Match &m) {
  const std::string unit(name(m.gradation.unit()));
  const std::vector<ShownShares> shown = shown_shares(m);
  const std::vector<ShownTolerance> tolerances = shown_tolerances(m);
  TextTable table;
  table.add_column("class", '>');
  table.add_column("sizes, " + unit + " (above, up to]", '<');
  for (const ShownShares &s : shown) {
    table.add_column(s.what, '>');
    if (!s.limits.empty())
      table.add_column("limits", '>');
    table.add_column("achieved", '>');
  }
  for (const ShownTolerance &t : tolerances)
    table.add_column(t.what, '>');
  table.add_column("quantity", '>');
  table.add_column("size of a particle (" + unit + ")", '<');
  const std::vector<Row> all = rows(m);
  for (std::size_t j = 0; j < all.size(); ++j) {
    const Row &r = all[j];
    table.add_line();
    table.add(std::to_string(j + 1));
    table.add("(" + r.lower + ", " + r.upper + "]");
    for (const ShownShares &s : shown) {
      table.add(percent_text(s.target[j]));
      if (!s.limits.empty())
        table.add(limits_text(s.limits[j]));
      table.add(percent_text(s.achieved[j]));
    }
    for (const ShownTolerance &t : tolerances)
      table.add(j < t.percent.size() ? to_decimal(t.percent[j]) : "-");
    table.add(r.quantity);
    table.add(r.size ? r.size->text() : "-");
  }
  add(out, "{}", table.text());
  out.push_back('\n');
  if (m.tolerance->total)
    add(out, "  sum of all deviations: {} of {} percentage points\n", percent_text(total_deviation(m)),
        percent_text(*m.tolerance->total));
  add_text_volume(out, m);
}

/// The scale of the asked volume: exactly, or enclosed.
std::string start_text(const Interval &s, unsigned digits) {
  if (s.is_point())
    return to_string(s.lo);
  return enclose_interval(numerator(s.lo) * denominator(s.hi), numerator(s.hi) * denominator(s.lo),
                          denominator(s.lo) * denominator(s.hi), digits)
      .text();
}

void add_text_scale(Buffer &out, const MatchScale &scale, const Match &m) {
  const unsigned p = m.scale_power();
  const std::string s = p == 1 ? "s" : "s^" + std::to_string(p);
  add(out, "  scale: {} above {} and up to {}", s, to_string(scale.window.above),
      to_string(scale.window.up_to));
  if (scale.window.start)
    add(out, "; from {} on for the volume", start_text(*scale.window.start, m.digits));
  add(out, "\n  chosen: {} = {}; every size is {} or more of itself away from the sieves\n", s,
      to_string(scale.chosen), margin_text(scale));
}

void add_text_spectrum(Buffer &out, const Spectrum &s) {
  add(out, "\n  numbers of particles that have an exact match:\n");
  for (const auto &[from, to] : s.intervals) {
    if (from == to)
      add(out, "    {}\n", to_string(from));
    else
      add(out, "    {} to {}\n", to_string(from), to_string(to));
  }
  if (s.complete)
    add(out, "    every number from {} on\n", to_string(s.all_from));
  else
    add(out, "    from {} on it is open: a limit was reached\n", to_string(s.all_from));
}

/// The JSON answer up to its classes.
void add_json_begin(Buffer &out, const Match &m) {
  add_compiled(out, FMT_COMPILE(R"({{"schema":"mdm-answer-1","id":{},"status":"{}",)"),
               json_string(m.gradation.id()), status_name(m.status));
  const std::optional<Integer> particles = m.particles();
  if (m.has_answer())
    add_compiled(out, FMT_COMPILE(R"("particles":"{}")"), to_string(*particles));
  else
    add(out, R"("particles":null)");
  add_compiled(out, FMT_COMPILE(R"(,"lower_bound":"{}")"), to_string(m.lower_bound));
  if (particles && (m.status == Status::feasible || m.status == Status::unknown))
    add(out, R"(,"upper_bound":"{}")", to_string(*particles));
  add_compiled(out, FMT_COMPILE(R"(,"unit":"{}",)"), name(m.gradation.unit()));
  if (m.gradation.root() > 1)
    add(out, R"("size_power":"{}",)", m.gradation.root());
  add_compiled(out, FMT_COMPILE(R"("classes":[)"));
}

/// The members behind its classes.
void add_json_end(Buffer &out, const Match &m, const Spectrum *spectrum,
                  const std::optional<std::uint64_t> &seed) {
  out.push_back(']');
  if (m.has_answer()) {
    if (m.sample->scale)
      add_json_scale(out, *m.sample->scale);
    else
      add_json_tolerant_scale(out, *m.sample);
    if (m.scale_power() > 1)
      add(out, R"(,"scale_power":"{}")", m.scale_power());
    out.push_back('}');
  } else {
    add(out, R"(,"scale":null)");
  }
  if (m.tolerance)
    add_json_tolerance(out, m);
  else
    add(out, R"(,"tolerance":null)");
  const std::optional<Enclosure> volume = m.has_answer() ? m.solids_volume() : std::nullopt;
  if (volume)
    add_compiled(out, FMT_COMPILE(R"(,"solids_volume":["{}","{}"])"), volume->lower_text(),
                 volume->upper_text());
  else
    add(out, R"(,"solids_volume":null)");
  if (spectrum != nullptr)
    add_json_spectrum(out, *spectrum);
  if (seed)
    add(out, R"(,"seed":"{}")", *seed);
  if (const std::string words = in_words(m.question); !words.empty())
    add(out, R"(,"question":{})", json_string(words));
  add(out, R"(,"notes":[)");
  for (std::size_t i = 0; i < m.notes.size(); ++i)
    add(out, "{}{}", i == 0 ? "" : ",", json_string(m.notes[i]));
  add_compiled(out, FMT_COMPILE(R"(],"versions":{}}})"), versions_json());
}

/// Streamed text is handed on in parts of some such length.
constexpr std::size_t part = std::size_t{1} << 16;

void hand_on(Buffer &out, const Sink &sink) {
  sink(std::string_view(out.data(), out.size()));
  out.clear();
}

/// Calls take(size) for every particle of a class.
template <class Take>
void for_each_size(const ClassSpread &c, unsigned digits, Take take) {
  ClassSpread::Masses masses = c.masses();
  for (std::uint64_t i = 0; i < c.quantity(); ++i)
    take(c.size(masses.next(), digits));
}

void add_text_spread(Buffer &out, const Match &m, const Spread &spread) {
  add(out, "\n  a spread with every class's mass exactly, seed {}:\n\n", spread.seed);
  const std::string unit(name(m.gradation.unit()));
  TextTable table;
  table.add_column("class", '>');
  table.add_column("quantity", '>');
  table.add_column("smallest size (" + unit + ")", '<');
  table.add_column("largest size (" + unit + ")", '<');
  for (const ClassSpread &c : spread.classes) {
    ClassSpread::Masses masses = c.masses();
    Integer least = c.most(), most = c.least();
    for (std::uint64_t i = 0; i < c.quantity(); ++i) {
      const Integer n = masses.next();
      least = std::min(least, n);
      most = std::max(most, n);
    }
    table.add_line();
    for (const std::string &entry : {std::to_string(c.index() + 1), std::to_string(c.quantity()),
                                     c.size(least, m.digits).text(), c.size(most, m.digits).text()})
      table.add(entry);
  }
  add(out, "{}", table.text());
}

} // namespace

std::string headline(const Match &m) {
  const std::string words = in_words(m.question);
  const std::string set = std::string("the smallest set that matches") + (m.tolerance ? "" : " exactly") +
                          (words.empty() ? "" : " (" + words + ")");
  if (m.status == Status::none && !m.complete)
    return "no match within the limit on N: " + set + " has at least " + counted(m.lower_bound);
  if (!m.sample) {
    if (!m.complete)
      return "stopped at a limit before a match was found: " + set + " has at least " +
             counted(m.lower_bound);
    const std::optional<std::string> reason =
        m.question.band ? contradiction(*m.question.band) : std::nullopt;
    return "no set matches (" + words + "): " +
           (reason ? "the band contradicts itself: " + *reason : "no gradation meets these demands at once");
  }
  const Integer particles = *m.particles();
  const std::string between = "N in [" + to_string(m.lower_bound) + ", " + to_string(particles) + "]";
  switch (m.status) {
  case Status::optimal:
    return counted(particles) + ": " + set;
  case Status::feasible:
    return "stopped at a limit: " + set + " has " + between + "; below is one with " + counted(particles);
  case Status::none:
    return "no match within the limit on N: " + set + " has " + counted(m.lower_bound);
  default:
    return "stopped at a limit: " + set + " has " + between + "; whether the limit on N can be met is open";
  }
}

std::string answer_json(const Match &m, const Spectrum *spectrum) {
  Buffer out;
  add_json_begin(out, m);
  const std::vector<Row> all = rows(m);
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (j > 0)
      out.push_back(',');
    add_json_row(out, m, j, all[j]);
    out.push_back('}');
  }
  add_json_end(out, m, spectrum, std::nullopt);
  return fmt::to_string(out);
}

void spread_json(const Match &m, const Spectrum *spectrum, const Spread &spread, const Sink &sink) {
  Buffer out;
  add_json_begin(out, m);
  const std::vector<Row> all = rows(m);
  auto spread_class = spread.classes.begin();
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (j > 0)
      out.push_back(',');
    add_json_row(out, m, j, all[j]);
    if (spread_class != spread.classes.end() && spread_class->index() == j) {
      add(out, R"(,"sizes":)");
      char before = '[';
      for_each_size(*spread_class++, m.digits, [&](const Enclosure &size) {
        add_compiled(out, FMT_COMPILE(R"({}["{}","{}"])"), before, size.lower_text(), size.upper_text());
        before = ',';
        if (out.size() > part)
          hand_on(out, sink);
      });
      out.push_back(']');
    }
    out.push_back('}');
  }
  add_json_end(out, m, spectrum, spread.seed);
  hand_on(out, sink);
}

std::string answer_csv(const Match &m) {
  Buffer out;
  const std::string_view unit = name(m.gradation.unit());
  add(out, "lower_{0},upper_{0},mass,quantity,size_lo_{0},size_hi_{0}\n", unit);
  for (const Row &r : rows(m))
    add(out, "{},{},{},{},{},{}\n", r.lower, r.upper, r.mass, r.quantity, r.size ? r.size->lower_text() : "",
        r.size ? r.size->upper_text() : "");
  return fmt::to_string(out);
}

void spread_csv(const Match &m, const Spread &spread, const Sink &sink) {
  Buffer out;
  add(out, "lower_{0},upper_{0},size_lo_{0},size_hi_{0}\n", name(m.gradation.unit()));
  const std::vector<Row> all = rows(m);
  for (const ClassSpread &c : spread.classes)
    for_each_size(c, m.digits, [&](const Enclosure &size) {
      const Row &row = all[c.index()];
      add_compiled(out, FMT_COMPILE("{},{},{},{}\n"), row.lower, row.upper, size.lower_text(),
                   size.upper_text());
      if (out.size() > part)
        hand_on(out, sink);
    });
  hand_on(out, sink);
}

std::string answer_text(const Match &m, const Spectrum *spectrum, const Spread *spread, bool with_scale) {
  Buffer out;
  add(out, "{}: {}\n", printable(m.gradation.id()), headline(m));
  if (m.has_answer()) {
    out.push_back('\n');
    if (m.tolerance) {
      add_tolerant_table(out, m);
    } else {
      add_table(out, m);
      if (with_scale || m.solids_volume())
        out.push_back('\n');
      if (with_scale)
        add_text_scale(out, *m.sample->scale, m);
      add_text_volume(out, m);
    }
  }
  if (spread != nullptr)
    add_text_spread(out, m, *spread);
  if (spectrum != nullptr)
    add_text_spectrum(out, *spectrum);
  for (const std::string &note : m.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

} // namespace mdm

#include "answer/answer.hpp"
#include "answer/answer_rows.hpp"
#include "number/counted.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// A share in percent: exact if that is short, else its first digits.
std::string percent_text(const Rational &share) {
  constexpr std::size_t longest = 9;
  constexpr unsigned digits = 7;
  const std::optional<std::string> exact = exact_decimal(Rational(share * 100));
  return exact && exact->size() <= longest ? *exact : approximate(Rational(share * 100), digits);
}

bool is_limit(const ShareBounds &bounds) {
  return bounds.lo > 0 || bounds.hi < 1;
}

std::string limits_text(const ShareBounds &bounds) {
  if (!is_limit(bounds))
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
  const Gradation &g = m.gradation;
  const std::vector<Rational> target = of_classes(g, shares(g));
  const std::vector<Rational> achieved = of_classes(g, *m.sample->shares);
  std::vector<ShownShares> shown;
  if (!t.passing.empty())
    shown.push_back({"passes upper (%)", accumulated(target), t.passing, accumulated(achieved)});
  if (!t.retained.empty() || t.total)
    shown.push_back({"retained (%)", target, of_classes(g, t.retained), achieved});
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
void add_text_volume(TextBuffer &out, const Match &m) {
  if (const std::optional<Enclosure> volume = m.solids_volume())
    add(out, "  volume of the particles: {} {}^3\n", volume->text(), name(m.gradation.unit()));
}

/// A column between the sizes of the classes and their quantities, with an entry a class.
struct Column {
  std::string title;
  std::vector<std::string> entries;
};

std::vector<Column> exact_columns(const std::vector<AnswerRow> &rows) {
  Column mass = {"mass", {}};
  for (const AnswerRow &row : rows)
    mass.entries.push_back(row.mass);
  return {mass};
}

/// The shares that the tolerance speaks of.
std::vector<Column> tolerant_columns(const Match &m) {
  std::vector<Column> columns;
  const auto add_shares = [&columns](const std::string &title, const std::vector<Rational> &shares) {
    columns.push_back({title, {}});
    for (const Rational &share : shares)
      columns.back().entries.push_back(percent_text(share));
  };
  for (const ShownShares &s : shown_shares(m)) {
    add_shares(s.what, s.target);
    if (std::any_of(s.limits.begin(), s.limits.end(), is_limit)) {
      columns.push_back({"limits", {}});
      for (const ShareBounds &bounds : s.limits)
        columns.back().entries.push_back(limits_text(bounds));
    }
    add_shares("achieved", s.achieved);
  }
  for (const ShownTolerance &t : shown_tolerances(m)) {
    columns.push_back({t.what, {}});
    for (const Rational &percent : t.percent)
      columns.back().entries.push_back(to_decimal(percent));
    columns.back().entries.resize(m.gradation.classes(), "-");
  }
  return columns;
}

void add_table(TextBuffer &out, const Match &m) {
  const std::vector<AnswerRow> rows = answer_rows(m);
  const std::vector<Column> columns = m.tolerance ? tolerant_columns(m) : exact_columns(rows);
  const std::string unit(name(m.gradation.unit()));
  const bool has_materials = !m.gradation.materials().empty();
  TextTable table;
  table.add_column("class", '>');
  if (has_materials)
    table.add_column("material", '<');
  table.add_column("sizes, " + unit + " (above, up to]", '<');
  for (const Column &column : columns)
    table.add_column(column.title, '>');
  table.add_column("quantity", '>');
  table.add_column("size of a particle (" + unit + ")", '<');
  for (std::size_t j = 0; j < rows.size(); ++j) {
    table.add_line();
    table.add(std::to_string(rows[j].index + 1));
    if (has_materials)
      table.add(printable(rows[j].material));
    table.add(rows[j].sizes());
    for (const Column &column : columns)
      table.add(column.entries[j]);
    table.add(rows[j].quantity);
    table.add(rows[j].size != nullptr ? rows[j].size->text() : "-");
  }
  add(out, "{}", table.text());
}

void add_total_deviation(TextBuffer &out, const Match &m) {
  add(out, "  sum of all deviations: {} of {} percentage points\n", percent_text(total_deviation(m)),
      percent_text(*m.tolerance->total));
}

/// The scale of the asked volume: exactly, or enclosed.
std::string start_text(const Interval &s, unsigned digits) {
  if (s.is_point())
    return to_string(s.lo);
  return enclose_interval(numerator(s.lo) * denominator(s.hi), numerator(s.hi) * denominator(s.lo),
                          denominator(s.lo) * denominator(s.hi), digits)
      .text();
}

void add_text_scale(TextBuffer &out, const MatchScale &scale, const Match &m) {
  const unsigned p = m.scale_power();
  const std::string s = p == 1 ? "s" : "s^" + std::to_string(p);
  add(out, "  scale: {} above {} and up to {}", s, to_string(scale.window.above),
      to_string(scale.window.up_to));
  if (scale.window.start)
    add(out, "; from {} on for the volume", start_text(*scale.window.start, m.digits));
  add(out, "\n  chosen: {} = {}; every size is {} or more of itself away from the sieves\n", s,
      to_string(scale.chosen), margin_text(scale));
}

void add_text_spectrum(TextBuffer &out, const Spectrum &s) {
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

void add_text_spread(TextBuffer &out, const Match &m, const Spread &spread) {
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

std::string budget_text(const MatchBudget &budget) {
  const bool is_tolerance = budget.by == BudgetBy::tolerance;
  const std::string what = is_tolerance ? "tolerance" : "size factor", sign = is_tolerance ? "%" : "";
  const std::string particles = counted(budget.particles) + ": ";
  if (!budget.enough && !budget.is_decided)
    return particles + "no " + what + " is known to suffice";
  if (!budget.enough)
    return particles + "no " + what + " suffices" +
           (is_tolerance ? "" : ": without the specimen no match has so few");
  const std::string enough =
      particles + "the " + what + " " + to_decimal(*budget.enough) + sign + " suffices";
  return budget.next_finer ? enough + ", " + to_decimal(*budget.next_finer) + sign + " does not" : enough;
}

std::string headline(const Match &m) {
  const std::string words = in_words(m.question, m.gradation.unit());
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
    return "stopped at a limit: " + set + " has " + between + "; one with " + counted(particles) +
           " was found";
  case Status::none:
    return "no match within the limit on N: " + set + " has " + counted(m.lower_bound);
  default:
    return "stopped at a limit: " + set + " has " + between + "; whether the limit on N can be met is open";
  }
}

std::string answer_text(const Match &m, const Spectrum *spectrum, const Spread *spread, bool with_scale) {
  TextBuffer out;
  add(out, "{}: {}\n", printable(m.gradation.id()), headline(m));
  if (m.budget)
    add(out, "  {}\n", budget_text(*m.budget));
  if (m.has_answer()) {
    out.push_back('\n');
    add_table(out, m);
    const bool scale_shown = with_scale && m.sample->scale;
    if (m.tolerance || scale_shown || m.solids_volume())
      out.push_back('\n');
    if (m.tolerance && m.tolerance->total)
      add_total_deviation(out, m);
    if (scale_shown)
      add_text_scale(out, *m.sample->scale, m);
    add_text_volume(out, m);
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

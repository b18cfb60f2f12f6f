#include "report/timesteps_report.hpp"

#include "answer/json_values.hpp"
#include "number/counted.hpp"
#include "report/interval_json.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

bool has_coordination(const TimestepState &s) {
  return s.packing && s.packing->coordination.spheres > 0;
}

/// A column of what is measured at each timestep.
struct TimestepMeasure {
  const char *key;   ///< in CSV, and without _percent in JSON
  const char *title; ///< in the table
  std::optional<Interval> (*value)(const TimestepState &);
  bool is_percent = false;
};

constexpr TimestepMeasure timestep_measures[] = {
    {"largest_error_percent", "largest error %",
     [](const TimestepState &s) { return std::optional(s.maximum_error); }, true},
    {"total_error_percent", "all errors %",
     [](const TimestepState &s) { return std::optional(s.total_error); }, true},
    {"void_ratio", "void ratio", [](const TimestepState &s) { return s.void_ratio(); }},
    {"coordination", "Z", [](const TimestepState &s) { return s.coordination(); }},
    {"coordination_without_rattlers", "Z, no rattlers",
     [](const TimestepState &s) { return s.coordination_without_rattlers(); }},
    {"rattlers_percent", "rattlers %", [](const TimestepState &s) { return s.rattlers(); }, true},
    {"segregation", "segregation", [](const TimestepState &s) { return s.segregation(); }},
    {"breakage_hardin", "B_r", [](const TimestepState &s) { return s.hardin; }},
    {"breakage_einav", "B", [](const TimestepState &s) { return s.einav; }}};

std::string text_of(const TimestepMeasure &m, const TimestepState &s, unsigned digits) {
  const std::optional<Interval> y = m.value(s);
  if (!y)
    return "";
  return m.is_percent ? percent_text(*y, digits) : interval_text(*y);
}

std::string fines_lost_text(const TimestepsReport &r, const TimestepState &s) {
  const std::optional<Rational> lost = r.fines_lost(s);
  return lost ? percent_text(*lost, r.digits) : "";
}

/// True if the measure is available at some timestep.
bool is_there(const TimestepMeasure &m, const TimestepsReport &r) {
  return std::any_of(r.states.begin(), r.states.end(),
                     [&m](const TimestepState &s) { return m.value(s).has_value(); });
}

std::string headline(const TimestepsReport &r) {
  const auto first = std::find_if(r.states.begin(), r.states.end(),
                                  [](const TimestepState &s) { return s.verdict != Verdict::match; });
  if (first == r.states.end())
    return r.states.size() == 1 ? "matches at the one timestep"
                                : fmt::format("matches at all {} timesteps", r.states.size());
  const auto matching = std::count_if(r.states.begin(), r.states.end(),
                                      [](const TimestepState &s) { return s.verdict == Verdict::match; });
  return fmt::format("matches at {} of {}; at {}, the first of the others: {}", matching,
                     counted(r.states.size(), "timestep"), to_string(first->timestep), first->headline);
}

} // namespace

std::optional<Interval> TimestepState::void_ratio() const {
  return packing ? std::optional(packing->void_ratio) : std::nullopt;
}

std::optional<Interval> TimestepState::coordination() const {
  return has_coordination(*this) ? std::optional<Interval>(packing->coordination.mean()) : std::nullopt;
}

std::optional<Interval> TimestepState::coordination_without_rattlers() const {
  const std::optional<Rational> mean =
      has_coordination(*this) ? packing->coordination.mean_without_rattlers() : std::nullopt;
  return mean ? std::optional<Interval>(*mean) : std::nullopt;
}

std::optional<Interval> TimestepState::rattlers() const {
  if (!has_coordination(*this))
    return std::nullopt;
  return Interval(ratio(packing->coordination.rattlers, packing->coordination.spheres));
}

std::optional<Interval> TimestepState::segregation() const {
  return packing ? packing->segregation : std::nullopt;
}

Verdict TimestepsReport::verdict() const {
  const auto has = [this](Verdict verdict) {
    return std::any_of(states.begin(), states.end(),
                       [verdict](const TimestepState &s) { return s.verdict == verdict; });
  };
  return has(Verdict::no_match)    ? Verdict::no_match
         : has(Verdict::undecided) ? Verdict::undecided
                                   : Verdict::match;
}

std::optional<Rational> TimestepsReport::fines_lost(const TimestepState &state) const {
  const Integer &first = states.front().finest;
  return first == 0 ? std::nullopt : std::optional<Rational>(ratio(Integer(first - state.finest), first));
}

std::string timesteps_csv(const TimestepsReport &r) {
  TextBuffer out;
  add(out, "timestep,verdict,particles,below,above,fines_lost_percent");
  for (const TimestepMeasure &m : timestep_measures)
    add(out, ",{}", m.key);
  const Gradation &g = r.gradation;
  for (std::size_t j = 0; j < g.classes(); ++j)
    add(out, ",found_percent_{}_{}_{}", g.opening_text(j), g.opening_text(j + 1), name(g.unit()));
  out.push_back('\n');
  for (const TimestepState &s : r.states) {
    add(out, "{},{},{},{},{},{}", to_string(s.timestep), name(s.verdict), to_string(s.particles),
        to_string(s.below), to_string(s.above), fines_lost_text(r, s));
    for (const TimestepMeasure &m : timestep_measures)
      add(out, ",{}", csv_field(text_of(m, s, r.digits)));
    for (const Interval &share : s.shares)
      add(out, ",{}", csv_field(percent_text(share, r.digits)));
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

std::string timesteps_json(const TimestepsReport &r) {
  JsonWriter json;
  const Gradation &g = r.gradation;
  json.begin_object().key("schema").plain("mdm-timesteps-1").key("id").string(g.id());
  json.key("sample").string(r.sample).key("verdict").plain(name(r.verdict()));
  json.key("unit").plain(name(g.unit())).key("openings").begin_array();
  for (std::size_t j = 0; j <= g.classes(); ++j)
    json.plain(g.opening_text(j));
  json.end_array().key("timesteps").begin_array();
  for (const TimestepState &s : r.states) {
    write(json.begin_object().key("timestep"), s.timestep);
    json.key("verdict").plain(name(s.verdict));
    write(json.key("particles"), s.particles);
    write(json.key("below"), s.below);
    write(json.key("above"), s.above);
    write(json.key("fines_lost"), r.fines_lost(s));
    json.key("found").begin_array();
    for (const Interval &share : s.shares)
      write_number(json, share);
    json.end_array();
    for (const TimestepMeasure &m : timestep_measures) {
      constexpr std::string_view percent = "_percent";
      std::string_view key = m.key;
      if (key.ends_with(percent))
        key.remove_suffix(percent.size());
      json.key(key);
      if (const std::optional<Interval> y = m.value(s))
        write_number(json, *y);
      else
        json.null();
    }
    json.end_object();
  }
  json.end_array().key("notes").strings(r.notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string timesteps_text(const TimestepsReport &r) {
  TextBuffer out;
  add(out, "{} against {}: {}\n\n", printable(r.sample), printable(r.gradation.id()), headline(r));
  std::vector<std::string> titles = {"timestep", "verdict", "particles", "outside", "fines lost %"};
  std::vector<const TimestepMeasure *> shown;
  for (const TimestepMeasure &m : timestep_measures)
    if (is_there(m, r)) {
      shown.push_back(&m);
      titles.emplace_back(m.title);
    }
  std::vector<std::vector<std::string>> lines = {std::move(titles)};
  for (const TimestepState &s : r.states) {
    std::vector<std::string> line = {to_string(s.timestep), name(s.verdict), to_string(s.particles),
                                     to_string(Integer(s.below + s.above)), fines_lost_text(r, s)};
    for (const TimestepMeasure *m : shown)
      line.push_back(text_of(*m, s, r.digits));
    lines.push_back(std::move(line));
  }
  add(out, "{}", text_table(lines, "><>"));
  add(out, "\n  fines: the particles of the finest class with mass, lost since the first timestep\n"
           "  Z: contacts of a particle; segregation by height (Danckwerts; 0 none, 1 full)\n"
           "  B_r, B: relative breakage of Hardin and of Einav, against the gradation\n");
  for (const std::string &note : r.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

} // namespace mdm

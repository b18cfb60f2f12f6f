#include "answer/answer.hpp"
#include "answer/answer_rows.hpp"
#include "answer/answer_schema.hpp"
#include "answer/json_values.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <array>

namespace mdm {
namespace {

const char *status_name(Status status) {
  static constexpr std::array<const char *, 4> names = {"optimal", "feasible", "none", "unknown"};
  return names.at(static_cast<std::size_t>(status));
}

/// The members of a budget.
void write_budget(JsonWriter &json, const MatchBudget &budget) {
  write(json.key("particles"), budget.particles);
  write_decimal(json.key(budget.by == BudgetBy::tolerance ? "tolerance" : "size_factor"), budget.enough);
  write_decimal(json.key("next_finer"), budget.next_finer);
  json.end_object();
}

/// The members before the classes.
void write_verdict(JsonWriter &json, const Match &m) {
  const std::optional<Integer> particles = m.particles();
  json.key("schema").plain(answer_schema).key("id").string(m.gradation.id());
  json.key("status").plain(status_name(m.status));
  write(json.key("particles"), m.has_answer() ? particles : std::nullopt);
  write(json.key("lower_bound"), m.lower_bound);
  if (particles && (m.status == Status::feasible || m.status == Status::unknown))
    write(json.key("upper_bound"), *particles);
  if (m.budget)
    write_budget(json.key("budget").begin_object(), *m.budget);
  json.key("unit").plain(name(m.gradation.unit()));
  if (m.gradation.root() > 1)
    json.key("size_power").number(m.gradation.root());
}

/// The members of a class, all but its spread.
void write_class(JsonWriter &json, const Match &m, const AnswerRow &row) {
  if (!row.material.empty())
    json.key("material").string(row.material);
  json.key("lower").plain(row.lower).key("upper").plain(row.upper).key("mass").plain(row.mass);
  if (m.gradation.has_factors())
    write_decimal(json.key("factor"), m.gradation.factor(row.index));
  if (m.gradation.root() > 1) {
    write(json.key("lower_power"), m.gradation.powers()[row.index]);
    write(json.key("upper_power"), m.gradation.powers()[row.index + 1]);
  }
  json.key("quantity");
  if (row.quantity.empty())
    json.null();
  else
    json.plain(row.quantity);
  json.key("size");
  if (row.size != nullptr)
    write(json, *row.size);
  else
    json.null();
}

/// Of a match within a tolerance: the scale at which the achieved shares are the masses. With it and the
/// quantities a reader has the sizes exactly, as f^-1(chosen * share / (quantity * factor)).
void write_tolerant_scale(JsonWriter &json, const MatchSample &sample) {
  json.key("above").null().key("up_to").null();
  write(json.key("chosen"), sample.mass).key("margin").null();
}

void write_exact_scale(JsonWriter &json, const MatchScale &scale) {
  write(json.key("above"), scale.window.above);
  write(json.key("up_to"), scale.window.up_to);
  write(json.key("chosen"), scale.chosen).key("margin").plain(margin_text(scale));
  if (const std::optional<Interval> &start = scale.window.start)
    json.key("start").bounds(to_string(start->lo), to_string(start->hi));
}

void write_scale(JsonWriter &json, const Match &m) {
  if (!m.has_answer()) {
    json.null();
    return;
  }
  json.begin_object();
  if (m.sample->scale)
    write_exact_scale(json, *m.sample->scale);
  else
    write_tolerant_scale(json, *m.sample);
  if (m.scale_power() > 1)
    json.key("scale_power").number(m.scale_power());
  json.end_object();
}

void write_bounds(JsonWriter &json, const std::vector<ShareBounds> &bounds) {
  json.begin_array();
  for (const ShareBounds &b : bounds)
    json.bounds(to_string(b.lo), to_string(b.hi));
  json.end_array();
}

/// The tolerance as it was asked for and as bounds on shares.
void write_tolerance(JsonWriter &json, const Match &m) {
  const Tolerance &t = *m.tolerance;
  json.begin_object().key("asked").begin_array();
  for (const AskedTolerance &a : m.question.tolerances)
    json.plain(to_string(a));
  json.end_array().key("band");
  if (m.question.band)
    json.string(m.question.band->id);
  else
    json.null();
  write_bounds(json.key("retained"), of_classes(m.gradation, t.retained));
  write_bounds(json.key("passing"), t.passing);
  write(json.key("total"), t.total).end_object();
}

/// The shares that the match has.
void write_achieved(JsonWriter &json, const Match &m) {
  if (!m.has_answer()) {
    json.null();
    return;
  }
  json.begin_array();
  for (const Rational &share : of_classes(m.gradation, *m.sample->shares))
    write(json, share);
  json.end_array();
}

void write_spectrum(JsonWriter &json, const Spectrum &s) {
  json.begin_object().key("intervals").begin_array();
  for (const auto &[from, to] : s.intervals)
    json.bounds(to_string(from), to_string(to));
  write(json.end_array().key(s.complete ? "all_from" : "unknown_from"), s.all_from).end_object();
}

/// The members behind the classes.
void write_rest(JsonWriter &json, const Match &m, const Spectrum *spectrum,
                const std::optional<std::uint64_t> &seed, const std::string &proof = "") {
  write_scale(json.key("scale"), m);
  json.key("tolerance");
  if (m.tolerance) {
    write_tolerance(json, m);
    write_achieved(json.key("achieved"), m);
  } else {
    json.null();
  }
  write(json.key("solids_volume"), m.has_answer() ? m.solids_volume() : std::nullopt);
  if (spectrum != nullptr)
    write_spectrum(json.key("spectrum"), *spectrum);
  if (seed)
    json.key("seed").number(*seed);
  if (const std::string words = in_words(m.question, m.gradation.unit()); !words.empty())
    json.key("question").string(words);
  if (!proof.empty())
    json.key("proof").string(proof);
  json.key("notes").strings(m.notes).key("versions").raw(versions_json());
}

} // namespace

std::string answer_json(const Match &m, const Spectrum *spectrum, const std::string &proof) {
  JsonWriter json;
  write_verdict(json.begin_object(), m);
  json.key("classes").begin_array();
  for (const AnswerRow &row : answer_rows(m)) {
    write_class(json.begin_object(), m, row);
    json.end_object();
  }
  write_rest(json.end_array(), m, spectrum, std::nullopt, proof);
  return json.end_object().take();
}

void spread_json(const Match &m, const Spectrum *spectrum, const Spread &spread, const Sink &sink) {
  JsonWriter json(sink);
  write_verdict(json.begin_object(), m);
  json.key("classes").begin_array();
  auto spread_class = spread.classes.begin();
  for (const AnswerRow &row : answer_rows(m)) {
    write_class(json.begin_object(), m, row);
    if (spread_class != spread.classes.end() && spread_class->index() == row.index) {
      json.key("sizes").begin_array();
      for_each_size(*spread_class++, m.digits, [&json](const Enclosure &size) { write(json, size); });
      json.end_array();
    }
    json.end_object();
  }
  write_rest(json.end_array(), m, spectrum, spread.seed);
  json.end_object().hand_on();
}

} // namespace mdm

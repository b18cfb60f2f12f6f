#include "report/published.hpp"

#include "answer/json_values.hpp"
#include "gradation/law_inverse.hpp"
#include "match/problem.hpp"
#include "number/counted.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

const char *algorithm_name(PublishedAlgorithm algorithm) {
  static constexpr std::array<const char *, 3> names = {"rounded", "fixed-size", "spanned-integer"};
  return names.at(static_cast<std::size_t>(algorithm));
}

/// The size of class j's particles; nothing where there are none. Of an exact match it lies in its class.
std::optional<Enclosure> size_of(const PublishedReport &r, std::size_t j) {
  const Rational &power = r.run.powers[j];
  if (power == 0)
    return std::nullopt;
  const Gradation &g = r.gradation;
  const auto enclose = [&](unsigned digits) {
    return enclose_inverse(r.law, numerator(power), denominator(power), r.law.a, digits);
  };
  Enclosure x = enclose(r.digits);
  const bool in_class = power > r.law.powered(g.lower(j)) && power <= r.law.powered(g.upper(j));
  const bool is_opening = power == r.law.powered(g.upper(j));
  for (unsigned digits = 2 * r.digits;
       in_class && !is_opening && (x.lower() <= g.lower(j) || x.upper() > g.upper(j)); digits *= 2)
    x = enclose(digits);
  return x;
}

/// Classes whose particles do not pass their class's test: at or below its lower sieve.
std::vector<std::size_t> misplaced(const PublishedReport &r) {
  std::vector<std::size_t> classes;
  for (std::size_t j = 0; j < r.gradation.classes(); ++j)
    if (r.run.powers[j] != 0 && r.run.powers[j] <= r.law.powered(r.gradation.lower(j)))
      classes.push_back(j);
  return classes;
}

Integer particles(const PublishedReport &r) {
  return total(r.run.result().q);
}

/// N of the least match; [lo, hi] where only bounds are known.
void write_least(JsonWriter &json, const PublishedReport &r) {
  if (r.least.is_point())
    write(json, r.least.lo);
  else
    json.bounds(to_string(r.least.lo), to_string(r.least.hi));
}

void write_ratio(JsonWriter &json, const PublishedReport &r) {
  const auto over = [&r](const Integer &least) { return to_string(ratio(particles(r), least)); };
  if (r.least.is_point())
    json.plain(over(r.least.lo));
  else
    json.bounds(over(r.least.hi), over(r.least.lo));
}

std::string percent(const Rational &share) {
  return approximate(Rational(100 * share), 4) + " %";
}

template <class Number>
void write_numbers(JsonWriter &json, const std::vector<Number> &numbers) {
  json.begin_array();
  for (const Number &n : numbers)
    write(json, n);
  json.end_array();
}

std::optional<Rational> times(const Rational &phi, const std::optional<Rational> &zeta) {
  if (phi == 0)
    return Rational(0);
  return zeta ? std::optional(Rational(phi * *zeta)) : std::nullopt;
}

/// [lo, hi]; hi is null where it is infinite.
void write_range(JsonWriter &json, const Rational &lo, const std::optional<Rational> &hi) {
  write(write(json.begin_array(), lo), hi).end_array();
}

void write_class(JsonWriter &json, const PublishedReport &r, std::size_t j) {
  const Gradation &g = r.gradation;
  const Published &run = r.run;
  json.begin_object().key("lower").plain(to_decimal(g.lower(j))).key("upper").plain(to_decimal(g.upper(j)));
  write(json.key("mass").plain(to_decimal(g.mass(j))).key("phi"), run.phi[j]);
  write_range(json.key("zeta"), run.least_zeta[j], run.most_zeta[j]);
  write_range(json.key("kappa"), Rational(run.phi[j] * run.least_zeta[j]),
              times(run.phi[j], run.most_zeta[j]));
  write(json.key("quantity"), run.result().q[j]);
  write(json.key("size"), size_of(r, j));
  write(json.key("error"), run.result().error.of_class[j]);
  json.end_object();
}

/// Counted from 1; `none` where no class has an error.
std::string worst_class(const PublishedTry &t, const char *none) {
  return t.error.maximum == 0 ? none : std::to_string(t.error.worst + 1);
}

void write_iteration(JsonWriter &json, const PublishedTry &t) {
  json.begin_object().key("multiple").number(t.multiple).key("sizes_tried").number(t.sizes);
  write(json.key("particles"), total(t.q));
  write_numbers(json.key("quantities"), t.q);
  write_numbers(json.key("errors"), t.error.of_class);
  write(json.key("total_error"), t.error.total);
  write(json.key("maximum_error"), t.error.maximum);
  json.key("worst_class");
  if (t.error.maximum == 0)
    json.null();
  else
    json.number(t.error.worst + 1);
  json.end_object();
}

std::string class_table(const PublishedReport &r) {
  const Gradation &g = r.gradation;
  const bool one_size = r.algorithm != PublishedAlgorithm::spanned_integer;
  const std::string unit(name(g.unit()));
  std::vector<std::vector<std::string>> lines = {{"class", "sizes, " + unit + " (above, up to]", "mass",
                                                  one_size ? "K" : "K from .. to", "quantity",
                                                  "target - found", "size of a particle (" + unit + ")"}};
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const std::optional<Rational> most = times(r.run.phi[j], r.run.most_zeta[j]);
    const std::string least = approximate(Rational(r.run.phi[j] * r.run.least_zeta[j]), 6);
    const std::optional<Enclosure> size = size_of(r, j);
    lines.push_back(
        {std::to_string(j + 1), "(" + to_decimal(g.lower(j)) + ", " + to_decimal(g.upper(j)) + "]",
         to_decimal(g.mass(j)), one_size ? least : least + " .. " + (most ? approximate(*most, 6) : "oo"),
         to_string(r.run.result().q[j]), percent(r.run.result().error.of_class[j]),
         size ? size->text() : "-"});
  }
  return text_table(lines, ">>>>>><");
}

/// The first and the last iterations of a long run.
std::string iteration_table(const Published &run) {
  constexpr std::size_t at_each_end = 10;
  std::vector<std::vector<std::string>> lines = {
      {"iteration", "sizes tried", "particles", "total error", "largest", "in class"}};
  for (std::size_t n = 0; n < run.tries.size(); ++n) {
    const PublishedTry &t = run.tries[n];
    if (n == at_each_end && run.tries.size() > 2 * at_each_end + 1) {
      lines.push_back({"...", "", "", "", "", ""});
      n = run.tries.size() - at_each_end - 1;
      continue;
    }
    lines.push_back({std::to_string(t.multiple), std::to_string(t.sizes), to_string(total(t.q)),
                     percent(t.error.total), percent(t.error.maximum), worst_class(t, "-")});
  }
  return text_table(lines, ">>>>><");
}

std::string verdict(const PublishedReport &r) {
  if (r.run.is_match())
    return "an exact match";
  const std::string error = "no exact match: total error " + percent(r.run.result().error.total);
  if (r.algorithm == PublishedAlgorithm::fixed_size)
    return error + (r.run.reached ? ", within the tolerance" : ", above the tolerance");
  if (r.algorithm == PublishedAlgorithm::spanned_integer && !r.run.reached)
    return error + ", not every class spans an integer";
  return error;
}

std::vector<std::string> all_notes(const PublishedReport &r) {
  std::vector<std::string> notes = r.notes;
  for (const std::size_t j : misplaced(r))
    notes.push_back(fmt::format("class {}: the size that Eq. 19 gives is not above the lower sieve", j + 1));
  if (!r.least.is_point())
    notes.push_back(
        fmt::format("The smallest match was not found within {} steps; mdm solve goes on for longer.",
                    most_steps_beside));
  return notes;
}

} // namespace

bool succeeded(const PublishedReport &r) {
  switch (r.algorithm) {
  case PublishedAlgorithm::fixed_size:
    return r.run.reached;
  case PublishedAlgorithm::spanned_integer:
    return r.run.is_match();
  default:
    return true;
  }
}

std::string published_json(const PublishedReport &r) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-published-1").key("id").string(r.gradation.id());
  json.key("algorithm").plain(algorithm_name(r.algorithm)).key("settings").string(r.settings);
  json.key("reached").boolean(r.run.reached).key("match").boolean(r.run.is_match());
  write(json.key("particles"), particles(r));
  write_least(json.key("least"), r);
  write_ratio(json.key("ratio"), r);
  json.key("unit").plain(name(r.gradation.unit())).key("classes").begin_array();
  for (std::size_t j = 0; j < r.gradation.classes(); ++j)
    write_class(json, r, j);
  json.end_array().key("iterations").begin_array();
  for (const PublishedTry &t : r.run.tries)
    write_iteration(json, t);
  json.end_array().key("notes").strings(all_notes(r)).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string published_csv(const PublishedReport &r) {
  std::string text = "multiple,sizes_tried,particles,total_error,maximum_error,worst_class\n";
  for (const PublishedTry &t : r.run.tries)
    text += fmt::format("{},{},{},{},{},{}\n", t.multiple, t.sizes, to_string(total(t.q)),
                        approximate(t.error.total, 15), approximate(t.error.maximum, 15), worst_class(t, ""));
  return text;
}

std::string published_text(const PublishedReport &r) {
  std::string text = fmt::format(
      "{}: {} by the algorithm {} as published ({})\n  {}; the smallest exact match has {} ({} times)\n\n",
      printable(r.gradation.id()), counted(particles(r), "particle"), algorithm_name(r.algorithm), r.settings,
      verdict(r), r.least.text(), r.least.ratio_text(particles(r)));
  text += class_table(r) + "\n" + iteration_table(r.run);
  for (const std::string &note : all_notes(r))
    text += "  note: " + note + "\n";
  return text;
}

} // namespace mdm

#include "report/tradeoff_report.hpp"

#include "answer/json_values.hpp"
#include "text/option_name.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// `retained`, `passing` or `total`.
std::string kind_name(const Tradeoff &t) {
  const std::string asked = to_string(AskedTolerance{t.kind, 0});
  return asked.substr(0, asked.find(':'));
}

const char *status_name(const TradeoffRow &row) {
  return row.is_optimal() ? "optimal" : row.has_none ? "none" : row.particles ? "feasible" : "unknown";
}

/// Exact if it is a short decimal, else its first digits.
std::string short_number(const Rational &r, unsigned digits) {
  const std::optional<std::string> exact = exact_decimal(r);
  return exact && exact->size() <= digits + 2 ? *exact : approximate(r, digits);
}

std::string particles_text(const TradeoffRow &row) {
  if (row.is_optimal())
    return to_string(*row.particles);
  if (row.has_none)
    return "none";
  return row.particles ? fmt::format("[{}, {}]", to_string(row.lower_bound), to_string(*row.particles))
                       : fmt::format("[{}, ?]", to_string(row.lower_bound));
}

/// The N of the whole gradation's match over this one, if both are known.
std::string saving_text(const Tradeoff &t, const TradeoffRow &row) {
  return row.is_optimal() && t.whole().is_optimal()
             ? short_number(ratio(*t.whole().particles, *row.particles), 3)
             : "-";
}

void add_counts(TextTable &table, const Tradeoff &t, const TradeoffRow &row) {
  table.add(particles_text(row));
  table.add(saving_text(t, row));
}

std::string by_tolerance_text(const Tradeoff &t) {
  TextTable table;
  table.add_column(kind_name(t) + " within (%)", '>');
  table.add_column("particles", '>');
  table.add_column("times fewer", '>');
  for (const TradeoffRow &row : t.by_tolerance) {
    table.add_line();
    table.add(to_decimal(row.tolerance));
    add_counts(table, t, row);
  }
  return table.text();
}

std::string by_sieve_text(const Tradeoff &t) {
  TextTable table;
  table.add_column(fmt::format("smallest sieve kept ({})", name(t.gradation.unit())), '>');
  table.add_column("mass lost (%)", '>');
  table.add_column("particles", '>');
  table.add_column("times fewer", '>');
  for (const TradeoffRow &row : t.by_sieve) {
    table.add_line();
    table.add(row.smallest.power == 0 ? "pan" : row.smallest.text());
    table.add(short_number(Rational(100 * row.lost), 6));
    add_counts(table, t, row);
  }
  return table.text();
}

/// At least so many of the largest particles lie beside each other in the specimen; nothing of a volume, and
/// where the opening is irrational.
std::optional<Rational> largest_beside_each_other(const Tradeoff &t, const TradeoffRow &row) {
  const std::optional<Rational> width = t.question.solids ? narrowest(*t.question.solids) : std::nullopt;
  if (!width || t.gradation.root() != 1)
    return std::nullopt;
  std::size_t coarsest = 0;
  for (std::size_t j = 0; j < t.gradation.classes(); ++j)
    if (t.gradation.mass(j) > 0)
      coarsest = j;
  return *width / (t.gradation.opening(coarsest + 1).power * row.size_factor);
}

std::string by_size_factor_text(const Tradeoff &t) {
  if (t.by_size_factor.empty())
    return "";
  TextTable table;
  for (const char *heading :
       {"size factor", "particles", "times fewer", "of the coarsest class", "specimen / d_max"})
    table.add_column(heading, '>');
  for (const TradeoffRow &row : t.by_size_factor) {
    const std::optional<Rational> beside = largest_beside_each_other(t, row);
    table.add_line();
    table.add(to_decimal(row.size_factor));
    add_counts(table, t, row);
    table.add(row.coarsest > 0 ? to_string(row.coarsest) : "-");
    table.add(beside ? approximate(*beside, 3) : "-");
  }
  return "\n" + table.text();
}

/// ASTM D4767 and D7181, triaxial tests: the largest particle is smaller than a sixth of the diameter.
constexpr unsigned fewest_beside_each_other = 6;

void write_size_factor_rows(JsonWriter &json, const Tradeoff &t) {
  json.begin_array();
  for (const TradeoffRow &row : t.by_size_factor) {
    json.begin_object().key("size_factor").plain(to_decimal(row.size_factor));
    json.key("status").plain(status_name(row));
    write(json.key("particles"), row.particles);
    write(json.key("lower_bound"), row.lower_bound);
    write(json.key("coarsest"), row.coarsest > 0 ? std::optional(row.coarsest) : std::nullopt);
    write(json.key("specimen_over_largest"), largest_beside_each_other(t, row));
    json.end_object();
  }
  json.end_array();
}

void write_rows(JsonWriter &json, const std::vector<TradeoffRow> &rows) {
  json.begin_array();
  for (const TradeoffRow &row : rows) {
    json.begin_object().key("tolerance").plain(to_decimal(row.tolerance));
    json.key("smallest").plain(row.smallest.text());
    write(json.key("lost"), row.lost).key("status").plain(status_name(row));
    write(json.key("particles"), row.particles);
    write(json.key("lower_bound"), row.lower_bound).end_object();
  }
  json.end_array();
}

std::string csv_row(const Tradeoff &t, const TradeoffRow &row) {
  return fmt::format("{},{},{},{},{},{},{}{}\n", kind_name(t), to_decimal(row.tolerance), row.smallest.text(),
                     short_number(Rational(100 * row.lost), 15),
                     row.particles ? to_string(*row.particles) : "", to_string(row.lower_bound),
                     status_name(row), t.by_size_factor.empty() ? "" : "," + to_decimal(row.size_factor));
}

/// Says of the budgets that no row tells of why that is.
void add_missed(std::vector<std::string> &notes, const Tradeoff &t, BudgetBy by, bool is_certain) {
  std::vector<std::string> numbers;
  for (const Tradeoff::MissedBudget &budget : t.missed)
    if (budget.by == by && budget.is_certain == is_certain)
      numbers.push_back(to_string(budget.particles));
  if (numbers.empty())
    return;
  const char *const what = by == BudgetBy::tolerance ? "tolerance" : "size factor";
  const std::string all = fmt::format("{}", fmt::join(numbers, ", "));
  notes.push_back(
      is_certain ? fmt::format("there is no {} with which so few particles suffice: {}", what, all)
                 : fmt::format("a limit came before a {} was found with which so few particles suffice: {}",
                               what, all));
}

} // namespace

std::string tradeoff_text(const Tradeoff &t) {
  const std::string words = in_words(t.question, t.gradation.unit());
  std::string text =
      fmt::format("{}: the smallest match within a tolerance, and without the finest classes{}\n\n",
                  printable(t.gradation.id()), words.empty() ? "" : " (" + words + ")");
  text += by_tolerance_text(t) + "\n" + by_sieve_text(t) + by_size_factor_text(t);
  for (const std::string &note : tradeoff_notes(t))
    text += "  note: " + note + "\n";
  return text;
}

std::string tradeoff_json(const Tradeoff &t) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-tradeoff-1").key("id").string(t.gradation.id());
  json.key("question")
      .string(in_words(t.question, t.gradation.unit()))
      .key("unit")
      .plain(name(t.gradation.unit()));
  write_rows(json.key("kind").plain(kind_name(t)).key("by_tolerance"), t.by_tolerance);
  write_rows(json.key("by_sieve"), t.by_sieve);
  if (!t.by_size_factor.empty())
    write_size_factor_rows(json.key("by_size_factor"), t);
  json.key("notes").strings(tradeoff_notes(t)).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string tradeoff_csv(const Tradeoff &t) {
  std::string text =
      fmt::format("kind,tolerance_percent,smallest_{},lost_percent,particles,lower_bound,status{}\n",
                  name(t.gradation.unit()), t.by_size_factor.empty() ? "" : ",size_factor");
  for (const std::vector<TradeoffRow> *rows : {&t.by_tolerance, &t.by_sieve, &t.by_size_factor})
    for (const TradeoffRow &row : *rows)
      text += csv_row(t, row);
  return text;
}

std::vector<std::string> tradeoff_notes(const Tradeoff &t) {
  std::vector<std::string> notes = t.gradation.notes();
  for (const TradeoffRow &row : t.by_size_factor)
    if (const std::optional<Rational> beside = largest_beside_each_other(t, row);
        beside && *beside < fewest_beside_each_other) {
      notes.push_back(
          fmt::format("from the size factor {} on the specimen is less than {} openings of the "
                      "coarsest sieve wide: ASTM D4767 and D7181 ask for {} of the largest particle",
                      to_decimal(row.size_factor), fewest_beside_each_other, fewest_beside_each_other));
      break;
    }
  if (t.at_most)
    notes.push_back(fmt::format("where more than {} particles are needed there is none: {}",
                                to_string(*t.at_most), option("at-most")));
  for (const BudgetBy by : {BudgetBy::tolerance, BudgetBy::size_factor})
    for (const bool is_certain : {true, false})
      add_missed(notes, t, by, is_certain);
  return notes;
}

} // namespace mdm

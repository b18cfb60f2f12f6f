#include <mdm/error.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/text_table.hpp>
#include <mdm/report/versions.hpp>
#include <mdm/study/tradeoff_report.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// `retained`, `passing` or `total`.
std::string kind_name(const Tradeoff &t) {
  const std::string asked = to_string(AskedTolerance{t.kind, 0});
  return asked.substr(0, asked.find(':'));
}

const char *status_name(const TradeoffRow &row) {
  return row.is_optimal() ? "optimal" : "feasible";
}

/// Exact if it is a short decimal, else its first digits.
std::string short_number(const Rational &r, unsigned digits) {
  const std::optional<std::string> exact = exact_decimal(r);
  return exact && exact->size() <= digits + 2 ? *exact : approximate(r, digits);
}

std::string particles_text(const TradeoffRow &row) {
  return row.is_optimal() ? to_string(row.particles)
                          : fmt::format("[{}, {}]", to_string(row.lower_bound), to_string(row.particles));
}

/// How many times fewer particles than the exact match, if both are known.
std::string saving_text(const Tradeoff &t, const TradeoffRow &row) {
  return row.is_optimal() && t.exact().is_optimal()
             ? short_number(ratio(t.exact().particles, row.particles), 3)
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
    table.add(row.smallest == 0 ? "pan" : to_decimal(row.smallest));
    table.add(short_number(Rational(100 * row.lost), 6));
    add_counts(table, t, row);
  }
  return table.text();
}

std::string json_row(const TradeoffRow &row) {
  return fmt::format(
      R"({{"tolerance":"{}","smallest":"{}","lost":"{}","status":"{}","particles":"{}","lower_bound":"{}"}})",
      to_decimal(row.tolerance), to_decimal(row.smallest), to_string(row.lost), status_name(row),
      to_string(row.particles), to_string(row.lower_bound));
}

std::string json_rows(const std::vector<TradeoffRow> &rows) {
  std::string text;
  for (const TradeoffRow &row : rows)
    text += (text.empty() ? "" : ",") + json_row(row);
  return "[" + text + "]";
}

std::string csv_row(const Tradeoff &t, const TradeoffRow &row) {
  return fmt::format("{},{},{},{},{},{},{}\n", kind_name(t), to_decimal(row.tolerance),
                     to_decimal(row.smallest), short_number(Rational(100 * row.lost), 15),
                     to_string(row.particles), to_string(row.lower_bound), status_name(row));
}

} // namespace

std::string tradeoff_text(const Tradeoff &t) {
  const std::string words = in_words(t.question);
  std::string text =
      fmt::format("{}: the smallest match within a tolerance, and without the finest classes{}\n\n",
                  printable(t.gradation.id()), words.empty() ? "" : " (" + words + ")");
  text += by_tolerance_text(t) + "\n" + by_sieve_text(t);
  for (const std::string &note : t.gradation.notes())
    text += "  note: " + note + "\n";
  return text;
}

std::string tradeoff_json(const Tradeoff &t) {
  std::string notes;
  for (const std::string &note : t.gradation.notes())
    notes += (notes.empty() ? "" : ",") + json_string(note);
  return fmt::format(
      R"({{"schema":"mdm-tradeoff-1","id":{},"question":{},"unit":"{}","kind":"{}","by_tolerance":{},)"
      R"("by_sieve":{},"notes":[{}],"versions":{}}})",
      json_string(t.gradation.id()), json_string(in_words(t.question)), name(t.gradation.unit()),
      kind_name(t), json_rows(t.by_tolerance), json_rows(t.by_sieve), notes, versions_json());
}

std::string tradeoff_csv(const Tradeoff &t) {
  std::string text =
      fmt::format("kind,tolerance_percent,smallest_{},lost_percent,particles,lower_bound,status\n",
                  name(t.gradation.unit()));
  for (const std::vector<TradeoffRow> *rows : {&t.by_tolerance, &t.by_sieve})
    for (const TradeoffRow &row : *rows)
      text += csv_row(t, row);
  return text;
}

} // namespace mdm

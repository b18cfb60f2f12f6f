#include "gradation/lab_values.hpp"

#include "gradation/mass_digits.hpp"
#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

/// How far percent of the whole may be above 100.
constexpr int largest_loss = 5;

/// Percent, if the whole is there as 100 or the user says passing or cumulative.
void check_percent(const Table &table, const LabValues &values, const Reading &reading,
                   const Source &source) {
  const Rational largest = *std::max_element(table.values.begin(), table.values.end());
  if (!reading.kind && largest != 100)
    source.refuse(table.header_line,
                  fmt::format("the column {} may be percent or fractions, its largest value is {}: say {} "
                              "passing_percent, passing_fraction or cumulative_retained_percent",
                              in_quotes(values.header), shown(largest), option("kind")));
}

/// Cumulative percent that all are at most 1 may be fractions.
void check_cumulative_percent(const Table &table, const LabValues &values, const Source &source) {
  const Rational largest = *std::max_element(table.values.begin(), table.values.end());
  if (largest > 0 && largest <= 1)
    source.refuse(table.header_line,
                  fmt::format("the column {} has nothing above {}, and may be percent or fractions: write "
                              "percent, or say {} cumulative_retained_percent",
                              in_quotes(values.header), shown(largest), option("kind")));
}

/// What each sieve retains, from cumulative masses.
void take_differences(Table &table, const Reading &reading, const Source &source) {
  if (reading.round)
    table.notes.push_back(*settle_digits(table.values, reading.round, "cumulative mass"));
  table.has_settled_digits = reading.round.has_value();
  std::vector<std::size_t> order(table.sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&table](std::size_t i, std::size_t j) { return table.sizes[i] > table.sizes[j]; });
  Rational above = 0;
  for (const std::size_t i : order) {
    const Rational value = table.values[i];
    if (value < above)
      source.refuse(
          table.lines[i],
          fmt::format("cumulative mass {} is below {} of the next coarser sieve: correct one of them",
                      shown(value), shown(above)));
    table.values[i] = value - above;
    above = value;
  }
  table.notes.emplace_back(
      "Cumulative masses were taken apart: each sieve holds the difference to the next coarser "
      "one.");
}

std::string_view column_name(const HeaderMeaning &meaning) {
  const bool is_percent = meaning.unit == ColumnUnit::percent,
             is_fraction = meaning.unit == ColumnUnit::fraction;
  switch (meaning.meaning) {
  case ColumnMeaning::passing:
    return is_fraction ? "passing_fraction" : "passing_percent";
  case ColumnMeaning::cumulative:
    return "cumulative_retained_percent";
  default:
    return is_percent ? "retained_percent" : is_fraction ? "retained_fraction" : "mass";
  }
}

/// True where no sieve holds less than the next coarser one.
bool never_falls(const Table &table) {
  std::vector<std::pair<Rational, Rational>> rows;
  for (std::size_t i = 0; i < table.sizes.size(); ++i)
    rows.emplace_back(-table.sizes[i], table.values[i]);
  std::sort(rows.begin(), rows.end());
  const auto less = [](const auto &a, const auto &b) { return a.second < b.second; };
  return std::is_sorted(rows.begin(), rows.end(), less);
}

/// From so many sieves on, the pan among them, of which none holds less than the next coarser one, there is a
/// note, or an error; an error from few on where the values have no unit and end at 100.
constexpr std::ptrdiff_t few_sieves = 3, many_sieves = 5;

/// The number of sieves that hold mass, where none holds less than the next coarser one, as cumulative masses
/// do; else 0.
std::ptrdiff_t sieves_as_cumulative(const Table &table) {
  const auto is_held = [](const Rational &value) { return value > 0; };
  return never_falls(table) ? std::count_if(table.values.begin(), table.values.end(), is_held) : 0;
}

/// An error, or of few sieves a note, where masses grow as cumulative ones do, and nothing else in the sheet
/// says that they are none.
void check_growth(Table &table, const LabValues &values, const Reading &reading, const Source &source) {
  if (values.meaning.is_symbol && !reading.kind && never_falls(table))
    source.refuse(
        table.header_line,
        fmt::format("the column {0} holds what each sieve retains, or what all coarser ones retain too, and "
                    "no sieve has less than the next coarser one: say {1} retained or {1} cumulative",
                    in_quotes(values.header), option("kind")));
  const std::ptrdiff_t sieves = sieves_as_cumulative(table);
  if (values.meaning.unit == ColumnUnit::percent || reading.kind || values.is_confirmed ||
      values.meaning.is_individual || sieves < few_sieves)
    return;
  const bool may_be_percent = values.meaning.unit == ColumnUnit::none &&
                              *std::max_element(table.values.begin(), table.values.end()) == 100;
  if (sieves >= many_sieves || may_be_percent)
    source.refuse(
        table.header_line,
        fmt::format("no sieve retains less than the next coarser one, as in a cumulative column: say "
                    "{0} cumulative if {1} is one, else {0} retained",
                    option("kind"), in_quotes(values.header)));
  table.notes.push_back(
      fmt::format("No sieve retains less than the next coarser one: {} was read as what each retains; say {} "
                  "cumulative if it is cumulative.",
                  in_quotes(values.header), option("kind")));
}

} // namespace

void settle_lab_values(Table &table, const LabValues &values, const Reading &reading, const Source &source) {
  const ColumnMeaning meaning = values.meaning.meaning;
  const ColumnUnit unit = values.meaning.unit;
  if (unit == ColumnUnit::mass && meaning == ColumnMeaning::passing)
    source.refuse(table.header_line,
                  "the mass that passes is given, not its percentage: divide by the whole mass, or "
                  "give the mass retained");
  if (unit == ColumnUnit::fraction && meaning == ColumnMeaning::cumulative)
    source.refuse(table.header_line, "cumulative fractions are not read: give them in percent");
  // Neither percent nor fractions are so large.
  const bool is_mass = unit == ColumnUnit::mass ||
                       (unit == ColumnUnit::none &&
                        *std::max_element(table.values.begin(), table.values.end()) > 100 + largest_loss);
  const bool is_cumulative_mass = meaning == ColumnMeaning::cumulative && is_mass;
  if (is_cumulative_mass)
    take_differences(table, reading, source);
  else if (unit == ColumnUnit::none && meaning != ColumnMeaning::retained)
    check_percent(table, values, reading, source);
  else if (unit == ColumnUnit::percent && meaning == ColumnMeaning::cumulative && !reading.kind)
    check_cumulative_percent(table, values, source);
  table.column = find_mass_column(is_cumulative_mass ? "mass" : column_name(values.meaning));
  if (table.column->form == MassForm::retained) {
    if (table.column->full != 0)
      table.mass_roundings = table.roundings;
    table.roundings.clear();
    if (!is_cumulative_mass)
      check_growth(table, values, reading, source);
  } else {
    for (Rational &rounding : table.roundings)
      rounding *= ratio(100, table.column->full);
  }
}

} // namespace mdm

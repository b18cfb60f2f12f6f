#include "report/fractions_report.hpp"

#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

bool is_empty(const Fraction &f) {
  return f.share && f.share->exact() == Rational(0);
}

std::string range(const Fraction &f) {
  if (!f.up_to)
    return "above " + to_decimal(f.above) + " mm";
  if (f.above == 0)
    return "to " + to_decimal(*f.up_to) + " mm";
  return to_decimal(f.above) + " to " + to_decimal(*f.up_to) + " mm";
}

} // namespace

std::optional<Real> percent(const Fraction &f) {
  return f.share ? std::optional(*f.share * 100) : std::nullopt;
}

void write_value(JsonWriter &json, const std::optional<Real> &value, unsigned digits) {
  write(json, value ? std::optional(enclose(*value, digits)) : std::nullopt);
}

void write_fractions(JsonWriter &json, const std::vector<Fraction> &fractions, unsigned digits) {
  json.begin_array();
  for (const Fraction &f : fractions) {
    json.begin_object().key("name").plain(f.name).key("above").plain(to_decimal(f.above)).key("up_to");
    if (f.up_to)
      json.plain(to_decimal(*f.up_to));
    else
      json.null();
    write_value(json.key("percent"), percent(f), digits);
    json.end_object();
  }
  json.end_array();
}

void add_csv_row(TextBuffer &out, const std::string &item, const char *unit, const std::optional<Real> &value,
                 unsigned digits, const std::string &text) {
  if (!value) {
    add(out, "{},{},,,{}\n", item, unit, csv_field(text));
    return;
  }
  const Enclosure e = enclose(*value, digits);
  add(out, "{},{},{},{},{}\n", item, unit, e.lower_text(), e.upper_text(), csv_field(text));
}

void add_csv_bounds(TextBuffer &out, const std::optional<Real> &value, unsigned digits) {
  if (!value) {
    add(out, ",,");
    return;
  }
  const Enclosure e = enclose(*value, digits);
  add(out, ",{},{}", e.lower_text(), e.upper_text());
}

std::string column_name(std::string_view fraction) {
  std::string name(fraction);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

void add_csv_fractions(TextBuffer &out, const char *system, const std::vector<Fraction> &fractions,
                       unsigned digits) {
  for (const Fraction &f : fractions)
    add_csv_row(out, fmt::format("{} {}", system, f.name), "percent", percent(f), digits);
}

void add_text_fractions(TextBuffer &out, const char *system, const std::vector<Fraction> &fractions,
                        unsigned digits) {
  add(out, "\n  percent of the mass, {}\n", system);
  std::vector<std::vector<std::string>> lines;
  bool parent_empty = false;
  for (const Fraction &f : fractions) {
    if (f.main)
      parent_empty = is_empty(f);
    if ((parent_empty && (!f.main || lines.empty())) || (!f.main && !f.share))
      continue;
    const std::optional<Real> share = percent(f);
    lines.push_back({(f.main ? "" : "  ") + std::string(f.name), range(f),
                     share ? rounded(*share, digits) : "not available"});
  }
  add(out, "{}", text_table(lines, "<<>"));
}

} // namespace mdm

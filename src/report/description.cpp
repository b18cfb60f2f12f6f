#include "text_buffer.hpp"

#include <mdm/error.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/description.hpp>
#include <mdm/report/text_table.hpp>
#include <mdm/report/versions.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace mdm {
namespace {

/// An index number as all three forms show it.
struct Item {
  const char *key;  // in JSON and CSV
  const char *name; // in text
  const char *unit;
  std::optional<Real> value;
};

std::optional<Real> real(const Available<PowerProduct> &value) {
  return value ? std::optional(value->real()) : std::nullopt;
}

std::optional<Real> real(const Available<Real> &value) {
  return value ? std::optional(*value) : std::nullopt;
}

std::vector<Item> items(const SoilDescription &d) {
  return {{"D10", "D10", "mm", real(d.d10)},    {"D30", "D30", "mm", real(d.d30)},
          {"D50", "D50", "mm", real(d.d50)},    {"D60", "D60", "mm", real(d.d60)},
          {"Cu", "C_u", "", real(d.c_u)},       {"Cc", "C_c", "", real(d.c_c)},
          {"IGS", "I_GS", "", real(d.i_gs)},    {"IC", "I_C", "", real(d.i_c)},
          {"phi1", "phi_1", "", Real(d.phi_1)}, {"zeta1", "zeta_1", "", Real(d.zeta_1)}};
}

std::optional<Real> percent(const Fraction &f) {
  return f.share ? std::optional(*f.share * 100) : std::nullopt;
}

const char *name(Fines fines) {
  static constexpr std::array<const char *, 5> names = {"ML", "MH", "CL", "CH", "CL-ML"};
  return names.at(static_cast<std::size_t>(fines));
}

std::string json_enclosure(const std::optional<Real> &value, unsigned digits) {
  if (!value)
    return "null";
  return json_enclosure(enclose(*value, digits));
}

void add_json_fractions(Buffer &out, const char *key, const std::vector<Fraction> &fractions,
                        unsigned digits) {
  add(out, R"(,"{}":[)", key);
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    const Fraction &f = fractions[i];
    add(out, R"({}{{"name":"{}","above":"{}","up_to":{},"percent":{}}})", i == 0 ? "" : ",", f.name,
        to_decimal(f.above), f.up_to ? "\"" + to_decimal(*f.up_to) + "\"" : "null",
        json_enclosure(percent(f), digits));
  }
  out.push_back(']');
}

void add_csv_row(Buffer &out, const std::string &item, const char *unit, const std::optional<Real> &value,
                 unsigned digits) {
  if (!value) {
    add(out, "{},{},,,\n", item, unit);
    return;
  }
  const Enclosure e = enclose(*value, digits);
  add(out, "{},{},{},{},\n", item, unit, e.lower_text(), e.upper_text());
}

/// A name, what it is about, and a value.
using Line = std::vector<std::string>;

bool is_zero(const Fraction &f) {
  return f.share && f.share->exact() == Rational(0);
}

std::string range(const Fraction &f) {
  if (!f.up_to)
    return "above " + to_decimal(f.above) + " mm";
  if (f.above == 0)
    return "to " + to_decimal(*f.up_to) + " mm";
  return to_decimal(f.above) + " to " + to_decimal(*f.up_to) + " mm";
}

/// A line a band; parts without a value, parts of empty bands, and empty bands coarser than all are left out.
void add_text_fractions(Buffer &out, const char *system, const std::vector<Fraction> &fractions,
                        unsigned digits) {
  add(out, "\n  percent of the mass, {}\n", system);
  std::vector<Line> lines;
  bool parent_empty = false;
  for (const Fraction &f : fractions) {
    if (f.main)
      parent_empty = is_zero(f);
    if ((parent_empty && (!f.main || lines.empty())) || (!f.main && !f.share))
      continue;
    const std::optional<Real> share = percent(f);
    lines.push_back({(f.main ? "" : "  ") + std::string(f.name), range(f),
                     share ? rounded(*share, digits) : "not available"});
  }
  add(out, "{}", text_table(lines, "<<>"));
}

std::string headline(const SoilDescription &d) {
  const std::string id = printable(d.id) + ": ";
  return d.group ? id + d.group->symbol + ", " + d.group->name : id + "no USCS group";
}

} // namespace

std::string description_json(const SoilDescription &d, unsigned digits) {
  Buffer out;
  add(out, R"({{"schema":"mdm-describe-1","id":{},"unit":"mm","passing":[)", json_string(d.id));
  for (std::size_t i = 0; i < d.curve.sizes().size(); ++i)
    add(out, R"({}{{"size":"{}","percent":{}}})", i == 0 ? "" : ",", to_decimal(d.curve.sizes()[i]),
        json_enclosure(Real(d.curve.shares()[i] * 100), digits));
  out.push_back(']');
  for (const Item &item : items(d))
    add(out, R"(,"{}":{})", item.key, json_enclosure(item.value, digits));
  if (d.group)
    add(out, R"(,"uscs":{{"symbol":"{}","name":"{}","fines":"{}"}})", d.group->symbol, d.group->name,
        name(d.fines));
  else
    add(out, R"(,"uscs":null)");
  add_json_fractions(out, "uscs_fractions", d.uscs, digits);
  add_json_fractions(out, "iso_14688_fractions", d.iso_14688, digits);
  add(out, R"(,"notes":[)");
  for (std::size_t i = 0; i < d.notes.size(); ++i)
    add(out, "{}{}", i == 0 ? "" : ",", json_string(d.notes[i]));
  add(out, R"(],"versions":{{)");
  for (std::size_t i = 0; i < versions().size(); ++i)
    add(out, "{}{}:{}", i == 0 ? "" : ",", json_string(versions()[i].first),
        json_string(versions()[i].second));
  add(out, "}}}}");
  return fmt::to_string(out);
}

std::string description_csv(const SoilDescription &d, unsigned digits) {
  Buffer out;
  add(out, "item,unit,lo,hi,text\n");
  for (const Item &item : items(d))
    add_csv_row(out, item.key, item.unit, item.value, digits);
  add(out, "USCS symbol,,,,{}\nUSCS name,,,,\"{}\"\n", d.group ? d.group->symbol : "",
      d.group ? d.group->name : "");
  for (const auto &[system, fractions] : {std::pair("USCS", &d.uscs), std::pair("ISO 14688", &d.iso_14688)})
    for (const Fraction &f : *fractions)
      add_csv_row(out, fmt::format("{} {}", system, f.name), "percent", percent(f), digits);
  return fmt::to_string(out);
}

std::string description_text(const SoilDescription &d, unsigned digits) {
  Buffer out;
  add(out, "{}\n\n", headline(d));
  for (const Item &item : items(d))
    add(out, "  {:<6}  {}{}{}\n", item.name, item.value ? rounded(*item.value, digits) : "not available",
        item.value && *item.unit != 0 ? " " : "", item.value ? item.unit : "");
  add_text_fractions(out, "ASTM D2487", d.uscs, digits);
  add_text_fractions(out, "ISO 14688", d.iso_14688, digits);
  if (!d.notes.empty())
    out.push_back('\n');
  for (const std::string &note : d.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

} // namespace mdm

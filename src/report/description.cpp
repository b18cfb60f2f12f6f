#include "report/description.hpp"

#include "report/fractions_report.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace mdm {
namespace {

/// An index number as all three forms show it.
struct Item {
  const char *key;  // in JSON and CSV
  const char *name; // in text; null: a note says it there
  const char *unit;
  std::optional<Real> value;
};

std::optional<Real> real(const Available<PowerProduct> &value) {
  return value ? std::optional(value->real()) : std::nullopt;
}

std::optional<Real> real(const Available<Real> &value) {
  return value ? std::optional(*value) : std::nullopt;
}

std::optional<Real> over_d50(const SoilDescription &d) {
  return d.d50 ? std::optional((d.d_max / *d.d50).real()) : std::nullopt;
}

std::vector<Item> items(const SoilDescription &d) {
  return {{"D10", "D10", "mm", real(d.d10)},       {"D30", "D30", "mm", real(d.d30)},
          {"D50", "D50", "mm", real(d.d50)},       {"D60", "D60", "mm", real(d.d60)},
          {"Cu", "C_u", "", real(d.c_u)},          {"Cc", "C_c", "", real(d.c_c)},
          {"IGS", "I_GS", "", real(d.i_gs)},       {"IC", "I_C", "", real(d.i_c)},
          {"phi1", "phi_1", "", Real(d.phi_1)},    {"zeta1", "zeta_1", "", d.zeta_1.real()},
          {"dmax", nullptr, "mm", d.d_max.real()}, {"dmaxD50", nullptr, "", over_d50(d)}};
}

const char *name(Fines fines) {
  static constexpr std::array<const char *, 5> names = {"ML", "MH", "CL", "CH", "CL-ML"};
  return names.at(static_cast<std::size_t>(fines));
}

/// A decimal, or an enclosure where the opening is none.
void write_opening(JsonWriter &json, const RootSize &opening, unsigned digits) {
  if (opening.degree == 1 || opening.fraction())
    json.plain(opening.text());
  else
    write(json, enclose_root(numerator(opening.power), denominator(opening.power), opening.degree, digits));
}

std::string headline(const SoilDescription &d) {
  const std::string id = printable(d.id) + ": ";
  return d.group ? id + d.group->symbol + ", " + d.group->name : id + "no USCS group";
}

} // namespace

std::string description_json(const SoilDescription &d, unsigned digits) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-describe-1").key("id").string(d.id).key("unit").plain("mm");
  json.key("passing").begin_array();
  for (std::size_t i = 0; i < d.curve.shares().size(); ++i) {
    write_opening(json.begin_object().key("size"), d.curve.opening(i), digits);
    write_value(json.key("percent"), Real(d.curve.shares()[i] * 100), digits);
    json.end_object();
  }
  json.end_array();
  for (const Item &item : items(d))
    write_value(json.key(item.key), item.value, digits);
  json.key("uscs");
  if (d.group)
    json.begin_object()
        .key("symbol")
        .plain(d.group->symbol)
        .key("name")
        .plain(d.group->name)
        .key("fines")
        .plain(name(d.fines))
        .end_object();
  else
    json.null();
  write_fractions(json.key("uscs_fractions"), d.uscs, digits);
  write_fractions(json.key("iso_14688_fractions"), d.iso_14688, digits);
  json.key("notes").strings(d.notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string description_csv(const SoilDescription &d, unsigned digits) {
  TextBuffer out;
  add(out, "item,unit,lo,hi,text\n");
  for (const Item &item : items(d))
    add_csv_row(out, item.key, item.unit, item.value, digits);
  add(out, "USCS symbol,,,,{}\nUSCS name,,,,\"{}\"\n", d.group ? d.group->symbol : "",
      d.group ? d.group->name : "");
  add_csv_fractions(out, "USCS", d.uscs, digits);
  add_csv_fractions(out, "ISO 14688", d.iso_14688, digits);
  for (const std::string &note : d.notes)
    add(out, "note,,,,{}\n", csv_field(note));
  return fmt::to_string(out);
}

std::string description_text(const SoilDescription &d, unsigned digits) {
  TextBuffer out;
  add(out, "{}\n\n", headline(d));
  for (const Item &item : items(d))
    if (item.name != nullptr)
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

#include "report/description.hpp"

#include "report/description_items.hpp"
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

void write_item(JsonWriter &json, const DescriptionItem &i, unsigned digits) {
  if (const auto ends = bounds_of(i, digits))
    json.bounds(ends->first, ends->second);
  else
    json.null();
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

std::string line_of(const DescriptionItem &i, unsigned digits) {
  if (!i.value)
    return "not available";
  return *i.unit == 0 ? shown_item(i, digits) : fmt::format("{} {}", shown_item(i, digits), i.unit);
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
  for (const DescriptionItem &i : usual_items(d))
    write_item(json.key(i.key), i, digits);
  json.key("diameters").begin_array();
  for (const DiameterAt &at : d.diameters) {
    json.begin_object().key("percent").plain(to_decimal(at.percent));
    write_item(json.key("size"), item_of(at), digits);
    json.end_object();
  }
  json.end_array();
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
  json.key("aashto");
  if (d.aashto) {
    json.begin_object().key("symbol").plain(d.aashto->symbol).key("name").plain(d.aashto->name);
    write(json.key("index"), d.aashto->index).end_object();
  } else
    json.null();
  json.key("iso_14688");
  if (d.iso_name)
    json.begin_object()
        .key("symbol")
        .plain(d.iso_name->symbol)
        .key("name")
        .plain(d.iso_name->words)
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
  for (const DescriptionItem &i : items_of(d)) {
    const auto ends = bounds_of(i, digits);
    add(out, "{},{},{},{},\n", i.key, i.unit, ends ? ends->first : "", ends ? ends->second : "");
  }
  add(out, "USCS symbol,,,,{}\nUSCS name,,,,\"{}\"\n", d.group ? d.group->symbol : "",
      d.group ? d.group->name : "");
  add(out, "AASHTO symbol,,,,{0}\nAASHTO name,,,,\"{1}\"\nAASHTO group index,,{2},{2},\n",
      d.aashto ? d.aashto->symbol : "", d.aashto ? d.aashto->name : "", group_index(d));
  add(out, "ISO 14688-2 symbol,,,,{}\nISO 14688-2 name,,,,{}\n", d.iso_name ? d.iso_name->symbol : "",
      d.iso_name ? d.iso_name->words : "");
  add_csv_fractions(out, "USCS", d.uscs, digits);
  add_csv_fractions(out, "ISO 14688", d.iso_14688, digits);
  for (const std::string &note : d.notes)
    add(out, "note,,,,{}\n", csv_field(note));
  return fmt::to_string(out);
}

std::string description_text(const SoilDescription &d, unsigned digits) {
  TextBuffer out;
  add(out, "{}\n\n", headline(d));
  for (const DescriptionItem &i : items_of(d))
    if (!i.name.empty())
      add(out, "  {:<6}  {}\n", i.name, line_of(i, digits));
  add(out, "  AASHTO  {}\n", d.aashto ? aashto_symbol(d) + ", " + d.aashto->name : "not available");
  add(out, "  ISO     {}\n",
      d.iso_name ? d.iso_name->symbol + ", " + d.iso_name->words + " (14688-2:2004)" : "not available");
  add_text_fractions(out, "ASTM D2487", d.uscs, digits);
  add_text_fractions(out, "ISO 14688", d.iso_14688, digits);
  if (!d.notes.empty())
    out.push_back('\n');
  for (const std::string &note : d.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

} // namespace mdm

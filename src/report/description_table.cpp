#include "report/description.hpp"
#include "report/description_items.hpp"
#include "report/fractions_report.hpp"
#include "report/sample_notes.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// The percents of the main fractions of all samples.
std::string fractions_table(const char *system, const std::vector<SoilDescription> &all,
                            std::vector<Fraction> SoilDescription::*fractions, unsigned digits) {
  TextTable table;
  table.add_column(fmt::format("percent, {}", system), '<');
  for (const Fraction &f : all.front().*fractions)
    if (f.main)
      table.add_column(std::string(f.name), '>');
  for (const SoilDescription &d : all) {
    table.add_line();
    table.add(printable(d.id));
    for (const Fraction &f : d.*fractions)
      if (f.main) {
        const std::optional<Real> share = percent(f);
        table.add(share ? rounded(*share, digits) : "");
      }
  }
  return table.text();
}

} // namespace

std::string descriptions_text(const std::vector<SoilDescription> &all, unsigned digits) {
  TextTable table;
  for (const char *title : {"sample", "USCS", "AASHTO", "ISO 14688-2"})
    table.add_column(title, '<');
  std::vector<std::string> names;
  for (const DescriptionItem &i : items_of(all.front()))
    if (!i.name.empty()) {
      names.push_back(i.name);
      table.add_column(i.name, '>');
    }
  for (const SoilDescription &d : all) {
    table.add_line();
    table.add(printable(d.id));
    table.add(d.group ? d.group->symbol : "");
    table.add(aashto_symbol(d));
    table.add(d.iso_name ? d.iso_name->symbol : "");
    for (const DescriptionItem &i : items_of(d))
      if (!i.name.empty())
        table.add(shown_item(i, digits));
  }
  TextBuffer out;
  add(out, "Sizes in mm, k in m/s.\n\n{}", table.text());
  add(out, "\n{}", fractions_table("ASTM D2487", all, &SoilDescription::uscs, digits));
  add(out, "\n{}\n", fractions_table("ISO 14688", all, &SoilDescription::iso_14688, digits));
  for (const std::string &note : notes_of_samples(all))
    add(out, "  note: {}\n", printable(note));
  return fmt::to_string(out);
}

std::string descriptions_csv(const std::vector<SoilDescription> &all, unsigned digits) {
  TextBuffer out;
  add(out, "id,uscs,aashto,aashto_index,iso_14688");
  for (const DescriptionItem &i : items_of(all.front()))
    add(out, ",{0}_lo,{0}_hi", i.key);
  for (const auto &[system, fractions] :
       {std::pair("uscs", &all.front().uscs), std::pair("iso_14688", &all.front().iso_14688)})
    for (const Fraction &f : *fractions)
      add(out, ",{0}_{1}_percent_lo,{0}_{1}_percent_hi", system, column_name(f.name));
  out.push_back('\n');
  for (const SoilDescription &d : all) {
    add(out, "{},{},{},{},{}", csv_field(d.id), d.group ? d.group->symbol : "",
        d.aashto ? d.aashto->symbol : "", group_index(d), d.iso_name ? d.iso_name->symbol : "");
    for (const DescriptionItem &i : items_of(d)) {
      const auto ends = bounds_of(i, digits);
      add(out, ",{},{}", ends ? ends->first : "", ends ? ends->second : "");
    }
    for (const std::vector<Fraction> *fractions : {&d.uscs, &d.iso_14688})
      for (const Fraction &f : *fractions)
        add_csv_bounds(out, percent(f), digits);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

} // namespace mdm

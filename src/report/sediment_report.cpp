#include "report/sediment_report.hpp"

#include "gradation/shown.hpp"
#include "report/fractions_report.hpp"
#include "report/sample_notes.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <array>

namespace mdm {
namespace {

std::optional<Real> known(const Available<Real> &value) {
  return value ? std::optional(*value) : std::nullopt;
}

/// A measure as all three forms show it.
struct Measure {
  std::string key;
  const char *unit;
  const NamedMeasure *measure;
};

std::array<Measure, 4> measures(const std::string &method, const PhiMeasures &m) {
  return {{{method + "mean", "phi", &m.mean},
           {method + "sorting", "phi", &m.sorting},
           {method + "skewness", "", &m.skewness},
           {method + "kurtosis", "", &m.kurtosis}}};
}

void write_measures(JsonWriter &json, const PhiMeasures &m, unsigned digits) {
  json.begin_object();
  for (const Measure &each : measures("", m)) {
    write_value(json.key(each.key).begin_object().key("value"), known(each.measure->value), digits);
    write_text(json.key("word"), each.measure->word).end_object();
  }
  json.end_object();
}

std::string shown_value(const Available<Real> &value, const char *unit, unsigned digits) {
  if (!value)
    return "not available";
  return rounded(*value, digits) + (*unit == 0 ? "" : std::string(" ") + unit);
}

std::string range_of(const SizeMode &m) {
  return fmt::format("({}, {}] mm", shown(m.above), shown(m.up_to));
}

} // namespace

std::string sediment_json(const SedimentDescription &s, unsigned digits) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-sediment-1").key("id").string(s.id);
  write_measures(json.key("folk_ward"), s.graphic, digits);
  write_measures(json.key("moments"), s.moments, digits);
  json.key("trask").begin_object();
  write_value(json.key("sorting"), known(s.trask_sorting), digits);
  write_value(json.key("skewness"), known(s.trask_skewness), digits);
  json.end_object().key("modes").begin_array();
  for (const SizeMode &m : s.modes) {
    json.begin_object().key("above").plain(m.above.text());
    json.key("up_to").plain(m.up_to.text());
    json.end_object();
  }
  write_text(json.end_array().key("texture"), s.folk);
  write_text(json.key("shepard"), s.shepard);
  write_text(json.key("usda"), s.usda);
  write_fractions(json.key("wentworth_fractions"), s.wentworth, digits);
  json.key("notes").strings(s.notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string sediment_csv(const SedimentDescription &s, unsigned digits) {
  TextBuffer out;
  add(out, "item,unit,lo,hi,text\n");
  for (const auto &[method, group] :
       {std::pair("Folk and Ward ", &s.graphic), std::pair("moments ", &s.moments)})
    for (const Measure &m : measures(method, *group))
      add_csv_row(out, m.key, m.unit, known(m.measure->value), digits, m.measure->word);
  add_csv_row(out, "Trask sorting", "", known(s.trask_sorting), digits);
  add_csv_row(out, "Trask skewness", "", known(s.trask_skewness), digits);
  for (const SizeMode &m : s.modes)
    add(out, "mode,mm,{},{},\n", m.above.text(), m.up_to.text());
  add(out, "texture,,,,{}\nShepard texture,,,,{}\nUSDA texture,,,,{}\n", csv_field(s.folk),
      csv_field(s.shepard), csv_field(s.usda));
  add_csv_fractions(out, "Wentworth", s.wentworth, digits);
  for (const std::string &note : s.notes)
    add(out, "note,,,,{}\n", csv_field(note));
  return fmt::to_string(out);
}

std::string sediment_text(const SedimentDescription &s, unsigned digits) {
  TextBuffer out;
  add(out, "{}: {}\n\n", printable(s.id), s.folk.empty() ? "no texture" : s.folk);
  std::vector<std::vector<std::string>> lines = {{"", "Folk and Ward", "", "moments", ""}};
  const std::array<Measure, 4> graphic = measures("", s.graphic), moments = measures("", s.moments);
  for (std::size_t i = 0; i < graphic.size(); ++i)
    lines.push_back({graphic[i].key, shown_value(graphic[i].measure->value, graphic[i].unit, digits),
                     graphic[i].measure->word,
                     shown_value(moments[i].measure->value, moments[i].unit, digits),
                     moments[i].measure->word});
  add(out, "{}", text_table(lines, "<><><"));
  add(out, "\n  Trask: sorting {}, skewness {}\n", shown_value(s.trask_sorting, "", digits),
      shown_value(s.trask_skewness, "", digits));
  std::vector<std::string> modes;
  for (const SizeMode &m : s.modes)
    modes.push_back(range_of(m));
  if (!modes.empty())
    add(out, "  modes, the highest first: {}\n", fmt::join(modes, ", "));
  add(out, "  of what passes 2 mm: {} of Shepard, {} of the USDA\n",
      s.shepard.empty() ? "no texture" : s.shepard, s.usda.empty() ? "no texture" : s.usda);
  add_text_fractions(out, "Wentworth", s.wentworth, digits);
  out.push_back('\n');
  for (const std::string &note : s.notes)
    add(out, "  note: {}\n", printable(note));
  return fmt::to_string(out);
}

std::string sediments_text(const std::vector<SedimentDescription> &all, unsigned digits) {
  TextTable table;
  table.add_column("sample", '<');
  for (const char *title : {"mean", "sorting", "skewness", "kurtosis"})
    table.add_column(title, '>');
  for (const char *title : {"sorting in words", "texture of Folk"})
    table.add_column(title, '<');
  for (const SedimentDescription &s : all) {
    table.add_line();
    table.add(printable(s.id));
    for (const Measure &m : measures("", s.graphic))
      table.add(shown_value(m.measure->value, "", digits));
    table.add(s.graphic.sorting.word);
    table.add(s.folk);
  }
  TextBuffer out;
  add(out, "Folk and Ward, in phi\n\n{}\n", table.text());
  for (const std::string &note : notes_of_samples(all))
    add(out, "  note: {}\n", printable(note));
  return fmt::to_string(out);
}

std::string sediments_csv(const std::vector<SedimentDescription> &all, unsigned digits) {
  TextBuffer out;
  add(out, "id");
  for (const char *method : {"folk_ward", "moments"})
    for (const char *measure : {"mean", "sorting", "skewness", "kurtosis"})
      add(out, ",{0}_{1}_lo,{0}_{1}_hi,{0}_{1}_word", method, measure);
  add(out, ",trask_sorting_lo,trask_sorting_hi,trask_skewness_lo,trask_skewness_hi,folk,shepard,usda");
  for (const Fraction &f : all.front().wentworth)
    add(out, ",{0}_percent_lo,{0}_percent_hi", column_name(f.name));
  out.push_back('\n');
  for (const SedimentDescription &s : all) {
    add(out, "{}", csv_field(s.id));
    for (const PhiMeasures *group : {&s.graphic, &s.moments})
      for (const Measure &m : measures("", *group)) {
        add_csv_bounds(out, known(m.measure->value), digits);
        add(out, ",{}", csv_field(m.measure->word));
      }
    add_csv_bounds(out, known(s.trask_sorting), digits);
    add_csv_bounds(out, known(s.trask_skewness), digits);
    add(out, ",{},{},{}", csv_field(s.folk), csv_field(s.shepard), csv_field(s.usda));
    for (const Fraction &f : s.wentworth)
      add_csv_bounds(out, percent(f), digits);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

} // namespace mdm

#include "report/rule_report.hpp"

#include "answer/json_values.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

std::optional<Enclosure> enclosure(const std::optional<Real> &y, unsigned digits) {
  return y ? std::optional(enclose(*y, digits)) : std::nullopt;
}

void write_rule_number(JsonWriter &json, const RuleNumber &n, unsigned digits) {
  json.begin_object().key("name").string(n.name);
  write(json.key("value"), enclosure(n.value, digits));
  json.key("unit").string(n.unit).end_object();
}

void write_numbers(JsonWriter &json, const std::vector<RuleNumber> &numbers, unsigned digits) {
  json.begin_array();
  for (const RuleNumber &n : numbers)
    write_rule_number(json, n, digits);
  json.end_array();
}

void write_requirement(JsonWriter &json, const Requirement &r, unsigned digits) {
  json.begin_object().key("name").string(r.name).key("verdict").plain(name(r.verdict));
  write_rule_number(json.key("of"), r.value, digits);
  json.key("side").plain(r.at_most ? "most" : "least");
  write(json.key("limit"), enclosure(r.limit, digits));
  json.key("limit_is").string(r.limit_text).end_object();
}

/// A number with its unit.
std::string number_text(const std::optional<Real> &y, const std::string &unit, unsigned digits) {
  if (!y)
    return "not told";
  return rounded(*y, digits) + (unit.empty() ? "" : " " + unit);
}

std::string requirement_table(const RuleJudgement &sample, unsigned digits) {
  std::vector<std::vector<std::string>> lines = {{"requirement", "of", "", "limit", "", "which is"}};
  for (const Requirement &r : sample.requirements)
    lines.push_back(
        {r.name, r.value.name, number_text(r.value.value, r.value.unit, digits),
         fmt::format("{} {}", r.at_most ? "at most" : "at least", number_text(r.limit, r.value.unit, digits)),
         std::string(name(r.verdict)), r.limit_text});
  return text_table(lines, "<<><<<");
}

void add_numbers(TextBuffer &out, const std::vector<RuleNumber> &numbers, unsigned digits) {
  for (const RuleNumber &n : numbers)
    add(out, "  {}: {}\n", n.name, number_text(n.value, n.unit, digits));
}

void add_note_lines(TextBuffer &out, const std::vector<std::string> &notes) {
  for (const std::string &note : notes)
    add(out, "  note: {}\n", printable(note));
}

} // namespace

std::string rule_json(const RuleReport &report, unsigned digits) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-rule-1").key("rule").string(report.rule);
  json.key("about").string(report.about).key("verdict").plain(name(report.verdict()));
  write_numbers(json.key("numbers"), report.numbers, digits);
  json.key("notes").strings(report.notes).key("samples").begin_array();
  for (const RuleJudgement &sample : report.samples) {
    json.begin_object().key("id").string(sample.id).key("verdict").plain(name(sample.verdict));
    json.key("requirements").begin_array();
    for (const Requirement &r : sample.requirements)
      write_requirement(json, r, digits);
    json.end_array();
    write_numbers(json.key("numbers"), sample.numbers, digits);
    json.key("notes").strings(sample.notes).end_object();
  }
  json.end_array().key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string rule_csv(const RuleReport &report, unsigned digits) {
  TextBuffer out;
  add(out, "sample,requirement,of,unit,value_lo,value_hi,side,limit_lo,limit_hi,verdict\n");
  const auto ends = [digits](const std::optional<Real> &y) {
    const std::optional<Enclosure> e = enclosure(y, digits);
    return e ? e->lower_text() + "," + e->upper_text() : ",";
  };
  for (const RuleJudgement &sample : report.samples) {
    const std::string id = csv_field(sample.id);
    for (const Requirement &r : sample.requirements)
      add(out, "{},{},{},{},{},{},{},{}\n", id, csv_field(r.name), csv_field(r.value.name), r.value.unit,
          ends(r.value.value), r.at_most ? "most" : "least", ends(r.limit), name(r.verdict));
    add(out, "{},,,,,,,,,{}\n", id, name(sample.verdict));
  }
  return fmt::to_string(out);
}

std::string rule_text(const RuleReport &report, unsigned digits) {
  TextBuffer out;
  for (const RuleJudgement &sample : report.samples) {
    add(out, "{}: {} of {}\n\n", printable(sample.id), headline(sample.verdict), report.rule);
    if (!sample.requirements.empty())
      add(out, "{}\n", requirement_table(sample, digits));
    add_numbers(out, sample.numbers, digits);
    add_note_lines(out, sample.notes);
    out.push_back('\n');
  }
  add(out, "{}: {}\n", report.rule, report.about);
  add_numbers(out, report.numbers, digits);
  add_note_lines(out, report.notes);
  return fmt::to_string(out);
}

} // namespace mdm

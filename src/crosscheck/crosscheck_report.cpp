#include "crosscheck/crosscheck_report.hpp"

#include "answer/json_values.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

constexpr unsigned shown_digits = 6;
constexpr std::size_t shown_bad_rows = 10;

std::string number(const std::optional<Integer> &n) {
  return n ? to_string(*n) : "";
}

std::string number(const std::optional<Rational> &r) {
  return r ? approximate(*r, shown_digits) : "";
}

std::optional<Rational> percent(const std::optional<Rational> &share) {
  return share ? std::optional(Rational(*share * 100)) : std::nullopt;
}

bool is_match(const CrosscheckRow &row) {
  return row.verdict == AnswerVerdict::minimal || row.verdict == AnswerVerdict::larger;
}

/// Verdicts that a table shows: those that always have a meaning, and those that occurred.
std::vector<AnswerVerdict> shown_verdicts(const CrosscheckSummary &summary) {
  std::vector<AnswerVerdict> shown;
  for (const AnswerVerdict v : answer_verdicts)
    if (v <= AnswerVerdict::not_a_match || summary.count(v) > 0)
      shown.push_back(v);
  return shown;
}

constexpr std::array<const char *, 5> quartile_keys = {"least", "quarter", "median", "three_quarters",
                                                       "largest"};

} // namespace

std::string crosscheck_csv_header(const CrosscheckColumns &columns) {
  return "id,verdict,particles,minimum,ratio,max_error" +
         (columns.setting.empty() ? "" : "," + csv_field(columns.setting)) +
         (columns.reasons ? ",reason\n" : "\n");
}

std::string crosscheck_csv(const CrosscheckRow &row, const CrosscheckColumns &columns) {
  return fmt::format("{},{},{},{},{},{}", csv_field(row.id), name(row.verdict), number(row.particles),
                     number(row.minimum), number(row.ratio), number(percent(row.max_error))) +
         (columns.setting.empty() ? "" : "," + csv_field(row.setting)) +
         (columns.reasons ? "," + csv_field(row.reason) : "") + "\n";
}

void begin_crosscheck(JsonWriter &json, const CrosscheckAsked &asked) {
  const auto write_optional = [&json](const char *key, const std::optional<std::string> &value) {
    if (value)
      json.key(key).string(*value);
    else
      json.key(key).null();
  };
  json.begin_object().key("schema").plain("mdm-crosscheck-1").key("suite").string(asked.suite);
  write_optional("answers", asked.answers);
  write_optional("solver", asked.solver);
  write_optional("by", asked.by);
  write_optional("question", asked.question);
  json.key("size_tolerance").plain(to_string(asked.size_tolerance)).key("rows").begin_array();
}

void write_row(JsonWriter &json, const CrosscheckRow &row, bool has_setting) {
  const auto write_shown = [&json](const char *key, const std::string &n) {
    if (n.empty())
      json.key(key).null();
    else
      json.key(key).plain(n);
  };
  json.begin_object().key("id").string(row.id);
  if (has_setting)
    json.key("setting").string(row.setting);
  json.key("verdict").plain(name(row.verdict));
  write_shown("particles", number(row.particles));
  write_shown("minimum", number(row.minimum));
  write_shown("ratio", number(row.ratio));
  write_shown("max_error", number(percent(row.max_error)));
  write_text(json.key("reason"), row.reason).end_object();
}

void end_crosscheck(JsonWriter &json, const CrosscheckSummary &summary, bool has_setting,
                    const std::vector<std::string> &notes) {
  json.end_array().key("summary");
  summary.write(json, has_setting);
  json.key("notes").strings(notes).key("versions").raw(versions_json()).end_object();
}

std::string crosscheck_text(const std::string &suite, const std::optional<std::string> &question,
                            std::uint64_t gradations, const CrosscheckSummary &summary,
                            const CrosscheckColumns &columns, const std::vector<std::string> &notes) {
  std::string text =
      fmt::format("{}: {} {}{}\n\n", suite, gradations, gradations == 1 ? "gradation" : "gradations",
                  question ? ", asked with " + printable(*question) : "") +
      summary.text(columns);
  for (const std::string &note : notes)
    text += "  note: " + note + "\n";
  return text;
}

std::optional<Quartiles> quartiles(std::vector<Rational> ratios) {
  if (ratios.empty())
    return std::nullopt;
  std::sort(ratios.begin(), ratios.end());
  const std::size_t n = ratios.size();
  return Quartiles{ratios[0], ratios[n / 4], ratios[n / 2], ratios[3 * n / 4], ratios[n - 1]};
}

std::uint64_t CrosscheckSummary::Setting::rows() const {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void CrosscheckSummary::add(const CrosscheckRow &row) {
  auto setting = std::find_if(settings_.begin(), settings_.end(),
                              [&row](const Setting &s) { return s.name == row.setting; });
  if (setting == settings_.end()) {
    settings_.emplace_back().name = row.setting;
    setting = settings_.end() - 1;
  }
  ++setting->counts[static_cast<std::size_t>(row.verdict)];
  if (row.ratio)
    setting->ratios.push_back(*row.ratio);
  if (!is_match(row) && first_bad_.size() < shown_bad_rows)
    first_bad_.push_back(row);
}

std::uint64_t CrosscheckSummary::count(AnswerVerdict verdict) const {
  std::uint64_t n = 0;
  for (const Setting &s : settings_)
    n += s.count(verdict);
  return n;
}

std::string CrosscheckSummary::text(const CrosscheckColumns &columns) const {
  const std::vector<AnswerVerdict> shown = shown_verdicts(*this);
  std::vector<std::vector<std::string>> lines = {{printable(columns.setting), "answers"}};
  for (const AnswerVerdict v : shown)
    lines[0].emplace_back(name(v));
  for (const char *heading : {"N/smallest: least", "1/4", "median", "3/4", "largest"})
    lines[0].emplace_back(heading);
  std::uint64_t rows = 0;
  for (const Setting &s : settings_) {
    std::vector<std::string> &line = lines.emplace_back();
    line = {printable(s.name), std::to_string(s.rows())};
    rows += s.rows();
    for (const AnswerVerdict v : shown)
      line.push_back(std::to_string(s.count(v)));
    if (const std::optional<Quartiles> q = quartiles(s.ratios))
      for (const Rational &ratio : *q)
        line.push_back(approximate(ratio, shown_digits));
    else
      line.insert(line.end(), quartile_keys.size(), "-");
  }
  std::string text = text_table(lines, "<>");
  const std::uint64_t bad = rows - count(AnswerVerdict::minimal) - count(AnswerVerdict::larger);
  if (bad > 0)
    text += bad > first_bad_.size()
                ? fmt::format("\nnot judged a match, the first {} of {}:\n", first_bad_.size(), bad)
                : "\nnot judged a match:\n";
  for (const CrosscheckRow &row : first_bad_)
    text += fmt::format("  {}{}: {}{}\n", row.id.empty() ? "(no id)" : printable(row.id),
                        row.setting.empty() ? "" : " (" + printable(row.setting) + ")", name(row.verdict),
                        row.reason.empty() ? "" : ": " + printable(row.reason));
  return text;
}

void CrosscheckSummary::write(JsonWriter &json, bool has_setting) const {
  json.begin_array();
  for (const Setting &s : settings_) {
    json.begin_object();
    if (has_setting)
      json.key("setting").string(s.name);
    json.key("answers").number(s.rows()).key("verdicts").begin_object();
    for (const AnswerVerdict v : answer_verdicts)
      json.key(name(v)).number(s.count(v));
    json.end_object().key("ratio");
    if (const std::optional<Quartiles> q = quartiles(s.ratios)) {
      json.begin_object();
      for (std::size_t i = 0; i < quartile_keys.size(); ++i)
        json.key(quartile_keys[i]).plain(approximate((*q)[i], shown_digits));
      json.end_object();
    } else {
      json.null();
    }
    json.end_object();
  }
  json.end_array();
}

} // namespace mdm

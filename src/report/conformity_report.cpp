#include "report/conformity_report.hpp"

#include "answer/json_values.hpp"
#include "gradation/shown.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

void write_percent(JsonWriter &json, const std::optional<Real> &percent, unsigned digits) {
  write(json, percent ? std::optional(enclose(*percent, digits)) : std::nullopt);
}

void write_specification(JsonWriter &json, const Specification &s) {
  json.begin_object().key("id").string(s.id).key("about").strings(s.about).key("sieves").begin_array();
  for (const PassingLimits &limits : s.sieves)
    json.begin_object()
        .key("size")
        .plain(to_decimal(limits.size))
        .key("passing_min_percent")
        .plain(to_decimal(limits.least))
        .key("passing_max_percent")
        .plain(to_decimal(limits.most))
        .end_object();
  json.end_array().key("notes").strings(s.notes).end_object();
}

void write_sieve(JsonWriter &json, const SieveVerdict &s, unsigned digits) {
  json.begin_object().key("size").plain(to_decimal(s.limits.size)).key("verdict").plain(name(s.verdict));
  write_percent(json.key("percent"), s.passing, digits);
  write_percent(json.key("least"), s.least, digits);
  write_percent(json.key("most"), s.most, digits);
  json.key("interpolated").boolean(s.is_interpolated);
  write_percent(json.key("distance"), s.distance, digits);
  json.end_object();
}

void write_limit(JsonWriter &json, const LimitVerdict &v, unsigned digits) {
  json.begin_object().key("name").string(v.number.name).key("verdict").plain(name(v.verdict));
  write_decimal(json.key("min"), v.limit.least);
  write_decimal(json.key("max"), v.limit.most);
  write_percent(json.key("value"), v.value, digits);
  write_percent(json.key("least"), v.least, digits);
  write_percent(json.key("most"), v.most, digits);
  json.end_object();
}

void write_witness(JsonWriter &json, const std::optional<WitnessCurve> &witness) {
  if (!witness) {
    json.null();
    return;
  }
  json.begin_array();
  for (std::size_t i = 0; i < witness->sizes.size(); ++i)
    write(json.begin_object().key("size").plain(witness->sizes[i].text()).key("percent"), witness->passing[i])
        .end_object();
  json.end_array();
}

void write_sample(JsonWriter &json, const Conformity &c, unsigned digits) {
  json.begin_object().key("id").string(c.id).key("verdict").plain(name(c.verdict));
  json.key("rounded").boolean(!c.is_exact).key("sieves").begin_array();
  for (const SieveVerdict &s : c.sieves)
    write_sieve(json, s, digits);
  json.end_array().key("limits").begin_array();
  for (const LimitVerdict &v : c.limits)
    write_limit(json, v, digits);
  json.end_array();
  write_witness(json.key("within"), c.within);
  write_witness(json.key("outside"), c.outside);
  json.key("notes").strings(c.notes).end_object();
}

/// What may have been rounded, where it is no point.
std::string range(const SieveVerdict &s, unsigned digits) {
  return rounded(s.least, digits) + " to " + rounded(s.most, digits);
}

std::string percent(const SieveVerdict &s, unsigned digits) {
  return s.passing ? shown_beside_limits(*s.passing, s.limits.least, s.limits.most, digits) : "not told";
}

using Lines = std::vector<std::vector<std::string>>;

std::string sieve_table(const Conformity &c, unsigned digits) {
  Lines lines = {{"size [mm]", "passing [%]", "min", "max", "", "distance"}};
  if (!c.is_exact)
    lines[0].insert(lines[0].begin() + 2, "may be");
  for (auto s = c.sieves.rbegin(); s != c.sieves.rend(); ++s) {
    lines.push_back({to_decimal(s->limits.size), percent(*s, digits), to_decimal(s->limits.least),
                     to_decimal(s->limits.most), std::string(name(s->verdict)),
                     s->distance ? rounded(*s->distance, digits) : ""});
    if (!c.is_exact)
      lines.back().insert(lines.back().begin() + 2, range(*s, digits));
  }
  return text_table(lines, c.is_exact ? ">>>><>" : ">>>>><>");
}

std::string limit_text(const std::optional<Rational> &limit) {
  return limit ? to_decimal(*limit) : "";
}

std::string value_text(const LimitVerdict &v, unsigned digits) {
  return v.value ? shown_beside_limits(*v.value, v.limit.least, v.limit.most, digits) : "not told";
}

std::string limit_table(const Conformity &c, unsigned digits) {
  Lines lines = {{"", "", "min", "max", ""}};
  if (!c.is_exact)
    lines[0].insert(lines[0].begin() + 2, "may be");
  for (const LimitVerdict &v : c.limits) {
    lines.push_back({v.number.name, value_text(v, digits), limit_text(v.limit.least),
                     limit_text(v.limit.most), std::string(name(v.verdict))});
    if (!c.is_exact)
      lines.back().insert(lines.back().begin() + 2,
                          rounded(v.least, digits) + " to " + rounded(v.most, digits));
  }
  return text_table(lines, c.is_exact ? "<>>><" : "<>>>><");
}

void add_witness(TextBuffer &out, const char *what, const std::optional<WitnessCurve> &witness) {
  if (!witness)
    return;
  std::vector<std::string> points;
  for (std::size_t i = witness->sizes.size(); i-- > 0;)
    points.push_back(shown(witness->passing[i]) + " at " + witness->sizes[i].text());
  add(out, "  {}: percent passing {} mm\n", what, fmt::join(points, ", "));
}

void add_details(TextBuffer &out, const Conformity &c) {
  add_witness(out, "a curve of this report that keeps the limits", c.within);
  add_witness(out, "one that does not", c.outside);
}

/// Samples as columns; what is not certain to pass says so.
std::string matrix(const ConformityReport &r, unsigned digits) {
  Lines lines = {{"size [mm]", "min", "max"}};
  for (const Conformity &c : r.samples)
    lines[0].push_back(printable(c.id));
  const std::vector<PassingLimits> &sieves = r.specification.sieves;
  for (std::size_t i = sieves.size(); i-- > 0;) {
    lines.push_back({to_decimal(sieves[i].size), to_decimal(sieves[i].least), to_decimal(sieves[i].most)});
    for (const Conformity &c : r.samples) {
      const SieveVerdict &s = c.sieves[i];
      lines.back().push_back(percent(s, digits) +
                             (s.verdict == Compliance::holds ? "" : " " + std::string(name(s.verdict))));
    }
  }
  for (std::size_t i = 0; i < r.samples.front().limits.size(); ++i) {
    const LimitVerdict &first = r.samples.front().limits[i];
    lines.push_back({first.number.name, limit_text(first.limit.least), limit_text(first.limit.most)});
    for (const Conformity &c : r.samples) {
      const LimitVerdict &v = c.limits[i];
      lines.back().push_back(value_text(v, digits) +
                             (v.verdict == Compliance::holds ? "" : " " + std::string(name(v.verdict))));
    }
  }
  lines.push_back({"all", "", ""});
  for (const Conformity &c : r.samples)
    lines.back().emplace_back(name(c.verdict));
  return text_table(lines, ">>>>");
}

void add_notes(TextBuffer &out, const std::vector<std::string> &notes, const std::string &of) {
  for (const std::string &note : notes)
    add(out, "  note: {}{}\n", of, printable(note));
}

} // namespace

Compliance ConformityReport::verdict() const {
  std::vector<Compliance> verdicts;
  for (const Conformity &c : samples)
    verdicts.push_back(c.verdict);
  return worst(verdicts);
}

std::string shown_beside_limits(const Real &value, const std::optional<Rational> &least,
                                const std::optional<Rational> &most, unsigned digits) {
  constexpr unsigned most_digits = 30;
  const bool is_low = least && compare(value, *least) == Order::less;
  const bool is_high = most && compare(value, *most) == Order::greater;
  std::string text = rounded(value, digits);
  while (digits < most_digits &&
         ((is_low && parse_decimal(text) >= *least) || (is_high && parse_decimal(text) <= *most)))
    text = rounded(value, ++digits);
  return text;
}

std::string conformity_json(const ConformityReport &r, unsigned digits) {
  JsonWriter json;
  json.begin_object()
      .key("schema")
      .plain("mdm-judge-1")
      .key("unit")
      .plain("mm")
      .key("verdict")
      .plain(name(r.verdict()));
  write_specification(json.key("specification"), r.specification);
  json.key("samples").begin_array();
  for (const Conformity &c : r.samples)
    write_sample(json, c, digits);
  json.end_array().key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string conformity_csv(const ConformityReport &r, unsigned digits) {
  TextBuffer out;
  add(out,
      "sample,size_mm,passing_min_percent,passing_max_percent,passing_lo,passing_hi,least,most,verdict\n");
  const auto lower = [digits](const Real &y) { return enclose(y, digits).lower_text(); };
  const auto upper = [digits](const Real &y) { return enclose(y, digits).upper_text(); };
  for (const Conformity &c : r.samples) {
    const std::string id = csv_field(c.id);
    for (const SieveVerdict &s : c.sieves) {
      const std::optional<Enclosure> passing =
          s.passing ? std::optional(enclose(*s.passing, digits)) : std::nullopt;
      add(out, "{},{},{},{},{},{},{},{},{}\n", id, to_decimal(s.limits.size), to_decimal(s.limits.least),
          to_decimal(s.limits.most), passing ? passing->lower_text() : "",
          passing ? passing->upper_text() : "", lower(s.least), upper(s.most), name(s.verdict));
    }
    for (const LimitVerdict &v : c.limits)
      add(out, "{},{},{},{},{},{},{},{},{}\n", id, csv_field(v.number.name), limit_text(v.limit.least),
          limit_text(v.limit.most), v.value ? lower(*v.value) : "", v.value ? upper(*v.value) : "",
          lower(v.least), upper(v.most), name(v.verdict));
    add(out, "{},,,,,,,,{}\n", id, name(c.verdict));
  }
  return fmt::to_string(out);
}

std::string conformity_text(const ConformityReport &r, unsigned digits) {
  TextBuffer out;
  if (r.samples.size() == 1) {
    const Conformity &c = r.samples.front();
    add(out, "{}: {} of {}\n\n{}", printable(c.id), headline(c.verdict), printable(r.specification.id),
        sieve_table(c, digits));
    if (!c.limits.empty())
      add(out, "\n{}", limit_table(c, digits));
    if (c.within || c.outside)
      out.push_back('\n');
    add_details(out, c);
  } else {
    add(out, "{}: {}\n\n{}", printable(r.specification.id), headline(r.verdict()), matrix(r, digits));
    for (const Conformity &c : r.samples)
      if (c.within || c.outside) {
        add(out, "\n{}:\n", printable(c.id));
        add_details(out, c);
      }
  }
  out.push_back('\n');
  add_notes(out, r.specification.about, r.specification.id + ": ");
  add_notes(out, r.specification.notes, r.specification.id + ": ");
  for (const Conformity &c : r.samples)
    add_notes(out, c.notes, r.samples.size() == 1 ? "" : printable(c.id) + ": ");
  return fmt::to_string(out);
}

} // namespace mdm

#include "document/laboratory_report.hpp"

#include "document/html.hpp"
#include "document/report_texts.hpp"
#include "gradation/shown.hpp"
#include "gradation/sieve_name.hpp"
#include "plot/curves_figure.hpp"
#include "plot/picture.hpp"
#include "report/description.hpp"
#include "report/description_items.hpp"
#include "report/fractions_report.hpp"
#include "report/sample_notes.hpp"
#include "text/german.hpp"
#include "text/json_writer.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned shown_digits = 4;

constexpr std::string_view style = R"(
:root { color-scheme: light; }
body { font: 11pt/1.4 system-ui, "DejaVu Sans", sans-serif; margin: 2em auto; max-width: 50em; color: #111; }
h1 { font-size: 1.5em; margin: 0 0 .5em; }
h2 { font-size: 1.15em; margin: 1.6em 0 .4em; border-bottom: 1px solid #888; break-after: avoid; }
table.head th, table.head td { border: 0; padding: .1em 1em .1em 0; text-align: left; vertical-align: top; }
table.head th { font-weight: 600; }
table.head td { overflow-wrap: anywhere; }
table { border-collapse: collapse; margin: .6em 0 1em; font-size: .92em; break-inside: avoid; }
caption { text-align: left; font-weight: 600; padding-bottom: .2em; }
th, td { border: 1px solid #bbb; padding: .15em .6em; overflow-wrap: anywhere; }
thead th { background: #eee; }
tbody th { font-weight: 400; text-align: left; }
td { text-align: right; font-variant-numeric: tabular-nums; }
tr.fail td, tr.fail th { background: #fbe3e0; }
.verdict { font-size: 1.1em; font-weight: 600; }
svg { max-width: 100%; height: auto; }
footer { margin-top: 2em; font-size: .85em; color: #444; }
@page { margin: 15mm 14mm; }
@media print { body { margin: 0; max-width: none; font-size: 9.5pt; } }
)";

/// The tables of a report, in its language.
class ReportTables {
public:
  explicit ReportTables(Language language) : language_(language), texts_(report_texts(language)) {}

  std::string analysis(const ReportedSample &sample) const;
  std::string conformity(const ConformityReport &r) const;
  std::string indices(const std::vector<ReportedSample> &samples) const;
  /// Percents of the main fractions, a column a sample.
  std::string fractions(const char *system, const std::vector<ReportedSample> &samples,
                        std::vector<Fraction> SoilDescription::*of) const;

private:
  std::string number(std::string text) const { return local_number(std::move(text), language_); }
  std::string percent_of(const Rational &share) const {
    return number(rounded(Real(share * 100), shown_digits));
  }
  std::string sieve_title(const RootSize &opening) const;
  std::string verdict_cell(const SieveVerdict &s) const;
  std::string conformity_table(const ConformityReport &r) const;
  std::string iso_name(const Available<Iso14688Name> &name) const {
    return name ? name->symbol + ", " + local_soil_name(name->symbol, name->words, language_)
                : std::string(texts_.not_available);
  }

  Language language_;
  const ReportTexts &texts_;
};

/// `0.075 (No. 200)`; `pan` at size 0.
std::string ReportTables::sieve_title(const RootSize &opening) const {
  if (opening.power == 0)
    return std::string(texts_.pan);
  const std::optional<Rational> size = opening.fraction();
  const std::optional<std::string> astm = size ? astm_sieve_name(*size) : std::nullopt;
  return number(shown(opening)) + (astm ? " (" + *astm + ")" : "");
}

/// A line a sieve, the coarsest first: mass where masses were weighed, percent retained and percent passing.
std::string ReportTables::analysis(const ReportedSample &sample) const {
  const GradingCurve &curve = sample.description.curve;
  const bool is_weighed = sample.sheet.kind == "mass" && !sample.sheet.masses.empty();
  std::vector<std::string> titles = {std::string(texts_.sieve)};
  if (is_weighed)
    titles.emplace_back(texts_.mass_retained);
  titles.insert(titles.end(), {std::string(texts_.retained), std::string(texts_.passing)});
  HtmlTable table(sample.description.id, titles);
  for (std::size_t i = curve.shares().size(); i-- > 0;) {
    const bool is_last = i + 1 == curve.shares().size();
    std::vector<std::string> cells = {sieve_title(curve.opening(i))};
    if (is_weighed)
      cells.push_back(number(shown(sample.sheet.gradation.masses()[i])));
    cells.push_back(is_last ? "0" : percent_of(curve.mass(i)));
    cells.push_back(percent_of(curve.shares()[i]));
    table.add(cells);
  }
  return table.html();
}

/// The percent that passes and the verdict.
std::string ReportTables::verdict_cell(const SieveVerdict &s) const {
  const std::string passing =
      s.passing ? number(shown_beside_limits(*s.passing, s.limits.least, s.limits.most, shown_digits)) : "?";
  return fmt::format("{}{} {}", passing, s.is_interpolated ? "*" : "", texts_.verdict(s.verdict));
}

/// A line a sieve of the specification, the coarsest first.
std::string ReportTables::conformity_table(const ConformityReport &r) const {
  std::vector<std::string> titles;
  for (const std::string_view title : {texts_.sieve, texts_.least, texts_.most})
    titles.emplace_back(title);
  for (const Conformity &c : r.samples)
    titles.push_back(c.id);
  HtmlTable table(std::string(texts_.percent_passing), titles, 3);
  for (std::size_t i = r.specification.sieves.size(); i-- > 0;) {
    const PassingLimits &limits = r.specification.sieves[i];
    std::vector<std::string> cells;
    for (const Rational &limit : {limits.size, limits.least, limits.most})
      cells.push_back(number(to_decimal(limit)));
    bool misses = false;
    for (const Conformity &c : r.samples) {
      cells.push_back(verdict_cell(c.sieves[i]));
      misses = misses || c.sieves[i].verdict != Compliance::holds;
    }
    table.add(cells, misses && r.samples.size() == 1 ? "fail" : "");
  }
  return table.html();
}

std::string ReportTables::conformity(const ConformityReport &r) const {
  std::string html =
      fmt::format("<section><h2>{} {}</h2>\n", texts_.specification, html_text(r.specification.id));
  for (const std::string &line : r.specification.about)
    html += fmt::format("<p>{}</p>\n", html_text(line));
  for (const Conformity &c : r.samples)
    html += fmt::format("<p class=\"verdict\">{}: {}</p>\n", html_text(c.id), texts_.verdict(c.verdict));
  html += conformity_table(r);
  const bool is_interpolated = std::any_of(r.samples.begin(), r.samples.end(), [](const Conformity &c) {
    return std::any_of(c.sieves.begin(), c.sieves.end(),
                       [](const SieveVerdict &s) { return s.is_interpolated; });
  });
  if (is_interpolated)
    html += fmt::format("<p>* {}</p>\n", texts_.interpolated);
  return html + "</section>\n";
}

/// A line an index number, a column a sample.
std::string ReportTables::indices(const std::vector<ReportedSample> &samples) const {
  const std::string none(texts_.not_available);
  std::vector<std::string> titles = {""};
  std::vector<std::vector<DescriptionItem>> items;
  for (const ReportedSample &s : samples) {
    titles.push_back(s.description.id);
    items.push_back(items_of(s.description));
  }
  HtmlTable table(std::string(texts_.indices), titles);
  const auto add = [&](const std::string &title, auto value) {
    std::vector<std::string> cells = {title};
    for (std::size_t j = 0; j < samples.size(); ++j)
      cells.push_back(value(j));
    table.add(cells);
  };
  add("ASTM D2487", [&](std::size_t j) {
    const Available<UscsGroup> &group = samples[j].description.group;
    return group ? group->symbol + ", " + group->name : none;
  });
  add("AASHTO M 145", [&](std::size_t j) {
    const SoilDescription &d = samples[j].description;
    return d.aashto ? aashto_symbol(d) : none;
  });
  add("ISO 14688-2:2004", [&](std::size_t j) { return iso_name(samples[j].description.iso_name); });
  for (std::size_t i = 0; i < items.front().size(); ++i)
    if (const DescriptionItem &first = items.front()[i]; !first.name.empty())
      add(*first.unit == 0 ? first.name : fmt::format("{}, {}", first.name, first.unit), [&](std::size_t j) {
        return items[j][i].value ? number(shown_item(items[j][i], shown_digits)) : none;
      });
  return table.html();
}

std::string ReportTables::fractions(const char *system, const std::vector<ReportedSample> &samples,
                                    std::vector<Fraction> SoilDescription::*of) const {
  std::vector<std::string> titles = {std::string(texts_.fractions)};
  for (const ReportedSample &s : samples)
    titles.push_back(s.description.id);
  HtmlTable table(system, titles);
  const std::vector<Fraction> &first = samples.front().description.*of;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!first[i].main)
      continue;
    std::vector<std::string> cells = {band_names(first[i].name, language_).front()};
    for (const ReportedSample &s : samples) {
      const std::optional<Real> share = percent((s.description.*of)[i]);
      cells.push_back(share ? number(rounded(*share, shown_digits)) : std::string(texts_.not_available));
    }
    table.add(cells);
  }
  return table.html();
}

/// The curves as SVG that stands in HTML.
std::string curves_svg(const LaboratoryReport &r) {
  CurvesFigure figure;
  figure.form.bare = true;
  figure.form.language = r.language;
  if (r.conformity)
    figure.limits = envelope_of(r.conformity->specification);
  for (std::size_t j = 0; j < r.samples.size(); ++j) {
    DrawnCurve curve{r.samples[j].description.id, r.samples[j].sheet.gradation};
    if (r.conformity)
      curve.missed = missed_sizes(r.conformity->samples[j]);
    figure.curves.push_back(std::move(curve));
  }
  const std::string svg = picture_of(curves_figure(figure), Picture::svg);
  return svg.substr(svg.find("<svg")); // without the declaration of XML
}

std::vector<std::string> all_notes(const LaboratoryReport &r) {
  std::vector<SoilDescription> descriptions;
  for (const ReportedSample &s : r.samples)
    descriptions.push_back(s.description);
  std::vector<std::string> notes = notes_of_samples(descriptions);
  if (r.conformity) {
    notes.insert(notes.end(), r.conformity->specification.notes.begin(),
                 r.conformity->specification.notes.end());
    for (const std::string &note : notes_of_samples(r.conformity->samples))
      if (std::find(notes.begin(), notes.end(), note) == notes.end())
        notes.push_back(note);
  }
  return notes;
}

/// A note in the report's language; one that has no German text stays English, and says so.
std::string note_item(const std::string &note, Language language) {
  if (language == Language::english)
    return fmt::format("<li>{}</li>\n", html_text(note));
  const std::optional<std::string> german = in_german(note);
  return german ? fmt::format("<li>{}</li>\n", html_text(*german))
                : fmt::format("<li lang=\"en\">{}</li>\n", html_text(note));
}

} // namespace

std::string report_html(const LaboratoryReport &r) {
  const ReportTexts &texts = report_texts(r.language);
  const ReportTables tables(r.language);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{2}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<header><h1>{0}</h1>\n<table class=\"head\"><tbody>\n",
      html_text(r.title), style, texts.code);
  for (const auto &[name, value] : r.fields)
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", html_text(name), html_text(value));
  html += fmt::format("</tbody></table>\n</header>\n<main>\n<section><h2>{}</h2>\n{}</section>\n",
                      texts.curves, curves_svg(r));
  html += fmt::format("<section><h2>{}</h2>\n", texts.analysis);
  for (const ReportedSample &s : r.samples)
    html += tables.analysis(s);
  html += "</section>\n";
  if (r.conformity)
    html += tables.conformity(*r.conformity);
  html += fmt::format("<section><h2>{}</h2>\n", texts.description) + tables.indices(r.samples);
  html += tables.fractions("ASTM D2487", r.samples, &SoilDescription::uscs);
  html += tables.fractions("ISO 14688", r.samples, &SoilDescription::iso_14688);
  html += fmt::format("</section>\n<section><h2>{}</h2>\n<ul>\n", texts.notes);
  for (const std::string &note : all_notes(r))
    html += note_item(note, r.language);
  html += "</ul>\n</section>\n</main>\n<footer>";
  html += fmt::format(fmt::runtime(texts.footer), versions().front().second, shown_digits);
  return html + "</footer>\n</body>\n</html>\n";
}

std::string report_json(const LaboratoryReport &r, unsigned digits) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-report-1").key("title").string(r.title);
  json.key("fields").begin_array();
  for (const auto &[name, value] : r.fields)
    json.begin_object().key("name").string(name).key("value").string(value).end_object();
  json.end_array().key("descriptions").begin_array();
  for (const ReportedSample &s : r.samples)
    json.raw(description_json(s.description, digits));
  json.end_array().key("judgement");
  if (r.conformity)
    json.raw(conformity_json(*r.conformity, digits));
  else
    json.null();
  return json.key("versions").raw(versions_json()).end_object().take();
}

} // namespace mdm

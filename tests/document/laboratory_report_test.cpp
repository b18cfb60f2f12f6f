// The laboratory's report as HTML and JSON.

#include "catch.hpp"
#include "count.hpp"
#include "document/html.hpp"
#include "document/laboratory_report.hpp"

#include <algorithm>

namespace laboratory_report_test {

using namespace mdm;
using mdm_test::count;

namespace {

ReportedSample sample(const std::string &name, const std::string &csv) {
  UnderstoodGradation sheet = understand_gradation(csv, name);
  SoilDescription description = describe(sheet.gradation, {});
  return {std::move(sheet), std::move(description)};
}

LaboratoryReport two_sands() {
  LaboratoryReport r{"Quay <1>", {{"Client", "A & B"}, {"Sampled", "2026-05-04"}}, {}, std::nullopt};
  r.samples.push_back(sample("a.csv", "size_mm,passing_percent\n4.75,100\n2.36,80\n0.3,20\n0.075,3\n"));
  r.samples.push_back(sample("b.csv", "size_mm,mass\n0.075,1\n0.15,5.25\n0.3,3.75\n0.6,0\n"));
  return r;
}

bool has(const std::string &text, const std::string &part) {
  return count(text, part) > 0;
}

} // namespace

TEST_CASE("text of any kind is safe in HTML", "[document]") {
  CHECK(html_text("a <b> & \"c\"") == "a &lt;b&gt; &amp; &quot;c&quot;");
  CHECK(html_text("a\nb") == "a\\x0ab");
}

TEST_CASE("a table with more columns than a page has room for is several", "[document]") {
  std::vector<std::string> titles = {"sieve"}, cells = {"1"};
  for (int i = 0; i < 13; ++i) {
    titles.push_back("sample " + std::to_string(i));
    cells.push_back("percent " + std::to_string(i));
  }
  HtmlTable table("passing", titles);
  table.add(cells);
  const std::string html = table.html();
  CHECK(count(html, "<table>") == 3);
  CHECK(count(html, "<th scope=\"row\">1</th>") == 3);
  for (std::size_t i = 1; i < titles.size(); ++i) {
    CHECK(count(html, ">" + titles[i] + "<") == 1);
    CHECK(count(html, ">" + cells[i] + "<") == 1);
  }
}

TEST_CASE("the page has head, curves, analyses, index numbers and notes", "[document]") {
  const std::string html = report_html(two_sands());
  CHECK(html.starts_with("<!DOCTYPE html>"));
  for (const char *part :
       {"<h1>Quay &lt;1&gt;</h1>", "<th scope=\"row\">Client</th><td>A &amp; B</td>", "<td>2026-05-04</td>",
        "<svg", "<caption>a</caption>",
        "<th scope=\"row\">0.075 (No. 200)</th><td>1</td><td>10</td><td>0</td>",
        "<td>5.25</td><td>52.5</td><td>10</td>", "<th scope=\"row\">2.36 (No. 8)</th><td>20</td><td>80</td>",
        "<th scope=\"row\">AASHTO M 145</th>", "<th scope=\"row\">C_u</th>", "<li>a: ", "<li>b: "})
    CHECK(has(html, part));
  CHECK(count(html, "<table") == count(html, "</table>"));
  CHECK_FALSE(has(html, "http://localhost"));
  CHECK_FALSE(has(html, "<?xml"));
  CHECK_FALSE(has(html, "Specification"));
}

TEST_CASE("a German report has German notes, and says which are English", "[document]") {
  LaboratoryReport r = two_sands();
  r.language = Language::german;
  r.samples[0].description.notes.emplace_back("a remark <in> English");
  const std::string html = report_html(r);
  for (const char *part : {"<html lang=\"de\">", "<h2>Hinweise</h2>\n<ul>\n",
                           "<li>a: Eine Schale der Größe 0 wurde ergänzt für die 3 Prozent, die durch das "
                           "feinste Sieb gehen, 0.075 mm.</li>",
                           "<li lang=\"en\">a: a remark &lt;in&gt; English</li>"})
    CHECK(has(html, part));
  CHECK(count(html, "lang=\"en\"") == 1);
  CHECK_FALSE(has(report_html(two_sands()), "<li lang"));
}

TEST_CASE("nothing of the page is fetched", "[document]") {
  const std::string html = report_html(two_sands());
  for (const char *part : {"src=", "<link", "@import", "<script"})
    CHECK_FALSE(has(html, part));
  CHECK(count(html, "url(") == count(html, "url(#")); // a clip of the picture, which is in it
}

TEST_CASE("the page has the verdicts on a specification", "[document]") {
  LaboratoryReport r = two_sands();
  r.conformity = ConformityReport{*shipped_specification("astm-c33-fine"), {}};
  for (const ReportedSample &s : r.samples)
    r.conformity->samples.push_back(judge(s.sheet, r.conformity->specification));
  const std::string html = report_html(r);
  CHECK(has(html, "Specification astm-c33-fine"));
  CHECK(has(html, "<p class=\"verdict\">a: fail</p>"));
  CHECK(has(html, "a limit is missed"));
  CHECK_FALSE(has(html, "<tr class=\"fail\">")); // a line is of both
  r.samples.pop_back();
  r.conformity->samples.pop_back();
  CHECK(has(report_html(r), "<tr class=\"fail\">"));
  CHECK(has(html, "* interpolated"));
}

TEST_CASE("the report as JSON holds those of describe and judge", "[document]") {
  const std::string json = report_json(two_sands(), 6);
  CHECK(has(json, R"("fields":[{"name":"Client","value":"A & B"})"));
  CHECK(count(json, "\"schema\":\"mdm-describe-1\"") == 2);
  CHECK(has(json, "\"judgement\":null"));
}

} // namespace laboratory_report_test

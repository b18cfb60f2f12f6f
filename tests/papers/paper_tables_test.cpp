#include "catch.hpp"
#include "files.hpp"
#include "papers/paper_figures.hpp"
#include "papers/paper_tables.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <map>
#include <sstream>

namespace paper_tables_test {

using namespace mdm;

namespace {

/// The suite's rows, made once.
const std::vector<SurveyRow> &suite() {
  static const std::vector<SurveyRow> rows = [] {
    std::vector<SurveyRow> all;
    std::istringstream lines(mdm_test::read_file(MDM_SUITE));
    for (std::string line; std::getline(lines, line);)
      all.push_back(survey(read_json_gradation(line, "suite", "")));
    return all;
  }();
  return rows;
}

std::vector<std::string> split(const std::string &text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);)
    parts.push_back(part);
  return parts;
}

/// parameter -> least, greatest.
std::map<std::string, std::pair<double, double>> table1() {
  std::map<std::string, std::pair<double, double>> values;
  for (const std::string &line : split(table1_csv(suite()), '\n')) {
    const std::vector<std::string> cells = split(line, ',');
    if (cells[0] != "parameter")
      values[cells[0]] = {std::stod(cells[2]), std::stod(cells[3])};
  }
  return values;
}

Gradation sand() {
  const std::string path = MDM_SOURCE_DIR "/examples/gradations/athabasca-sand.csv";
  return read_gradation(mdm_test::read_file(path), path);
}

} // namespace

TEST_CASE("Table 1 of the suite is the paper's") {
  const auto values = table1();
  const auto is = [&](const char *parameter, double least, double greatest) {
    CHECK(values.at(parameter).first == Approx(least).epsilon(1e-3));
    CHECK(values.at(parameter).second == Approx(greatest).epsilon(1e-3));
  };
  is("gradations", 2750, 2750);
  is("sieves", 5, 14);
  is("x_2", 0.075, 25);
  is("C_u", 1.168, 214.5);
  is("C_c", 0.1999, 25.47);
  is("I_GS", 0.0349, 0.600);
  is("I_C", 0.2927, 1.574);
  is("finest_class", 0.4316, 34.41);
}

TEST_CASE("the published counts of the suite are known, and never below the exact ones") {
  int minimal = 0, minimal_printed = 0;
  for (const SurveyRow &row : suite()) {
    const SurveyCounts &n = row.counts;
    REQUIRE(n.spanned_integer);
    REQUIRE(n.spanned_integer_printed);
    CHECK(*n.spanned_integer >= n.exact);
    CHECK(*n.spanned_integer_printed >= n.exact);
    minimal += *n.spanned_integer == n.exact ? 1 : 0;
    minimal_printed += *n.spanned_integer_printed == n.exact ? 1 : 0;
  }
  CHECK(minimal == 23);
  CHECK(minimal_printed == 852);
}

TEST_CASE("every figure's table has a row a gradation and as many cells as its header") {
  for (const std::string &text : {figure3_csv(suite()), figure4_csv(suite()), figure5_csv(suite())}) {
    const std::vector<std::string> lines = split(text, '\n');
    CHECK(lines.size() == 2751);
    const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
    CHECK(std::all_of(lines.begin(), lines.end(), [commas](const std::string &line) {
      return std::count(line.begin(), line.end(), ',') == commas && line.find(",,") == std::string::npos;
    }));
  }
  const std::vector<std::string> curves = split(figure1_csv(suite()), '\n');
  std::map<std::string, int> ids;
  for (std::size_t i = 1; i < curves.size(); ++i)
    ++ids[split(curves[i], ',')[0]];
  CHECK(ids.size() == 275);
  const std::optional<std::size_t> example = figure1_example(suite());
  REQUIRE(example);
  CHECK(rounded(*suite()[*example].i_c, 3) == "1.09");
}

TEST_CASE("Figure 2 has every iteration of both algorithms") {
  const Convergence c = convergence(sand());
  const std::vector<std::string> lines = split(figure2_csv({c}), '\n');
  REQUIRE(lines.size() == 1 + c.spanned_integer.tries.size() + c.fixed_size.tries.size());
  CHECK(lines[1] == "athabasca-sand,spanned-integer,1,10350,0");
  CHECK(lines[2].rfind("athabasca-sand,fixed-size,1,21612,0.0801", 0) == 0);
}

TEST_CASE("a gradation without an index leaves its cell empty, and ids are quoted where they must be") {
  Gradation::Data data;
  data.id = "a,\"b\"";
  data.sizes = {0, 1, 2};
  data.masses = {1, 1, 0};
  const std::vector<SurveyRow> rows = {survey(Gradation(data))};
  CHECK(split(figure5_csv(rows), '\n')[1].rfind("\"a,\"\"b\"\"\",,", 0) == 0);
  CHECK(table1_csv(rows).find("I_GS,,,,,\n") != std::string::npos);
  for (const Figure &figure :
       {paper_figure1(rows), paper_figure3(rows), paper_figure4(rows), paper_figure5(rows)})
    for (const Panel &panel : figure.panels)
      CHECK(panel.x.span() > 0);
}

TEST_CASE("figures show every gradation that has the values") {
  const Figure third = paper_figure3(suite());
  REQUIRE(third.panels.size() == 2);
  for (const Panel &panel : third.panels)
    CHECK(panel.series[0].points.size() == 2750);
  CHECK(paper_figure4(suite()).panels[0].series[0].points.size() == 2750);
  std::size_t points = 0;
  for (const Panel &panel : paper_figure5(suite()).panels)
    points += panel.series[1].points.size();
  CHECK(points == 2750);
  const Figure second = paper_figure2({convergence(sand())});
  // No error at all lies behind the line below the logarithmic axis.
  const Panel &errors = second.panels[0];
  CHECK(errors.y.ticks[0].label == "0");
  CHECK(errors.y.ticks[0].at < errors.back.at(0).y_high);
  CHECK(errors.back[0].y_high < errors.y.ticks[1].at);
  for (const Series &series : second.panels[0].series)
    for (const Point &p : series.points)
      CHECK_FALSE(p.y < second.panels[0].y.low);
}

} // namespace paper_tables_test

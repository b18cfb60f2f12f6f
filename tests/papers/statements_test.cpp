// The statements of both papers: their numbers a second way, and their verdicts of suites that were made for
// them.

#include "catch.hpp"
#include "files.hpp"
#include "papers/fitted_line.hpp"
#include "papers/model_statements.hpp"
#include "papers/paper_statements.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace statements_test {

using namespace mdm;

namespace {

struct SurveyedSuite {
  std::vector<SurveyRow> rows;
  std::vector<Convergence> runs;
};

/// The paper's suite, surveyed once.
const SurveyedSuite &paper_suite() {
  static const SurveyedSuite suite = [] {
    SurveyedSuite s;
    std::istringstream lines(mdm_test::read_file(MDM_SUITE));
    for (std::string line; std::getline(lines, line);) {
      const Gradation g = read_json_gradation(line, "suite", "");
      if (s.rows.size() % 10 == 0)
        s.runs.push_back(convergence(g));
      s.rows.push_back(survey(g));
    }
    return s;
  }();
  return suite;
}

const std::vector<Statement> &suite_statements() {
  static const std::vector<Statement> all = paper_statements(paper_suite().rows, paper_suite().runs);
  return all;
}

const Statement &with(const std::vector<Statement> &all, const std::string &part) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Statement &s) {
    return s.statement.find(part) != std::string::npos;
  });
  INFO(part);
  REQUIRE(at != all.end());
  return *at;
}

void check(const std::vector<Statement> &all, const std::string &part, Holds holds,
           const std::string &found = "") {
  const Statement &s = with(all, part);
  INFO(s.statement << ": " << s.found);
  CHECK(std::string(name(s.holds)) == name(holds));
  CHECK(s.found.find(found) != std::string::npos);
  CHECK_FALSE(s.command.empty());
}

double log10_n(const SurveyRow &row) {
  return std::log10(row.counts.exact.convert_to<double>());
}

double as_double(const Real &y) {
  return enclose(y, 15).lower().convert_to<double>();
}

/// Slope and r in doubles, by deviations from the means.
std::pair<double, double> line_in_doubles(const std::vector<std::pair<double, double>> &points) {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const auto &[px, py] : points) {
    x += px / static_cast<double>(points.size());
    y += py / static_cast<double>(points.size());
  }
  for (const auto &[px, py] : points) {
    xx += (px - x) * (px - x);
    xy += (px - x) * (py - y);
    yy += (py - y) * (py - y);
  }
  return {xy / xx, xy / std::sqrt(xx * yy)};
}

} // namespace

TEST_CASE("a line of least squares is enclosed, and needs different points", "[statements]") {
  const auto balls = [](const std::vector<int> &values) {
    std::vector<Ball> all;
    for (const int v : values)
      all.emplace_back(v, 128);
    return all;
  };
  // y = 1, 2, 2, 5 over x = 0, 1, 2, 3: slope 6/5, r = 6 / sqrt(5 * 9).
  const auto line = fitted_line(balls({0, 1, 2, 3}), balls({1, 2, 2, 5}));
  REQUIRE(line);
  CHECK(line->slope.lo <= ratio(6, 5));
  CHECK(line->slope.hi >= ratio(6, 5));
  CHECK(line->correlation.lo.convert_to<double>() == Approx(6 / std::sqrt(45.0)));
  CHECK_FALSE(fitted_line(balls({1, 1, 1}), balls({1, 2, 3})));
  CHECK_FALSE(fitted_line(balls({1, 2, 3}), balls({4, 4, 4})));
  CHECK_FALSE(fitted_line(balls({1, 2}), balls({1, 2})));
}

TEST_CASE("Arnold's statements on Table 1 are beside what the suite has", "[statements]") {
  const std::vector<Statement> &all = suite_statements();
  check(all, "2750 gradations", Holds::yes);
  check(all, "sieves in G", Holds::yes, "5 to 14");
  check(all, "x_min+1", Holds::yes);
  check(all, "x_max in mm from 9.5 to 75", Holds::no, "0.6 to 63");
  check(all, "C_c from", Holds::yes);
  check(all, "C_u from", Holds::yes);
  check(all, "I_GS from", Holds::yes);
  check(all, "I_C from", Holds::yes);
  check(all, "Percent fines", Holds::partly, "34.41 % lie in the finest class");
  check(all, "trapezoid", Holds::no, "0.293 to 1.57");
  check(all, "14 opening sizes", Holds::no, "13 sieves from 0.075 to 63 mm");
  check(all, "consecutive", Holds::yes);
  check(all, "I_C = 1.09", Holds::yes, "g1990");
}

TEST_CASE("Arnold's statements on the algorithms are beside exact counts", "[statements]") {
  const std::vector<Statement> &all = suite_statements();
  check(all, "over 98 %", Holds::yes, "98.55 % of the subset");
  check(all, "one or two iterations", Holds::partly, "2 tries at most in the subset and 4 in all");
  check(all, "FS takes 1 to 15", Holds::yes, "up to 15 in the subset");
  check(all, "factor of N(0)", Holds::partly);
  check(all, "satisfies Cond4", Holds::yes, "2750 of 2750");
  check(all, "smallest possible quantity", Holds::partly, "smallest for 23 of 2750");
  // By hand: a coarsest class of one particle above 1/4 mm needs 1, 1, 17 and 513; 32^0 + 32 + 32^2 + 32^3 =
  // 33825.
  check(all, "self-similar fractals", Holds::yes,
        "33825 with sizes at the upper sieves, 138547.2 in the middle, 2164800 at");
  check(all, "self-similar fractals", Holds::yes, "smallest match has 532");
}

TEST_CASE("relations of N are those that doubles find", "[statements]") {
  const std::vector<Statement> &all = suite_statements();
  const auto told = [](double y) {
    std::ostringstream text;
    text.precision(3);
    text << y;
    return text.str();
  };
  std::vector<std::pair<double, double>> phi, index, zeta, gs;
  for (const SurveyRow &row : paper_suite().rows) {
    const double x = std::log10(row.zeta_1.convert_to<double>()), y = log10_n(row);
    zeta.emplace_back(x, y);
    gs.emplace_back(as_double(*row.i_gs), y);
    if (row.phi_1 > ratio(35, 100) && row.phi_1 < ratio(45, 100))
      phi.emplace_back(x, y);
    if (as_double(*row.i_c) > 0.65 && as_double(*row.i_c) < 0.75)
      index.emplace_back(x, y);
  }
  check(all, "phi_1 near 0.4", Holds::yes, "slope " + told(line_in_doubles(phi).first));
  check(all, "phi_1 near 0.4", Holds::yes, "242 gradations");
  check(all, "I_C near 0.7", Holds::yes, "slope " + told(line_in_doubles(index).first));
  check(all, "I_GS does not", Holds::yes, "r with log N is " + told(line_in_doubles(gs).second));
  check(all, "do not characterize", Holds::yes, told(line_in_doubles(zeta).second) + " for log zeta_1");
  check(all, "from O(10^1) to O(10^10)", Holds::yes, "4 to 8761036315");
  check(all, "larger mass of the smallest", Holds::yes, "for 41");
  check(all, "scattered about a line", Holds::yes);
  check(all, "a larger I_C", Holds::yes, "for 41");
  check(all, "C_c does not", Holds::yes);
  check(all, "C_u does not", Holds::no);
}

TEST_CASE("groups of soils are beside their numbers of particles", "[statements]") {
  const std::vector<Statement> &all = suite_statements();
  check(all, "All but the broadest", Holds::yes, "11 of 15 groups");
  check(all, "numerous instances", Holds::partly);
  check(all, "Well-graded gravel", Holds::yes, "median 984");
  check(all, "Gravel with silt and sand", Holds::yes, "704939");
  check(all, "Sand with silt and gravel", Holds::yes);
  check(all, "Well-graded sand has", Holds::yes);
  check(all, "Silty sand", Holds::yes);
  check(all, "feasible", Holds::open);
}

TEST_CASE("of a few gradations most statements cannot be decided, and some are false", "[statements]") {
  const std::vector<SurveyRow> few(paper_suite().rows.begin(), paper_suite().rows.begin() + 2);
  const std::vector<Statement> all = paper_statements(few, {paper_suite().runs.front()});
  CHECK(all.size() == suite_statements().size());
  check(all, "2750 gradations", Holds::no, "2");
  check(all, "phi_1 near 0.4", Holds::open);
  check(all, "I_GS does not", Holds::open);
  check(all, "Well-graded gravel", Holds::open);
  check(all, "from O(10^1) to O(10^10)", Holds::partly);
}

TEST_CASE("a table of statements has five columns", "[statements]") {
  const std::string table = statements_table({{"a, b", "here", "1", Holds::partly, "mdm solve FILE"}});
  CHECK(table == "statement,where,found,holds,command\n\"a, b\",here,1,holds in part,mdm solve FILE\n");
}

TEST_CASE("the words for shapes are true of densities, few of grading curves", "[statements]") {
  const std::vector<Statement> all = shape_statements();
  REQUIRE(all.size() == 15);
  check(all, "U-shaped for", Holds::partly, "grading curve h for none");
  check(all, "strictly decreasing for", Holds::partly, "grading curve h for none");
  check(all, "strictly increasing for", Holds::yes);
  check(all, "strictly convex for a = 1, b > 2", Holds::partly,
        "volume density h' for (1, 3), (1, 4), of the grading curve h for none");
  check(all, "strictly convex for a > 2, b = 1", Holds::yes);
  check(all, "a straight line for a = 1, b = 2", Holds::partly);
  check(all, "strictly concave for a = 1, 1 < b < 2", Holds::yes);
  check(all, "strictly concave for 1 < a < 2", Holds::partly);
  check(all, "unimodal", Holds::partly, "volume density h' for (3, 3), (2, 4), (4, 2)");
  check(all, "symmetric", Holds::partly);
  check(all, "strictly convex for a = 1, b > 1", Holds::partly,
        "volume density h' for (1, 3), of the grading curve h for none");
  check(all, "strictly concave for a > 1, b = 1", Holds::partly,
        "volume density h' for (1.5, 1), of the grading curve h for none");
  check(all, "double curved", Holds::partly, "of the grading curve h for (3, 3), (2, 4), (4, 2)");
}

TEST_CASE("the statements on the model have their numbers", "[statements]") {
  ModelStudy study;
  study.coefficients = figure4_rows();
  SetQuestion q;
  for (const Classing classing : {Classing::geometric, Classing::regular})
    for (const Shape &shape : compared_shapes())
      for (const unsigned classes : {1U, 10U, 30U}) {
        q.shape = shape;
        q.classing = classing;
        q.classes = classes;
        study.classes.push_back(set_row(q, 0));
      }
  for (const ShapeQuestion &one : figure8_maps())
    if (one.classing == Classing::regular && one.span == ratio(97, 100))
      study.maps.push_back(shape_row(one));
  const std::vector<Statement> all = model_statements(study);
  check(all, "monotonic function of s", Holds::yes, "for 6 of 6 shapes");
  check(all, "determine the shape", Holds::partly,
        "(0.7038, 0.8227) at s = 0.9; (0.8625, 1.613) at s = 0.95");
  check(all, "R = 100", Holds::partly, "= 99;");
  // (49/50)^2 / (98/99)^2 and (49^2/50^3) / (98^2/99^3).
  check(all, "uniform by particle sizes", Holds::partly, "0.9801 times");
  check(all, "uniform by particle sizes", Holds::partly, "1.941 times");
  check(all, "precisely at s = 0.41", Holds::yes, "0.414214");
  // Descartes: 2 + r + 2 sqrt(1 + 2 r) for r = 1 + sqrt 2 and 3 + 2 sqrt 3.
  check(all, "square lattice takes", Holds::partly, "R = 9.2426");
  check(all, "triangular lattice takes", Holds::partly, "R = 15.928");
  check(all, "fill the space", Holds::yes);
  check(all, "power law and the structure", Holds::yes, "1.30");
  check(all, "two sizes as a and b", Holds::yes);
  check(all, "Ten size classes", Holds::open); // nothing was drawn
  check(all, "For few classes N_min", Holds::partly, "(1, 3) geometric: 2000, 33927 and 806699");
  check(all, "at least N_pc particles", Holds::yes, "18 of 18");
  check(all, "lower bound of N", Holds::partly);
  check(all, "larger than a = b = 10", Holds::yes, "regular: 7.5;");
  check(all, "for a < b", Holds::yes);
  check(all, "(3, 1) and (1, 1)", Holds::yes);
}

} // namespace statements_test

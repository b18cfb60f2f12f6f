// The figures of Voivret, Delenne and Radjai: their numbers computed a second way.

#include "catch.hpp"
#include "papers/size_model_figures.hpp"
#include "papers/size_model_tables.hpp"

#include <algorithm>
#include <cmath>

namespace size_models_test {

using namespace mdm;

namespace {

/// h for integer a and b: the chance of a successes or more in a + b - 1 trials.
Rational passing(const Shape &shape, const Rational &x) {
  const auto a = static_cast<unsigned>(floor(shape.a)), n = a + static_cast<unsigned>(floor(shape.b)) - 1;
  Rational sum = 0;
  for (unsigned j = a; j <= n; ++j) {
    Integer ways = 1;
    for (unsigned i = 0; i < j; ++i)
      ways = ways * (n - i) / (i + 1);
    sum += Rational(ways) * power(x, j) * power(Rational(1 - x), n - j);
  }
  return sum;
}

/// Bounds of the classes; the geometric ones to 120 digits.
std::vector<Rational> bounds(const Rational &largest, Classing classing, unsigned n) {
  const Integer unit = power_of_ten(120);
  const Rational factor = ratio(floor_root(numerator(Rational(largest * Rational(power(unit, n)))) /
                                               denominator(Rational(largest * Rational(power(unit, n)))),
                                           n),
                                unit);
  std::vector<Rational> all = {1};
  for (unsigned i = 1; i < n; ++i)
    all.push_back(classing == Classing::regular
                      ? Rational(1 + (largest - 1) * ratio(i, n))
                      : ratio(floor(Rational(all.back() * factor * Rational(unit))), unit));
  all.push_back(largest);
  return all;
}

struct Counts {
  std::vector<Integer> estimate, numbers;
};

Integer total(const std::vector<Integer> &n) {
  Integer sum = 0;
  for (const Integer &one : n)
    sum += one;
  return sum;
}

/// Eq. 6-9 for discs in plain fractions. What is rounded in them is certain to be far from integers.
Counts counts(const Shape &shape, const Rational &span, Classing classing, unsigned classes,
              const Integer &n_pc, const Integer &n_min) {
  const Rational largest = (1 + span) / (1 - span);
  const std::vector<Rational> d = bounds(largest, classing, classes);
  std::vector<Rational> n;
  for (std::size_t i = 0; i < classes; ++i) {
    const Rational f = passing(shape, Rational((d[i + 1] - 1) / (largest - 1))) -
                       passing(shape, Rational((d[i] - 1) / (largest - 1)));
    const Rational median = 2 * d[i] * d[i + 1] / (d[i] + d[i + 1]);
    n.push_back(f / (median * median));
  }
  const Rational least = *std::min_element(n.begin(), n.end());
  static const Rational tiny = ratio(1, power_of_ten(40));
  Counts result;
  for (const Rational &one : n) {
    const Rational exact = Rational(n_pc) * one / least;
    const Integer floored = floor(exact);
    if (classing == Classing::geometric && one != least) {
      REQUIRE(exact - Rational(floored) > tiny);
      REQUIRE(Rational(floored + 1) - exact > tiny);
    }
    result.estimate.push_back(floored);
  }
  const Integer sum = total(result.estimate);
  for (const Integer &one : result.estimate)
    result.numbers.push_back(sum < n_min ? Integer(n_min * one / sum) : one);
  return result;
}

double to_double(const Real &y) {
  return enclose(y, 15).lower().convert_to<double>();
}

std::ptrdiff_t count(const std::string &text, char c) {
  return std::count(text.begin(), text.end(), c);
}

} // namespace

TEST_CASE("the counts of Figures 5 to 7 are those of a second computation") {
  for (const auto &questions : {figure5_questions(), figure6_questions(), figure7_questions()})
    for (const SetQuestion &q : questions) {
      if (q.classes > 12 && q.classes % 6 != 0)
        continue;
      const SetRow row = set_row(q, 0);
      const Counts second =
          counts(q.shape, ratio(49, 50), q.classing, q.classes, q.wanted.min_per_class, q.wanted.at_least);
      REQUIRE(row.counts.decided());
      CHECK(row.counts.numbers == second.numbers);
      CHECK(row.counts.estimated().lo == total(second.estimate));
      CHECK(row.c_r.empty());
    }
}

TEST_CASE("with the default criteria the paper's three shapes need these numbers") {
  std::vector<Integer> n;
  for (const Shape &shape : compared_shapes()) {
    SetQuestion question;
    question.shape = shape;
    n.push_back(set_row(question, 0).counts.particles());
  }
  CHECK(n == std::vector<Integer>{33927, 6801, 23090});
}

TEST_CASE("the particles of Figure 8 are those of a second computation") {
  for (const Classing classing : {Classing::regular, Classing::geometric})
    for (const Rational &span : {ratio(1, 10), ratio(1, 2), ratio(97, 100)})
      for (unsigned a = 1; a <= 10; a += 2)
        for (unsigned b = 1; b <= 12; b += 3) {
          const ShapeRow row = shape_row({classing, span, {a, b}});
          const Counts second = counts({a, b}, span, classing, 10, 10, 2000);
          CHECK(row.particles == std::max(total(second.estimate), Integer(2000)));
        }
}

TEST_CASE("C_u and C_c of Figure 4 are those of closed forms") {
  for (const CoefficientRow &row : figure4_rows()) {
    const double a = row.shape.a.convert_to<double>(), b = row.shape.b.convert_to<double>();
    if (a > 1 && b > 1)
      continue;
    const double s = row.span.convert_to<double>(), width = 2 * s / (1 - s);
    const auto size = [&](double p) {
      return 1 + width * (a > 1 ? std::pow(p, 1 / a) : 1 - std::pow(1 - p, 1 / b));
    };
    CHECK(to_double(row.c_u) == Approx(size(.6) / size(.1)).epsilon(1e-12));
    CHECK(to_double(row.c_c) == Approx(size(.3) * size(.3) / size(.6) / size(.1)).epsilon(1e-12));
  }
}

TEST_CASE("C_u grows with the span, as the paper remarks") {
  const std::vector<CoefficientRow> rows = figure4_rows();
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i].span > rows[i - 1].span)
      CHECK(compare(rows[i - 1].c_u, rows[i].c_u) == Order::less);
}

TEST_CASE("C_r gets better with more classes, and large sets go without") {
  SetQuestion question;
  question.shape = {3, 1};
  question.classing = Classing::regular;
  question.classes = 2;
  const SetRow two = set_row(question, 2000);
  question.classes = 20;
  const SetRow twenty = set_row(question, 2000);
  REQUIRE(two.c_r.size() == 10);
  REQUIRE(twenty.c_r.size() == 10);
  CHECK(two.least().lo > 10 * twenty.greatest().hi);
  CHECK(set_row(question, 1000).c_r.empty());
}

TEST_CASE("C_r of a set is the mean of ten draws that differ") {
  const SetRow row = set_row({{3, 1}, Classing::regular, 5, {10, 500, 2}}, 2000);
  REQUIRE(row.c_r.size() == 10);
  Rational sum = 0, least = row.c_r[0].lo, greatest = row.c_r[0].lo;
  for (const Interval &one : row.c_r) {
    sum += one.lo;
    least = std::min(least, one.lo);
    greatest = std::max(greatest, one.lo);
  }
  CHECK(row.mean().lo == sum / 10);
  CHECK(row.least().lo == least);
  CHECK(row.greatest().lo == greatest);
  CHECK(row.least().hi < row.greatest().lo);
}

TEST_CASE("the four functions of Figure 1 belong together") {
  const std::vector<DistributionRow> rows = figure1_rows();
  REQUIRE(rows.size() == 100);
  const double width = 0.00009;
  const Shape shape{3, 3};
  double F = 0, moment = 0;
  for (const DistributionRow &r : rows) {
    const double d = r.size.convert_to<double>(), f = to_double(r.number_density);
    CHECK(to_double(r.partition) == Approx(F + f * width / 2).margin(5e-4)); // the middle of a class
    F += f * width;
    moment += d * d * f * width;
  }
  CHECK(F == Approx(1).margin(2e-3));
  for (const DistributionRow &r : rows) {
    const double d = r.size.convert_to<double>();
    CHECK(to_double(r.volume_density) ==
          Approx(d * d * to_double(r.number_density) / moment).epsilon(2e-3)); // Eq. 5
    const Rational reduced = (r.size - ratio(1, 1000)) / ratio(9, 1000);
    const double h = passing(shape, reduced).convert_to<double>();
    CHECK(to_double(r.grading) == Approx(h).margin(1e-4));
  }
}

TEST_CASE("curves of Figure 3 have points wherever they are steep") {
  const std::vector<PassingRow> rows = figure3_rows();
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i].reduced > rows[i - 1].reduced && rows[i - 1].reduced > 0 && rows[i].reduced < 1)
      CHECK(to_double(rows[i].passing) - to_double(rows[i - 1].passing) < 0.06);
}

TEST_CASE("curves of Figure 3 begin at 0, end at 1 and do not fall") {
  const std::vector<PassingRow> rows = figure3_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].reduced == 0)
      CHECK(rows[i].passing.fraction() == Rational(0));
    else
      CHECK(compare(rows[i - 1].passing, rows[i].passing) == Order::less);
    if (rows[i].reduced == 1)
      CHECK(rows[i].passing.fraction() == Rational(1));
  }
}

TEST_CASE("the maps have the paper's spans and both classings") {
  const std::vector<ShapeQuestion> maps = figure8_maps();
  CHECK(maps.size() == 4 * 24 * 24);
  CHECK(std::count_if(maps.begin(), maps.end(), [](const ShapeQuestion &q) {
          return q.classing == Classing::regular && q.span == ratio(97, 100);
        }) == 24 * 24);
}

TEST_CASE("tables have a row a point and as many cells as their header") {
  const SetRow set = set_row(figure7_questions().front(), 0);
  const ShapeRow shape = shape_row({Classing::regular, ratio(1, 10), {1, 1}});
  for (const std::string &text :
       {table_csv(std::vector<DistributionRow>{figure1_rows()[7]}),
        table_csv(std::vector<PassingRow>{figure3_rows()[7]}),
        table_csv(std::vector<CoefficientRow>{figure4_rows()[7]}), table_csv(std::vector<SetRow>{set}),
        table_csv(std::vector<ShapeRow>{shape})}) {
    const std::string header = text.substr(0, text.find('\n'));
    CHECK(count(text, '\n') == 2);
    CHECK(count(text, ',') == 2 * count(header, ','));
  }
  CHECK(table_csv(std::vector<SetRow>{set}).find("\n1,3,geometric,10,10,100,33927,33927,0,,,\n") !=
        std::string::npos);
}

TEST_CASE("figures of the size models have axes, and lines for every shape") {
  std::vector<SetRow> sets;
  for (const SetQuestion &q : figure7_questions())
    if (q.wanted.at_least <= 1000)
      sets.push_back(set_row(q, 1000));
  std::vector<ShapeRow> maps, spans;
  for (const ShapeQuestion &q : figure8_maps())
    if (denominator(q.shape.a) == 1 && denominator(q.shape.b) == 1)
      maps.push_back(shape_row(q));
  for (const ShapeQuestion &q : figure8_spans())
    if (q.shape.a == 1)
      spans.push_back(shape_row(q));
  const std::vector<Figure> figures = {distribution_figure(figure1_rows()), passing_figure(figure3_rows()),
                                       coefficient_figure(figure4_rows()),
                                       set_figure(sets, Criterion::at_least), accessible_figure(maps, spans)};
  const std::vector<std::size_t> panels = {2, 1, 2, 2, 6};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    REQUIRE(figures[i].panels.size() == panels[i]);
    for (const Panel &panel : figures[i].panels) {
      CHECK(panel.x.span() > 0);
      CHECK(panel.y.span() > 0);
      CHECK_FALSE(panel.series.empty());
      for (const Series &series : panel.series)
        for (const Point &p : series.points) {
          if (std::isnan(p.x)) // between bars
            continue;
          CHECK(panel.x.low <= p.x);
          CHECK(p.x <= panel.x.high);
          CHECK(panel.y.low <= p.y);
          CHECK(p.y <= panel.y.high);
        }
    }
  }
  CHECK(figures[1].panels[0].series.size() == 7);
  CHECK(figures[2].panels[0].series.size() == 6);
  CHECK(figures[3].panels[0].series.size() == 12); // and bars
  CHECK(figures[3].panels[1].series.size() == 6);
}

} // namespace size_models_test

// The figure of a triaxial test: what stands where.

#include "catch.hpp"
#include "plot/picture.hpp"
#include "plot/triaxial_figure.hpp"

namespace triaxial_figure_test {

using namespace mdm;

namespace {

const TriaxialLog three_states = {"p",
                                  {{0, 0, 100000, -500, ratio(1, 2), 4, 0},
                                   {ratio(1, 10), ratio(1, 100), 140000, 120000, ratio(1, 2), 4, 0},
                                   {ratio(1, 5), ratio(-3, 100), 135000, 105000, ratio(1, 2), 4, 0}}};

} // namespace

TEST_CASE("a triaxial test has q in kPa and the volumetric strain over the axial strain in percent") {
  const Figure figure = triaxial_figure("sand", three_states, {});
  REQUIRE(figure.panels.size() == 2);
  CHECK(figure.title == "sand");
  CHECK(figure.notes == std::vector<std::string>{"constant: p"});
  const Panel &q = figure.panels[0], &volume = figure.panels[1];
  CHECK(q.x.title == "axial strain (percent)");
  CHECK(q.y.title == "q (kPa)");
  REQUIRE(q.series.at(0).points.size() == 3);
  CHECK(q.series[0].points[1].x == Approx(10));
  CHECK(q.series[0].points[1].y == Approx(120));
  CHECK(volume.series.at(0).points[2].x == Approx(20));
  CHECK(volume.series[0].points[2].y == Approx(-3));
  for (const Panel &panel : figure.panels)
    for (const Point &p : panel.series[0].points) {
      CHECK(p.x >= panel.x.low);
      CHECK(p.x <= panel.x.high);
      CHECK(p.y >= panel.y.low);
      CHECK(p.y <= panel.y.high);
    }
}

TEST_CASE(
    "a narrow picture of a triaxial test has its panels one below the other, in the language asked for") {
  FigureForm form;
  form.width = 500;
  form.language = Language::german;
  const Figure figure = triaxial_figure("sand", three_states, form);
  CHECK(figure.columns == 1);
  CHECK(triaxial_figure("sand", three_states, {}).columns == 2);
  CHECK(figure.notes == std::vector<std::string>{"konstant: p"});
  CHECK(figure.panels[0].title == "Deviatorspannung");
  CHECK(figure.panels[1].x.title == "axiale Dehnung (Prozent)");
}

} // namespace triaxial_figure_test

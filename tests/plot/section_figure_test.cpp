// Sections through spheres: circles of the cut, their classes and the scale.

#include "catch.hpp"
#include "plot/section_figure.hpp"

#include <cmath>
#include <set>

namespace section_figure_test {

using namespace mdm;

namespace {

Gradation three_classes() {
  Gradation::Data d;
  d.sizes = {1, 2, 3, 4};
  d.masses = {1, 1, 1, 0};
  return Gradation(std::move(d));
}

/// The places go from y = 0 to y = 10: the plane is y = 5.
SphereSample sample() {
  SphereSample s;
  s.add({"1", "0", "1"}, 1, 2, 0);
  s.add({"1", "5", "1.5"}, 1, 3, 1);
  s.add({"5", "6", "7"}, 1, 4, 2);
  s.add({"5", "6", "1"}, 1, 2, 0);
  s.add({"8", "4.5", "1"}, 1, 9, SphereSample::no_group);
  s.add({"1", "10", "1"}, 1, 2, 0);
  return s;
}

} // namespace

TEST_CASE("a section has the circles of the spheres that it cuts, by class") {
  const Panel panel = section_panel(sample(), three_classes(), 0.75);
  REQUIRE(panel.series.size() == 3); // the plane just touches one sphere of the first class
  CHECK(panel.series[0].title == "outside all classes");
  CHECK(panel.series[1].title == "3 to 4 mm");
  CHECK(panel.series[2].title == "2 to 3 mm");
  for (const Series &series : panel.series) {
    CHECK(series.discs);
    CHECK(series.filled);
    REQUIRE(series.points.size() == 1);
  }
  CHECK(panel.series[0].points[0].radius == Approx(std::sqrt(20.0)));
  CHECK(panel.series[1].points[0].radius == Approx(std::sqrt(3.0)));
  CHECK(panel.series[1].points[0].x == 5);
  CHECK(panel.series[1].points[0].y == 7);
  CHECK(panel.series[2].points[0].radius == 1.5);
}

TEST_CASE("both axes of a section have the same scale and hold all spheres") {
  for (const double slope : {0.3, 0.75, 4.0}) {
    const Panel panel = section_panel(sample(), three_classes(), slope);
    CHECK(panel.y.span() / panel.x.span() == Approx(slope));
    CHECK(panel.x.low <= 0);
    CHECK(panel.x.high >= 12.5);
    CHECK(panel.y.low <= -3.5);
    CHECK(panel.y.high >= 9);
    for (const Axis *const axis : {&panel.x, &panel.y})
      for (const Tick &tick : axis->ticks)
        CHECK((tick.at >= axis->low && tick.at <= axis->high));
  }
}

TEST_CASE("every one of many classes has a colour of its own in a section") {
  Gradation::Data d;
  SphereSample s;
  constexpr std::size_t classes = 40;
  for (std::size_t j = 0; j <= classes; ++j) {
    d.sizes.emplace_back(j + 1);
    d.masses.emplace_back(j < classes ? 1 : 0);
    const std::string x = std::to_string(100 * j);
    if (j < classes)
      s.add({x, "0", "0"}, 1, Rational(j + 2), static_cast<std::uint32_t>(j));
  }
  std::set<std::string> colors;
  for (const Series &series : section_panel(s, Gradation(std::move(d)), 1).series)
    colors.insert(series.color);
  CHECK(colors.size() == classes);
}

TEST_CASE("the coarser of two classes is the darker one in a section") {
  const Panel panel = section_panel(sample(), three_classes(), 0.75);
  CHECK(panel.series[1].color < panel.series[2].color);
}

} // namespace section_figure_test

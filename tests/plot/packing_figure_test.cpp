// Packings as figures: discs at scale, their images, colours with words.

#include "packing/apollonian.hpp"
#include "packing/support.hpp"
#include "packing/texture.hpp"
#include "plot/packing_figure.hpp"
#include "plot/picture.hpp"

#include <cmath>
#include <set>

namespace packing_figure_test {

using namespace mdm;
using packing_test::discs;
using packing_test::has;

namespace {

/// A box that is 1 wide, of 1000 units.
Packing packing_of(const std::vector<PackedDisc> &some, bool periodic) {
  Packing p;
  p.places = 3;
  p.width = 1000;
  p.periodic = periodic;
  p.front = 1000;
  p.discs = some;
  return p;
}

const Packing &deposit_of_many() {
  static const Packing p = deposit(discs(400, 4));
  return p;
}

std::size_t points(const Panel &panel) {
  std::size_t n = 0;
  for (const Series &s : panel.series)
    n += s.points.size();
  return n;
}

/// The number that the legend's entry of that beginning names.
std::uint64_t number_of(const Figure &figure, const std::string &title) {
  for (const Series &s : figure.panels.at(0).series)
    if (s.title.rfind(title + ": ", 0) == 0)
      return std::stoull(s.title.substr(title.size() + 2));
  return 0;
}

} // namespace

TEST_CASE("discs are drawn at their places, both axes at one scale", "[figure]") {
  const Packing p =
      packing_of({{200, 100, 100, on_floor, on_floor}, {500, 150, 150, on_floor, on_floor}}, false);
  const Figure figure = packing_figure(p, PackingColour::size);
  const Panel &panel = figure.panels.at(0);
  CHECK(panel.x.low == 0);
  CHECK(panel.x.high == Approx(1));
  CHECK(panel.y.high == Approx(0.5)); // room for the legend
  CHECK(packing_panel(p, {}).y.high == Approx(0.3));
  CHECK(figure.panel_height / panel.y.span() == Approx(figure.panel_width / panel.x.span()));
  REQUIRE(panel.series.size() == 2);
  CHECK(panel.series[0].points.at(0).x == Approx(0.2));
  CHECK(panel.series[0].points.at(0).y == Approx(0.1));
  CHECK(panel.series[0].points.at(0).radius == Approx(0.1));
  CHECK(panel.series[1].points.at(0).radius == Approx(0.15));
  CHECK(panel.series[0].title == "0.2 to 0.21: 1 disc");
}

TEST_CASE("a disc that sticks out of a periodic box is drawn on both sides", "[figure]") {
  const std::vector<PackedDisc> some = {{50, 100, 100, on_floor, on_floor},
                                        {500, 100, 100, on_floor, on_floor}};
  const Panel periodic = packing_panel(packing_of(some, true), {});
  REQUIRE(points(periodic) == 3);
  CHECK(periodic.series.at(0).points.at(1).x == Approx(1.05));
  CHECK(points(packing_panel(packing_of(some, false), {})) == 2);
}

TEST_CASE("what is above a cut box is left out", "[figure]") {
  PackingView view;
  view.most_high = 0.5;
  const Panel panel =
      packing_panel(packing_of({{500, 100, 100, on_floor, on_floor}, {500, 700, 100, 0, 0}}, false), view);
  CHECK(panel.y.high == Approx(0.5));
  CHECK(points(panel) == 1);
}

TEST_CASE("the legend counts discs by their contacts and cells by their corners", "[figure]") {
  const Packing &p = deposit_of_many();
  const PackingTexture t = packing_texture(p);
  const Figure contacts = packing_figure(p, PackingColour::contacts);
  for (const std::uint32_t n : {3U, 4U, 5U})
    CHECK(number_of(contacts, "touches " + std::to_string(n) + " others") == t.coordination.at(n));
  const Figure cells = packing_figure(p, PackingColour::cells);
  CHECK(number_of(cells, "triangles") == t.cells.triangles);
  CHECK(number_of(cells, "quadrangles") == t.cells.quadrangles);
  CHECK(number_of(cells, "five corners or more") == t.cells.pentagons + t.cells.larger);
  std::uint64_t sum = 0;
  const Figure sizes = packing_figure(p, PackingColour::size);
  for (const Series &s : sizes.panels[0].series)
    sum += std::stoull(s.title.substr(s.title.find(": ") + 2));
  CHECK(sum == p.discs.size());
}

TEST_CASE("equal discs have one colour, and nearly equal ones sizes that can be told apart", "[figure]") {
  std::vector<PackedDisc> some(3, {500, 100, 100, on_floor, on_floor});
  CHECK(packing_panel(packing_of(some, false), {}).series.size() == 1);
  Packing p = deposit_of_many();
  for (std::size_t i = 0; i < p.discs.size(); ++i)
    p.discs[i].r = 100000000 + static_cast<std::int64_t>(i);
  p.places = 8;
  std::set<std::string> titles;
  const Panel panel = packing_panel(p, {});
  for (const Series &s : panel.series) {
    titles.insert(s.title);
    const std::size_t to = s.title.find(" to ");
    CHECK(s.title.substr(0, to) != s.title.substr(to + 4, s.title.find(':') - to - 4));
  }
  CHECK(titles.size() == 8);
}

TEST_CASE("a gasket is shown in its outer circle", "[figure]") {
  const Packing p = ApollonianGasket::equal().packing(10);
  const Panel panel = packing_panel(p, {});
  const Point outer = panel.series.at(0).points.at(0);
  CHECK(outer.radius == Approx(1 + 2 / std::sqrt(3)));
  CHECK(panel.x.low < outer.x - outer.radius);
  CHECK(panel.y.high > outer.y + outer.radius);
  CHECK(points(panel) == p.discs.size() + 1);
}

TEST_CASE("discs are circles at scale in a picture, with their edge", "[figure]") {
  Figure figure;
  figure.panel_width = 500;
  Panel panel;
  panel.x = linear_axis("x", 0, 100);
  panel.y = linear_axis("y", 0, 100);
  Series series;
  series.discs = series.filled = true;
  series.edge = "#111111";
  series.title = "discs";
  series.points = {{50, 40, 0, 20}, {10, 10, 0, 0.01}};
  panel.series = {series};
  figure.panels = {panel};
  const std::string svg = picture_of(figure, Picture::svg);
  CHECK(has(svg, "r=\"100\"/>"));
  CHECK(has(svg, "r=\"0.05\"/>"));
  CHECK(has(svg, "stroke=\"#111111\""));
  CHECK(has(svg, ">discs</text>"));
}

} // namespace packing_figure_test

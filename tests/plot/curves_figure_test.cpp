// The figure of several gradations: what stands where.

#include "catch.hpp"
#include "plot/curves_figure.hpp"
#include "plot/picture.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <cmath>

namespace curves_figure_test {

using namespace mdm;

namespace {

Gradation read(const std::string &csv) {
  return read_gradation(csv, "sand.csv");
}

CurvesFigure two_sands() {
  CurvesFigure what;
  what.title = "limits";
  what.curves.push_back(
      {"a", read("size_mm,passing_percent\n1,0\n2,40\n4,100\n"), DrawnCurve::Weight::thick, {2}});
  what.curves.push_back(
      {"b", read("size_um,passing_percent\n500,5\n1000,60\n4000,100\n"), DrawnCurve::Weight::thin});
  what.limits = Envelope{"spec", SizeUnit::mm, {0, 1, 2}, {0, 10, 50}, {5, 20, 90}, {}};
  return what;
}

const Series &series(const Figure &figure, const std::string &title) {
  const std::vector<Series> &all = figure.panels.at(0).series;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Series &s) { return s.title == title; });
  REQUIRE(found != all.end());
  return *found;
}

} // namespace

TEST_CASE("each gradation has a curve of its own colour over the size in mm", "[curves]") {
  const Figure figure = curves_figure(two_sands());
  const Series &a = series(figure, "a"), &b = series(figure, "b");
  REQUIRE(a.points.size() == 3);
  CHECK(a.points[1].x == Approx(std::log10(2)));
  CHECK(a.points[1].y == Approx(40));
  REQUIRE(b.points.size() == 3); // its pan is not drawn
  CHECK(b.points[0].x == Approx(std::log10(0.5)));
  CHECK(b.points[0].y == Approx(5));
  CHECK(a.color != b.color);
  CHECK(a.width > b.width);
  CHECK(figure.panels[0].x.low < std::log10(0.5));
  CHECK(figure.panels[0].x.high > std::log10(4));
}

TEST_CASE("limits are an area, and a limit that is missed is marked on the curve", "[curves]") {
  const Figure figure = curves_figure(two_sands());
  CHECK(series(figure, "allowed: spec").filled);
  CHECK(series(figure, "allowed: spec").points.size() == 4); // the limit at size 0 has no place
  const Series &missed = series(figure, "a limit is missed");
  REQUIRE(missed.points.size() == 1);
  CHECK(missed.points[0].x == Approx(std::log10(2)));
  CHECK(missed.points[0].y == Approx(40));
  CHECK(missed.mark == Mark::ring);
}

TEST_CASE("from the ninth curve on strokes differ", "[curves]") {
  CurvesFigure what;
  for (int i = 0; i < 10; ++i)
    what.curves.push_back({std::to_string(i), read("size_mm,mass\n1,1\n2,0\n")});
  const Figure figure = curves_figure(what);
  CHECK(series(figure, "0").color == series(figure, "8").color);
  CHECK(series(figure, "0").stroke != series(figure, "8").stroke);
}

TEST_CASE("the figure of several gradations is drawn", "[curves]") {
  CHECK(picture_of(curves_figure(two_sands()), Picture::svg).find("allowed: spec") != std::string::npos);
  CurvesFigure german = two_sands();
  german.form.language = Language::german;
  german.form.width = 300;
  const std::string picture = picture_of(curves_figure(german), Picture::svg);
  CHECK(picture.find("Durchgang") != std::string::npos);
  CHECK(picture.find("eine Grenze ist verletzt") != std::string::npos);
}

} // namespace curves_figure_test

// The triangle of textures: what stands where.

#include "catch.hpp"
#include "plot/picture.hpp"
#include "plot/texture_figure.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <cmath>

namespace texture_figure_test {

using namespace mdm;

namespace {

NamedCurve named(const std::string &name, const std::string &rows) {
  return {name, GradingCurve(read_gradation("size_mm,passing_percent\n" + rows, "sand.csv"))};
}

/// 40 % sand, 40 % silt and 20 % clay, which is loam.
NamedCurve loam() {
  return named("field", "0.0001,0\n0.002,20\n0.05,60\n2,100\n");
}

} // namespace

TEST_CASE("a gradation is a point of the triangle, with its texture in the legend", "[texture]") {
  const Figure figure = texture_figure(TextureSystem::usda, {loam()}, {});
  const Series &point = figure.panels.at(0).series.back();
  CHECK(point.title == "field: loam");
  REQUIRE(point.points.size() == 1);
  CHECK(point.points[0].x == Approx(0.5)); // silt and half the clay
  CHECK(point.points[0].y == Approx(0.2 * std::sqrt(0.75)));
  CHECK(point.mark != Mark::none);
  CHECK_FALSE(figure.panels[0].framed);
  CHECK(figure.panel_height / figure.panel_width ==
        Approx(figure.panels[0].y.span() / figure.panels[0].x.span())); // the triangle's sides are equal
}

TEST_CASE("a gradation whose fines are not known has no point, and a remark says why", "[texture]") {
  const Figure figure =
      texture_figure(TextureSystem::shepard, {loam(), named("sand", "0.063,5\n2,100\n")}, {});
  const std::vector<Series> &all = figure.panels.at(0).series;
  CHECK(std::none_of(all.begin(), all.end(), [](const Series &s) { return s.title.rfind("sand", 0) == 0; }));
  REQUIRE(figure.remarks.size() == 1);
  CHECK(figure.remarks[0].rfind("sand: no texture: ", 0) == 0);
}

TEST_CASE("the triangles are drawn, short labels are explained", "[texture]") {
  for (const TextureSystem system : {TextureSystem::folk, TextureSystem::shepard, TextureSystem::usda}) {
    FigureForm german;
    german.language = Language::german;
    german.width = 300;
    const std::string picture = picture_of(texture_figure(system, {loam()}, german), Picture::svg);
    CHECK(picture.find("Sand (%)") != std::string::npos);
    CHECK((picture.find("msG: muddy sandy gravel") != std::string::npos) == (system == TextureSystem::folk));
  }
}

} // namespace texture_figure_test

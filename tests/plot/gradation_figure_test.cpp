// The figure of a gradation: what stands where.

#include "catch.hpp"
#include "plot/gradation_figure.hpp"
#include "plot/picture.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <cmath>

namespace gradation_figure_test {

using namespace mdm;

namespace {

Gradation read(const std::string &csv) {
  return read_gradation(csv, "sand.csv");
}

const Gradation &sand() {
  static const Gradation g = read("size_mm,mass\n0.075,10\n0.25,30\n1.18,40\n2.1,20\n4.75,0\n");
  return g;
}

const Series *series(const Panel &panel, const std::string &title) {
  for (const Series &s : panel.series)
    if (s.title.rfind(title, 0) == 0)
      return &s;
  return nullptr;
}

std::vector<double> ys(const Series &s) {
  std::vector<double> all;
  for (const Point &p : s.points)
    all.push_back(p.y);
  return all;
}

bool has(const std::vector<std::string> &lines, const std::string &line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

std::vector<std::string> texts(const Panel &panel) {
  std::vector<std::string> all;
  for (const Text &t : panel.texts)
    all.push_back(t.text);
  return all;
}

using Lines = std::vector<std::string>;

Lines sieves(const Gradation &g, SieveNames sieve_names) {
  GradationFigure what;
  what.sieve_names = sieve_names;
  const Figure figure = gradation_figure(g, what);
  Lines names;
  for (const Tick &t : figure.panels[0].top)
    names.push_back(t.label);
  return names;
}

} // namespace

TEST_CASE("the curve goes through the percent passing at each sieve", "[figure]") {
  const Figure figure = gradation_figure(sand(), {});
  CHECK(figure.title == "sand");
  REQUIRE(figure.panels.size() == 1);
  const Panel &p = figure.panels[0];
  const Series *curve = series(p, "sieve analysis");
  REQUIRE(curve != nullptr);
  CHECK(ys(*curve) == std::vector<double>{0, 10, 40, 80, 100});
  CHECK(curve->points[0].x == Approx(std::log10(0.075)));
  CHECK(curve->points[4].x == Approx(std::log10(4.75)));
  CHECK(p.x.title == "size (mm)");
  CHECK_FALSE(p.x.reversed);
  CHECK(p.right.front().label == "100");
  CHECK(p.right.back().label == "0");
}

TEST_CASE("sieves stand on top with their openings, their ASTM names, or not at all", "[figure]") {
  CHECK(sieves(sand(), SieveNames::astm) == Lines{"No. 200", "No. 60", "No. 16", "2.1", "No. 4"});
  CHECK(sieves(sand(), SieveNames::iso) == Lines{"0.075", "0.25", "1.18", "2.1", "4.75"});
  CHECK(sieves(sand(), SieveNames::none).empty());
  const Gradation micrometres = read("size_um,mass\npan,1\n74,10\n75,10\n300,0\n");
  CHECK(sieves(micrometres, SieveNames::astm) == Lines{"74", "No. 200", "No. 50"});
  CHECK(sieves(micrometres, SieveNames::iso) == Lines{"74", "75", "300"});
}

TEST_CASE("D10, D30 and D60, their indices and the group stand in the figure", "[figure]") {
  // Computed by hand: D10 = 0.25, D30 = 0.25 (4.72)^(2/3), D60 = (1.18 2.1)^(1/2).
  const Figure figure = gradation_figure(sand(), {});
  CHECK(has(figure.notes, "D10 = 0.25 mm"));
  CHECK(has(figure.notes, "D30 = 0.703 mm"));
  CHECK(has(figure.notes, "D60 = 1.57 mm"));
  CHECK(has(figure.notes, "USCS SW"));
  CHECK(texts(figure.panels[0]) == Lines{"D10", "D30", "D60"});
}

TEST_CASE("what is finer than the finest sieve is dashed and told", "[figure]") {
  const Figure figure = gradation_figure(read("size_mm,mass\npan,20\n0.25,30\n1,50\n4,0\n"), {});
  const Panel &p = figure.panels[0];
  CHECK(ys(*series(p, "sieve analysis")) == std::vector<double>{20, 50, 100});
  const auto dashed = std::find_if(p.series.begin(), p.series.end(), [&p](const Series &s) {
    return s.stroke == Stroke::dashed && s.points[0].x == p.x.low && s.points[0].y == 20;
  });
  CHECK(dashed != p.series.end());
  CHECK(has(figure.notes, "D10 < 0.25 mm"));
  CHECK(has(figure.notes, "finer than 0.25 mm: 20 %"));
  CHECK(texts(p) == Lines{"D30", "D60"});
}

TEST_CASE("what reading and the group assume is remarked", "[figure]") {
  const Gradation silty = read("size_mm,passing_percent\n4.75,100\n0.425,60\n0.075,20\n");
  const auto remarks = [&silty](const GradationFigure &what) {
    Lines lines = gradation_figure(silty, what).remarks;
    return lines;
  };
  const auto some = [](const Lines &lines, const std::string &part) {
    return std::any_of(lines.begin(), lines.end(),
                       [&part](const std::string &l) { return l.find(part) != std::string::npos; });
  };
  const Lines assumed = remarks({});
  CHECK(some(assumed, "A pan of size 0 was added"));
  CHECK(some(assumed, "the fines are taken as low-plasticity silt (ML)"));
  CHECK(some(assumed, "D10: below 0.075 mm"));
  GradationFigure clayey;
  clayey.soil.limits = AtterbergLimits{40, 20};
  CHECK_FALSE(some(remarks(clayey), "low-plasticity silt"));
  CHECK(has(gradation_figure(silty, clayey).notes, "USCS SC"));
  CHECK(has(gradation_figure(silty, {}).notes, "USCS SM"));
  GradationFigure counts;
  counts.curve = false;
  counts.counts = true;
  counts.particles = {{Rational(0), ratio(75, 1000), 20, 3, ratio(6, 100)}};
  CHECK(remarks(counts) == silty.notes());
}

TEST_CASE("the curve is continued into the pan where that is asked for", "[figure]") {
  const Gradation fine = read("size_mm,mass\npan,20\n0.25,30\n1,50\n4,0\n");
  GradationFigure what;
  what.soil.extrapolate = true;
  // 0.25 / 4^(1/3)
  CHECK(has(gradation_figure(fine, what).notes, "D10 = 0.157 mm"));
}

TEST_CASE("the figure says whose bands it has", "[figure]") {
  GradationFigure what;
  CHECK(has(gradation_figure(sand(), what).notes, "bands: ASTM D2487"));
  what.bands = Bands::iso_14688;
  CHECK(has(gradation_figure(sand(), what).notes, "bands: ISO 14688"));
  what.bands = Bands::none;
  for (const std::string &note : gradation_figure(sand(), what).notes)
    CHECK(note.rfind("bands", 0) != 0);
}

TEST_CASE("bands of two classifications, or none", "[figure]") {
  const auto main_bands = [](Bands bands) {
    GradationFigure what;
    what.bands = bands;
    const Figure figure = gradation_figure(sand(), what);
    Lines names;
    for (const Strip &strip : figure.panels[0].strips)
      for (const Strip::Part &part : strip.parts)
        names.push_back(part.names[0]);
    return names;
  };
  CHECK(has(main_bands(Bands::uscs), "medium sand"));
  CHECK(has(main_bands(Bands::iso_14688), "medium sand"));
  CHECK(has(main_bands(Bands::uscs), "fines"));
  CHECK(has(main_bands(Bands::iso_14688), "silt"));
  CHECK_FALSE(has(main_bands(Bands::iso_14688), "fines"));
  CHECK(main_bands(Bands::none).empty());
}

TEST_CASE("a set of particles is steps of its mass and bars of its counts", "[figure]") {
  GradationFigure what;
  what.counts = true;
  what.coarse_left = true;
  what.particles = {{ratio(3, 40), ratio(1, 4), 10, Integer("12345678901234"), ratio(1, 10)},
                    {ratio(1, 4), ratio(59, 50), 30, 7, 1}};
  const Figure figure = gradation_figure(sand(), what);
  REQUIRE(figure.panels.size() == 2);
  const Series *steps = series(figure.panels[0], "set of particles");
  REQUIRE(steps != nullptr);
  CHECK(ys(*steps) == std::vector<double>{0, 0, 25, 25, 100, 100});
  CHECK(steps->points[1].x == Approx(-1));
  CHECK(steps->points[2].x == Approx(-1));
  CHECK(steps->points[3].x == Approx(0));
  const Panel &counts = figure.panels[1];
  CHECK(counts.x.reversed);
  REQUIRE(counts.boxes.size() == 2);
  CHECK(counts.boxes[1].x_low == Approx(std::log10(0.25)));
  CHECK(counts.boxes[1].x_high == Approx(std::log10(1.18)));
  CHECK(counts.boxes[1].y_high == Approx(std::log10(7)));
  CHECK(texts(counts) == Lines{"1.234e13", "7"});
  CHECK(has(figure.notes, "N = 1.234e13"));
  CHECK(counts.y.high > std::log10(1.3e13));
}

TEST_CASE("the axis holds particles beyond the sieves, and their classes from end to end", "[figure]") {
  GradationFigure what;
  what.counts = true;
  what.particles = {{ratio(1, 100), ratio(3, 40), 10, 70, ratio(1, 15)}, {4, 50, 30, 7, 5}};
  for (const Panel &p : gradation_figure(sand(), what).panels) {
    CHECK(p.x.low < -2);
    CHECK(p.x.high > std::log10(50));
  }
  what.particles[0].lower = 0; // to the frame, with room for its number
  const Panel counts = gradation_figure(sand(), what).panels[1];
  CHECK(counts.boxes[0].x_low == counts.x.low);
  CHECK(counts.boxes[0].x_high - counts.x.low > 0.1);
}

TEST_CASE("numbers of crowded classes keep their distance, the largest are shown", "[figure]") {
  GradationFigure what;
  what.curve = false;
  what.counts = true;
  std::string csv = "size_mm,mass\n";
  constexpr int classes = 200;
  for (int j = 0; j <= classes; ++j)
    csv += std::to_string(1000 + j) + (j < classes ? ",1\n" : ",0\n");
  for (int j = 0; j < classes; ++j)
    what.particles.push_back({1000 + j, 1001 + j, 1, j == 101 ? 5000 : 1000 + j % 2, Rational(1001 + j)});
  const Figure figure = gradation_figure(read(csv), what);
  const Panel &p = figure.panels[0];
  CHECK(has(texts(p), "5000"));
  CHECK(p.texts.size() > 20);
  std::vector<double> at;
  for (const Text &t : p.texts)
    at.push_back(t.x / p.x.span() * figure.panel_width);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i)
    CHECK(at[i] - at[i - 1] > letter_size);
}

TEST_CASE("an envelope is drawn in the gradation's unit", "[figure]") {
  GradationFigure what;
  what.envelope = read_envelope(
      "size_um,passing_min_percent,passing_max_percent\n0,0,1\n100,5,20\n1000,70,90\n", "spec.csv");
  const Figure figure = gradation_figure(sand(), what);
  const Series *inside = series(figure.panels[0], "allowed: spec");
  REQUIRE(inside != nullptr);
  CHECK(inside->filled);
  CHECK(ys(*inside) == std::vector<double>{5, 70, 90, 20});
  CHECK(inside->points[0].x == Approx(-1));
  CHECK(inside->points[1].x == Approx(0).margin(1e-12));
}

TEST_CASE("figures of extreme gradations have axes of numbers", "[figure]") {
  for (const char *csv : {"size_mm,mass\npan,1\n1,0\n", "size_mm,mass\n1,1\n1.0000000000000000000001,0\n",
                          "size_m,mass\n1e-300,1\n1e300,0\n", "size_mm,mass\n1e-400,1\n1e-399,0\n",
                          "size_mm,mass\n0.5,1\n1,0\n"}) {
    const Gradation g = read(csv);
    GradationFigure what;
    what.counts = true;
    what.particles = {{g.lower(0), g.upper(0), 1, power_of_ten(900), g.upper(0)}};
    const Figure figure = gradation_figure(g, what);
    INFO(csv);
    CHECK(figure.panels[0].x.span() > 0);
    const std::string svg = picture_of(figure, Picture::svg);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
  }
}

TEST_CASE("sieves of any size have short labels") {
  const Lines labels = sieves(read("size_mm,mass\n1e-400,1\n1,2\n1e400,0\n"), SieveNames::astm);
  CHECK(labels == Lines{"1e-400", "No. 18", "1.000e400"});
}

TEST_CASE("the figure's own words are German where that is asked for, and no others", "[figure]") {
  GradationFigure what;
  what.form.language = Language::german;
  what.bands = Bands::iso_14688;
  what.particles = {{ratio(1, 4), ratio(59, 50), 30, 7, 1}};
  what.counts = true;
  const Figure figure = gradation_figure(sand(), what);
  const Panel &p = figure.panels[0];
  CHECK(figure.title == "sand");
  CHECK(p.x.title == "Gr\u00F6\u00DFe (mm)");
  CHECK(p.y.title == "Durchgang in Prozent");
  CHECK(series(p, "Soll: Siebanalyse") != nullptr);
  CHECK(series(p, "Partikelmenge") != nullptr);
  CHECK(figure.panels[1].y.title == "Partikel in der Klasse");
  CHECK(has(figure.notes, "Bereiche: ISO 14688"));
  CHECK(has(figure.notes, "USCS SW"));
  Lines bands;
  for (const Strip &strip : p.strips)
    for (const Strip::Part &part : strip.parts)
      bands.push_back(part.names[0]);
  for (const char *band : {"Kies", "Sand", "Schluff", "Mittelsand", "Grobschluff"})
    CHECK(has(bands, band));
  CHECK(figure.description.find("Durchgang") != std::string::npos);
}

TEST_CASE("every band has a name in both languages, and a short one", "[figure]") {
  CHECK(band_names("coarse sand", Language::english) == Lines{"coarse sand", "coarse", "c"});
  CHECK(band_names("coarse sand", Language::german) == Lines{"Grobsand", "grob", "g"});
  CHECK(band_names("large boulders", Language::german).front() == "gro\u00DFe Bl\u00F6cke");
  GradationFigure what;
  what.form.language = Language::german;
  const Gradation wide = read("size_m,mass\n1e-6,1\n1e-3,1\n1,1\n10,0\n");
  for (const Bands bands : {Bands::uscs, Bands::iso_14688}) {
    what.bands = bands;
    const Figure figure = gradation_figure(wide, what);
    for (const Strip &strip : figure.panels[0].strips) {
      CHECK(strip.parts.size() >= 4);
      for (const Strip::Part &part : strip.parts)
        CHECK_FALSE(part.names.front().empty());
    }
  }
}

TEST_CASE("a figure is as wide as asked; a narrow one leaves its right side free", "[figure]") {
  for (const double width : {328.0, 700.0, 1200.0}) {
    GradationFigure what;
    what.form.width = width;
    what.form.bare = true;
    const Figure figure = gradation_figure(sand(), what);
    const std::string svg = picture_of(figure, Picture::svg);
    CHECK(std::stod(svg.substr(svg.find("width=\"") + 7)) == Approx(width).margin(1));
    CHECK(figure.panels[0].right.empty() == (width < 480));
    CHECK(figure.panels[0].x.title == "size (mm); bands: ASTM D2487"); // no note says it
  }
}

} // namespace gradation_figure_test

// Pictures of figures: what stands where in SVG, and that PNG and PDF are drawn of the same.

#include "catch.hpp"
#include "plot/figure_layout.hpp"
#include "plot/palette.hpp"
#include "plot/picture.hpp"

#include <mdm/text/error.hpp>

#include <cmath>
#include <limits>
#include <sstream>

namespace picture_test {

using namespace mdm;

namespace {

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string &text, const std::string &part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

/// The value of an attribute of the first text with that content.
double place_of(const std::string &svg, const std::string &text, const std::string &attribute) {
  const std::size_t end = svg.find(">" + text + "</text>");
  REQUIRE(end != std::string::npos);
  const std::size_t begin = svg.rfind("<text", end);
  const std::size_t at = svg.find(attribute + "=\"", begin);
  REQUIRE(at < end);
  return std::stod(svg.substr(at + attribute.size() + 2));
}

Panel square_panel() {
  Panel panel;
  panel.x = linear_axis("size", 0, 10);
  panel.y = linear_axis("percent", 0, 100);
  return panel;
}

Figure figure_of(const Panel &panel) {
  Figure figure;
  figure.panels = {panel};
  return figure;
}

std::string svg_of(const Series &series) {
  Panel panel = square_panel();
  panel.series = {series};
  return picture_of(figure_of(panel), Picture::svg);
}

} // namespace

TEST_CASE("a line goes through its points, and breaks where there is no number", "[picture]") {
  Series line;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  line.points = {{0, 0}, {10, 100}, {gap, gap}, {5, 50}, {5, 100}};
  const std::string svg = svg_of(line);
  const std::size_t path = svg.find("stroke=\"#1f4e79\"");
  REQUIRE(path != std::string::npos);
  std::istringstream d(svg.substr(svg.find("d=\"M", path) + 4));
  double x = 0, y = 0;
  char letter = ' ';
  d >> x >> y;
  const double left = x, bottom = y;
  d >> letter >> x >> y;
  CHECK(letter == 'L');
  CHECK(x - left == Approx(560));
  CHECK(bottom - y == Approx(380));
  d >> letter >> x >> y;
  CHECK(letter == 'M');
  CHECK(x - left == Approx(280));
  CHECK(bottom - y == Approx(190));
}

TEST_CASE("a reversed axis begins at its greatest value", "[picture]") {
  Panel panel = square_panel();
  const auto distance = [&panel] {
    const std::string svg = picture_of(figure_of(panel), Picture::svg);
    return place_of(svg, "10", "x") - place_of(svg, "0", "x");
  };
  panel.y.ticks.clear();
  CHECK(distance() == Approx(560));
  panel.x.reversed = true;
  CHECK(distance() == Approx(-560));
}

TEST_CASE("marks have their shape, and are left out beyond the frame", "[picture]") {
  Series marks;
  marks.stroke = Stroke::none;
  marks.mark = Mark::disc;
  marks.points = {{1, 10}, {2, 20}, {11, 50}, {5, 101}};
  CHECK(count(svg_of(marks), "<circle") == 2);
  marks.mark = Mark::square;
  CHECK(count(svg_of(marks), "<circle") == 0);
  CHECK(count(svg_of(marks), "<path") == count(svg_of(Series()), "<path") + 2);
}

TEST_CASE("values are coloured by the scale, which is drawn as a bar", "[picture]") {
  Series scatter;
  scatter.title = "least match";
  scatter.points = {{1, 10, 0}, {2, 20, 12}};
  scatter.stroke = Stroke::none;
  scatter.mark = Mark::disc;
  scatter.by_value = true;
  Panel panel = square_panel();
  panel.series = {scatter};
  Figure figure;
  figure.title = "Figure 3";
  figure.panels = {panel, panel};
  figure.columns = 2;
  figure.colors = linear_axis("log volume ratio", 0, 12);
  const std::string svg = picture_of(figure, Picture::svg);
  CHECK(contains(svg, "fill=\"#440154\""));
  CHECK(contains(svg, "fill=\"#fde725\""));
  CHECK(contains(svg, ">Figure 3</text>"));
  CHECK(contains(svg, ">log volume ratio</text>"));
  CHECK(count(svg, ">least match</text>") == 1); // in the legend once
  CHECK(svg == picture_of(figure, Picture::svg));
}

TEST_CASE("colours of values go evenly between their nodes, and stay at the ends", "[picture]") {
  CHECK(palette_color(0) == "#440154");
  CHECK(palette_color(1) == "#fde725");
  CHECK(palette_color(0.5) == "#21908d");
  CHECK(palette_color(0.0625) == "#461767"); // half way between the first two
  CHECK(palette_color(-3) == palette_color(0));
  CHECK(palette_color(7) == palette_color(1));
  CHECK(palette_color(std::numeric_limits<double>::quiet_NaN()) == palette_color(0));
}

TEST_CASE("texts are data: nothing of them is markup", "[picture]") {
  Panel panel = square_panel();
  panel.title = "<b> & \"q\" 'r' \\n `x` $y";
  panel.texts.push_back({1, 1, "a\nb\xFF</svg>"});
  Figure figure = figure_of(panel);
  figure.notes = {"sand \u4E2D", "\u00E4 \u00B2"};
  const std::string svg = picture_of(figure, Picture::svg);
  CHECK(contains(svg, ">&lt;b&gt; &amp; \"q\" 'r' \\n `x` $y</text>"));
  CHECK(contains(svg, ">a\\x0ab\\xff&lt;/svg&gt;</text>"));
  CHECK(contains(svg, ">sand \\u4e2d</text>"));
  CHECK(contains(svg, ">\u00E4 \u00B2</text>"));
  CHECK(count(svg, "</svg>") == 1);
}

TEST_CASE("the page has room for notes and legend, and nothing stands outside of it", "[picture]") {
  Series series;
  series.title = "a curve";
  series.points = {{1, 10}, {2, 20}};
  Panel panel = square_panel();
  panel.series = {series};
  Figure figure = figure_of(panel);
  const auto height = [](const std::string &svg) { return std::stod(svg.substr(svg.find("height=\"") + 8)); };
  const double before = height(picture_of(figure, Picture::svg));
  figure.notes = std::vector<std::string>(12, "a note");
  const std::string svg = picture_of(figure, Picture::svg);
  CHECK(height(svg) > before);
  CHECK(count(svg, ">a note</text>") == 12);
  std::size_t texts = 0;
  for (std::size_t at = svg.find("<text x=\""); at != std::string::npos;
       at = svg.find("<text x=\"", at + 1)) {
    const double x = std::stod(svg.substr(at + 9)), y = std::stod(svg.substr(svg.find("y=\"", at) + 3));
    CHECK((0 < x && x < std::stod(svg.substr(svg.find("width=\"") + 7))));
    CHECK((0 < y && y < height(svg)));
    ++texts;
  }
  CHECK(texts > 20);
}

TEST_CASE("labels of the upper side keep their distance and both ends", "[picture]") {
  Panel panel;
  panel.x = log_axis("size", 0, 1);
  panel.y = linear_axis("percent passing", 0, 100);
  for (int i = 0; i <= 200; ++i)
    panel.top.push_back({i / 200.0, "s" + std::to_string(i) + "."});
  const std::string svg = picture_of(figure_of(panel), Picture::svg);
  CHECK(contains(svg, ">s0.<"));
  CHECK(contains(svg, ">s200.<"));
  double last = -1;
  std::size_t shown = 0;
  for (int i = 0; i <= 200; ++i) {
    const std::string label = "s" + std::to_string(i) + ".";
    if (!contains(svg, ">" + label + "<"))
      continue;
    const double at = place_of(svg, label, "x");
    CHECK((last < 0 || at - last >= letter_size));
    last = at;
    ++shown;
  }
  CHECK(shown > 30);
}

TEST_CASE("numbers far outside of the frame are drawn up to its edge", "[picture]") {
  Series line;
  line.points = {{-1e300, 50}, {1e300, 50}};
  const std::string svg = svg_of(line);
  CHECK_FALSE(contains(svg, "e+"));
  CHECK(contains(svg, "clip-path"));
}

TEST_CASE("PNG and PDF are drawn, the same each time, or refused with the reason", "[picture]") {
  Series series;
  series.points = {{1, 10}, {2, 20}};
  Panel panel = square_panel();
  panel.series = {series};
  const Figure figure = figure_of(panel);
  try {
    const std::string png = picture_of(figure, Picture::png), pdf = picture_of(figure, Picture::pdf);
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    CHECK(pdf.substr(0, 5) == "%PDF-");
    CHECK(png == picture_of(figure, Picture::png));
    CHECK(pdf == picture_of(figure, Picture::pdf));
    Figure large = figure;
    large.panel_width = 1e6;
    CHECK_THROWS_WITH(picture_of(large, Picture::png), Catch::Contains("cairo says"));
  } catch (const InputError &error) {
    CHECK(contains(error.what(), "libcairo2-dev"));
  }
}

TEST_CASE("remarks stand below all else, each whole, within the picture", "[picture]") {
  const std::string closing = "and then ends here";
  for (const bool has_colors : {false, true}) {
    Figure figure = figure_of(square_panel());
    figure.notes = {"a note"};
    if (has_colors)
      figure.colors = linear_axis("share", 0, 1);
    figure.remarks = {"a first remark",
                      "a longer one that goes on as sentences do that say what was assumed, in more "
                      "words than stand in one line below a panel and its labels at either side, " +
                          closing};
    const FigureLayout layout(figure);
    const std::string svg = picture_of(figure, Picture::svg);
    const double first = place_of(svg, "a first remark", "y");
    CHECK(first > place_of(svg, "a note", "y"));
    CHECK(first > layout.panels[0].bottom);
    REQUIRE(layout.remarks.size() > 2);
    CHECK(layout.remarks.back().ends_with(closing));
    CHECK(place_of(svg, layout.remarks.back(), "y") > first + letter_size);
    CHECK(place_of(svg, layout.remarks.back(), "y") < layout.height);
    for (const std::string &line : layout.remarks)
      CHECK(layout.around.left + text_width(line, letter_size) <= layout.width);
    figure.remarks.clear();
    CHECK(layout.height > FigureLayout(figure).height + 2 * letter_size);
  }
}

TEST_CASE("a picture says what it is to programs that read it out", "[picture]") {
  Figure figure = figure_of(square_panel());
  CHECK(contains(picture_of(figure, Picture::svg), "role=\"img\""));
  CHECK_FALSE(contains(picture_of(figure, Picture::svg), "<title>"));
  figure.title = "<sand> & gravel";
  figure.description = "Percent & size.";
  const std::string svg = picture_of(figure, Picture::svg);
  const std::size_t title =
      svg.find("<title>&lt;sand&gt; &amp; gravel</title>\n<desc>Percent &amp; size.</desc>");
  REQUIRE(title != std::string::npos);
  CHECK(title < svg.find("<rect")); // the first child of the picture
}

TEST_CASE("a bare figure has its panels and its legend alone", "[picture]") {
  Series series;
  series.title = "a curve";
  series.points = {{1, 10}, {2, 20}};
  Panel panel = square_panel();
  panel.series = {series};
  Figure figure = figure_of(panel);
  figure.title = "sand";
  figure.notes = {"a note"};
  figure.remarks = {"a remark"};
  const std::string whole = picture_of(figure, Picture::svg);
  for (const char *text : {">sand</text>", ">a note<", ">a remark<", ">a curve<", ">size<"})
    CHECK(contains(whole, text));
  figure.bare = true;
  const std::string bare = picture_of(figure, Picture::svg);
  for (const char *text : {">sand</text>", ">a note<", ">a remark<"})
    CHECK_FALSE(contains(bare, text));
  for (const char *text : {"<title>sand</title>", ">a curve<", ">size<"})
    CHECK(contains(bare, text));
  CHECK(FigureLayout(figure).height < 480);
}

TEST_CASE("panels fill the width that is asked for, beside their labels", "[picture]") {
  Figure figure = figure_of(square_panel());
  for (const double width : {300.0, 1000.0}) {
    figure.panel_width = panel_width_in(width, figure);
    CHECK(FigureLayout(figure).width == Approx(width).margin(1));
  }
  figure.panels.push_back(square_panel());
  figure.columns = 2;
  figure.panel_width = panel_width_in(1000, figure);
  CHECK(FigureLayout(figure).width == Approx(1000).margin(1));
  CHECK(panel_width_in(10, figure) == 100);
}

TEST_CASE("a line of a hundred thousand points has those that can be seen, its ends among them",
          "[picture]") {
  Series line;
  constexpr int points = 100'000;
  for (int i = 0; i <= points; ++i)
    line.points.push_back({10.0 * i / points, i == points / 2 ? 100.0 : 0.0});
  Panel panel = square_panel();
  panel.x.ticks.clear();
  panel.y.ticks.clear();
  panel.series = {line};
  const std::string svg = picture_of(figure_of(panel), Picture::svg);
  CHECK(svg.size() < 60'000);
  const FigureLayout layout(figure_of(panel));
  const std::string path =
      svg.substr(svg.find("d=\"M"), svg.find("\"/>", svg.find("d=\"M")) - svg.find("d=\"M"));
  std::istringstream first(path.substr(4));
  double x = 0;
  first >> x;
  CHECK(x == Approx(layout.panels[0].left).margin(0.01));
  std::istringstream last(path.substr(path.rfind('L') + 1));
  last >> x;
  CHECK(x == Approx(layout.panels[0].right).margin(0.01));
  CHECK(layout.panels[0].top == 6);
  CHECK(contains(path, " 6L")); // the peak, which is one point
}

} // namespace picture_test

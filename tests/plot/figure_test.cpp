// Figures and their scripts; gnuplot itself draws in tests/cli/plot_test.cpp.

#include "catch.hpp"
#include "plot/gnuplot_script.hpp"

#include <cmath>
#include <limits>

using namespace mdm;

namespace {

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> labels(const Axis &axis) {
  std::vector<std::string> all;
  for (const Tick &t : axis.ticks)
    if (!t.label.empty())
      all.push_back(t.label);
  return all;
}

using Labels = std::vector<std::string>;

} // namespace

TEST_CASE("linear axes end at round values", "[figure]") {
  const Axis percent = linear_axis("percent", 0, 100);
  CHECK(percent.low == 0);
  CHECK(percent.high == 100);
  CHECK(labels(percent) == Labels{"0", "20", "40", "60", "80", "100"});
  CHECK(labels(linear_axis("", 0.012, 0.058)) == Labels{"0.01", "0.02", "0.03", "0.04", "0.05", "0.06"});
  CHECK(labels(linear_axis("", -3, 3)) == Labels{"-3", "-2", "-1", "0", "1", "2", "3"});
  CHECK(linear_axis("", 5, 5).span() > 0);
  CHECK(linear_axis("", 0, 0).span() > 0);
}

TEST_CASE("logarithmic axes have powers of ten, and values where there are none", "[figure]") {
  CHECK(labels(log_axis("", -2, 2)) == Labels{"0.01", "0.1", "1", "10", "100"});
  CHECK(labels(log_axis("", 4, 6.1)) == Labels{"10\u2074", "10\u2075", "10\u2076"});
  CHECK(labels(log_axis("", -5, -4)) == Labels{"10\u207B\u2075", "10\u207B\u2074"});
  CHECK(labels(log_axis("", std::log10(0.5), std::log10(0.9))) == Labels{"0.5", "0.6", "0.7", "0.8", "0.9"});
  CHECK(labels(log_axis("", -1.1, 0.1)) == Labels{"0.1", "0.2", "0.5", "1"});
  CHECK(labels(log_axis("", -400, 400)).size() <= 13);
  CHECK(labels(log_axis("", 350.2, 350.3)).size() <= 1);
  CHECK(log_axis("", 1, 1).span() > 0);
}

TEST_CASE("logarithms of fractions of any length", "[figure]") {
  CHECK(log10_of(Rational(1000)) == Approx(3));
  CHECK(log10_of(ratio(3, 40)) == Approx(std::log10(0.075)));
  CHECK(log10_of(Rational(power_of_ten(400))) == Approx(400));
  CHECK(log10_of(ratio(1, power_of_ten(400))) == Approx(-400));
}

TEST_CASE("a text that is too wide is cut between characters", "[figure]") {
  CHECK(fitted("sand", 100) == "sand");
  CHECK(fitted("", 0).empty());
  const std::string cut = fitted("\u00E4\u00F6\u00FC\u00E4\u00F6\u00FC\u00E4\u00F6\u00FC", 50);
  CHECK(cut.substr(cut.size() - 3) == "...");
  CHECK((cut.size() - 3) % 2 == 0);
  CHECK(text_width(cut, letter_size) <= 50);
  CHECK(fitted("a\nb", 100) == "a\\x0ab");
}

TEST_CASE("a text in a script is a string in one line that nothing of it can end", "[figure]") {
  CHECK(gnuplot_string("No. 200") == R"("No. 200")");
  CHECK(gnuplot_string("it's \"q\"") == R"("it\047s \042q\042")");
  CHECK(gnuplot_string("`x` @y $z {a}^b") == R"("\140x\140 \100y \044z \173a\175\136b")");
  CHECK(gnuplot_string("\\n1") == R"("\134n1")");
  CHECK(gnuplot_string("a\nb\r\xFF") == R"("a\134x0ab\134x0d\134xff")");
  CHECK(gnuplot_string("\u00E4 \u00B2") == "\"\u00E4 \u00B2\"");
}

TEST_CASE("characters that fonts may lack are drawn as their numbers", "[figure]") {
  CHECK(drawable("sand \u4E2D") == "sand \\u4e2d");
  CHECK(drawable("\U0001F600\u200B\u202E\u0301\u0378") ==
        "\\u1f600\\xe2\\x80\\x8b\\xe2\\x80\\xae\\u0301\\u0378");
  const std::string common =
      "\u00E9\u0159\u00DF\u03B1\u03A9\u0416\u044F \u2013\u201C\u2026\u2264\u00B5m\u00B3";
  CHECK(drawable(common) == common);
  CHECK(drawable("a\n\xFF") == "a\\x0a\\xff");
  CHECK(gnuplot_string("\u4E2D") == R"("\134u4e2d")");
  Figure figure;
  figure.title = "sand \u4E2D";
  figure.notes = {"\u00E4", "a\nb"};
  figure.panels.resize(2);
  figure.panels[0].title = "\u6C99";
  figure.panels[1].series.resize(1);
  figure.panels[1].series[0].title = "\u77F3";
  figure.panels[1].series[0].points = {{0, 0}};
  CHECK(escaped_texts(figure) == std::vector<std::string>{"sand \u4E2D", "\u6C99", "\u77F3"});
  const std::string script = gnuplot_script(figure, Picture::png);
  CHECK(contains(script, R"("sand \134u4e2d")"));
  CHECK(contains(script, R"("\134u6c99")"));
  CHECK(contains(script, R"(title "\134u77f3")"));
  CHECK_FALSE(contains(script, "\u4E2D"));
}

TEST_CASE("a scatter with a colour bar and a line in a script", "[figure]") {
  Panel panel;
  panel.x = log_axis("share", -3, 0);
  panel.y = log_axis("particles", 1, 10);
  Series scatter;
  scatter.title = "least match";
  scatter.points = {{-2, 3, 5}, {-1, 4, 6}};
  scatter.stroke = Stroke::none;
  scatter.mark = Mark::disc;
  scatter.by_value = true;
  Series curves;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  curves.points = {{-3, 1}, {-2, 2}, {gap, gap}, {-3, 4}, {-1, 8}};
  panel.series = {scatter, curves};
  Figure figure;
  figure.title = "Figure 3";
  figure.panels = {panel, panel};
  figure.columns = 2;
  figure.colors = linear_axis("log volume ratio", 0, 12);
  const std::string script = gnuplot_script(figure, Picture::svg);
  CHECK(contains(script, "$panel1_series1 << EOD\n-2 3 5\n-1 4 6\nEOD\n"));
  CHECK(contains(script, "$panel2_series2 << EOD\n-3 1\n-2 2\n\n-3 4\n-1 8\nEOD\n"));
  CHECK(contains(script, "set terminal svg "));
  CHECK(contains(script, "\"Figure 3\""));
  CHECK(contains(script, "\"log volume ratio\""));
  CHECK(contains(script, "linecolor palette"));
  const std::size_t legend = script.find("title \"least match\"");
  REQUIRE(legend != std::string::npos);
  CHECK(script.find("title \"least match\"", legend + 1) == std::string::npos);
  CHECK(script == gnuplot_script(figure, Picture::svg));
  CHECK(contains(gnuplot_script(figure, Picture::png), "set terminal pngcairo "));
  CHECK(contains(gnuplot_script(figure, Picture::pdf), "set terminal pdfcairo "));
}

TEST_CASE("labels of the upper side keep their distance and both ends", "[figure]") {
  Panel panel;
  panel.x = log_axis("size", 0, 1);
  panel.y = linear_axis("percent passing", 0, 100);
  for (int i = 0; i <= 200; ++i)
    panel.top.push_back({i / 200.0, "s" + std::to_string(i) + "."});
  Figure figure;
  figure.panels = {panel};
  const std::string script = gnuplot_script(figure, Picture::svg);
  CHECK(contains(script, "\"s0.\""));
  CHECK(contains(script, "\"s200.\""));
  double last = -1;
  std::size_t shown = 0;
  for (int i = 0; i <= 200; ++i)
    if (contains(script, "\"s" + std::to_string(i) + ".\"")) {
      const double at = figure.panel_width * i / 200;
      CHECK((last < 0 || at - last >= letter_size));
      last = at;
      ++shown;
    }
  CHECK(shown > 30);
}

// Axes and texts of figures; the pictures are in picture_test.cpp.

#include "catch.hpp"
#include "plot/figure.hpp"

#include <cmath>

namespace figure_test {

using namespace mdm;

namespace {

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

TEST_CASE("characters that fonts may lack are drawn as their numbers", "[figure]") {
  CHECK(drawable("sand \u4E2D") == "sand \\u4e2d");
  CHECK(drawable("\U0001F600\u200B\u202E\u0301\u0378") ==
        "\\u1f600\\xe2\\x80\\x8b\\xe2\\x80\\xae\\u0301\\u0378");
  const std::string common =
      "\u00E9\u0159\u00DF\u03B1\u03A9\u0416\u044F \u2013\u201C\u2026\u2264\u00B5m\u00B3";
  CHECK(drawable(common) == common);
  CHECK(drawable("a\n\xFF") == "a\\x0a\\xff");
  Figure figure;
  figure.title = "sand \u4E2D";
  figure.notes = {"\u00E4", "a\nb"};
  figure.panels.resize(2);
  figure.panels[0].title = "\u6C99";
  figure.panels[1].series.resize(1);
  figure.panels[1].series[0].title = "\u77F3";
  figure.panels[1].series[0].points = {{0, 0}};
  CHECK(escaped_texts(figure) == std::vector<std::string>{"sand \u4E2D", "\u6C99", "\u77F3"});
}

TEST_CASE("sentences are broken at spaces, and words that are too long are cut", "[figure]") {
  using Lines = std::vector<std::string>;
  const double wide = text_width("one two", letter_size) + 1;
  CHECK(wrapped("one two one two one", wide) == Lines{"one two", "one two", "one"});
  CHECK(wrapped("one two", 1000) == Lines{"one two"});
  CHECK(wrapped("", wide).empty());
  const Lines cut = wrapped("a " + std::string(80, 'x'), wide);
  REQUIRE(cut.size() == 2);
  CHECK(cut[1].ends_with("..."));
  for (const std::string &line : cut)
    CHECK(text_width(line, letter_size) <= wide);
}

} // namespace figure_test

// Tolerances: what is asked for, and the bounds that come of it.

#include "catch.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/tolerance.hpp>
#include <mdm/text/error.hpp>

namespace tolerance_test {

using namespace mdm;

namespace {

using Kind = AskedTolerance::Kind;

std::string refusal_of(const std::string &tolerance) {
  try {
    parse_tolerance(tolerance);
  } catch (const InputError &e) {
    return e.what();
  }
  return "";
}

bool contains(const std::string &text, const std::string &part) {
  UNSCOPED_INFO(text);
  return text.find(part) != std::string::npos;
}

/// Lower and upper bounds, separated by blanks.
std::string text(const std::vector<ShareBounds> &bounds) {
  std::string all;
  for (const ShareBounds &b : bounds)
    all += (all.empty() ? "" : " ") + to_string(b.lo) + "-" + to_string(b.hi);
  return all;
}

/// Shares 1/10, 4/10, 5/10.
Gradation three_classes() {
  return read_gradation("size_mm,passing_percent\n1,0\n2,10.0\n3,50\n4,100\n", "g");
}

Tolerance within(const std::vector<std::string> &asked, const Gradation &g = three_classes()) {
  std::vector<AskedTolerance> all;
  for (const std::string &one : asked)
    all.push_back(parse_tolerance(one));
  return tolerance_of(g, all, std::nullopt, 1);
}

Envelope envelope(const std::string &rows) {
  return read_envelope("size_mm,passing_min_percent,passing_max_percent\n" + rows, "band");
}

} // namespace

TEST_CASE("a tolerance is read with its unit") {
  CHECK(parse_tolerance("retained:1%") == AskedTolerance{Kind::retained, 1});
  CHECK(parse_tolerance("passing:0.5%") == AskedTolerance{Kind::passing, ratio(1, 2)});
  CHECK(parse_tolerance("total:100%") == AskedTolerance{Kind::total, 100});
  CHECK(parse_tolerance("total:200%") == AskedTolerance{Kind::total, 200});
  CHECK(parse_tolerance("retained:0%") == AskedTolerance{Kind::retained, 0});
  CHECK(parse_tolerance("retained:1e-2%") == AskedTolerance{Kind::retained, ratio(1, 100)});
  for (const char *words : {"retained:file", "passing:file", "laboratory", "rounding", "retained:0.25%"})
    CHECK(to_string(parse_tolerance(words)) == words);
}

TEST_CASE("a tolerance without a word is of what is retained, and its sign may be left out") {
  CHECK(parse_tolerance("1%") == AskedTolerance{Kind::retained, 1});
  CHECK(parse_tolerance("0.5") == AskedTolerance{Kind::retained, ratio(1, 2)});
  CHECK(parse_tolerance("passing:1") == AskedTolerance{Kind::passing, 1});
  CHECK(parse_tolerance("2_0e-1") == AskedTolerance{Kind::retained, 2});
  CHECK(parse_tolerance("file") == AskedTolerance{Kind::retained_file, 0});
}

TEST_CASE("what is no tolerance is refused with what to write") {
  CHECK(contains(refusal_of("one"), "'one' is no tolerance: write retained:1%"));
  CHECK(contains(refusal_of(""), "is no tolerance"));
  CHECK(contains(refusal_of("Retained:1%"), "is no tolerance"));
  CHECK(contains(refusal_of("total:file"), "is no tolerance"));
  CHECK(contains(refusal_of("1 %"), "is no tolerance"));
  CHECK(contains(refusal_of("retained:-1%"), "is not between 0 and 100"));
  CHECK(contains(refusal_of("passing:100.1%"), "is not between 0 and 100"));
  CHECK(contains(refusal_of("total:200.1%"), "is not between 0 and 200"));
  CHECK(contains(refusal_of("200.1%"), "is not between 0 and 100"));
  CHECK(contains(refusal_of("retained:nan%"), "is no tolerance"));
  CHECK(contains(refusal_of("retained:%"), "is no tolerance"));
  CHECK(contains(refusal_of("retained:1%%"), "is no tolerance"));
  CHECK(contains(refusal_of("laboratory:1%"), "is no tolerance"));
}

TEST_CASE("bounds on shares are those of the gradation, widened and cut to [0, 1]") {
  CHECK(text(within({"retained:20%"}).retained) == "0-3/10 1/5-3/5 3/10-7/10");
  CHECK(within({"retained:20%"}).passing.empty());
  CHECK(text(within({"passing:20%"}).passing) == "0-3/10 3/10-7/10 0-1");
  CHECK(within({"passing:20%"}).retained.empty());
  CHECK(within({"total:20%"}).total == ratio(1, 5));
}

TEST_CASE("all tolerances hold: the bounds are the narrowest") {
  const Tolerance t =
      within({"retained:20%", "retained:5%", "passing:1%", "rounding", "total:9%", "total:3%"});
  CHECK(text(t.retained) == "1/20-3/20 7/20-9/20 9/20-11/20");
  CHECK(text(t.passing) == "199/2000-201/2000 99/200-101/200 0-1");
  CHECK(t.total == ratio(3, 100));
}

TEST_CASE("tolerances of the file are of the sieves in their rows") {
  const Gradation g = read_gradation("size_mm,mass,tolerance_percent\n1,1,0.5\n2,1,1\n3,2,100\n4,0,7\n", "g");
  CHECK(text(within({"retained:file"}, g).retained) == "49/200-51/200 6/25-13/50 0-1");
  CHECK(text(within({"passing:file"}, g).passing) == "6/25-13/50 0-1 0-1");
  CHECK(text(within({"retained:file"}, g.cut_below(2)).retained) == "97/300-103/300 0-1");
  CHECK_THROWS_AS(within({"retained:file"}), InputError);
}

TEST_CASE("rounding is half a unit of the last digit that the file has") {
  const auto half_units = [](const std::string &content) {
    std::string all;
    for (const Rational &r : passing_tolerances(read_gradation(content, "g"), Kind::rounding))
      all += (all.empty() ? "" : " ") + to_string(r);
    return all;
  };
  CHECK(half_units("size_mm,passing_percent\n1,0\n2,12.50\n3,20\n4,5e1\n5,6.0e1\n6,100\n") ==
        "1/200 1/2 5 1/2");
  CHECK(half_units("size_mm,passing_percent\n1,12\n2,100\n") == "1/2");
  CHECK(half_units("size_mm,cumulative_retained_percent\n1,100\n2,12.5\n3,0\n") == "1/20");
  CHECK(half_units("size_mm,passing_fraction\n1,0\n2,.125\n3,1\n") == "1/20");
  const std::string ags = "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"GRAT_SIZE\",\"GRAT_PERP\"\n"
                          "\"UNIT\",\"\",\"mm\",\"%\"\n\"TYPE\",\"ID\",\"2DP\",\"0DP\"\n"
                          "\"DATA\",\"BH1\",\"1.00\",\"0\"\n\"DATA\",\"BH1\",\"2.00\",\"45.5\"\n"
                          "\"DATA\",\"BH1\",\"4.00\",\"100\"\n";
  CHECK(half_units(ags) == "1/20");
  CHECK_THROWS_AS(half_units("size_mm,mass\n1,1\n2,0\n"), InputError);
}

TEST_CASE("the laboratory's tolerance is 0.05 sqrt(X (100 - X)), rounded outwards to 6 places") {
  std::string content = "size_mm,passing_percent\n1,0\n2,1e-9\n";
  for (int i = 1; i < 1000; ++i)
    content += std::to_string(i + 2) + "," + std::to_string(i / 10) + "." + std::to_string(i % 10) + "\n";
  const Gradation g = read_gradation(content + "1002,100\n", "g");
  const std::vector<Rational> e = passing_tolerances(g, Kind::laboratory);
  const Tolerance t = tolerance_of(g, {{Kind::laboratory, 0}}, std::nullopt, 1);
  REQUIRE(e.size() == 1000);
  const Rational unit = ratio(1, 1000000);
  Rational x = 0;
  for (std::size_t j = 0; j < e.size(); ++j) {
    x += g.mass(j);
    const Rational square = x * (100 - x) / 400;
    CHECK(e[j] * e[j] >= square);
    CHECK((e[j] - unit) * (e[j] - unit) < square);
    CHECK(denominator(Rational(e[j] / unit)) == 1);
    CHECK(t.passing[j].lo == std::max(Rational(0), Rational((x - e[j]) / 100)));
    CHECK(t.passing[j].hi == std::min(Rational(1), Rational((x + e[j]) / 100)));
  }
  CHECK(e[500] == ratio(5, 2));          // X = 50
  CHECK(e[200] == 2);                    // X = 20
  CHECK(e[100] == ratio(3, 2));          // X = 10
  CHECK(e[1] == ratio(158035, 1000000)); // X = 0.1: 0.1580348...
}

TEST_CASE("a band bounds what passes its sieves, in any unit and after a size factor") {
  const Gradation g = three_classes();
  const auto within_band = [&g](const std::string &band, const Rational &factor = 1) {
    return text(tolerance_of(g.scaled(factor), {}, read_envelope(band, "band"), factor).passing);
  };
  const std::string percent = "passing_min_percent,passing_max_percent\n";
  CHECK(within_band("size_mm," + percent + "2,5,30\n") == "1/20-3/10 0-1 0-1");
  CHECK(within_band("size_um," + percent + "3000,40,60\n0.5,0,3\n7000,80,100\n") == "0-1 2/5-3/5 4/5-1");
  CHECK(within_band("size_mm," + percent + "2,5,30\n", 7) == "1/20-3/10 0-1 0-1");
  CHECK_THROWS_AS(within_band("size_mm," + percent + "2.5,5,30\n"), InputError);
  CHECK_THROWS_AS(within_band("size_mm," + percent + "1,5,30\n"), InputError);
}

TEST_CASE("the middle of a band is between the narrowest bounds that curves have") {
  const Gradation g = middle_of(envelope("1,0,0\n2,10,60\n3,0,40\n4,90,100\n"));
  CHECK(g.sizes() == std::vector<Rational>{1, 2, 3, 4});
  CHECK(g.masses() == std::vector<Rational>{25, 0, 75, 0}); // 10..40 at 2 and at 3
  CHECK(g.id() == "band");
  CHECK(g.notes() ==
        std::vector<std::string>{"No gradation was given: the target is the middle of the band."});
  const Gradation with_pan = middle_of(envelope("2,0,10\n4,100,100\n"));
  CHECK(with_pan.sizes() == std::vector<Rational>{0, 2, 4});
  CHECK(with_pan.masses() == std::vector<Rational>{5, 95, 0});
  CHECK(middle_of(envelope("pan,0,9\n2,0,10\n4,100,100\n")).masses() == with_pan.masses());
  CHECK(middle_of(envelope("3,90,100\n")).masses() == std::vector<Rational>{100, 0});
  CHECK_THROWS_AS(middle_of(envelope("2,0,10\n4,90,99\n")), InputError);
  CHECK_THROWS_AS(middle_of(envelope("pan,0,100\n")), InputError);
}

TEST_CASE("a band that contradicts itself has a middle, so that the question can be asked") {
  const Gradation g = middle_of(envelope("1,20,30\n2,0,10\n3,5,100\n"));
  CHECK(g.masses() == std::vector<Rational>{20, 0, 80, 0});
  CHECK(middle_of(envelope("1,100,20\n2,0,100\n")).masses() == std::vector<Rational>{100, 0, 0});
}

} // namespace tolerance_test

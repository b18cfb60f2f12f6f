// The trade-off: hand-made cases, the commands' own answers one by one, and pictures whose labels keep apart.

#include "catch.hpp"
#include "files.hpp"
#include "plot/tradeoff_figure.hpp"
#include "report/tradeoff_report.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <fstream>
#include <sstream>

namespace tradeoff_report_test {

using namespace mdm;

namespace {

Gradation example(const std::string &name) {
  const std::string path = MDM_SOURCE_DIR "/examples/gradations/" + name + ".csv";
  return read_gradation(mdm_test::read_file(path), path);
}

TradeoffOptions within(const std::vector<Rational> &percents) {
  TradeoffOptions options;
  options.tolerances = percents;
  return options;
}

/// Tolerances or sizes and losses with their N, separated by blanks.
std::string text(const std::vector<TradeoffRow> &rows) {
  std::string all;
  for (const TradeoffRow &row : rows) {
    CHECK(row.is_optimal());
    all += (all.empty() ? "" : " ") + to_string(row.tolerance) + "/" + row.smallest.text() + "/" +
           to_string(row.lost) + ":" + to_string(*row.particles);
  }
  return all;
}

void check_falling(const std::vector<TradeoffRow> &rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(rows[i].lower_bound <= rows[i].particles);
    if (i == 0)
      continue;
    CHECK(rows[i].particles <= rows[i - 1].particles);
    CHECK(rows[i].lower_bound <= rows[i - 1].lower_bound);
  }
}

/// Seven classes of relative width 1e-6: hundreds of thousands of particles.
Gradation narrow_classes() {
  std::string text = "size_mm,mass\n";
  for (int j = 0; j < 8; ++j)
    text += "1.00000" + std::to_string(j) + "," + std::to_string(j < 7 ? 100 + 37 * j * j % 53 : 0) + "\n";
  return read_gradation(text, "narrow");
}

/// Where a text of a panel is drawn, in pt.
struct Area {
  double left, right, bottom, top;
};

Area area(const Figure &f, const Panel &p, const Text &t) {
  const double width = text_width(t.text, letter_size);
  const double anchor = (t.x - p.x.low) / p.x.span() * f.panel_width + t.dx;
  const double left = t.align == Align::left     ? anchor
                      : t.align == Align::center ? anchor - width / 2
                                                 : anchor - width;
  const double middle = (t.y - p.y.low) / p.y.span() * f.panel_height + t.dy;
  return {left, left + width, middle - letter_size / 2, middle + letter_size / 2};
}

/// No label leaves the frame, and none covers another.
void check_labels(const Figure &f) {
  for (const Panel &p : f.panels)
    for (std::size_t i = 0; i < p.texts.size(); ++i) {
      const Area a = area(f, p, p.texts[i]);
      INFO(p.title << ": " << p.texts[i].text);
      CHECK(a.left >= 0);
      CHECK(a.right <= f.panel_width);
      CHECK(a.bottom >= 0);
      CHECK(a.top <= f.panel_height);
      for (std::size_t k = 0; k < i; ++k) {
        const Area b = area(f, p, p.texts[k]);
        CHECK((a.right <= b.left || b.right <= a.left || a.top <= b.bottom || b.top <= a.bottom));
      }
    }
}

} // namespace

TEST_CASE("two halves: both curves by hand") {
  // Exact: two particles of 2 mm, one of a little more. Within a little, one of each; alone, one is half
  // away.
  const Gradation g = read_gradation("size_mm,mass\n1,1\n2,1\n3,0\n", "halves");
  const Tradeoff t = tradeoff(g, {}, within({50, 0, ratio(1, 100), ratio(4999, 100), 50}));
  CHECK(text(t.by_tolerance) == "0/1/0:3 1/100/1/0:2 4999/100/1/0:2 50/1/0:1");
  CHECK(text(t.by_sieve) == "0/1/0:3 0/2/1/2:1");
  TradeoffOptions total = within({99, 100});
  total.kind = AskedTolerance::Kind::total;
  CHECK(text(tradeoff(g, {}, total).by_tolerance) == "99/1/0:2 100/1/0:1");
}

TEST_CASE("sieves that retain nothing are no rows, and the law and the floor count") {
  const Gradation g = read_gradation("size_mm,mass\n1,0\n2,1\n3,0\n4,1\n9,0\n", "gaps");
  Question question;
  question.min_per_class = 3;
  question.law = parse_mass_law("power:1/2");
  const Tradeoff t = tradeoff(g, question, within({0}));
  REQUIRE(t.by_sieve.size() == 2);
  CHECK(t.by_sieve[0].smallest.power == 2);
  CHECK(t.by_sieve[1].smallest.power == 4);
  CHECK(t.by_sieve[1].lost == ratio(1, 2));
  CHECK(t.by_sieve[1].particles == 3);
  CHECK(t.by_tolerance[0].particles == solve(g, question).particles());
}

TEST_CASE("each row is the answer to its own question, and N never rises") {
  for (const char *name : {"athabasca-sand", "hostun-rf-sand", "limestone-pfc"})
    for (const AskedTolerance::Kind kind : {AskedTolerance::Kind::retained, AskedTolerance::Kind::passing}) {
      const Gradation g = example(name);
      TradeoffOptions options = within({0, ratio(1, 2), 1, 2, 5, 10, 30, 100});
      options.kind = kind;
      const Tradeoff t = tradeoff(g, {}, options);
      check_falling(t.by_tolerance);
      check_falling(t.by_sieve);
      CHECK(t.by_tolerance.back().particles == 1);
      for (const TradeoffRow &row : t.by_tolerance) {
        Question question;
        question.tolerances = {{kind, row.tolerance}};
        CHECK(solve(g, question).particles() == row.particles);
      }
      for (const TradeoffRow &row : t.by_sieve)
        CHECK(solve(g.cut_below(row.smallest.power)).particles() == row.particles);
    }
}

TEST_CASE("at a limit, rows share what they know") {
  TradeoffOptions options = within({0, ratio(1, 10), 1});
  options.limits.max_steps = 1000;
  options.limits.node_limit = 1;
  const Tradeoff t = tradeoff(narrow_classes(), {}, options);
  CHECK_FALSE(t.whole().is_optimal());
  check_falling(t.by_tolerance);
  check_falling(t.by_sieve);
  const Tradeoff sand = tradeoff(example("athabasca-sand"), {}, options);
  CHECK(sand.whole().particles == 1485);
  for (const TradeoffRow &row : sand.by_tolerance)
    CHECK(row.particles <= 1485);
  options.time_limit = std::chrono::milliseconds(0);
  check_falling(tradeoff(example("athabasca-sand"), {}, options).by_tolerance);
}

TEST_CASE("CSV has both curves") {
  const Gradation g = read_gradation("size_um,mass\npan,1\n2,2\n3,0\n", "g");
  CHECK(tradeoff_csv(tradeoff(g, {}, within({0, 100}))) ==
        "kind,tolerance_percent,smallest_um,lost_percent,particles,lower_bound,status\n"
        "retained,0,0,0,2,2,optimal\n"
        "retained,100,0,0,1,1,optimal\n"
        "retained,0,0,0,2,2,optimal\n"
        "retained,0,2,33.3333333333333,1,1,optimal\n");
}

TEST_CASE("labels of the figure neither overlap nor leave their panel") {
  for (const char *name : {"athabasca-sand", "hostun-rf-sand", "limestone-pfc", "cen-standard-sand"})
    check_labels(tradeoff_figure(tradeoff(example(name), {}, within({0, ratio(1, 2), 1, 2, 5}))));
  const Tradeoff many = tradeoff(example("ottawa-f65-sand"), {}, within({0, 2, ratio(21, 10), 5}));
  const Figure figure = tradeoff_figure(many);
  check_labels(figure);
  REQUIRE(figure.panels.size() == 2);
  CHECK(figure.panels[0].texts.size() == 4);
  CHECK(figure.panels[1].texts.size() > 15);
  TradeoffOptions limited = within({0, 1, 5});
  limited.limits.max_steps = 1000;
  check_labels(tradeoff_figure(tradeoff(narrow_classes(), {}, limited)));
  check_labels(
      tradeoff_figure(tradeoff(read_gradation("size_mm,mass\npan,1\n1,0\n", "one"), {}, within({0}))));
}

TEST_CASE("a tolerance of 0 and a pan stand left of all others") {
  const Figure f = tradeoff_figure(tradeoff(example("limestone-pfc"), {}, within({0, ratio(1, 2), 5})));
  const Axis &tolerance = f.panels[0].x;
  CHECK(tolerance.ticks[0].label == "0");
  CHECK(tolerance.ticks[1].label == "0.5");
  CHECK(tolerance.low < tolerance.ticks[0].at);
  CHECK(tolerance.ticks[0].at < tolerance.ticks[1].at);
  CHECK(f.panels[1].x.ticks[0].label == "pan");
  CHECK(f.panels[1].x.ticks[0].at < f.panels[1].x.ticks[1].at);
}

} // namespace tradeoff_report_test
